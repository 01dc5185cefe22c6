// tests/surface/projection/projection_agreement_test.cpp: all modes and projection methods agree with brute force and
// with each other.

#include <array>
#include <cstdio>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "sinew/surface/smoother.h"
#include "tests/support/oracle/compare.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/every_kind.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

constexpr double kAgreement = 1e-4;  // Fraction of H.
constexpr int kPoses = 3;
constexpr int kAsked = 900;  ///< Vertices checked by the oracle for each scene, mode and projection.

oracle::Tally tallyOf(const TrialScene& scene, const Rig& rig, ProjectionKind projection) {
  Smoother smoother(scene.character, projection);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  if (!prepared) return {};
  oracle::Oracle oracle(*scene.character, rig, projection);
  Projected projected(*scene.character, rig, projection);
  oracle::Tally total;
  Surface surface;
  int first = 0;
  for (const Pose& pose : spreadPoses(*scene.character, kPoses)) {
    smoother.smooth(pose, surface);
    EXPECT_TRUE(allFinite(surface.positions));
    EXPECT_TRUE(allUnit(surface.normals));
    oracle.pose(pose);
    const int stride = std::max(1, static_cast<int>(surface.positions.size()) * (kPoses + 1) / kAsked);
    const Surface& raw = projected.at(pose);
    const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
    total.add(oracle::compare(oracle, *scene.character, stages, surface, stride, first++ % stride));
  }
  return total;
}

void expectAgreement(SurfaceMode mode, float grooves = 0.0f) {
  std::printf("  %-11s %-8s %-10s %8s %8s %8s  %s\n", "scene", "mode", "projection", "asked", "sought", "within",
              "beyond 1e-4 H: another root, near-tangent, unexplained; normals off; guarded (off), shading off");
  for (const TrialScene& scene : trialScenes()) {
    for (const ProjectionKind projection : kEveryProjection) {
      Rig rig = withMode(scene.rig, mode);
      rig.surface.grooves = grooves;
      const oracle::Tally tally = tallyOf(scene, rig, projection);
      std::printf("  %-11s %-8s %-10s %8d %8d %7.2f%%  %d: %d, %d, %d; %d (%d on a crease); %d (%d), %d\n",
                  scene.name.c_str(), nameOf(mode), nameOf(projection), tally.compared, tally.sought,
                  100.0 * (1.0 - tally.farShare()), tally.far, tally.anotherRoot, tally.nearTangent, tally.unexplained,
                  tally.normalsOff, tally.normalsOnCrease, tally.guarded, tally.guardOff, tally.shadingOff);
      const std::string what = scene.name + ", " + nameOf(mode) + ", " + nameOf(projection);
      EXPECT_GT(tally.sought, 20) << what;
      EXPECT_LE(tally.farShare(), 0.008) << what << "; " << tally.firstFar;
      EXPECT_EQ(tally.unexplained, 0) << what << "; " << tally.firstFar;
      EXPECT_EQ(tally.farUnsought, 0) << what << "; " << tally.firstFar;
      EXPECT_LE(tally.normalsOffShare(), 0.01) << what << "; " << tally.firstOff;
      EXPECT_EQ(tally.guardOff, 0) << what << "; " << tally.firstOff;
      EXPECT_EQ(tally.shadingOff, 0) << what << "; " << tally.firstOff;
    }
  }
}

TEST(ProjectionAgreement, SwellMatchesBruteForce) { expectAgreement(SurfaceMode::kSwell); }

TEST(ProjectionAgreement, ReplaceMatchesBruteForce) { expectAgreement(SurfaceMode::kReplace); }

TEST(ProjectionAgreement, SwellWithGroovesMatchesBruteForce) { expectAgreement(SurfaceMode::kSwell, 0.02f); }

TEST(ProjectionAgreement, ReplaceWithGroovesMatchesBruteForce) { expectAgreement(SurfaceMode::kReplace, 0.02f); }

struct Difference {
  int compared = 0;
  int far = 0;        ///< Beyond 1e-4 H.
  int farUnique = 0;  ///< Those whose ray has a single root.
  double worstNear = 0.0;
};

/// Compares all vertices of two projections of the same rays, before folds are removed. Where they differ, the oracle
/// counts the roots.
Difference differenceOf(const TrialScene& scene, SurfaceMode mode, ProjectionKind other, float grooves) {
  Rig rig = withMode(scene.rig, mode);
  rig.surface.grooves = grooves;
  Projected newton(*scene.character, rig);
  Projected second(*scene.character, rig, other);
  oracle::Oracle oracle(*scene.character, rig);
  Difference out;
  const double height = static_cast<double>(scene.character->height);
  for (const Pose& pose : spreadPoses(*scene.character, 6)) {
    const Surface& a = newton.at(pose);
    const Surface& b = second.at(pose);
    oracle.pose(pose);
    out.compared += a.report.projected;
    for (std::size_t v = 0; v < a.positions.size(); ++v) {
      const double apart = static_cast<double>(glm::distance(a.positions[v], b.positions[v])) / height;
      if (!(apart > kAgreement)) {
        out.worstNear = std::max(out.worstNear, apart);
        continue;
      }
      ++out.far;
      const auto answer = oracle.evaluate(oracle::siteOf(scene.character->mesh, *a.refinement, static_cast<int>(v)));
      if (answer.roots.size() == 1) ++out.farUnique;
    }
  }
  return out;
}

void expectSame(const TrialScene& scene, SurfaceMode mode, ProjectionKind other, float grooves = 0.0f) {
  const Difference seen = differenceOf(scene, mode, other, grooves);
  std::printf("  %-11s %-8s %-10s %8d %8d %8d   %.2g H\n", scene.name.c_str(), nameOf(mode), nameOf(other),
              seen.compared, seen.far, seen.farUnique, seen.worstNear);
  EXPECT_GT(seen.compared, 500);
  EXPECT_EQ(seen.farUnique, 0) << scene.name << ", " << nameOf(mode) << ", " << nameOf(other);
  EXPECT_LE(seen.far, seen.compared / 1000) << scene.name << ", " << nameOf(mode) << ", " << nameOf(other);
}

// In `swell` all three follow the patch normal; in `replace` newton and bisection follow the segment to the anchor,
// while analytic follows the normal and is compared with the oracle only.
TEST(ProjectionAgreement, MethodsFindTheSameRootOnARay) {
  std::printf("  %-11s %-8s %-10s %8s %8s %8s   %s\n", "scene", "mode", "newton and", "vertices", "far", "unique",
              "worst of the rest");
  for (const TrialScene& scene : trialScenes()) {
    expectSame(scene, SurfaceMode::kSwell, ProjectionKind::kBisection);
    expectSame(scene, SurfaceMode::kSwell, ProjectionKind::kAnalytic);
    expectSame(scene, SurfaceMode::kReplace, ProjectionKind::kBisection);
    expectSame(scene, SurfaceMode::kSwell, ProjectionKind::kAnalytic, 0.02f);
    expectSame(scene, SurfaceMode::kReplace, ProjectionKind::kBisection, 0.02f);
  }
}

}  // namespace
}  // namespace sinew::test
