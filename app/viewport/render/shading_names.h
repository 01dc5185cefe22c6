// app/viewport/render/shading_names.h: what files, the command line and the state log call the shadings.
#pragma once

#include <array>
#include <cstddef>

#include "app/viewport/render/scene.h"

namespace sinew::app {

inline constexpr std::array kShadingNames{"textured", "clay", "classes", "heat"};

[[nodiscard]] inline const char* nameOf(Shading shading) { return kShadingNames[static_cast<std::size_t>(shading)]; }

}  // namespace sinew::app
