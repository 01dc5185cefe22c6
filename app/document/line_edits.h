// app/document/line_edits.h: what a designer does to muscle lines beyond typing numbers, as pure functions rig -> rig.
#pragma once

#include <string>

#include "core/lines/line_lengths.h"
#include "core/symmetry/mirror.h"
#include "sinew/base/result.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// The pose's length becomes the rest length. @param stretch  lambda in the pose
[[nodiscard]] Result<Rig> withRestNow(const Rig& rig, int line, float stretch);
/// The pose's length becomes that of full contraction. Error: the line is not shorter than at rest.
[[nodiscard]] Result<Rig> withFullNow(const Rig& rig, int line, float stretch);

struct Learned {
  Rig rig;
  std::string said;     ///< "Full contraction at 74 %: shortest in Range of motion"
  std::string warning;  ///< Empty, or why the line probably passes through a joint.
};
/// Full contraction from the 2nd percentile of the lengths. Error: the muscle never shortens.
[[nodiscard]] Result<Learned> withLearned(const Rig& rig, int line, const LineLengths& lengths);

/// A via point on the origin's bone, beside the joint between the two bones, on the side where the line passes it.
/// Error: the line's bones are not there.
[[nodiscard]] Result<Rig> withViaPoint(const Rig& rig, int line, const Character& character);
[[nodiscard]] Result<Rig> withoutViaPoint(const Rig& rig, int line);

/// Puts a muscle that rides its bone on a new line to another bone; it stays where it is in the bind pose. The line
/// begins at the muscle's far end and ends a little way along the other bone, both half way between skin and axis. Its
/// linked twin follows. Error: a bone is not there, or the ends would meet.
[[nodiscard]] Result<Rig> withOtherEnd(const Rig& rig, int primitive, int bone, const Character& character,
                                       const MirrorPlan* plan);

}  // namespace sinew::app
