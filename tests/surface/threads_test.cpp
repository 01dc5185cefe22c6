// tests/surface/threads_test.cpp: a surface computed by several threads matches a single thread's, bit for bit.

#include <gtest/gtest.h>

#include "core/rig/trial_rig.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/stand_ins.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

constexpr int kSharedDepth = 7;  // Every bundled character has enough patches and roots to be distributed.
constexpr int kLeastVertices = 10'000;

/// Compares one thread's surfaces with those of several threads, each with its own smoother prepared by several
/// threads.
void expectSame(const std::shared_ptr<const Character>& character, const Rig& rig) {
  Smoother one(character);
  Smoother several(character);
  {
    const ThreadLimit limit(1);
    ASSERT_TRUE(one.prepare(rig).ok());
  }
  ASSERT_TRUE(several.prepare(rig).ok());
  Surface wanted;
  Surface surface;
  for (const Pose& pose : spreadPoses(*character, 5)) {
    {
      const ThreadLimit limit(1);
      one.smooth(pose, wanted);
    }
    ASSERT_GT(wanted.positions.size(), static_cast<std::size_t>(kLeastVertices));
    ASSERT_GT(wanted.report.projected, 100);
    for (const int threads : {2, 3, 0}) {
      const ThreadLimit limit(threads);
      several.smooth(pose, surface);
      ASSERT_EQ(surface.refinement->triangles, wanted.refinement->triangles);
      ASSERT_EQ(surface.classes, wanted.classes);
      ASSERT_EQ(surface.positions, wanted.positions) << threads;
      ASSERT_EQ(surface.normals, wanted.normals) << threads;
      ASSERT_EQ(surface.shadingNormals, wanted.shadingNormals) << threads;
      ASSERT_EQ(surface.displacement, wanted.displacement) << threads;
      EXPECT_EQ(surface.report.projected, wanted.report.projected);
      EXPECT_EQ(surface.report.uncertified, wanted.report.uncertified);
      EXPECT_EQ(surface.report.residualMax, wanted.report.residualMax);
    }
  }
}

class Threads : public ::testing::TestWithParam<const char*> {
 protected:
  TrialScene scene_ = bundledTrialScene(GetParam());
};

TEST_P(Threads, GiveTheSameSurfaceInBothModes) {
  Rig rig = scene_.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = kSharedDepth;
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    rig.surface.mode = mode;
    expectSame(scene_.character, rig);
  }
}

TEST_P(Threads, GiveTheSameCreases) {
  Rig rig = scene_.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = kSharedDepth;
  rig.smoothing.creaseAngle = 30.0f;
  rig.smoothing.patch = PatchKind::kPhong;
  expectSame(scene_.character, rig);
}

// Stages over control triangles or control vertices use several threads only above some thousands of them.
TEST(ThreadsOnAFineBody, GiveTheSameSurface) {
  const auto character = fineHumanoid();
  Rig rig = trialRig(*character, 14, 3);
  rig.smoothing.depth = 1;
  for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
    rig.smoothing.detail = detail;
    expectSame(character, rig);
  }
}

INSTANTIATE_TEST_SUITE_P(Rigs, Threads, ::testing::Values("humanoid", "horse", "demo", "wrapped"),
                         [](const auto& rig) { return std::string(rig.param); });

}  // namespace
}  // namespace sinew::test
