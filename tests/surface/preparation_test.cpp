// tests/surface/preparation_test.cpp: data shared between preparations, and use from several threads.

#include "core/surface/preparation.h"

#include <thread>

#include <gtest/gtest.h>

#include "core/geometry/normals.h"
#include "core/surface/projector.h"
#include "core/surface/smooth.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

struct Prepared {
  std::shared_ptr<const Character> character = makeLimb();
  std::shared_ptr<const CharacterTables> tables = characterTables(character);
  BlendingGraphMemo graphs;

  std::shared_ptr<const Preparation> operator()(const Rig& rig, const Preparation* former = nullptr,
                                                const PreparationOptions& options = {}) {
    return prepare(tables, rig, options, former, graphs).value();
  }
  Rig rig(std::uint64_t seed, SurfaceMode mode) const {
    Rig made = randomRig(*character, {.primitives = 6}, seed);
    made.surface.mode = mode;
    made.smoothing.depth = 3;
    return made;
  }
};

Surface surfaceOf(const std::shared_ptr<const Preparation>& preparation, const Pose& pose) {
  SmoothingMemory memory;
  Surface surface;
  smooth(preparation, preparation->poser->pose(pose), pose, std::nullopt, memory, surface);
  return surface;
}

void expectSame(const Surface& a, const Surface& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.classes, b.classes);
}

class SharedPreparations : public testing::TestWithParam<SurfaceMode> {};

TEST_P(SharedPreparations, ShareEverythingAShapeEditDoesNotAffect) {
  Prepared prepared;
  Rig rig = prepared.rig(3, GetParam());
  const auto before = prepared(rig);
  rig.primitives[1].placement.radii *= 1.1f;
  rig.primitives[2].sign = -rig.primitives[2].sign;
  const auto after = prepared(rig, before.get());
  EXPECT_EQ(after->attached, before->attached);
  EXPECT_EQ(after->seen, before->seen);
  EXPECT_EQ(after->refined, before->refined);
  EXPECT_EQ(after->tiles, before->tiles);
  EXPECT_EQ(after->bindFronts, before->bindFronts);
  EXPECT_EQ(after->anchors, before->anchors);
}

TEST_P(SharedPreparations, DoNotDependOnHistory) {
  Prepared prepared;
  std::shared_ptr<const Preparation> former;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rig rig = animatedLimbRig(*prepared.character, seed / 2);
    rig.surface.mode = seed % 3 == 0 ? GetParam() : SurfaceMode::kReplace;
    rig.smoothing.depth = 2 + static_cast<int>(seed % 2);
    rig.smoothing.creaseAngle = seed % 4 == 0 ? 30.0f : kNoCreases;
    const std::vector<int> hidden = seed % 3 == 1 ? std::vector<int>{0} : std::vector<int>{};
    const Pose pose = samplePose(prepared.character->skeleton, prepared.character->clips.front(), 0.7f);
    former = prepared(rig, former.get(), {hidden, {}, {}});
    expectSame(surfaceOf(former, pose), surfaceOf(prepared(rig, nullptr, {hidden, {}, {}}), pose));
  }
}

TEST_P(SharedPreparations, CanBeReadByConcurrentThreads) {
  Prepared prepared;
  Rig rig = animatedLimbRig(*prepared.character, 5);
  rig.surface.mode = GetParam();
  const auto preparation = prepared(rig);
  std::vector<Pose> poses;
  for (const float time : {0.1f, 0.5f, 0.9f, 1.3f}) {
    poses.push_back(samplePose(prepared.character->skeleton, prepared.character->clips.front(), time));
  }
  std::vector<Surface> together(poses.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    threads.emplace_back([&, i] { together[i] = surfaceOf(preparation, poses[i]); });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < poses.size(); ++i) expectSame(together[i], surfaceOf(preparation, poses[i]));
}

TEST_P(SharedPreparations, ProjectorsAgree) {
  Prepared prepared;
  const auto preparation = prepared(prepared.rig(7, GetParam()));
  const Pose pose = samplePose(prepared.character->skeleton, prepared.character->clips.front(), 0.6f);
  const PosedRig rig = preparation->poser->pose(pose);
  PosedField posed;
  poseFieldAndSkin(preparation, rig, pose, posed);
  std::vector<Surface> surfaces;
  for (const Projector& projector : projectors()) {
    Workspace workspace;
    Surface& surface = surfaces.emplace_back();
    surface.refinement = preparation->refined->refinement;
    evaluatePatch(*preparation, preparation->smoothing.patch, posed.control.positions, posed.control.normals,
                  surface.positions, surface.normals);
    surface.displacement.assign(surface.positions.size(), 0.0f);
    const FieldView field{posed.primitives, preparation->seen.get(), {}};
    projector.project({*preparation, posed, field}, pose, workspace, surface);
  }
  ASSERT_GE(surfaces.size(), 2u);
  int moved = 0;
  for (std::size_t v = 0; v < surfaces[0].positions.size(); ++v) {
    EXPECT_LT(glm::distance(surfaces[0].positions[v], surfaces[1].positions[v]), 1e-6f * prepared.character->height);
    moved += surfaces[0].displacement[v] != 0.0f ? 1 : 0;
  }
  EXPECT_GT(moved, 20);
}

INSTANTIATE_TEST_SUITE_P(Modes, SharedPreparations, testing::Values(SurfaceMode::kSwell, SurfaceMode::kReplace),
                         [](const auto& mode) { return std::string(nameOf(mode.param)); });

}  // namespace
}  // namespace sinew::test
