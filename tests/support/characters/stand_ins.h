// tests/support/characters/stand_ins.h: characters like those of games, made from the bundled ones: irregular, fine, in
// parts.
#pragma once

#include <memory>

#include "sinew/character/character.h"

namespace sinew::test {

/// The bundled horse in 1,648 triangles of uneven size and shape: vertices moved within the skin, edges flipped.
[[nodiscard]] std::shared_ptr<const Character> irregularHorse();

/// The bundled humanoid in 47,952 triangles.
[[nodiscard]] std::shared_ptr<const Character> fineHumanoid();

/// The bundled humanoid in 2,368 triangles and eight parts (head, trunk, arms, forearms with hands, legs) that share no
/// vertex: borders are open, and slightly smaller than those they meet.
[[nodiscard]] std::shared_ptr<const Character> humanoidInParts();

}  // namespace sinew::test
