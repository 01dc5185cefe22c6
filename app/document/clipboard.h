// app/document/clipboard.h: muscles as text, for the system's clipboard.
//
// The text is a whole rig file (docs/formats.md) of the copied muscles, their groups and the links between these:
// what is pasted into an editor of text, or saved as a .rig.json, reads as any other rig.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/symmetry/mirror.h"
#include "sinew/base/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// With the lines they ride. Links to twins that are not among the copied are left out.
[[nodiscard]] std::string musclesAsText(const Rig& rig, std::span<const int> indices);

struct Pasted {
  Rig rig;
  std::vector<std::string> names;    ///< Of the new muscles, in order.
  std::vector<std::string> leftOut;  ///< Why each of the others is not there, one line each.
};

/// Appends what the text holds, under free names; twins that are both in it are twins again. Groups go by name and are
/// made where absent, linked to each other as in the text. Muscle lines are copied, not shared. Muscles on bones that
/// this character lacks are left out.
/// @param mirror  null, or the plan by which each is pasted on the other side.
/// Error: the text is no rig, holds no muscle, or none could be pasted.
[[nodiscard]] Result<Pasted> pastedMuscles(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                                           const MirrorPlan* mirror);

/// The same, but on another bone: what was copied from one bone (or from a pair of bones, with twins) goes to `bone`,
/// at the same place along it, as much larger as that bone is longer. Twins go to its mirror image. Default
/// territories. What was copied from several bones, from this one, or
/// rides a muscle line, goes where it was.
/// @param plan  null: twins become single muscles.
[[nodiscard]] Result<Pasted> pastedOnBone(const Rig& rig, const std::string& text, const Skeleton& skeleton, int bone,
                                          const MirrorPlan* plan);

}  // namespace sinew::app
