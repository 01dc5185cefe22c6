// tests/surface/finish/normals_test.cpp: shading normals deviate from the drawn faces no more than the patch's do.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "sinew/surface/smoother.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

constexpr int kNormalsDepth = 8;
constexpr double kAllowedDegrees = 10.0;
constexpr double kFade = 0.06;  ///< Change of a territory weight between neighbors.

double degreesBetween(const glm::vec3& a, const glm::vec3& b) {
  const double cosine = static_cast<double>(glm::dot(glm::normalize(a), glm::normalize(b)));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
}

/// Statistics of the small triangles around each vertex.
struct Faceted {
  std::vector<glm::vec3> normals;  ///< [V'] weighted by the corners' angles.
  std::vector<double> spread;      ///< [V'] degrees: widest angle of a face to that normal: large at a crease.
};

Faceted facetedOf(const Surface& surface) {
  Faceted out;
  out.normals.assign(surface.positions.size(), glm::vec3(0.0f));
  out.spread.assign(surface.positions.size(), 0.0);
  const auto each = [&](auto&& visit) {
    for (const auto& t : surface.refinement->triangles) {
      const auto at = [&](std::size_t i) { return surface.positions[static_cast<std::size_t>(t[i % 3])]; };
      const glm::vec3 face = glm::cross(at(1) - at(0), at(2) - at(0));
      if (!(glm::length(face) > 0.0f)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const double angle = degreesBetween(at(i + 1) - at(i), at(i + 2) - at(i));
        visit(static_cast<std::size_t>(t[i]), glm::normalize(face), static_cast<float>(angle));
      }
    }
  };
  each([&](std::size_t v, const glm::vec3& face, float angle) { out.normals[v] += angle * face; });
  each([&](std::size_t v, const glm::vec3& face, float) {
    out.spread[v] = std::max(out.spread[v], degreesBetween(face, out.normals[v]));
  });
  return out;
}

struct Count {
  int moved = 0;    ///< Moved by muscles; in `replace` those that lie on F = T with all their neighbors.
  int creased = 0;  ///< A face leans by more than 10 degrees (unlinked groups meet, the cage folds), or:
  int folded = 0;   ///< Creased ones where the mesh overlaps itself, inside out.
  int judged = 0;   ///< The rest.
  int raw = 0;      ///< Judged ones beyond 10 degrees.
  int off = 0;      ///< Judged ones more than 10 degrees beyond the patch's own normal's deviation from the patch.
};

/// In `replace`: vertices with F = T, as have all around them, and whose territory weights hardly differ from their
/// neighbors': elsewhere surface and normals are mixed.
std::vector<bool> onTheImplicitSurface(const oracle::Oracle& oracle, const ControlMesh& mesh, const Surface& surface) {
  const double iso = oracle.field().iso();
  std::vector<std::vector<double>> weights;
  std::vector<bool> alone;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    weights.push_back(oracle.weightsAt(oracle::siteOf(mesh, *surface.refinement, static_cast<int>(v))));
    const double value = oracle.field().value(oracle::vec(surface.positions[v]), weights.back());
    alone.push_back(std::abs(value - iso) < 1e-3 * iso);
  }
  const auto alike = [&](std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < weights[a].size(); ++i) {
      if (std::abs(weights[a][i] - weights[b][i]) > kFade) return false;
    }
    return true;
  };
  std::vector<bool> out = alone;
  for (const auto& t : surface.refinement->triangles) {
    const auto at = [&](std::size_t i) { return static_cast<std::size_t>(t[i]); };
    const bool all = alone[at(0)] && alone[at(1)] && alone[at(2)] && alike(at(0), at(1)) && alike(at(1), at(2)) &&
                     alike(at(2), at(0));
    for (std::size_t i = 0; i < 3; ++i) out[at(i)] = all && out[at(i)];
  }
  return out;
}

void judge(const Surface& surface, const Surface& patch, const std::vector<bool>& counts, Count& out) {
  const Faceted faceted = facetedOf(surface);
  const Faceted facetedPatch = facetedOf(patch);
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    if (surface.positions[v] == patch.positions[v] || !counts[v]) continue;
    ++out.moved;
    const bool folded = glm::dot(faceted.normals[v], patch.normals[v]) < 0.0f ||
                        glm::dot(faceted.normals[v], surface.normals[v]) < 0.0f;
    out.folded += folded ? 1 : 0;
    if (folded || faceted.spread[v] > kAllowedDegrees) {
      ++out.creased;
      continue;
    }
    ++out.judged;
    const double degrees = degreesBetween(faceted.normals[v], surface.normals[v]);
    const double patchDegrees = degreesBetween(facetedPatch.normals[v], patch.normals[v]);
    out.raw += degrees > kAllowedDegrees ? 1 : 0;
    out.off += degrees > kAllowedDegrees + patchDegrees ? 1 : 0;
  }
}

Count countOf(const TrialScene& scene, SurfaceMode mode) {
  Rig rig = withMode(scene.rig, mode);
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = kNormalsDepth;
  Rig empty = rig;
  empty.primitives.clear();
  Smoother smoother(scene.character);
  Smoother bare(scene.character);
  EXPECT_TRUE(smoother.prepare(rig).ok() && bare.prepare(empty).ok());
  oracle::Oracle oracle(*scene.character, rig);
  Surface surface;
  Surface patch;
  Count out;
  for (const Pose& pose : spreadPoses(*scene.character, 1)) {
    smoother.smooth(pose, surface);
    bare.smooth(pose, patch);
    oracle.pose(pose);
    EXPECT_TRUE(allUnit(surface.normals)) << scene.name;
    std::vector<bool> counts(surface.positions.size(), true);
    if (mode == SurfaceMode::kReplace) counts = onTheImplicitSurface(oracle, scene.character->mesh, surface);
    judge(surface, patch, counts, out);
  }
  return out;
}

TEST(SurfaceNormals, StayNearTheFaceNormals) {
  std::printf("  %-11s %-8s %8s %8s %8s %8s %10s %20s\n", "scene", "mode", "moved", "creased", "folded", "judged",
              "within 10", "beyond the patch's");
  for (const TrialScene& scene : trialScenes()) {
    for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
      const Count seen = countOf(scene, mode);
      const double judged = std::max(seen.judged, 1);
      const double within = 1.0 - seen.off / judged;
      std::printf("  %-11s %-8s %8d %8d %8d %8d %9.2f%% %19.2f%%\n", scene.name.c_str(), nameOf(mode), seen.moved,
                  seen.creased, seen.folded, seen.judged, 100.0 * (1.0 - seen.raw / judged), 100.0 * within);
      EXPECT_GE(within, 0.99) << scene.name << ", " << nameOf(mode);
      // `replace` moves little of a body without wrapping muscles.
      const bool wrapped = scene.name == "wrapped" || scene.name == "tangle";
      if (mode == SurfaceMode::kSwell || wrapped) {
        EXPECT_GT(seen.judged, 100) << scene.name << ", " << nameOf(mode);
      }
      // Normals that converge over a hollow cross if the skin rises further than their distance.
      if (mode == SurfaceMode::kSwell) {
        EXPECT_LE(seen.folded, seen.moved / 10) << scene.name;
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
