// tests/support/characters/characters.h: paths of the real characters' files, if available.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sinew::test {

/// SINEW_CHARACTERS_DIR/file, or nullopt where it is absent: then the test calls SINEW_SKIP_WITHOUT_CHARACTERS.
[[nodiscard]] std::optional<std::filesystem::path> characterFile(const std::string& file);

}  // namespace sinew::test

#define SINEW_SKIP_WITHOUT_CHARACTERS() GTEST_SKIP() << "left out: real characters are not at hand"
