// tests/support/characters/real_characters.cpp: characters from the folder of real files.

#include "tests/support/characters/real_characters.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"

namespace sinew::test {

std::shared_ptr<const Character> realCharacter(const std::string& file) {
  const std::filesystem::path path = std::filesystem::path(SINEW_CHARACTERS_DIR) / file;
  if (!std::filesystem::exists(path)) return nullptr;
  auto imported = importGltf(path);
  if (!imported) {
    ADD_FAILURE() << imported.error().text();
    return nullptr;
  }
  return imported.value();
}

}  // namespace sinew::test
