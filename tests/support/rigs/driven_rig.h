// tests/support/rigs/driven_rig.h: a rig with the parameter values of a pose.
#pragma once

#include "core/rig/posed_rig.h"

namespace sinew::test {

/// The rig with its parameter values in a pose; keys and drivers stay.
[[nodiscard]] Rig withNumbers(Rig rig, const RigNumbers& numbers);
[[nodiscard]] Rig drivenRig(const Rig& rig, const Character& character, const Pose& pose);

}  // namespace sinew::test
