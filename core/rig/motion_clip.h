// core/rig/motion_clip.h: the range of motion as one more clip of an open character.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/character/range_of_motion.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"

namespace sinew {

/// What a range of motion of the character needs to know besides its skeleton.
[[nodiscard]] RangeOfMotionHints motionHints(const Character& character);

/// The character with a clip "Range of motion" (core/character/range_of_motion.h) at the end of its clips. The same
/// character where it has a clip of that name already, its file's own too, or where none of its joints can turn.
[[nodiscard]] std::shared_ptr<const Character> withRangeOfMotion(std::shared_ptr<const Character> character);

/// The same for those who have the character's mirror plan already: finding it takes longest.
[[nodiscard]] std::shared_ptr<const Character> withRangeOfMotion(std::shared_ptr<const Character> character,
                                                                 const MirrorPlan& plan);

/// For the command line: the character, with the range of motion if that is the clip asked for.
[[nodiscard]] std::shared_ptr<const Character> withClipNamed(std::shared_ptr<const Character> character,
                                                             const std::string& clip);

/// Index of the first clip of that name, or -1.
[[nodiscard]] int findClip(const Character& character, std::string_view name);

}  // namespace sinew
