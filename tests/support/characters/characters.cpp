// tests/support/characters/characters.cpp: paths of the real characters.

#include "tests/support/characters/characters.h"

namespace sinew::test {

std::optional<std::filesystem::path> characterFile(const std::string& file) {
  std::filesystem::path path = std::filesystem::path(SINEW_CHARACTERS_DIR) / file;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  return path;
}

}  // namespace sinew::test
