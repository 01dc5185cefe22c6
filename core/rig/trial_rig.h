// core/rig/trial_rig.h: muscles placed by rule, for characters that have none: what benchmarks and tests measure.
#pragma once

#include <cstdint>
#include <vector>

#include "core/character/bone_segments.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

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

/// `muscles` ellipsoids as a first try would set them: on the bones with the most skin, one each (more where they are
/// few), lying along the bone, half buried in the skin at a vertex of that bone's which the seed picks. Three groups in
/// a chain a - b - c, default territories, no carves. The same character, count and seed give the same rig.
[[nodiscard]] Rig trialRig(const Character& character, int muscles, std::uint64_t seed);

}  // namespace sinew
