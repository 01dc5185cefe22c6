// tests/smoothing/threads_test.cpp: one surface made by several threads is that of one thread, bit for bit.

#include <gtest/gtest.h>

#include "sinew/base/threads.h"
#include "sinew/smoothing/smoother.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

constexpr int kSharedDepth = 7;  // Every bundled character is large enough to be shared out.
constexpr int kLeastVertices = 10'000;

class Threads : public ::testing::TestWithParam<const char*> {
 protected:
  TrialScene scene_ = bundledTrialScene(GetParam());

  /// One thread's surfaces against those of several, of a smoother each.
  void expectSame(const Rig& rig) {
    const std::vector<Pose> poses = spreadPoses(*scene_.character, 5);
    Smoother one(scene_.character);
    Smoother several(scene_.character);
    ASSERT_TRUE(one.prepare(rig).ok() && several.prepare(rig).ok());
    Surface wanted;
    Surface surface;
    for (const Pose& pose : poses) {
      {
        const ThreadLimit limit(1);
        one.smooth(pose, wanted);
      }
      ASSERT_GT(wanted.positions.size(), static_cast<std::size_t>(kLeastVertices));
      ASSERT_GT(wanted.report.projected, 100);
      for (const int threads : {2, 3, 0}) {
        const ThreadLimit limit(threads);
        several.smooth(pose, surface);
        ASSERT_EQ(surface.positions, wanted.positions) << threads;
        ASSERT_EQ(surface.normals, wanted.normals) << threads;
        ASSERT_EQ(surface.shadingNormals, wanted.shadingNormals) << threads;
        ASSERT_EQ(surface.displacement, wanted.displacement) << threads;
        EXPECT_EQ(surface.report.projected, wanted.report.projected);
        EXPECT_EQ(surface.report.uncertified, wanted.report.uncertified);
        EXPECT_EQ(surface.report.evaluations.field, wanted.report.evaluations.field);
        EXPECT_EQ(surface.report.residualMax, wanted.report.residualMax);
      }
    }
  }
};

TEST_P(Threads, MakeTheSameSurfaceInBothModes) {
  Rig rig = scene_.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = kSharedDepth;
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    rig.surface.mode = mode;
    expectSame(rig);
  }
}

TEST_P(Threads, MakeTheSameCreases) {
  Rig rig = scene_.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = kSharedDepth;
  rig.smoothing.creaseAngle = 30.0f;
  rig.smoothing.patch = PatchKind::kPhong;
  expectSame(rig);
}

INSTANTIATE_TEST_SUITE_P(Rigs, Threads, ::testing::Values("humanoid", "horse", "demo", "wrapped"),
                         [](const auto& rig) { return std::string(rig.param); });

}  // namespace
}  // namespace sinew::test
