// tests/bodies/fit_to_sculpt_test.cpp: muscles found again from their own skin, and what a fit keeps and refuses.
#include "core/bodies/fit_to_sculpt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/bodies/check.h"
#include "core/bodies/fit_muscles.h"
#include "core/bodies/height_model.h"
#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/weld.h"
#include "core/rig/twins.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/body_with_arms.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

using test::Random;

/// Triangles of a surface as a file would have them: any numbering, any diagonals.
ControlMesh sculptOf(const std::vector<glm::vec3>& positions, std::vector<std::array<std::uint32_t, 3>> triangles) {
  TriangleSoup soup;
  soup.positions = positions;
  soup.uvs.assign(positions.size(), glm::vec2(0.0f));
  soup.influenceBegin.assign(positions.size() + 1, 0);
  soup.triangles = std::move(triangles);
  soup.materials.assign(soup.triangles.size(), 0);
  return weld(soup, 1e-6f);
}

Surface surfaceOf(const std::shared_ptr<const Character>& character, Rig rig, int depth) {
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = depth;
  Smoother smoother(character);
  EXPECT_TRUE(smoother.prepare(rig).ok());
  Surface surface;
  EXPECT_TRUE(smoother.smooth(bindPose(character->skeleton), surface));
  return surface;
}

ControlMesh sculptOf(const std::shared_ptr<const Character>& character, const Rig& rig, int depth) {
  const Surface surface = surfaceOf(character, rig, depth);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto& [a, b, c] : surface.refinement->triangles) {
    triangles.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  }
  return sculptOf(surface.positions, std::move(triangles));
}

/// Flat heads just under the skin, some of which overlap. The surface lowers few of their rims.
Rig broadMuscles(const Character& character, int count, std::uint64_t seed) {
  Random random(seed);
  Rig rig;
  rig.groups = {{"one", {}, {}}, {"two", {}, {}}};
  rig.surface.grooves = seed % 2 == 0 ? kNewGrooves : 0.0f;
  const float h = character.height;
  for (int i = 0; i < count; ++i) {
    int v = 0;
    glm::vec3 normal(0.0f);
    do {  // On the outer sides, away from creases.
      v = random.below(static_cast<int>(character.mesh.positions.size()));
      normal = at(character.mesh.normals, v);
    } while (!(normal.x * at(character.mesh.positions, v).x > 0.5f * std::abs(at(character.mesh.positions, v).x)));
    const float thick = random.uniform(0.018f, 0.022f) * h;
    const glm::vec3 radii{random.uniform(0.03f, 0.045f) * h, random.uniform(0.05f, 0.09f) * h, thick};
    const glm::vec3 place = at(character.mesh.positions, v) - random.uniform(0.7f, 0.9f) * thick * normal;
    const int bone = strongestBone(character, v);
    Primitive muscle = test::ellipsoidAt(character, "m" + std::to_string(i), character.skeleton.fileName(bone),
                                         i % 2 == 0 ? "one" : "two", place, radii);
    const glm::vec3 side = glm::normalize(glm::cross(normal, glm::vec3(0.3f, 1.0f, 0.2f)));
    const glm::mat3 turn(glm::inverse(at(character.skeleton.bones, bone).bindInWorld));
    muscle.placement.rotation =
        glm::normalize(glm::quat_cast(turn * glm::mat3(side, glm::cross(normal, side), normal)));
    muscle.reach = random.uniform(1.6f, 2.0f);
    rig.primitives.push_back(muscle);
  }
  return rig;
}

/// Moved at random as far as a rough placement may be wrong.
Rig shaken(const Rig& rig, const Character& character, const MirrorPlan* plan, std::uint64_t seed, double share) {
  const FitMuscles muscles(rig, character, plan);
  Random random(seed);
  std::vector<double> step;
  for (std::size_t i = 0; i < muscles.size() * kFitNumbers; ++i) {
    const double size = i % kFitNumbers < 3 ? 0.005 * static_cast<double>(character.height) : 0.12;
    step.push_back(share * size * static_cast<double>(random.uniform(-1.0f, 1.0f)));
  }
  return muscles.moved(rig, step);
}

/// Root of the mean square of the distances between the surfaces of two rigs where either is moved, fraction of H.
double apart(const std::shared_ptr<const Character>& character, const Rig& a, const Rig& b) {
  const Surface first = surfaceOf(character, a, 4);
  const Surface second = surfaceOf(character, b, 4);
  std::vector<double> areas(first.positions.size(), 0.0);
  for (const auto& [u, v, w] : first.refinement->triangles) {
    const glm::vec3 from = at(first.positions, u);
    const glm::vec3 twice = glm::cross(at(first.positions, v) - from, at(first.positions, w) - from);
    for (const int corner : {u, v, w}) at(areas, corner) += static_cast<double>(glm::length(twice));
  }
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (first.displacement[v] == 0.0f && second.displacement[v] == 0.0f) continue;
    const glm::dvec3 between(first.positions[v] - second.positions[v]);
    sum += areas[v] * glm::dot(between, between);
    area += areas[v];
  }
  return area > 0.0 ? std::sqrt(sum / area) / static_cast<double>(character->height) : 0.0;
}

struct FitToSculpt : testing::Test {
  std::shared_ptr<const Character> character = test::makeTwoLegged();
  MirrorPlan plan = makeMirrorPlan(*character);
  Motions motions{character};

  [[nodiscard]] Result<SculptFit> fit(const Rig& rig, const ControlMesh& sculpt,
                                      const SculptFitOptions& options) const {
    return fitToSculpt(rig, character, plan, motions, sculpt, options);
  }
  /// A muscle on the left leg, its twin, and one in the middle.
  [[nodiscard]] Rig pairs() const {
    Rig rig;
    const float h = character->height;
    const auto& bones = character->skeleton.bones;
    const auto at = [&](const char* bone, const glm::vec3& away) {
      return glm::vec3(sinew::at(bones, *character->skeleton.findBone(bone)).bindInWorld[3]) + away * h;
    };
    Primitive leg = test::ellipsoidAt(*character, "calf L", "shin L", "", at("shin L", {0.03f, -0.1f, 0.03f}),
                                      glm::vec3(0.05f, 0.1f, 0.05f) * h);
    leg.reach = 1.5f;
    auto added = addPair(rig, leg, plan);
    EXPECT_TRUE(added.ok()) << added.error().text();
    Primitive middle = test::ellipsoidAt(*character, "belly", "hips", "", at("hips", {0.0f, 0.05f, 0.05f}),
                                         glm::vec3(0.08f, 0.06f, 0.06f) * h);
    added = addPair(added.value(), middle, plan);
    EXPECT_TRUE(added.ok());
    return added.value();
  }
};

TEST_F(FitToSculpt, FindsRandomMusclesAgain) {
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Rig meant = broadMuscles(*character, 4, seed);
    const Rig start = shaken(meant, *character, nullptr, seed, 1.0);
    const double before = apart(character, meant, start);
    const auto found = fit(start, sculptOf(character, meant, 6), {.hold = kLeastHold, .mirror = false});
    ASSERT_TRUE(found.ok()) << found.error().text();
    const double after = apart(character, meant, found->rig);
    EXPECT_GT(before, 4.0 * after) << seed;
    EXPECT_GT(found->before.rms, 4.0 * found->after.rms) << seed;
    worst = std::max(worst, found->after.rms);
  }
  EXPECT_LT(worst, 2e-4);
}

TEST_F(FitToSculpt, TrianglesOfTheSculptDoNotMatter) {
  const Rig meant = pairs();
  const Rig start = shaken(meant, *character, &plan, 1, 1.0);
  const auto first = fit(start, sculptOf(character, meant, 4), {});
  ASSERT_TRUE(first.ok()) << first.error().text();
  // Finer, in another order, faces inside out.
  const Surface surface = surfaceOf(character, meant, 7);
  std::vector<glm::vec3> positions(surface.positions.rbegin(), surface.positions.rend());
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const auto last = static_cast<int>(positions.size()) - 1;
  for (auto each = surface.refinement->triangles.rbegin(); each != surface.refinement->triangles.rend(); ++each) {
    const auto& [a, b, c] = *each;
    triangles.push_back({static_cast<std::uint32_t>(last - c), static_cast<std::uint32_t>(last - b),
                         static_cast<std::uint32_t>(last - a)});
  }
  const auto second = fit(start, sculptOf(positions, triangles), {});
  ASSERT_TRUE(second.ok()) << second.error().text();
  EXPECT_LT(apart(character, first->rig, second->rig), 2e-4);
  // With holes, and with scraps beside the skin.
  std::erase_if(triangles, [&](const auto& t) { return t[0] % 11 == 0; });
  const auto scraps = static_cast<std::uint32_t>(positions.size());
  for (std::uint32_t i = 0; i < 60; ++i) {
    const std::uint32_t corner = 97 * i % scraps;
    for (const float x : {0.0f, 0.002f, 0.004f}) {
      positions.push_back(positions[corner] +
                          (0.05f + x) * character->height * surface.normals[static_cast<std::size_t>(last) - corner]);
    }
    const auto n = static_cast<std::uint32_t>(positions.size());
    triangles.push_back({n - 3, n - 2, n - 1});
  }
  const auto third = fit(start, sculptOf(positions, triangles), {});
  ASSERT_TRUE(third.ok()) << third.error().text();
  EXPECT_LT(apart(character, first->rig, third->rig), 4e-4);
}

TEST_F(FitToSculpt, HoldKeepsTheMuscles) {
  const Rig meant = pairs();
  const Rig start = shaken(meant, *character, &plan, 2, 2.0);
  const ControlMesh sculpt = sculptOf(character, meant, 4);
  double moved = 1.0;
  double explained = 2.0;
  for (const float hold : {0.01f, 0.1f, 1.0f}) {
    const auto done = fit(start, sculpt, {.hold = hold});
    ASSERT_TRUE(done.ok()) << done.error().text();
    EXPECT_LT(done->moved, moved + 1e-6);
    EXPECT_LT(done->after.explained, explained + 1e-6);
    EXPECT_GE(done->after.explained, done->before.explained);
    moved = done->moved;
    explained = done->after.explained;
  }
}

TEST_F(FitToSculpt, TwinsStayMirrorImagesAndTheMiddleInThePlane) {
  const Rig meant = pairs();
  const Rig start = shaken(meant, *character, &plan, 3, 1.0);
  const auto done = fit(start, sculptOf(character, meant, 4), {});
  ASSERT_TRUE(done.ok()) << done.error().text();
  ASSERT_EQ(done->rig.primitives.size(), start.primitives.size());
  EXPECT_NE(done->rig.primitives[0].placement, start.primitives[0].placement);
  const auto image = mirroredPrimitive(plan, done->rig.primitives[0]);
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(done->rig.primitives[1].placement, image->placement);
  EXPECT_EQ(done->rig.primitives[1].amount, done->rig.primitives[0].amount);
  EXPECT_TRUE(liesInPlane(plan, done->rig.primitives[2], 1e-5f));
  for (std::size_t i = 0; i < start.primitives.size(); ++i) {
    Primitive same = done->rig.primitives[i];
    same.placement = start.primitives[i].placement;
    same.amount = start.primitives[i].amount;
    EXPECT_EQ(same, start.primitives[i]);
    EXPECT_EQ(done->rig.primitives[i].placement.shape, start.primitives[i].placement.shape);
  }
}

TEST_F(FitToSculpt, EachSideFollowsItsOwnSculptIfAsked) {
  Rig meant = pairs();
  meant.primitives[0].mirror.clear();
  meant.primitives[1].mirror.clear();
  meant.primitives[1].placement.radii *= 0.8f;
  const Rig start = pairs();
  const ControlMesh sculpt = sculptOf(character, meant, 4);
  const auto both = fit(start, sculpt, {.hold = 0.02f});
  const auto each = fit(start, sculpt, {.hold = 0.02f, .mirror = false});
  ASSERT_TRUE(both.ok() && each.ok());
  EXPECT_LT(apart(character, meant, each->rig), 0.5 * apart(character, meant, both->rig));
  for (const Primitive& primitive : each->rig.primitives) EXPECT_TRUE(primitive.mirror.empty());
}

TEST_F(FitToSculpt, KeyedMusclesStay) {
  Rig start = pairs();
  AnimatedNumber keyed;
  keyed.parameter = Parameter::kAmount;
  start.primitives[2].animated = {keyed};
  Rig meant = pairs();
  meant.primitives[2].placement.radii *= 1.2f;
  const auto done = fit(start, sculptOf(character, meant, 4), {});
  ASSERT_TRUE(done.ok()) << done.error().text();
  EXPECT_EQ(done->rig.primitives[2], start.primitives[2]);
}

TEST_F(FitToSculpt, CarvesLowerTheSkinOnRequest) {
  Rig meant = pairs();
  const Placement& calf = meant.primitives[0].placement;
  const glm::vec3 shin(character->skeleton.bones[toIndex(*character->skeleton.findBone("shin L"))].bindInWorld[3]);
  const float h = character->height;
  Primitive hollow = test::ellipsoidAt(*character, "hollow L", "shin L", meant.primitives[0].group,
                                       shin + h * glm::vec3(0.03f, -0.1f, 0.09f), 0.6f * calf.radii);
  hollow.sign = -1;
  hollow.amount = 0.5f;
  const auto carved = addPair(meant, hollow, plan);
  ASSERT_TRUE(carved.ok()) << carved.error().text();
  const ControlMesh sculpt = sculptOf(character, carved.value(), 4);
  const auto without = fit(meant, sculpt, {});
  const auto with = fit(meant, sculpt, {.carves = 2});
  ASSERT_TRUE(without.ok() && with.ok());
  EXPECT_EQ(without->carves, 0);
  EXPECT_GE(with->carves, 1);
  EXPECT_GT(with->after.explained, without->after.explained);
  for (std::size_t i = meant.primitives.size(); i < with->rig.primitives.size(); ++i) {
    EXPECT_EQ(with->rig.primitives[i].sign, -1);
  }
}

TEST_F(FitToSculpt, NoMuscleLeavesTheFleshThatDidNotBefore) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Rig meant = test::randomRig(*character, {.primitives = 5, .carveChance = 0.0f}, 100 + seed);
    const Rig start = shaken(meant, *character, nullptr, seed, 2.0);
    const auto done = fit(start, sculptOf(character, meant, 4), {.hold = kLeastHold, .mirror = false});
    ASSERT_TRUE(done.ok()) << done.error().text();
    std::vector<int> before;
    for (const Finding& finding : check(start, motions)) before.push_back(finding.primitive);
    for (const Finding& finding : check(done->rig, motions)) {
      EXPECT_NE(std::ranges::find(before, finding.primitive), before.end()) << textOf(finding);
    }
  }
}

TEST_F(FitToSculpt, ThreadsDoNotMatter) {
  const Rig meant = pairs();
  const Rig start = shaken(meant, *character, &plan, 4, 1.0);
  const ControlMesh sculpt = sculptOf(character, meant, 4);
  const auto many = fit(start, sculpt, {});
  const ThreadLimit alone(1);
  const auto one = fit(start, sculpt, {});
  ASSERT_TRUE(many.ok() && one.ok());
  EXPECT_EQ(many->rig, one->rig);
}

TEST_F(FitToSculpt, IsCancelledAnywhere) {
  const Rig meant = pairs();
  const Rig start = shaken(meant, *character, &plan, 5, 1.0);
  const ControlMesh sculpt = sculptOf(character, meant, 3);
  double last = 0.0;
  int calls = 0;
  SculptFitOptions options;
  options.progress = [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
    return ++calls > 0;
  };
  ASSERT_TRUE(fit(start, sculpt, options).ok());
  ASSERT_GT(calls, 2);
  for (const int at : {1, calls}) {
    int left = at;
    options.progress = [&](double) { return --left > 0; };
    const auto stopped = fit(start, sculpt, options);
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().reason, kFitCanceled);
  }
}

TEST_F(FitToSculpt, RefusesWhatIsNotThisBody) {
  const Rig rig = pairs();
  const ControlMesh sculpt = sculptOf(character, rig, 3);
  const auto refused = [&](const Rig& of, ControlMesh mesh, auto change) {
    for (glm::vec3& p : mesh.positions) p = change(p);
    const auto done = fit(of, mesh, {});
    return done ? std::string() : done.error().reason;
  };
  const auto same = [](const glm::vec3& p) { return p; };
  EXPECT_EQ(refused(rig, sculpt, same), "");
  EXPECT_NE(refused(rig, sculpt, [](const glm::vec3& p) { return 2.0f * p; }).find("2 times as large"),
            std::string::npos);
  EXPECT_NE(refused(rig, sculpt, [&](const glm::vec3& p) { return p + glm::vec3(character->height); }).find("away"),
            std::string::npos);
  EXPECT_NE(refused(rig, sculpt, [&](const glm::vec3& p) { return glm::vec3(p.z, p.y, -p.x); }), "");
  EXPECT_NE(refused(Rig{}, sculpt, same).find("no muscle"), std::string::npos);
  EXPECT_NE(refused(rig, {}, same).find("no triangles"), std::string::npos);
  Rig replaces = rig;
  replaces.surface.mode = SurfaceMode::kReplace;
  EXPECT_NE(refused(replaces, sculpt, same).find("swell"), std::string::npos);
}

}  // namespace
}  // namespace sinew
