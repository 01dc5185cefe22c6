// tests/surface/triangle_samples_test.cpp: samples do not depend on which others are taken, in which order, or how
// many.
#include "core/surface/triangle_samples.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/geometry/at.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/sampling.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/prepared_in_turn.h"

namespace sinew::test {
namespace {

using PreparationPtr = std::shared_ptr<const Preparation>;

struct Sampled {
  TrialScene scene;
  PreparationPtr whole;
  std::vector<Pose> poses;

  explicit Sampled(SurfaceMode mode) : scene(bundledTrialScene("tangle")) {
    PreparedInTurn prepared(scene.character);
    whole = prepared.next(withMode(scene.rig, mode));
    poses = spreadPoses(*scene.character, 3);
  }
  [[nodiscard]] std::size_t count() const { return whole->mesh().triangles.size(); }
};

TEST(TriangleSamples, AreTheSameWithoutTheOthers) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    const Sampled own(mode);
    SampledPiece all;
    std::vector<int> some;
    for (int t = 0; t < static_cast<int>(own.count()); ++t) {
      all.push_back(t);
      if (t % 5 == 2) some.push_back(t);
    }
    const SampledPart part = sampledPart(*own.whole, all);
    const ControlMesh& mesh = part.mesh();
    const RefinementLevels levels{std::vector<std::uint8_t>(mesh.edges.size(), 4),
                                  std::vector<std::uint8_t>(mesh.triangles.size(), 4)};
    SurfaceSampler sampler(part, samplePoints(mesh, levels));
    SurfaceSampler other(part, samplePoints(mesh, levels));
    int moved = 0;
    int leftOut = 0;
    for (const Pose& pose : own.poses) {
      const Surface& a = sampler.sample(pose, all);
      const Surface& b = other.sample(pose, some);
      for (const int t : all) {
        const bool isAsked = std::ranges::binary_search(some, t);
        const int begin = at(a.refinement->insideBegin, t);
        for (int v = begin; v < begin + a.refinement->insideVertices(t); ++v) {
          moved += isAsked && at(a.displacement, v) != 0.0f ? 1 : 0;
          leftOut += !isAsked && at(a.displacement, v) != 0.0f ? 1 : 0;
          EXPECT_EQ(at(b.displacement, v), isAsked ? at(a.displacement, v) : 0.0f);
        }
        if (!isAsked) continue;
        forEachSample(mesh, *a.refinement, t, 4, [&](int, int, int v) {
          EXPECT_EQ(at(a.positions, v), at(b.positions, v));
          EXPECT_EQ(at(a.normals, v), at(b.normals, v));
        });
      }
    }
    EXPECT_GT(moved, 100);
    EXPECT_GT(leftOut, 400);
  }
}

TEST(TriangleSamples, ComeInTheirPosesInOrder) {
  const Sampled own(SurfaceMode::kSwell);
  std::vector<std::uint8_t> fine(own.count(), 0);
  std::vector<PoseSet> posesOf(own.count(), 0);
  for (std::size_t t = 0; t < own.count(); ++t) {
    fine[t] = static_cast<std::uint8_t>(t % 4 == 0 ? 0 : 2 + t % 2 * 4);
    posesOf[t] = static_cast<PoseSet>(t % 8);
  }
  std::vector<std::vector<std::size_t>> came(own.count());
  sampleTriangles(*own.whole, own.poses, {fine, posesOf}, [&](int t, std::size_t pose, const FineSamples& samples) {
    at(came, t).push_back(pose);
    const std::size_t n = at(fine, t);
    EXPECT_EQ(samples.positions.size(), (n + 1) * (n + 2) / 2);
    EXPECT_EQ(samples.normals.size(), samples.positions.size());
  });
  for (std::size_t t = 0; t < own.count(); ++t) {
    std::vector<std::size_t> expected;
    for (std::size_t pose = 0; pose < own.poses.size() && fine[t] != 0; ++pose) {
      if (contains(posesOf[t], pose)) expected.push_back(pose);
    }
    EXPECT_EQ(came[t], expected) << t;
  }
}

TEST(TriangleSamples, FewAreAmongMany) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    const Sampled own(mode);
    const std::vector<PoseSet> posesOf(own.count(), 5);
    SampledSurface many(*own.whole, own.poses, posesOf);
    many.sample(std::vector<std::uint8_t>(own.count(), 12));
    for (const int n : {2, 3, 6, 12}) {
      SampledSurface few(*own.whole, own.poses, posesOf);
      few.sample(std::vector<std::uint8_t>(own.count(), static_cast<std::uint8_t>(n)));
      for (int t = 0; t < static_cast<int>(own.count()); t += 7) {
        const TriangleSamples& a = many.of(t);
        const TriangleSamples& b = few.of(t);
        ASSERT_TRUE(a.hold(n));
        ASSERT_EQ(b.fine, n);
        for (std::size_t nth = 0; nth < 2; ++nth) {
          for (int j = 0; j <= n; ++j) {
            for (int k = 0; k <= n - j; ++k) {
              EXPECT_EQ(a.of(nth).positions[a.placeOf(n, j, k)], b.of(nth).positions[b.placeOf(n, j, k)]);
              EXPECT_EQ(a.of(nth).normals[a.placeOf(n, j, k)], b.of(nth).normals[b.placeOf(n, j, k)]);
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
