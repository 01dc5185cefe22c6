// tests/tools/pops_test.cpp: skin over muscles laid with the tool's defaults pops nowhere, over random ones rarely.

#include "tests/support/surface/pops.h"

#include <cstdio>

#include <gtest/gtest.h>

#include "sinew/io/gltf_import.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/tools/laid_muscles.h"

namespace sinew::test {
namespace {

std::shared_ptr<const Character> bundled(const std::string& name) {
  return importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / (name + ".glb")).value();
}

void print(const char* name, const char* laid, const Pops& seen) {
  std::printf("  %-9s %-8s %5d frames: %lld steps over 0.5 %% H, up to %.2f %%; %lld pop\n", name, laid, seen.frames,
              seen.steps, 100.0 * static_cast<double>(seen.largestStep), seen.pops);
}

// Before slopes were bounded there were 5 and 184 pops (sinew_bench pops).
TEST(Pops, ThereAreNoneOverMusclesLaidWithTheToolsDefaults) {
  for (const char* name : {"horse", "humanoid"}) {
    const auto character = bundled(name);
    const Pops seen = countPops(character, layMuscles(character), 240);
    print(name, "by tool", seen);
    EXPECT_GT(seen.moved, 10'000) << name;
    EXPECT_EQ(seen.pops, 0) << name;
  }
}

// At most a twentieth of what there was before slopes were bounded; `sinew_bench pops` looks at more rigs.
TEST(Pops, AreRareOverRandomMusclesOfShortReach) {
  const struct {
    const char* name;
    int most;
  } kWere[] = {{"horse", 6}, {"humanoid", 30}};
  for (const auto& [name, most] : kWere) {
    const auto character = bundled(name);
    const Pops seen = countPops(character, randomRig(*character, kShortReach, 1));
    print(name, "random", seen);
    EXPECT_GT(seen.moved, 10'000) << name;
    EXPECT_LE(seen.pops, most) << name;
  }
}

}  // namespace
}  // namespace sinew::test
