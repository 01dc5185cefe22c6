// tests/files/mentions.h: notes of an import about dropped content.
#pragma once

#include <algorithm>
#include <string>

#include "sinew/character/character.h"

namespace sinew::test {

inline bool mentions(const Character& character, const std::string& what) {
  return std::ranges::any_of(character.ignored,
                             [&](const std::string& line) { return line.find(what) != std::string::npos; });
}

}  // namespace sinew::test
