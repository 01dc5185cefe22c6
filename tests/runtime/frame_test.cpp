// tests/runtime/frame_test.cpp: a game's frame: no allocation, refused poses, its own threads, its own bones.
#include <array>
#include <atomic>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "core/geometry/parallel.h"
#include "sinew/character/local_pose.h"
#include "sinew/character/pose_check.h"
#include "sinew/geometry/task_system.h"
#include "sinew/rig/mirror_edit.h"
#include "sinew/runtime/vertex_buffer.h"
#include "sinew/surface/smoother.h"
#include "tests/support/allocations.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

TEST(GameFrame, LocalsToBufferAllocatesNothing) {
  const TrialScene scene = bundledTrialScene("horse-flex");
  const Skeleton& skeleton = scene.character->skeleton;
  Smoother smoother(scene.character);
  ASSERT_TRUE(smoother.prepare(scene.rig).ok());
  std::vector<glm::quat> turns;
  std::vector<glm::vec3> places, sizes;
  for (const Bone& bone : skeleton.bones) {
    const LocalTransform& rest = skeleton.nodes[static_cast<std::size_t>(bone.node)].rest;
    turns.push_back(rest.rotation);
    places.push_back(rest.translation);
    sizes.push_back(rest.scale);
  }
  std::vector<glm::dmat4> scratch;
  Pose pose;
  Surface surface;
  std::vector<std::byte> buffer;
  const auto frame = [&](float angle) {
    turns[3] = skeleton.nodes[static_cast<std::size_t>(skeleton.bones[3].node)].rest.rotation *
               glm::angleAxis(angle, glm::vec3(1.0f, 0.0f, 0.0f));
    return poseFromLocals(skeleton, {turns, places, sizes}, scratch, pose).ok() && smoother.smooth(pose, surface) &&
           writeVertices(surface, {}, buffer).ok();
  };
  EXPECT_FALSE(frame(0.0f)) << "a buffer without bytes";
  buffer.resize(24 * vertexCount(*surface.refinement, BufferVertices::kDrawn));
  for (const float angle : {0.0f, 0.2f, 0.4f}) ASSERT_TRUE(frame(angle));
  const std::int64_t before = allocations();
  bool done = true;
  for (const float angle : {0.0f, 0.2f, 0.4f}) done = frame(angle) && done;
  EXPECT_EQ(allocations(), before);
  EXPECT_TRUE(done);
}

TEST(GameFrame, RefusedPoseKeepsTheLastSurfaceAndGivesAReason) {
  const auto limb = makeLimb();
  Smoother smoother(limb);
  ASSERT_TRUE(smoother.prepare(animatedLimbRig(*limb, 1)).ok());
  const Pose good = bindPose(limb->skeleton);
  Surface surface;
  ASSERT_TRUE(smoother.smooth(good, surface));
  const Surface last = surface;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<std::pair<Pose, const char*>> bad(6, {good, ""});
  bad[0].first.boneInWorld.pop_back();
  bad[0].second = "expected matrices of";
  bad[1].first.boneInWorld.clear();
  bad[1].second = "got 0";
  bad[2].first.boneInWorld[1][3][0] = nan;
  bad[2].second = "bone 1 \"";
  bad[3].first.flex = nan;
  bad[3].second = "flex";
  bad[4].first.time = std::numeric_limits<float>::infinity();
  bad[4].second = "time";
  bad[5].first.morphWeights = std::vector<float>(limb->morphTargets.size() + 1, 0.5f);
  bad[5].second = "morph targets or none";
  for (const auto& [pose, words] : bad) {
    const std::int64_t before = allocations();
    EXPECT_FALSE(smoother.smooth(pose, surface)) << words;
    EXPECT_EQ(allocations(), before);
    EXPECT_TRUE(surface.positions == last.positions && surface.normals == last.normals) << words;
    const auto checked = checkPose(*limb, pose);
    ASSERT_FALSE(checked.ok()) << words;
    EXPECT_NE(checked.error().text().find(words), std::string::npos) << checked.error().text();
  }
  EXPECT_TRUE(checkPose(*limb, good).ok());
  EXPECT_TRUE(smoother.smooth(good, surface));
}

/// A game's tasks, each on its own thread, started in reverse order.
struct Threads {
  std::atomic<int> calls{0};
  std::atomic<int> tasks{0};

  static void run(void* user, int tasks, void (*task)(void*, int), void* work) {
    auto& self = *static_cast<Threads*>(user);
    ++self.calls;
    self.tasks += tasks;
    std::vector<std::thread> threads;
    for (int i = tasks - 1; i >= 0; --i) threads.emplace_back(task, work, i);
    for (std::thread& thread : threads) thread.join();
  }
};

/// While alive, tasks run on these threads.
class OnThreads {
 public:
  explicit OnThreads(Threads& threads, int count) { setTaskSystem({&Threads::run, &threads, count}); }
  ~OnThreads() { setTaskSystem({}); }
  OnThreads(const OnThreads&) = delete;
  OnThreads& operator=(const OnThreads&) = delete;
};

TEST(GameTasks, GiveTheSameSurfaceBitForBit) {
  const TrialScene scene = bundledTrialScene("humanoid");
  const Pose pose = spreadPoses(*scene.character, 2).back();
  const auto smoothed = [&] {
    Smoother smoother(scene.character);
    EXPECT_TRUE(smoother.prepare(scene.rig).ok());
    Surface surface;
    smoother.smooth(pose, surface);
    return surface;
  };
  const Surface expected = smoothed();
  for (const int count : {2, 3, 7}) {
    Threads threads;
    const OnThreads scope(threads, count);
    EXPECT_EQ(threadCount(), count);
    const Surface surface = smoothed();
    EXPECT_TRUE(surface.positions == expected.positions && surface.normals == expected.normals) << count;
    EXPECT_GT(threads.calls, 0);
  }
}

TEST(GameTasks, VisitEveryIndexOnceWithinLimits) {
  Threads threads;
  const OnThreads scope(threads, 5);
  for (const std::size_t count : {1U, 2U, 7U, 1000U}) {
    for (const std::size_t least : {1U, 3U, 64U}) {
      std::vector<std::atomic<int>> seen(count);
      forEachIndex(count, least, [&](std::size_t i) { ++seen[i]; });
      for (const auto& times : seen) EXPECT_EQ(times, 1);
    }
  }
  const ThreadLimit two(2);
  threads.tasks = 0;
  forEachIndex(1000, 1, [](std::size_t) { EXPECT_LE(threadCount(), 2); });
  EXPECT_EQ(threads.tasks, 2);
  const ThreadLimit one(1);
  threads.calls = 0;
  forEachIndex(1000, 1, [](std::size_t) {});
  EXPECT_EQ(threads.calls, 0);
}

TEST(GameTasks, ExceptionsReachTheCaller) {
  Threads threads;
  const OnThreads scope(threads, 3);
  EXPECT_THROW(forEachIndex(100, 1,
                            [](std::size_t i) {
                              if (i == 42) throw std::bad_alloc();
                            }),
               std::bad_alloc);
}

TEST(BoneLocals, GiveThePoseAtRestAndInEveryClip) {
  const TrialScene scene = bundledTrialScene("humanoid");
  const Skeleton& skeleton = scene.character->skeleton;
  const auto rest = poseFromLocals(skeleton, {});
  ASSERT_TRUE(rest.ok());
  EXPECT_EQ(rest->boneInWorld, restPose(skeleton).boneInWorld);
  // Rotating a bone about its own axis takes its descendants along: compared with multiplying all of them.
  std::vector<glm::quat> turns;
  for (const Bone& bone : skeleton.bones) {
    turns.push_back(skeleton.nodes[static_cast<std::size_t>(bone.node)].rest.rotation);
  }
  const auto turned = static_cast<std::size_t>(*skeleton.findBone("upper_arm.L"));
  const glm::quat turn = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1.0f, 2.0f, 3.0f)));
  turns[turned] = turns[turned] * turn;
  const auto pose = poseFromLocals(skeleton, {.rotations = turns});
  ASSERT_TRUE(pose.ok());
  const glm::mat4 whole = rest->boneInWorld[turned] * glm::mat4_cast(turn) * glm::inverse(rest->boneInWorld[turned]);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    bool below = false;
    for (int up = static_cast<int>(b); up >= 0; up = skeleton.bones[static_cast<std::size_t>(up)].parent) {
      below = below || static_cast<std::size_t>(up) == turned;
    }
    const glm::mat4 expected = below ? whole * rest->boneInWorld[b] : rest->boneInWorld[b];
    for (int c = 0; c < 4; ++c) {
      EXPECT_LE(glm::distance(pose->boneInWorld[b][c], expected[c]), 1e-5f * scene.character->height) << b;
    }
  }
}

TEST(BoneLocals, RefuseInvalidInput) {
  Skeleton skeleton = makeLimb()->skeleton;
  const std::vector<glm::quat> few(skeleton.bones.size() - 1, glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
  EXPECT_FALSE(poseFromLocals(skeleton, {.rotations = few}).ok());
  std::vector<glm::vec3> scales(skeleton.bones.size(), glm::vec3(1.0f));
  EXPECT_TRUE(poseFromLocals(skeleton, {.scales = scales}).ok());
  skeleton.nodes[static_cast<std::size_t>(skeleton.bones[0].node)].rest.matrix = glm::mat4(1.0f);
  const auto mixed = poseFromLocals(skeleton, {.scales = scales});
  ASSERT_FALSE(mixed.ok());
  EXPECT_NE(mixed.error().text().find("rests by a matrix"), std::string::npos);
  scales[1].y = std::numeric_limits<float>::infinity();
  const auto odd = poseFromLocals(skeleton, {.scales = scales});
  ASSERT_FALSE(odd.ok());
  EXPECT_NE(odd.error().text().find("scales[1]"), std::string::npos) << odd.error().text();
}

TEST(LevelOfDetail, SharedSmootherMatchesAStandaloneOne) {
  const TrialScene scene = bundledTrialScene("demo");
  Smoother fine(scene.character);
  ASSERT_TRUE(fine.prepare(scene.rig).ok());
  Smoother coarse = fine.twin();
  Rig rig = scene.rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 1;
  ASSERT_TRUE(coarse.prepare(rig).ok());
  Smoother alone(scene.character);
  ASSERT_TRUE(alone.prepare(rig).ok());
  Surface shared, own, finer;
  const Pose pose = spreadPoses(*scene.character, 1).back();
  ASSERT_TRUE(coarse.smooth(pose, shared) && alone.smooth(pose, own) && fine.smooth(pose, finer));
  EXPECT_TRUE(shared.positions == own.positions && shared.normals == own.normals);
  EXPECT_GT(finer.positions.size(), own.positions.size());
}

TEST(MirrorEdits, AddAPairOnBothSides) {
  const TrialScene scene = bundledTrialScene("humanoid");
  const MirrorEdits mirror(*scene.character);
  ASSERT_TRUE(mirror.usable());
  Primitive muscle;
  muscle.name = "biceps L";
  muscle.bone = "upper_arm.L";
  const auto rig = mirror.addPair(Rig(), muscle);
  ASSERT_TRUE(rig.ok()) << rig.error().text();
  ASSERT_EQ(rig->primitives.size(), 2U);
  EXPECT_EQ(rig->primitives[1].name, "biceps R");
  EXPECT_EQ(rig->primitives[1].bone, "upper_arm.R");
  EXPECT_EQ(rig->primitives[1].mirror, "biceps L");
  muscle.bone = "nobody";
  EXPECT_FALSE(mirror.addPair(Rig(), muscle).ok());
  const AnimationClip clip = rangeOfMotion(*scene.character);
  EXPECT_GT(clip.channels.size(), 10U);
  EXPECT_EQ(samplePose(scene.character->skeleton, clip, 0.0f).boneInWorld,
            bindPose(scene.character->skeleton).boneInWorld);
}

}  // namespace
}  // namespace sinew::test
