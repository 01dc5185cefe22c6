// tests/surface/property_test.cpp: hundreds of random rigs and poses: finite, unit normals, bounded by the definitions,
// and continuous.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/long_run.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

Rig anyRig(const Character& character, std::uint64_t seed) {
  Random random(seed * 7919 + 1);
  RigRecipe recipe;
  recipe.primitives = random.below(25);
  recipe.groups = 1 + random.below(8);
  recipe.linkChance = random.uniform(0.0f, 1.0f);
  recipe.carveChance = random.uniform(0.0f, 0.6f);
  recipe.radiusLow = random.chance(0.2f) ? 0.001f : 0.03f;
  recipe.radiusHigh = random.chance(0.2f) ? 0.6f : 0.15f;
  recipe.groovesChance = 0.4f;
  Rig rig = randomRig(character, recipe, seed);
  rig.surface.mode = random.chance(0.5f) ? SurfaceMode::kSwell : SurfaceMode::kReplace;
  rig.surface.iso = random.uniform(0.02f, 0.95f);
  rig.surface.skinBlend = random.uniform(0.001f, 0.3f);
  rig.smoothing.depth = 1 + random.below(5);
  constexpr std::array kPatches{PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat};
  rig.smoothing.patch = kPatches[static_cast<std::size_t>(random.below(4))];
  for (Primitive& primitive : rig.primitives) {
    if (random.chance(0.1f)) primitive.reach = random.uniform(1.001f, 6.0f);
  }
  return rig;
}

/// Bounds of docs/design.md on how far muscles move the skin in one rig and pose.
class Bounds {
 public:
  Bounds(const Character& character, const Rig& rig, const Pose& pose)
      : character_(character), rig_(rig), field_(character, rig), projected_(character, rig) {
    projected_.at(pose);
    field_.pose(pose);
    all_.assign(static_cast<std::size_t>(field_.count()), 1.0);
    double radius = 0.0;
    for (const Primitive& primitive : rig.primitives) {
      const int bone = oracle::boneNamed(character.skeleton, primitive.bone);
      const auto scale = glm::determinant(glm::dmat3(pose.boneInWorld[static_cast<std::size_t>(bone)]));
      const glm::dvec3 radii(primitive.placement.radii);
      radius = std::max(radius, std::cbrt(std::abs(scale) * radii.x * radii.y * radii.z));
    }
    blend_ = std::min(static_cast<double>(rig.surface.skinBlend * character.height), radius);
  }

  /// @return number of moved vertices; -1 if one is out of bounds, and the test has failed
  int check(const Surface& surface) {
    const Surface& raw = projected_.now();
    const Surface& patch = projected_.patch();
    int moved = 0;
    for (int v = 0; v < surface.refinement->vertexCount; ++v) {
      const auto i = static_cast<std::size_t>(v);
      const double lift = distance(raw.positions[i], patch.positions[i]);
      moved += lift > 0.0 ? 1 : 0;
      // Folds: no vertex moves further from its place than muscles have moved it; corrections only shrink.
      const bool held = distance(surface.positions[i], patch.positions[i]) <= 2.0 * lift + (lift > 0.0 ? slack() : 0.0);
      const bool may = lift == 0.0 || (rig_.surface.mode == SurfaceMode::kSwell ? maySwell(v) : mayReplace(v));
      EXPECT_TRUE(held && may) << "vertex " << v << ", lifted by " << lift << (held ? "" : ", then thrown by folds");
      if (!held || !may) return -1;
    }
    return moved;
  }

 private:
  [[nodiscard]] double slack() const { return 1e-4 * static_cast<double>(character_.height); }
  static double distance(const glm::vec3& a, const glm::vec3& b) { return static_cast<double>(glm::distance(a, b)); }
  /// Inside some muscle's influence, with tolerance for rounding.
  [[nodiscard]] bool reached(const glm::vec3& point) const { return field_.nearest(oracle::vec(point), all_) < 1.01; }

  /// Swell: only skin within a muscle's reach moves. Outwards the skin's own field ends at h, so anything higher lies
  /// inside muscles that reach F = T on their own; inwards the search ends at r_T W.
  [[nodiscard]] bool maySwell(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    const glm::vec3& from = projected_.patch().positions[v];
    const glm::vec3& to = projected_.now().positions[v];
    if (!reached(from)) return false;
    const double isoRadius = std::sqrt(1.0 - std::sqrt(static_cast<double>(rig_.surface.iso)));
    const bool inwards = projected_.now().displacement[v] < 0.0f;
    const double most = inwards ? isoRadius * blend_ / (1.0 - isoRadius) : blend_;
    return distance(from, to) <= most + slack() || (!inwards && reached(to));
  }

  /// Replace: a mean of the patch and of roots no further than L from the point in the control triangle.
  [[nodiscard]] bool mayReplace(int vertex) const {
    const Surface& patch = projected_.patch();
    const oracle::Site site = oracle::siteOf(character_.mesh, *patch.refinement, vertex);
    glm::dvec3 flat(0.0);  // Control vertices come first in the refinement, and patches interpolate them.
    for (std::size_t i = 0; i < 3; ++i) {
      flat += site.barycentric[i] * glm::dvec3(patch.positions[static_cast<std::size_t>(site.vertices[i])]);
    }
    const auto v = static_cast<std::size_t>(vertex);
    const double most =
        std::max(0.2 * static_cast<double>(character_.height), glm::distance(flat, glm::dvec3(patch.positions[v])));
    return glm::distance(flat, glm::dvec3(projected_.now().positions[v])) <= most + slack();
  }

  const Character& character_;
  const Rig& rig_;
  oracle::Field field_;
  Projected projected_;
  std::vector<double> all_;  ///< Weights: territories only reduce.
  double blend_ = 0.0;       ///< Largest h.
};

TEST(SurfaceProperty, RandomRigsAndPosesStayFiniteAndWithinBounds) {
  const std::vector<CharacterPtr> characters{makeLimb(), makeTwoLegged(), makeTube(), makeStrip()};
  int moved[2] = {0, 0};
  for (std::uint64_t seed = 0; seed < (longRun() ? 1000u : 200u); ++seed) {
    const CharacterPtr& character = characters[seed % characters.size()];
    const Rig rig = anyRig(*character, seed);
    Smoother smoother(character);
    const auto prepared = smoother.prepare(rig);
    ASSERT_TRUE(prepared.ok()) << "seed " << seed << ": " << prepared.error().text();
    Surface surface;
    const Pose pose = randomPose(character->skeleton, 1.5f, 0.5f, seed);
    smoother.smooth(pose, surface);
    ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed;
    ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed;
    const int count = Bounds(*character, rig, pose).check(surface);
    ASSERT_GE(count, 0) << "seed " << seed;
    moved[static_cast<std::size_t>(rig.surface.mode)] += count;
  }
  EXPECT_GT(moved[0], 2'000);
  EXPECT_GT(moved[1], 2'000);
}

// Extreme values that a rig may contain.
TEST(SurfaceProperty, ExtremeSettingsStayFiniteAndWithinBounds) {
  const CharacterPtr character = makeTwoLegged();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rig rig = anyRig(*character, seed);
    for (const float iso : {kLeastIso, kMostIso}) {
      for (const float blend : {std::numeric_limits<float>::denorm_min(), 1e-6f, kMostSkinBlend}) {
        rig.surface.iso = iso;
        rig.surface.skinBlend = blend;
        rig.surface.grooves = seed % 2 == 0 ? kMostGrooves : std::numeric_limits<float>::denorm_min();
        Smoother smoother(character);
        ASSERT_TRUE(smoother.prepare(rig).ok());
        Surface surface;
        const Pose pose = randomPose(character->skeleton, 1.5f, 0.5f, seed);
        smoother.smooth(pose, surface);
        ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed << " iso " << iso << " blend " << blend;
        ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed << " iso " << iso << " blend " << blend;
        ASSERT_GE(Bounds(*character, rig, pose).check(surface), 0) << seed << " iso " << iso << " blend " << blend;
      }
    }
  }
}

// Bones flattened to a plane, a line, a point; muscles on them may reach nothing, but never give NaN.
TEST(SurfaceProperty, FlattenedBonesAreHarmless) {
  const CharacterPtr character = makeTwoLegged();
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const Rig rig = anyRig(*character, seed);
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    Pose pose = bindPose(character->skeleton);
    glm::mat4& bone = pose.boneInWorld[seed % pose.boneInWorld.size()];
    for (int column = 0; column <= static_cast<int>(seed % 3); ++column) bone[column] = glm::vec4(0.0f);
    Surface surface;
    smoother.smooth(pose, surface);
    ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed;
    ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed;
  }
}

// A mirrored bone (negative scale) turns the skin inside out; its normals stay unit.
TEST(SurfaceProperty, MirroredBonesAreHarmless) {
  const CharacterPtr character = makeLimb();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(anyRig(*character, seed)).ok());
    Pose pose = bindPose(character->skeleton);
    for (glm::mat4& bone : pose.boneInWorld) bone[0] = -bone[0];
    Surface surface;
    smoother.smooth(pose, surface);
    ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed;
    ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed;
  }
}

/// Largest step of any vertex between surfaces of neighboring parameters.
float largestStep(const Surface& a, const Surface& b) {
  float out = 0.0f;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    out = std::max(out, glm::distance(a.positions[v], b.positions[v]));
  }
  return out;
}

// A shallow muscle (no overhang) that slides out through the skin: the skin rises without a jump.
TEST(SurfaceProperty, SwellMovesContinuouslyWithThePrimitive) {
  const CharacterPtr character = makeLimb();
  Rig rig;
  rig.groups.push_back({"a", {}});
  rig.primitives.push_back(ellipsoidAt(*character, "lens", "middle", "a", {0.0f, 1.0f, 0.0f}, {0.25f, 0.3f, 0.15f}));
  rig.smoothing.depth = 4;
  Smoother smoother(character);
  const glm::vec3 start = rig.primitives[0].placement.center;
  Surface before;
  Surface after;
  float worst = 0.0f;
  float total = 0.0f;
  constexpr int kSteps = 400;
  for (int i = 0; i <= kSteps; ++i) {
    rig.primitives[0].placement.center = start + glm::vec3(0.0f, 0.0f, 0.2f * static_cast<float>(i) / kSteps);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    smoother.smooth(bindPose(character->skeleton), after);
    if (i > 0) {
      worst = std::max(worst, largestStep(before, after));
      total += largestStep(before, after);
    }
    before = after;
  }
  EXPECT_GT(total, 0.05f) << "the skin moved";
  EXPECT_LT(worst, 8.0f * 0.2f / kSteps) << "no step much longer than the primitive's own";
}

}  // namespace
}  // namespace sinew::test
