// core/rig/trial_rig.h: muscles placed by rule on characters without any, for benchmarks and tests.
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

/// The skin for which one bone has the largest weight.
struct Skin {
  int bone = 0;
  float area = 0.0f;
  std::vector<int> vertices;
};

[[nodiscard]] std::vector<Skin> skinsOf(const Character& character);  ///< Bones with skin, the largest area first.

/// An ellipsoid along the bone, half below the skin at a vertex.
[[nodiscard]] Placement placementAt(const Character& character, const Bone& bone, const Segment& segment, int vertex);

/// Places `muscles` ellipsoids (placementAt) on the bones with the largest areas of skin in turn, at vertices chosen by
/// the seed. Three groups in a chain a - b - c, default territories, no carves. Deterministic.
[[nodiscard]] Rig trialRig(const Character& character, int muscles, std::uint64_t seed);

}  // namespace sinew
