// tests/surface/crowd_test.cpp: a crowd's surfaces match one smoother's bit for bit, for any number of threads.

#include "sinew/surface/crowd_smoother.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <span>
#include <thread>
#include <vector>

#include "sinew/geometry/threads.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

class Crowd : public ::testing::TestWithParam<const char*> {};

TEST_P(Crowd, SurfacesMatchASingleSmoother) {
  const TrialScene scene = bundledTrialScene(GetParam());
  const std::vector<Pose> poses = spreadPoses(*scene.character, 23);
  CrowdSmoother crowd(scene.character);
  Smoother single(scene.character);
  std::vector<Surface> surfaces(poses.size());
  Surface wanted;
  for (const int depth : {2, 3}) {
    Rig rig = scene.rig;
    rig.smoothing.detail = DetailKind::kUniform;
    rig.smoothing.depth = depth;
    const std::vector<int> hidden(1, depth);  // The second time prepared again with other options.
    ASSERT_TRUE(crowd.prepare(rig, hidden).ok() && single.prepare(rig, hidden).ok());
    for (const int threads : {1, 2, 5}) {
      const ThreadLimit limit(threads);
      crowd.smooth(poses, surfaces);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        single.smooth(poses[i], wanted);
        ASSERT_EQ(surfaces[i].positions, wanted.positions) << i << " on " << threads;
        ASSERT_EQ(surfaces[i].normals, wanted.normals) << i << " on " << threads;
        ASSERT_EQ(surfaces[i].refinement, surfaces[0].refinement) << "one topology";
      }
    }
  }
}

TEST(CrowdCalls, AreThreadSafe) {
  const TrialScene scene = bundledTrialScene("demo");
  CrowdSmoother crowd(scene.character);
  ASSERT_TRUE(crowd.prepare(scene.rig).ok());
  const std::vector<Pose> poses = spreadPoses(*scene.character, 8);
  std::vector<Surface> wanted(poses.size());
  crowd.smooth(poses, wanted);
  std::vector<Surface> made(poses.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t first = 0; first < 4; ++first) {
      threads.emplace_back([&, first] {
        const ThreadLimit one(1);
        for (std::size_t i = first; i < poses.size(); i += 4) {
          crowd.smooth(std::span(poses).subspan(i, 1), std::span(made).subspan(i, 1));
        }
      });
    }
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(made[i].positions, wanted[i].positions) << i;
    EXPECT_EQ(made[i].normals, wanted[i].normals) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Rigs, Crowd, ::testing::Values("humanoid", "humanoid-flex", "horse-flex"),
                         [](const auto& rig) {
                           std::string name = rig.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(CrowdCalls, RefusedPoseKeepsOnlyItsOwnSurface) {
  const TrialScene scene = bundledTrialScene("demo");
  CrowdSmoother crowd(scene.character);
  ASSERT_TRUE(crowd.prepare(scene.rig).ok());
  std::vector<Pose> poses = spreadPoses(*scene.character, 6);
  std::vector<Surface> surfaces(poses.size());
  ASSERT_TRUE(crowd.smooth(poses, surfaces));
  const std::vector<Surface> before = surfaces;
  std::ranges::reverse(poses);
  poses[1].boneInWorld.pop_back();
  poses[4].boneInWorld[0][3][1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(crowd.smooth(poses, surfaces));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool refused = i == 1 || i == 4;
    EXPECT_EQ(surfaces[i].positions, before[refused ? i : poses.size() - 1 - i].positions) << i;
  }
}

TEST(EmptyCrowd, IsAccepted) {
  const TrialScene scene = bundledTrialScene("demo");
  CrowdSmoother crowd(scene.character);
  ASSERT_TRUE(crowd.prepare(scene.rig).ok());
  EXPECT_TRUE(crowd.smooth({}, {}));
}

TEST(EmptyCrowd, RefusedRigKeepsThePreviousOne) {
  const TrialScene scene = bundledTrialScene("demo");
  CrowdSmoother crowd(scene.character);
  ASSERT_TRUE(crowd.prepare(scene.rig).ok());
  Rig bad = scene.rig;
  bad.smoothing.detail = DetailKind::kUniform;
  bad.smoothing.depth = -1;
  EXPECT_FALSE(crowd.prepare(bad).ok());
  const std::vector<Pose> poses = spreadPoses(*scene.character, 3);
  std::vector<Surface> surfaces(poses.size());
  crowd.smooth(poses, surfaces);
  EXPECT_EQ(surfaces[0].report.depth, scene.rig.smoothing.depth);
}

}  // namespace
}  // namespace sinew::test
