// tests/fuzz/found_test.cpp: inputs that once broke a promise, the seeds, and some thousand changes of them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/gltf_mutator.h"
#include "tests/fuzz/seeds.h"

namespace sinew::fuzz {
namespace {

namespace fs = std::filesystem;

class FuzzTarget : public testing::TestWithParam<Target> {};

// A broken promise ends the process, so that the test fails with its line.
TEST_P(FuzzTarget, FoundInputsKeepTheInvariants) {
  const fs::path folder = fs::path(SINEW_SOURCE_DIR) / "tests/fuzz/found" / GetParam().name;
  std::vector<fs::path> files;
  if (fs::exists(folder)) std::ranges::copy(fs::directory_iterator(folder), std::back_inserter(files));
  std::ranges::sort(files);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.string());
    std::ifstream in(file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    ASSERT_FALSE(bytes.empty());
    GetParam().run(bytes);
  }
}

std::string withFlips(std::string bytes, std::mt19937& random) {
  if (bytes.empty()) return "x";
  for (unsigned flips = 1 + random() % 4; flips > 0; --flips) {
    bytes[random() % bytes.size()] = static_cast<char>(random());
  }
  return bytes;
}

TEST_P(FuzzTarget, MutatedSeedsKeepTheInvariants) {
  constexpr unsigned kChanges = 240;
  std::mt19937 random(7);
  const auto mutateBytes = [&](std::string bytes, std::size_t) { return withFlips(std::move(bytes), random); };
  for (const Seed& seed : seedsOf(GetParam().name)) {
    GetParam().run(seed.bytes);
    std::string bytes = seed.bytes;
    for (unsigned i = 0; i < kChanges; ++i) {
      // Every sixth begins with the seed again.
      bytes = mutated(i % 6 == 0 ? seed.bytes : bytes, 2 * seed.bytes.size(), i, mutateBytes);
      GetParam().run(bytes);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzTarget, testing::ValuesIn(allTargets().begin(), allTargets().end()),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(GltfMutator, KeepsTheLengthsOfAGlbConsistent) {
  std::mt19937 random(3);
  const auto mutateBytes = [&](std::string bytes, std::size_t) { return withFlips(std::move(bytes), random); };
  int whole = 0;
  for (const Seed& seed : seedsOf("import")) {
    if (!seed.bytes.starts_with("glTF")) continue;
    for (unsigned i = 0; i < 40; ++i) {
      const std::string bytes = mutated(seed.bytes, 4 * seed.bytes.size(), i, mutateBytes);
      ASSERT_GE(bytes.size(), 20u);
      std::uint32_t length = 0;
      std::copy_n(bytes.data() + 8, 4, reinterpret_cast<char*>(&length));
      whole += length == bytes.size();
    }
  }
  EXPECT_GT(whole, 8 * 40 * 3 / 4);
}

}  // namespace
}  // namespace sinew::fuzz
