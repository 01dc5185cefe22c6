// core/rig/rig_numbers.h: the numbers of a rig that keys and drivers may change, without the rig around them.
#pragma once

#include <vector>

#include "sinew/rig/parameter.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Which number of a rig.
struct NumberRef {
  Parameter parameter = Parameter::kAmount;
  int owner = 0;  ///< Index into Rig::primitives, Rig::lines or Rig::morphs; not read for the surface.

  friend bool operator==(const NumberRef&, const NumberRef&) = default;
};

/// The numbers of one primitive; see Primitive.
struct MuscleNumbers {
  Placement placement;  ///< Bone space.
  float reach = kDefaultReach;
  float amount = 1.0f;

  friend bool operator==(const MuscleNumbers&, const MuscleNumbers&) = default;
};

/// A rig's numbers as drawn, or as they are in a pose (core/rig/posed_rig.h). Copying them copies no names.
struct RigNumbers {
  float skinBlend = kDefaultSkinBlend;    ///< SurfaceSettings::skinBlend
  std::vector<LineSettings> lines;        ///< [Rig::lines]
  std::vector<MuscleNumbers> primitives;  ///< [Rig::primitives]
  std::vector<float> morphs;              ///< [Rig::morphs] MorphWeight::weight

  friend bool operator==(const RigNumbers&, const RigNumbers&) = default;
};

/// The numbers as the rig has them.
[[nodiscard]] RigNumbers drawnNumbers(const Rig& rig);

/// The number itself, or null where the owner is another.
[[nodiscard]] float* numberIn(MuscleNumbers& numbers, Parameter parameter);
[[nodiscard]] float& numberIn(RigNumbers& numbers, const NumberRef& ref);
[[nodiscard]] float numberOf(const RigNumbers& numbers, const NumberRef& ref);

}  // namespace sinew
