// tests/surface/projection/replace_shares_test.cpp: `replace` over one or two muscles, for which weights and roots have
// closed forms.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/attachment.h"
#include "core/surface/projection/replace.h"
#include "core/surface/projection/tile_projection.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

constexpr double kIso = 0.25;          // T
constexpr double kRadius = 0.3;        // Radius of the visible ball.
constexpr double kReach = 2.0;         // k
constexpr double kSearchLength = 0.4;  // L

double smoothstep(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// F of docs/design.md at a distance from the ball's center.
double fieldAt(double distance) {
  const auto g = [](double r) { return r < 1.0 ? (1.0 - r * r) * (1.0 - r * r) : 0.0; };
  return kIso / g(1.0 / kReach) * g(distance / (kReach * kRadius));
}

/// Largest F - T at nine points evenly spaced on an interval of a ray that passes the center of a ball at distance
/// `beside`, the ball `depth` below the ray's start.
double prominence(double depth, double beside, double from, double to) {
  double most = 0.0;
  for (int i = 1; i <= 9; ++i) {
    most = std::max(most, fieldAt(std::hypot(beside, depth - (from + (to - from) * i / 10.0))) - kIso);
  }
  return most;
}

/// A flat strip over muscles; its normals lead to them.
struct OverMuscles {
  std::shared_ptr<const Character> strip = makeStrip();
  glm::vec3 normal = strip->mesh.normals[0];
  Rig rig;
  Surface patch;

  OverMuscles() {
    Rig bare;
    bare.smoothing.depth = 6;
    bare.smoothing.patch = PatchKind::kFlat;
    Smoother smoother(strip);
    EXPECT_TRUE(smoother.prepare(bare).ok());
    smoother.smooth(bindPose(strip->skeleton), patch);
    rig.groups.push_back({"a", {}});
  }

  [[nodiscard]] glm::vec3 below(double depth) const {
    return glm::vec3(0.05f, 1.02f, 0.0f) - static_cast<float>(depth) * normal;
  }

  void add(double depth, const glm::vec3& radii, double reach) {
    Primitive muscle = ellipsoidAt(*strip, std::to_string(depth), "root", "a", below(depth), radii);
    muscle.reach = static_cast<float>(reach);
    muscle.territory = std::vector<std::string>{"root", "end"};
    rig.primitives.push_back(muscle);
  }

  [[nodiscard]] Surface replaced(const std::vector<glm::vec3>& anchors, ProjectionKind projection, bool inTiles) const {
    const Attachment attachment = attach(rig, *strip).value();
    const CandidateLists lists = makeCandidateLists(strip->mesh, attachment);
    std::vector<PosedPrimitive> posed;
    poseField(attachment.primitives, bindPose(strip->skeleton).boneInWorld, 0.0f, posed);
    Surface surface = patch;
    const FlatVertices flat{patch.positions, patch.normals, anchors};
    const ImplicitWeights weights{std::vector<float>(strip->mesh.positions.size(), 1.0f), true, 0};
    const ReplaceSettings settings{static_cast<float>(kIso), static_cast<float>(kSearchLength), projection, 1e-6};
    ProjectionScratch scratch;
    if (inTiles) {
      const VertexTiles tiles = makeVertexTiles(strip->mesh, *patch.refinement, lists);
      replaceInTiles(strip->mesh, {posed, &lists, {}}, settings, flat, weights, tiles, surface, scratch);
    } else {
      replace(strip->mesh, {posed, &lists, {}}, settings, flat, weights, surface, scratch);
    }
    return surface;
  }

  /// Distance of a vertex's normal from the muscles' middle.
  [[nodiscard]] double besideCenter(std::size_t v) const {
    const glm::vec3 away = patch.positions[v] - below(0.0);
    return static_cast<double>(glm::length(away - glm::dot(away, normal) * normal));
  }
};

// From outside. The interval is the chord up to the search length, and its weight fades towards L.
TEST(ReplaceWeight, ChordWeightFollowsProminenceAndDistance) {
  for (const double depth : {0.35, 0.45, 0.55, 0.65}) {
    OverMuscles scene;
    scene.add(depth, glm::vec3(static_cast<float>(kRadius)), kReach);
    const std::vector<glm::vec3> anchors(scene.patch.positions.size(), scene.below(depth));
    const Surface surface = scene.replaced(anchors, ProjectionKind::kAnalytic, false);
    int partly = 0;
    for (std::size_t v = 0; v < scene.patch.positions.size(); ++v) {
      const double beside = scene.besideCenter(v);
      double moved = 0.0;
      if (beside < kRadius) {
        const double half = std::sqrt(kRadius * kRadius - beside * beside);
        const double root = depth - half;
        const double most = prominence(depth, beside, root, std::min(depth + half, kSearchLength));
        const double share = smoothstep(most / (kIso / 4.0)) * smoothstep(5.0 * (kSearchLength - root) / kSearchLength);
        moved = share * root;
        partly += share > 0.05 && share < 0.95 ? 1 : 0;
      }
      const glm::vec3 expected = scene.patch.positions[v] - static_cast<float>(moved) * scene.normal;
      EXPECT_LT(glm::distance(surface.positions[v], expected), 1e-4f) << "depth " << depth << ", vertex " << v;
    }
    EXPECT_GT(partly, 5) << depth;
  }
}

// On the way to the anchor an interval that begins within the search length goes on into a muscle beyond it, whose
// prominence counts.
TEST(ReplaceWeight, CountsMusclesBeyondTheSearchLengthOnTheWayToTheAnchor) {
  constexpr double kDepth = 0.6;
  constexpr double kHalfLength = 0.6;
  constexpr double kDeepRadius = 0.5;
  constexpr double kDeepReach = 1.2;
  constexpr double kDeepDepth = kSearchLength + kDeepReach * kDeepRadius + 0.05;
  OverMuscles scene;
  const float across = static_cast<float>(kRadius);
  scene.add(kDepth, {across, across, static_cast<float>(kHalfLength)}, kReach);
  scene.add(kDeepDepth, glm::vec3(static_cast<float>(kDeepRadius)), kDeepReach);
  std::vector<glm::vec3> anchors;
  for (const glm::vec3& p : scene.patch.positions) anchors.push_back(p - 2.0f * scene.normal);
  for (const bool inTiles : {false, true}) {
    const Surface surface = scene.replaced(anchors, ProjectionKind::kNewton, inTiles);
    EXPECT_LT(surface.report.uncertified, surface.report.projected / 10);  // The rest go to the scalar code.
    int faint = 0;
    for (std::size_t v = 0; v < scene.patch.positions.size(); ++v) {
      const double beside = scene.besideCenter(v);
      if (beside > kRadius) continue;
      const double root = kDepth - kHalfLength * std::sqrt(1.0 - beside * beside / (kRadius * kRadius));
      if (root < 0.01 || root > 0.79 * kSearchLength) continue;  // Full weight.
      const glm::vec3 expected = scene.patch.positions[v] - static_cast<float>(root) * scene.normal;
      EXPECT_LT(glm::distance(surface.positions[v], expected), 1e-4f) << inTiles << ", vertex " << v;
      faint += fieldAt(beside) - kIso < 0.9 * kIso / 4.0 ? 1 : 0;  // But for the muscle beyond.
    }
    EXPECT_GT(faint, 5);
  }
}

}  // namespace
}  // namespace sinew::test
