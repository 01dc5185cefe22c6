// core/bodies/muscle_set.h: a set of muscles added to a rig: placed, learned and mended in one go.
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

// Muscles of one character as marks, so that they fit any: the way back from
// fit_preset.h.

struct PresetOfMuscles {
  Preset preset;  ///< Without name and title.
  std::vector<FittedPreset::LeftOut> leftOut;
};

/// Of twins one counts: fitting makes the other. What is on one side alone becomes a pair; what lies across the middle
/// stays single. Left out is what is on a bone that is no part of the body, on a hand, foot or head whose length is not
/// known, or has no skin over it. Keys, drivers, territories and the
/// activation by hand stay behind. Error: the body is unknown, or nothing is left.
/// @param primitives  rig indices
[[nodiscard]] Result<PresetOfMuscles> presetFromMuscles(const Rig& rig, std::span<const int> primitives,
                                                        const Character& character, const MirrorPlan& plan);

// A muscle of a set where a hand points, in place of where the set has it.

/// A place on the skin, as a mark: of the left side, or of the middle.
struct MarkOnSkin {
  Mark mark;
  BodySide side = BodySide::kLeft;
};
/// nullopt: the bone is no part of the body, or a part without length.
/// @param inBind  on the skin that follows the bone; world of the bind pose
[[nodiscard]] std::optional<MarkOnSkin> markOnSkin(const MeasuredBody& body, int bone, const glm::vec3& inBind);

/// Near its own place the muscle is laid there. Elsewhere on its part it goes round the part and along it, and its line
/// with it; on another part it is a belly alone, along that part and as long as it was.
[[nodiscard]] PresetMuscle muscleAt(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body);

/// Near enough its own place to be laid there.
[[nodiscard]] bool isOwnPlace(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body);

struct AddedSet {
  FittedPreset fitted;
  std::vector<std::string> mended;  ///< Of each line that was changed: "calf L: pivot 0.3".
};

/// fitPreset(), then what check() finds of the set's own muscles is mended (mend_rig.h), and what nothing mends is left
/// out; those that were there before are their designer's. In a rig without muscles the set decides how much muscle
/// skins blend. Errors as of fitPreset().
/// @param motions  of the character with the range of motion as a clip
[[nodiscard]] Result<AddedSet> addMuscleSet(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                            const Motions& motions, const MirrorPlan& plan);

/// The same without mending, which takes longest: for a slider that is being dragged.
[[nodiscard]] Result<FittedPreset> addMuscleSetQuickly(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                                       const Motions& motions, const MirrorPlan& plan);

}  // namespace sinew
