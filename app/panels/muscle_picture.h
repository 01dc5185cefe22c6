// app/panels/muscle_picture.h: a small picture of a muscle on a body.
#pragma once

#include "app/viewport/render/viewport.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

inline constexpr glm::ivec2 kMusclePicture{208, 140};

/// The bind pose in clay, seen level from the muscle's side; skin over it and its twin is red. Needs no OpenGL context.
/// @param muscles  on bones; the first is in the middle  @param least  least height of the picture, fraction of H
[[nodiscard]] Image musclePicture(const Character& character, std::span<const Primitive> muscles, float least);

}  // namespace sinew::app
