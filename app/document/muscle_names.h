// app/document/muscle_names.h: what muscles are called: in the history, and until their user says otherwise.
#pragma once

#include <span>
#include <string>

#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// "biceps L", or "3 muscles". @param indices  into the rig, in range
[[nodiscard]] std::string namedMuscles(const Rig& rig, std::span<const int> indices);

/// "upper_arm.L muscle": of a new muscle on a bone, before it is made free.
[[nodiscard]] std::string defaultMuscleName(const Skeleton& skeleton, int bone);

/// `after` with new default names for muscles that had the default name of the bone that they were on in `before` and
/// are on another one now; with them their twins that had the mirrored name, or will be named so. Names that somebody
/// has typed stay. The two have the same muscles in the same order.
[[nodiscard]] Rig withDefaultNames(const Rig& before, Rig after, const Skeleton& skeleton);

}  // namespace sinew::app
