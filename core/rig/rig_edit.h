// core/rig/rig_edit.h: edits of several primitives at once as pure functions rig -> rig, like sinew/rig/rig_edit.h, and
// the numbers of a rig that keys and drivers may change. Indices must be in range (asserted).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/parameter.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Weights that a rig adds to a character's morph targets. Pure functions, as in rig_edit.h.

enum class KeepIdle { kNo, kYes };

/// Names of a character's expressions and morph targets, each once, in the order of the file.
[[nodiscard]] std::vector<std::string> morphNames(const Character& character);

/// Makes an entry for every name of the character, in its order, followed by the rig's other entries. Idle entries are
/// not written to files.
/// @param idle  kYes: keeps other entries that are idle, since no entry may vanish while a document is edited
[[nodiscard]] Rig withMorphsOf(Rig rig, const Character& character, KeepIdle idle = KeepIdle::kNo);
[[nodiscard]] bool isIdle(const MorphWeight& morph);  ///< Weight 0 and not animated.

/// Adds the entry if there is none. Error: not in kLeastMorphWeight..kMostMorphWeight.
[[nodiscard]] Result<Rig> setMorphWeight(Rig rig, const std::string& name, float weight);
[[nodiscard]] Rig withoutMorphWeights(Rig rig);  ///< Sets all weights to 0; keys and drivers stay.

[[nodiscard]] Result<void> validateMorphs(const Rig& rig);  ///< Unique names; weights in range; valid keys and drivers.

struct NumberRef {
  Parameter parameter = Parameter::kAmount;
  int owner = 0;  ///< Index into Rig::primitives, lines, morphs or links; not read for the surface.

  friend bool operator==(const NumberRef&, const NumberRef&) = default;
};

/// The numbers of one primitive; see Primitive.
struct MuscleNumbers {
  Placement placement;  ///< Bone space.
  float reach = kDefaultReach;
  float amount = 1.0f;

  friend bool operator==(const MuscleNumbers&, const MuscleNumbers&) = default;
};

/// A rig's numbers as drawn, or in a pose (core/rig/posed_rig.h).
struct RigNumbers {
  float skinBlend = kDefaultSkinBlend;    ///< SurfaceSettings::skinBlend
  float grooves = 0.0f;                   ///< SurfaceSettings::grooves
  std::vector<LineSettings> lines;        ///< [Rig::lines]
  std::vector<MuscleNumbers> primitives;  ///< [Rig::primitives]
  std::vector<float> morphs;              ///< [Rig::morphs] MorphWeight::weight
  std::vector<float> links;               ///< [Rig::links] Link::amount

  friend bool operator==(const RigNumbers&, const RigNumbers&) = default;
};

[[nodiscard]] RigNumbers drawnNumbers(const Rig& rig);

[[nodiscard]] float* numberIn(MuscleNumbers& numbers, Parameter parameter);  ///< Null: the parameter has another owner.
[[nodiscard]] float& numberIn(RigNumbers& numbers, const NumberRef& ref);
[[nodiscard]] float numberOf(const RigNumbers& numbers, const NumberRef& ref);

/// `change` must not change name and mirror (asserted). Error: one is invalid or lacks its group; then none is changed.
/// Group and sign of a sheet's belly hold for the sheet.
[[nodiscard]] Result<Rig> editPrimitives(Rig rig, std::span<const int> indices,
                                         const std::function<void(Primitive&)>& change);

[[nodiscard]] Result<Rig> setGroupOfSeveral(Rig rig, std::span<const int> indices, const std::string& group);
[[nodiscard]] Result<Rig> moveToNewGroup(Rig rig, std::span<const int> indices, const std::string& name);
/// Removes a group and moves its primitives to another one. Error: the two are the same.
[[nodiscard]] Result<Rig> dissolveGroup(Rig rig, int group, int into);

/// Rig indices of a group's primitives, ascending.
[[nodiscard]] std::vector<int> membersOf(const Rig& rig, const std::string& group);

}  // namespace sinew
