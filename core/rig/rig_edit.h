// core/rig/rig_edit.h: changes of several primitives at once, as pure functions rig -> rig.
//
// As in rig_edit.h: a rig is taken by value; indices must be in range (asserted).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sinew/geometry/result.h"
#include "sinew/rig/parameter.h"
#include "sinew/rig/rig.h"

namespace sinew {

// The numbers of a rig that keys and drivers may change, without the rig around them.

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

/// Changes each of several primitives; every one must stand up by itself afterwards, and its group must exist. `change`
/// must leave name and mirror alone (asserted). One refusal, and nothing is changed.
[[nodiscard]] Result<Rig> editPrimitives(Rig rig, std::span<const int> indices,
                                         const std::function<void(Primitive&)>& change);

/// Puts several primitives into a group.
[[nodiscard]] Result<Rig> setGroupOfSeveral(Rig rig, std::span<const int> indices, const std::string& group);
/// The same with a group that is made for it.
[[nodiscard]] Result<Rig> moveToNewGroup(Rig rig, std::span<const int> indices, const std::string& name);
/// Removes a group whose primitives go to another one. Error: the two are the same.
[[nodiscard]] Result<Rig> dissolveGroup(Rig rig, int group, int into);

/// Rig indices of a group's primitives, ascending.
[[nodiscard]] std::vector<int> membersOf(const Rig& rig, const std::string& group);

}  // namespace sinew
