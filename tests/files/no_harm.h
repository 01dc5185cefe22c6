// tests/files/no_harm.h: what an import of a damaged file may come to: one line that a person can act on, or a
// character.
#pragma once

#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {

/// One line, with the file's name, saying more than that.
inline void expectOneLine(const Error& error, const std::filesystem::path& file) {
  const std::string line = error.text();
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_EQ(line.find(file.string()), 0u) << line;
  EXPECT_FALSE(error.reason.empty());
  EXPECT_LT(line.size(), 600u) << line;
}

/// Whatever comes back, it is a character or a proper error.
inline void expectNoHarm(const std::filesystem::path& file) {
  const auto imported = importGltf(file);
  if (!imported) {
    expectOneLine(imported.error(), file);
    return;
  }
  for (const glm::vec3& p : imported.value()->mesh.positions) ASSERT_TRUE(isFinite(p));
  for (const Bone& bone : imported.value()->skeleton.bones) {
    ASSERT_TRUE(isFinite(bone.bindInWorld) && isFinite(bone.inverseBindInWorld));
  }
  ASSERT_GT(imported.value()->height, 0.0f);
}

inline void flipBytes(const std::string& whole, const std::string& name, unsigned seeds) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < seeds; ++seed) {
    std::mt19937 random(seed);
    std::string damaged = whole;
    for (unsigned flips = 1 + random() % 8; flips > 0; --flips)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    expectNoHarm(folder.write(name, damaged));
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

}  // namespace sinew::test
