// app/document/clipboard.h: muscles as text, for the system's clipboard.
//
// The text is a whole rig file (docs/formats.md) of the copied muscles, their groups and the links between these:
// what is pasted into an editor of text, or saved as a .rig.json, reads as any other rig.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// With the lines they ride. Links to twins that are not among the copied are left out.
[[nodiscard]] std::string musclesAsText(const Rig& rig, std::span<const int> indices);

struct Pasted {
  Rig rig;
  std::vector<std::string> names;    ///< The new muscles', in order.
  std::vector<std::string> leftOut;  ///< Why each of the others is not there, one line each.
};

/// The rig with what the text holds (core/rig/merge.h: mergeRigs).
/// @param mirror  null, or the plan by which each is pasted on the other side.
/// Error: the text is no rig, holds no muscle, or none could be pasted.
[[nodiscard]] Result<Pasted> pasteText(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                                       const MirrorPlan* mirror);

/// The same on another bone, to which it is moved (moveToBone). What was copied from several bones, from this one, or
/// rides a muscle line, goes where it was.
/// @param plan  null: twins become single muscles.
[[nodiscard]] Result<Pasted> pasteTextOnBone(const Rig& rig, const std::string& text, const Skeleton& skeleton,
                                             int bone, const MirrorPlan* plan);

}  // namespace sinew::app
