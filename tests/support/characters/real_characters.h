// tests/support/characters/real_characters.h: third-party characters, where available.
#pragma once

#include <memory>
#include <string>

#include "sinew/character/character.h"

namespace sinew::test {

/// Imports a file of SINEW_CHARACTERS_DIR; null if it is absent there (then GTEST_SKIP). An import that fails on a file
/// that is there fails the test.
[[nodiscard]] std::shared_ptr<const Character> realCharacter(const std::string& file);

}  // namespace sinew::test
