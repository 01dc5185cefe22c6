// tests/surface/projection/replace_shares_test.cpp: `replace` over a single ball, for which weights and roots have
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

/// A flat strip over a ball `depth` below it: every ray is its normal.
struct OverBall {
  std::shared_ptr<const Character> strip = makeStrip();
  glm::vec3 normal = strip->mesh.normals[0];
  glm::vec3 center;
  Surface patch;
  Surface surface;

  explicit OverBall(double depth) : center(glm::vec3(0.05f, 1.02f, 0.0f) - static_cast<float>(depth) * normal) {
    Rig rig;
    rig.smoothing.depth = 6;
    rig.smoothing.patch = PatchKind::kFlat;
    Smoother smoother(strip);
    EXPECT_TRUE(smoother.prepare(rig).ok());
    const Pose bind = bindPose(strip->skeleton);
    smoother.smooth(bind, patch);

    rig.groups.push_back({"a", {}});
    rig.primitives.push_back(ellipsoidAt(*strip, "ball", "root", "a", center, glm::vec3(static_cast<float>(kRadius))));
    rig.primitives[0].reach = static_cast<float>(kReach);
    rig.primitives[0].territory = std::vector<std::string>{"root", "end"};
    const Attachment attachment = attach(rig, *strip).value();
    const CandidateLists lists = makeCandidateLists(strip->mesh, attachment);
    std::vector<PosedPrimitive> posed;
    poseField(attachment.primitives, bind.boneInWorld, posed);
    surface = patch;
    const std::vector<glm::vec3> anchors(patch.positions.size(), center);
    const ImplicitWeights weights{std::vector<float>(strip->mesh.positions.size(), 1.0f), true, 0};
    const ReplaceSettings settings{static_cast<float>(kIso), static_cast<float>(kSearchLength),
                                   ProjectionKind::kAnalytic, 1e-7};
    ProjectionScratch scratch;
    replace(strip->mesh, {posed, &lists, {}}, settings, {patch.positions, patch.normals, anchors}, weights, surface,
            scratch);
  }

  /// Distance of a vertex's ray from the ball's center.
  [[nodiscard]] double besideCenter(std::size_t v) const {
    const glm::vec3 away = patch.positions[v] - center;
    return static_cast<double>(glm::length(away - glm::dot(away, normal) * normal));
  }
};

// From outside. The interval is the chord up to the search length, and its weight fades towards L.
TEST(ReplaceWeight, ChordWeightFollowsProminenceAndDistance) {
  for (const double depth : {0.35, 0.45, 0.55, 0.65}) {
    const OverBall scene(depth);
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
      EXPECT_LT(glm::distance(scene.surface.positions[v], expected), 1e-4f) << "depth " << depth << ", vertex " << v;
    }
    EXPECT_GT(partly, 5) << depth;
  }
}

}  // namespace
}  // namespace sinew::test
