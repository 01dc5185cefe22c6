// app/cli/trial_placement.h: where muscles that are placed by rule lie: the skin of a bone, an ellipsoid along it.
#pragma once

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "sinew/character/character.h"
#include "sinew/primitives/ellipsoid.h"

namespace sinew {

// Semi-axes, fractions of H.
inline constexpr float kThinnestTrial = 0.015f;
inline constexpr float kThickestTrial = 0.06f;
inline constexpr float kLongestTrial = 0.12f;

/// The skin that follows one bone more than any other.
struct Skin {
  int bone = 0;
  float area = 0.0f;
  std::vector<int> vertices;
};

/// Bones that have skin, the one with the most first.
[[nodiscard]] std::vector<Skin> skinsOf(const Character& character);

/// A bone's segment in the bind pose, world.
struct Segment {
  glm::vec3 from{0.0f};
  glm::vec3 along{0.0f};

  explicit Segment(const Bone& bone)
      : from(bone.bindInWorld[3]), along(glm::vec3(bone.bindInWorld * glm::vec4(bone.tip, 1.0f)) - from) {}

  float parameter(const glm::vec3& point) const {
    const float span = glm::dot(along, along);
    return span > 0.0f ? glm::dot(point - from, along) / span : 0.0f;
  }
  float distance(const glm::vec3& point) const {
    return glm::distance(point, from + along * std::clamp(parameter(point), 0.0f, 1.0f));
  }
};

/// An ellipsoid along the bone, half buried in the skin at a vertex of it.
[[nodiscard]] Placement placementAt(const Character& character, const Bone& bone, const Segment& segment, int vertex);

}  // namespace sinew
