// tests/surface/projection/vector_replace_test.cpp: vectorized `replace` matches the scalar path, and gives the same
// bits with every instruction set.

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/projected.h"
#include "tests/support/surface/vector_agreement.h"

namespace sinew::test {
namespace {

std::vector<TrialScene> scenes() {
  std::vector<TrialScene> out = trialScenes();
  for (const char* name : {"humanoid-wrapped", "horse-wrapped", "humanoid", "demo", "horse-flex"}) {
    out.push_back(bundledTrialScene(name));
  }
  return out;
}

TEST(VectorReplace, MatchesTheScalarOnCharacters) {
  for (const TrialScene& scene : scenes()) {
    Agreement seen;
    addAgreement(*scene.character, withMode(scene.rig, SurfaceMode::kReplace), spreadPoses(*scene.character, 4), seen);
    print(scene.name, seen);
    EXPECT_GT(seen.projected, 50) << scene.name;
    EXPECT_EQ(seen.far, 0) << scene.name;
    EXPECT_LE(seen.uncertifiedShare(), 0.025) << scene.name;
  }
}

TEST(VectorReplace, EveryInstructionSetGivesTheSameBits) {
  for (const TrialScene& scene : scenes()) {
    Projected projected(*scene.character, withMode(scene.rig, SurfaceMode::kReplace));
    for (const Pose& pose : spreadPoses(*scene.character, 2)) {
      const Surface widest = projected.at(pose);
      for (const InstructionSet set : availableInstructionSets()) {
        if (set == InstructionSet::kScalar) continue;
        const Surface other = surfaceBy(set, projected, pose);
        EXPECT_TRUE(other.positions == widest.positions) << scene.name << ", " << nameOf(set);
        EXPECT_TRUE(other.normals == widest.normals) << scene.name << ", " << nameOf(set);
        EXPECT_TRUE(other.displacement == widest.displacement) << scene.name << ", " << nameOf(set);
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
