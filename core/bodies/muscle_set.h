// core/bodies/muscle_set.h: adds a set of muscles to a rig, and makes a set from muscles of a rig.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/bodies/body_map.h"
#include "core/bodies/fit_preset.h"
#include "core/bodies/mend.h"
#include "core/bodies/motions.h"
#include "core/bodies/preset.h"

namespace sinew {

struct PresetOfMuscles {
  Preset preset;  ///< Without name and title.
  std::vector<FittedPreset::LeftOut> leftOut;
};

/// The inverse of fitPreset(): muscles as marks. A pair of twins is one muscle; a muscle on one side alone becomes a
/// pair, one across the mirror plane stays single. Muscles are left out whose bone is no part of the body, that lie on
/// a hand, foot or head of unknown length, or have no skin over them. Keys, drivers, territories and manual activation
/// are dropped. Error: the body is unknown, or nothing is left.
/// @param primitives  rig indices
[[nodiscard]] Result<PresetOfMuscles> presetFromMuscles(const Rig& rig, std::span<const int> primitives,
                                                        const Character& character, const MirrorPlan& plan);

/// A place on the skin as a mark of the left side or the middle, and the side it is on.
struct MarkOnSkin {
  Mark mark;
  BodySide side = BodySide::kLeft;
};
/// nullopt: the bone is no part of the body, or a part without length.
/// @param inBind  on the skin that follows the bone; world of the bind pose
[[nodiscard]] std::optional<MarkOnSkin> markOnSkin(const MeasuredBody& body, int bone, const glm::vec3& inBind);

/// The muscle of a set at a place chosen by hand. Near its own place it stays there. Elsewhere on its part it moves
/// around and along the part together with its line; on another part it loses its line and keeps its length.
[[nodiscard]] PresetMuscle muscleAt(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body);

/// Near enough to the muscle's own place that it is laid there.
[[nodiscard]] bool isOwnPlace(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body);

struct AddedSet {
  FittedPreset fitted;
  std::vector<std::string> mended;  ///< One entry for each changed line: "calf L: pivot 0.3".
};

/// fitPreset(), then withMendedRig() on the set's own muscles; those that still have findings are left out. An empty
/// rig takes the set's skin blend and grooves. Errors as fitPreset().
/// @param motions  of the character with the range of motion as a clip
[[nodiscard]] Result<AddedSet> addMuscleSet(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                            const Motions& motions, const MirrorPlan& plan);

/// The same without mending, which takes longest: for use while a slider is dragged.
[[nodiscard]] Result<FittedPreset> addMuscleSetQuickly(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                                       const Motions& motions, const MirrorPlan& plan);

}  // namespace sinew
