// core/rig/animated_validation.h: what makes keys, drivers and channels sound.
#pragma once

#include <string>
#include <vector>

#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Parameters of the owner's kind, each once; curves with rising x and finite numbers; ranges of inputs. The Error's
/// place begins with `place`.
[[nodiscard]] Result<void> validateAnimated(const std::vector<AnimatedNumber>& animated, ParameterOwner owner,
                                            const std::string& place);
/// Channels have names and sound tracks, one of a name for a clip.
[[nodiscard]] Result<void> validateChannels(const Rig& rig);
/// Lines and channels that inputs name are there.
[[nodiscard]] Result<void> validateInputs(const Rig& rig);

}  // namespace sinew
