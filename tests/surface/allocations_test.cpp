// tests/surface/allocations_test.cpp: a frame allocates nothing once its buffers have grown.

#include "tests/support/allocations.h"

#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/instruction_set.h"
#include "sinew/surface/smoother.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

TEST(Allocations, AreCounted) {
  const std::int64_t before = allocations();
  const auto something = std::make_unique<int>(1);
  EXPECT_EQ(allocations(), before + 1) << *something;
}

class FrameAllocations : public testing::TestWithParam<SurfaceMode> {};

TEST_P(FrameAllocations, RepeatedFrameAllocatesNothing) {
  for (const TrialScene& scene : trialScenes()) {
    Rig rig = withMode(scene.rig, GetParam());
    rig.smoothing.detail = DetailKind::kUniform;
    rig.smoothing.depth = 4;
    rig.smoothing.autoDepth = false;
    const std::vector<Pose> poses = spreadPoses(*scene.character, 6);
    const float height = scene.character->height;
    for (const float crease : {180.0f, 30.0f}) {
      rig.smoothing.creaseAngle = crease;
      for (const std::optional<glm::vec3>& eye :
           {std::optional<glm::vec3>(), std::optional<glm::vec3>(glm::vec3(3.0f * height, height, 2.0f * height))}) {
        Smoother smoother(scene.character);
        ASSERT_TRUE(smoother.prepare(rig).ok());
        Surface surface;
        for (const Pose& pose : poses) smoother.smooth(pose, surface, eye);
        ASSERT_GT(surface.report.projected, 0) << scene.name;
        const std::int64_t before = allocations();
        for (const Pose& pose : poses) smoother.smooth(pose, surface, eye);
        EXPECT_EQ(allocations(), before) << scene.name << ", crease " << crease << (eye ? ", culled" : "");
      }
    }
  }
}

// Some vertices of each take the scalar path, which must not allocate either.
TEST(SearchAllocations, BundledRigsAllocateNothing) {
  for (const char* name : {"humanoid", "humanoid-wrapped", "horse-flex", "tangle"}) {
    TrialScene scene = bundledTrialScene(name);
    scene.rig.smoothing.tolerance = 0.003f;
    const std::vector<Pose> poses = spreadPoses(*scene.character, 3);
    for (const InstructionSet set : {chosenInstructionSet(), InstructionSet::kScalar}) {
      const InstructionSetScope scope(set);
      Smoother smoother(scene.character);
      ASSERT_TRUE(smoother.prepare(scene.rig).ok());
      Surface surface;
      for (const Pose& pose : poses) smoother.smooth(pose, surface);
      const std::int64_t before = allocations();
      for (const Pose& pose : poses) smoother.smooth(pose, surface);
      EXPECT_EQ(allocations(), before) << name << ", " << nameOf(set);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, FrameAllocations, testing::Values(SurfaceMode::kSwell, SurfaceMode::kReplace));

}  // namespace
}  // namespace sinew::test
