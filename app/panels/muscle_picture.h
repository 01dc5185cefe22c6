// app/panels/muscle_picture.h: a small picture of where a muscle is on a body.
#pragma once

#include "app/viewport/render/viewport.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

inline constexpr glm::ivec2 kMusclePicture{208, 140};

/// The bind pose in clay, seen level from the side that the muscle lies on, with the skin over it and its twin in red.
/// Drawn by the processor: no OpenGL context is needed.
/// @param muscles  attached to bones of the character; the first one is in the middle
/// @param least    of H: the picture is at least so high
[[nodiscard]] Image musclePicture(const Character& character, std::span<const Primitive> muscles, float least);

}  // namespace sinew::app
