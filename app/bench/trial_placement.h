// app/bench/trial_placement.h: where muscles that are placed by rule lie: the skin of a bone, an ellipsoid along it.
#pragma once

#include <vector>

#include "core/skeleton/bone_segments.h"
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

/// An ellipsoid along the bone, half buried in the skin at a vertex of it.
[[nodiscard]] Placement placementAt(const Character& character, const Bone& bone, const Segment& segment, int vertex);

}  // namespace sinew
