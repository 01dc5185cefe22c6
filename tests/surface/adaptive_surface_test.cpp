// tests/surface/adaptive_surface_test.cpp: adaptive detail: depends only on character and rig, closed, within
// tolerance, no more vertices than needed.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/geometry/at.h"
#include "core/geometry/weld.h"
#include "core/surface/adaptive_levels.h"
#include "core/surface/patches/levels.h"
#include "core/surface/smooth.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/crowd_smoother.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/body_with_arms.h"
#include "tests/support/characters/stand_ins.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/euler_characteristic.h"
#include "tests/support/long_run.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

constexpr float kCoarse = 0.002f;  ///< Tolerance where any will do: a third of the time of the default.

Rig adaptiveRig(const Character& character, std::uint64_t seed, float tolerance = kDefaultTolerance) {
  Rig rig = randomRig(character, {.primitives = 6}, seed);
  rig.smoothing.detail = DetailKind::kAdaptive;
  rig.smoothing.tolerance = tolerance;
  return rig;
}

struct Prepared {
  CharacterPtr character = makeLimb();
  std::shared_ptr<const CharacterTables> tables = characterTables(character);
  BlendingGraphMemo graphs{};

  std::shared_ptr<const Preparation> operator()(const Rig& rig, const Preparation* former = nullptr,
                                                const PreparationOptions& options = {}) {
    return prepare(tables, rig, options, former, graphs).value();
  }
};

TEST(AdaptiveSurface, IsClosedIfTheMeshIs) {
  for (const CharacterPtr& character : {makeLimb(), makeTube(), makeBodyWithArms()}) {
    const Topology control = topologyOf(character->mesh);
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      Smoother smoother(character);
      ASSERT_TRUE(smoother.prepare(adaptiveRig(*character, seed, kCoarse)).ok());
      Surface surface;
      smoother.smooth(bindPose(character->skeleton), surface);
      const Topology topology = topologyOf(surface.refinement->triangles);
      EXPECT_EQ(eulerCharacteristic(topology), eulerCharacteristic(control));
      EXPECT_EQ(topology.closed(), control.closed());
    }
  }
}

// A drag, undo and earlier edits leave no trace.
TEST(AdaptiveSurface, LevelsDependOnlyOnTheRig) {
  Prepared prepared;
  std::shared_ptr<const Preparation> former;
  for (std::uint64_t seed = 0; seed < (longRun() ? 24u : 9u); ++seed) {
    Rig rig =
        seed % 3 == 2 ? animatedLimbRig(*prepared.character, seed / 6) : adaptiveRig(*prepared.character, seed / 6);
    rig.smoothing.detail = DetailKind::kAdaptive;
    if (seed % 2 == 1) rig.primitives[seed % rig.primitives.size()].placement.radii *= 1.2f;
    if (seed % 5 == 4) rig.smoothing.tolerance = 0.003f;
    former = prepared(rig, former.get());
    const auto fresh = prepared(rig);
    ASSERT_EQ(former->detail->needed, fresh->detail->needed) << seed;
    ASSERT_EQ(former->refinement().triangles, fresh->refinement().triangles) << seed;
  }
}

TEST(AdaptiveSurface, UndoAndRedoGiveTheSameBytes) {
  const CharacterPtr character = makeBodyWithArms();
  const Pose pose = samplePose(character->skeleton, character->clips.front(), 0.6f);
  const Rig before = adaptiveRig(*character, 7, kCoarse);
  Rig after = before;
  after.primitives[2].placement.radii *= 1.3f;
  after.primitives.pop_back();
  const auto smoothed = [&](Smoother& smoother, const Rig& rig) {
    EXPECT_TRUE(smoother.prepare(rig).ok());
    Surface surface;
    smoother.smooth(pose, surface);
    return surface;
  };
  const auto expectSame = [](const Surface& a, const Surface& b) {
    EXPECT_EQ(a.refinement->triangles, b.refinement->triangles);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.normals, b.normals);
  };
  Smoother edited(character);
  const Surface first = smoothed(edited, before);
  const Surface done = smoothed(edited, after);
  EXPECT_NE(first.positions, done.positions);
  expectSame(smoothed(edited, before), first);
  expectSame(smoothed(edited, after), done);
  Smoother fresh(character);
  expectSame(smoothed(fresh, after), done);
}

TEST(AdaptiveSurface, SkinReleasedByATerritoryChangeIsReevaluated) {
  Prepared prepared{.character = makeTwoLegged()};
  const std::vector<Bone>& bones = prepared.character->skeleton.bones;
  Rig rig = adaptiveRig(*prepared.character, 1, kCoarse);
  rig.primitives.resize(1);
  rig.primitives[0].territory.reset();
  const auto before = prepared(rig);
  int different = 0;
  for (const Bone& bone : bones) {
    rig.primitives[0].territory = {bone.name};
    const auto fresh = prepared(rig);
    different += fresh->detail->needed == before->detail->needed ? 0 : 1;
    EXPECT_EQ(prepared(rig, before.get())->detail->needed, fresh->detail->needed) << bone.name;
  }
  EXPECT_GT(different, 0);
}

TEST(AdaptiveSurface, DragKeepsTheLevelsUntilItEnds) {
  Prepared prepared;
  Rig rig = adaptiveRig(*prepared.character, 3);
  const auto before = prepared(rig);
  rig.primitives[0].placement.radii *= 1.5f;
  const auto during = prepared(rig, before.get(), {.keepLevels = true});
  EXPECT_EQ(during->refined, before->refined);
  EXPECT_EQ(during->detail, before->detail);
  const auto after = prepared(rig, during.get());
  EXPECT_EQ(after->detail->needed, prepared(rig)->detail->needed);
}

TEST(AdaptiveSurface, DoesNotDependOnThreadsOrCrowd) {
  const CharacterPtr character = makeTube();
  const Rig rig = adaptiveRig(*character, 5, 0.0005f);
  const Pose pose = samplePose(character->skeleton, character->clips.front(), 0.7f);
  std::vector<Surface> surfaces;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    smoother.smooth(pose, surfaces.emplace_back());
  }
  CrowdSmoother crowd(character);
  ASSERT_TRUE(crowd.prepare(rig).ok());
  std::vector<Surface> made(2);
  crowd.smooth(std::vector<Pose>{pose, pose}, made);
  surfaces.push_back(made[1]);
  for (const Surface& surface : surfaces) {
    EXPECT_EQ(surface.refinement->triangles, surfaces[0].refinement->triangles);
    EXPECT_EQ(surface.positions, surfaces[0].positions);
    EXPECT_EQ(surface.normals, surfaces[0].normals);
  }
}

TEST(AdaptiveSurface, MeshDoesNotDependOnThePose) {
  Prepared prepared;
  const Rig rig = adaptiveRig(*prepared.character, 4);
  const auto preparation = prepared(rig);
  SmoothingMemory memory;
  Surface first;
  Surface second;
  const Skeleton& skeleton = prepared.character->skeleton;
  for (const float time : {0.2f, 1.1f}) {
    const Pose pose = samplePose(skeleton, prepared.character->clips.front(), time);
    smooth(preparation, preparation->poser->pose(pose), pose, std::nullopt, memory, time < 1.0f ? first : second);
  }
  EXPECT_EQ(first.refinement, second.refinement);
}

/// Distance of a point to a triangle by dense sampling, independent of the formulas that choose levels.
float distanceTo(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  float least = glm::distance(p, a);
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i) {
    for (int k = 0; k <= kSteps - i; ++k) {
      const float u = static_cast<float>(i) / kSteps;
      const float v = static_cast<float>(k) / kSteps;
      least = std::min(least, glm::distance(p, (1.0f - u - v) * a + u * b + v * c));
    }
  }
  return least;
}

/// Number of the fine mesh's vertices that are farther from the flat triangles of their control triangle.
int fartherThan(float most, const ControlMesh& mesh, const Surface& fine, const Surface& flat) {
  int count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 9) {
    for (int i = fine.refinement->triangleBegin[t]; i < fine.refinement->triangleBegin[t + 1]; i += 5) {
      const glm::vec3& p = at(fine.positions, at(fine.refinement->triangles, i)[0]);
      float least = 1e30f;
      for (int k = flat.refinement->triangleBegin[t]; least > most && k < flat.refinement->triangleBegin[t + 1]; ++k) {
        const auto corner = [&](std::size_t c) { return at(flat.positions, at(flat.refinement->triangles, k)[c]); };
        least = std::min(least, distanceTo(p, corner(0), corner(1), corner(2)));
      }
      count += least > most ? 1 : 0;
    }
  }
  return count;
}

// Against depth 12, as projected: later stages (filter, folds) need neighbors, and may differ by more.
TEST(AdaptiveSurface, IsWithinToleranceOfTheFineSurface) {
  for (const CharacterPtr& character : {makeLimb(), makeTube()}) {
    for (const float tolerance : {0.001f, 0.004f}) {
      Rig rig = adaptiveRig(*character, 2, tolerance);
      for (Primitive& primitive : rig.primitives) primitive.sign = 1;
      Projected adaptive(*character, rig);
      rig.smoothing.detail = DetailKind::kUniform;
      rig.smoothing.depth = 12;
      Projected fine(*character, rig);
      EXPECT_LT(adaptive.now().refinement->vertexCount, fine.now().refinement->vertexCount);
      // The oracle takes the nearest of sampled points of a triangle.
      EXPECT_EQ(fartherThan(1.03f * tolerance * character->height, character->mesh, fine.now(), adaptive.now()), 0);
    }
  }
}

// Nearly all triangles of a dense mesh meet a coarse tolerance as they are.
TEST(AdaptiveSurface, CoarserTolerancesGiveFewerVerticesDownToTheMesh) {
  const CharacterPtr character = fineHumanoid();
  Smoother smoother(character);
  int finer = std::numeric_limits<int>::max();
  for (const float tolerance : {0.001f, 0.003f, 0.01f}) {
    ASSERT_TRUE(smoother.prepare(adaptiveRig(*character, 1, tolerance)).ok());
    Surface surface;
    smoother.smooth(bindPose(character->skeleton), surface);
    EXPECT_LT(surface.refinement->vertexCount, finer) << tolerance;
    finer = surface.refinement->vertexCount;
  }
  EXPECT_LT(static_cast<double>(finer), 1.02 * static_cast<double>(character->mesh.positions.size()));
}

// Each triangle has fine samples in few of the poses.
TEST(AdaptiveSurface, DenseMeshIsWithinToleranceInNearlyAllOfItsPoses) {
  const CharacterPtr character = fineHumanoid();
  Rig rig = adaptiveRig(*character, 3, 0.0003f);
  for (Primitive& primitive : rig.primitives) primitive.sign = 1;
  Prepared prepared{character, characterTables(character)};
  const auto detail = prepared(rig)->detail;
  ASSERT_GT(detail->from.poses.size(), 4u);
  ASSERT_GT(character->mesh.triangles.size(), kDenseMesh);
  for (const PoseSet poses : detail->posesOf) {
    EXPECT_GE(std::popcount(poses), 1);
    EXPECT_LE(std::popcount(poses), 4);
  }
  Projected adaptive(*character, rig);
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 4;
  Projected fine(*character, rig);
  int far = 0;
  for (const std::size_t pose : {2u, 5u}) {
    const Pose& now = detail->from.poses[pose];
    far += fartherThan(1.03f * 0.0003f * character->height, character->mesh, fine.at(now), adaptive.at(now));
  }
  EXPECT_LE(far, 10);
}

TEST(AdaptiveSurface, SidesAreSplitAtLeastHalfAsFinelyAsTheirTriangle) {
  int fine = 0;
  for (const CharacterPtr& character : {makeLimb(), makeTube(), makeBodyWithArms()}) {
    Prepared prepared{character, characterTables(character)};
    for (std::uint64_t seed = 0; seed < (longRun() ? 3u : 1u); ++seed) {
      const RefinementLevels levels = prepared(adaptiveRig(*character, seed, 0.0005f))->detail->levels;
      for (std::size_t t = 0; t < levels.triangles.size(); ++t) {
        fine += levels.triangles[t] >= 4 ? 1 : 0;
        for (const int e : character->mesh.triangles[t].edges) {
          EXPECT_GE(2 * at(levels.edges, e) + 1, levels.triangles[t]) << t;
        }
      }
    }
  }
  EXPECT_GT(fine, 20);
}

constexpr int kOfEdge = 12;

/// Samples of an edge of length 1, straight, whose normal turns by degreesAt(sample) in its plane.
template <class DegreesAt>
int levelOfTurning(DegreesAt degreesAt, const LevelTolerance& tolerance) {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  for (int i = 0; i <= kOfEdge; ++i) {
    const float angle = glm::radians(degreesAt(static_cast<float>(i)));
    positions.emplace_back(static_cast<float>(i) / kOfEdge, 0.0f, 0.0f);
    normals.emplace_back(std::sin(angle), 0.0f, std::cos(angle));
  }
  return edgeLevel({positions, normals}, 1, tolerance);
}

// The wave is flat in the middle of each piece of a third, and 22 degrees off there with one piece or two.
TEST(EdgeLevel, ShorterPiecesMayTurnFurther) {
  const auto wave = [](float i) { return 22.0f * std::sin(i * 3.14159265f / 3.0f); };
  LevelTolerance tolerance{1e-3f, std::cos(glm::radians(8.0f)), 0.0f};
  EXPECT_EQ(levelOfTurning(wave, tolerance), kOfEdge);
  tolerance.seenPiece = 0.26f;
  EXPECT_EQ(levelOfTurning(wave, tolerance), 6) << "16 degrees on a piece of 1/6: 12.5 are allowed, of 1/12 25";
  tolerance.seenPiece = 1.01f;
  EXPECT_EQ(levelOfTurning(wave, tolerance), 4);
}

TEST(TriangleLevel, FollowsNormalsOfAFlatTriangle) {
  constexpr int kFine = 6;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> straight;
  std::vector<glm::vec3> bulging;
  for (int j = 0; j <= kFine; ++j) {
    for (int k = 0; k <= kFine - j; ++k) {
      positions.emplace_back(j, k, 0.0f);
      straight.emplace_back(0.0f, 0.0f, 1.0f);
      const float inside = static_cast<float>(j * k * (kFine - j - k)) / 8.0f;
      bulging.push_back(glm::normalize(glm::vec3(0.0f, 0.4f * inside, 1.0f)));
    }
  }
  LevelTolerance tolerance{1e-3f, 0.99f, 0.0f};
  EXPECT_EQ(triangleLevel({positions, straight}, kFine, 1, tolerance), 1);
  EXPECT_GT(triangleLevel({positions, bulging}, kFine, 1, tolerance), 1) << "the middle turns by more than 8 degrees";
  tolerance.seenPiece = 40.0f;
  EXPECT_EQ(triangleLevel({positions, bulging}, kFine, 1, tolerance), 1) << "the longest side is 8.5";
}

}  // namespace
}  // namespace sinew::test
