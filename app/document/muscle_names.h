// app/document/muscle_names.h: how the history calls what a step changed.
#pragma once

#include <span>
#include <string>

#include "sinew/rig/rig.h"

namespace sinew::app {

/// "biceps L", or "3 muscles". @param indices  into the rig, in range
[[nodiscard]] std::string namedMuscles(const Rig& rig, std::span<const int> indices);

}  // namespace sinew::app
