// tests/surface/align_splits_test.cpp: small triangles of adaptive detail keep their outline and follow the shading.
#include "core/surface/align_splits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/surface/adaptive_levels.h"
#include "core/surface/sampling.h"
#include "tests/support/characters/body_with_arms.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/long_run.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/prepared_in_turn.h"
#include "tests/support/surface/shading_error.h"

namespace sinew::test {
namespace {

double areaOf(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// One control triangle's small triangles, in the plane of the bind pose.
struct Outline {
  double area = 0.0;  ///< Sum, as a fraction of the control triangle.
  double leastAngle = 4.0;
  bool isUpright = true;
  std::map<std::pair<int, int>, int> sides;  ///< Ends of those without a triangle beyond.
};

Outline outlineOf(const ControlMesh& mesh, const Refinement& refinement, int t) {
  const auto& corners = at(mesh.triangles, t).vertices;
  const auto corner = [&](std::size_t i) { return glm::dvec3(at(mesh.positions, corners[i])); };
  Outline out;
  for (int i = at(refinement.triangleBegin, t); i < at(refinement.triangleBegin, t + 1); ++i) {
    const std::array<int, 3>& small = at(refinement.triangles, i);
    std::array<glm::dvec2, 3> flat;
    std::array<glm::dvec3, 3> in;
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::dvec3 place = controlCoordinates(mesh, refinement, t, small[c]);
      flat[c] = {place.y, place.z};
      in[c] = place.x * corner(0) + place.y * corner(1) + place.z * corner(2);
    }
    const double area = areaOf(flat[1] - flat[0], flat[2] - flat[0]);
    out.area += area;
    out.isUpright = out.isUpright && area > 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const glm::dvec3 u = in[(c + 1) % 3] - in[c];
      const glm::dvec3 v = in[(c + 2) % 3] - in[c];
      out.leastAngle = std::min(out.leastAngle, std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
      const int a = small[c];
      const int b = small[(c + 1) % 3];
      const auto beyond = out.sides.find({b, a});
      if (beyond != out.sides.end()) out.sides.erase(beyond);
      else ++out.sides[{a, b}];
    }
  }
  return out;
}

TEST(Alignment, KeepsTheOutlineAndMakesNoSlivers) {
  const std::uint64_t kSeeds = longRun() ? 4 : 2;
  std::uint64_t swapped = 0;
  for (const auto& character : {makeLimb(), makeBodyWithArms(), makeTwoLegged()}) {
    const ControlMesh& mesh = character->mesh;
    PreparedInTurn prepared(character);
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      Rig rig = randomRig(*character, {.primitives = 8, .reachHigh = 1.6f}, seed);
      rig.smoothing.detail = DetailKind::kAdaptive;
      const std::shared_ptr<const Preparation> preparation = prepared.next(rig);
      const Refinement& own = preparation->refinement();
      const Refinement plain = refine(mesh, preparation->detail->levels);
      ASSERT_EQ(own.vertexCount, plain.vertexCount);
      ASSERT_EQ(own.triangleBegin, plain.triangleBegin);
      for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        const Outline a = outlineOf(mesh, own, t);
        const Outline b = outlineOf(mesh, plain, t);
        EXPECT_TRUE(a.isUpright) << t;
        EXPECT_NEAR(a.area, 1.0, 1e-9) << t;
        EXPECT_EQ(a.sides, b.sides) << t;
        EXPECT_GE(a.leastAngle, 0.6 * std::min(b.leastAngle, 0.2617)) << t << ": edges move by themselves";
      }
      swapped += own.triangles != plain.triangles ? 1 : 0;
    }
  }
  EXPECT_GT(swapped, 2 * kSeeds);
}

/// The whole mesh.
SampledPart wholePart(const Preparation& preparation) {
  SampledPiece piece(preparation.mesh().triangles.size());
  std::iota(piece.begin(), piece.end(), 0);
  return sampledPart(preparation, piece);
}

// With exact normals at the vertices.
TEST(Alignment, BringsTheShadingCloserToTheSurface) {
  for (const char* name : {"humanoid", "horse"}) {
    const TrialScene scene = bundledTrialScene(name);
    Rig rig = scene.rig;
    rig.smoothing.detail = DetailKind::kAdaptive;
    PreparedInTurn prepared(scene.character);
    const std::shared_ptr<const Preparation> preparation = prepared.next(rig);
    const AdaptiveLevels& detail = *preparation->detail;
    const SampledPart part = wholePart(*preparation);
    const ControlMesh& mesh = part.mesh();
    ASSERT_EQ(mesh.positions, scene.character->mesh.positions);
    SurfaceSampler fine(part, refine(mesh, 12));
    SurfaceSampler even(part, refine(mesh, detail.levels));
    SurfaceSampler aligned(part, refine(mesh, detail.levels, detail.splits));
    for (const Pose& pose : {bindPose(scene.character->skeleton), detail.from.poses.back()}) {
      const ShadingError before = shadingError(mesh, fine.sample(pose, part.asked), even.sample(pose, part.asked));
      const ShadingError after = shadingError(mesh, fine.sample(pose, part.asked), aligned.sample(pose, part.asked));
      std::printf("  %s: %.2f %% of the skin is shaded otherwise, %.2f %% with even splits\n", name,
                  100.0 * after.off / after.area, 100.0 * before.off / before.area);
      EXPECT_LT(after.off, 0.6 * before.off) << name;
    }
  }
}

}  // namespace
}  // namespace sinew::test
