// tests/files/no_harm.h: allowed results of importing a damaged file: an actionable one-line error, or a character.
#pragma once

#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {

/// One line that contains the file's name and more.
inline void expectOneLine(const Error& error, const std::filesystem::path& file) {
  const std::string line = error.text();
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_EQ(line.find(file.string()), 0u) << line;
  EXPECT_FALSE(error.reason.empty());
  EXPECT_LT(line.size(), 600u) << line;
}

/// The result is either a character or a proper error.
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
