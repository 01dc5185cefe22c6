// tests/rig/twins_test.cpp: linked twins mirror each other exactly until unlinked.

#include "core/rig/twins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/rig/validation.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/rig_edits.h"

namespace sinew {
namespace {

using test::Random;

struct Scene {
  std::shared_ptr<const Character> character = test::makeTwoLegged();
  MirrorPlan plan = makeMirrorPlan(*character);
  Rig rig;

  Scene() {
    rig.groups = {{"legs", {}}, {"torso", {}}};
    Primitive thigh;
    thigh.name = "thigh L";
    thigh.bone = "leg L";
    thigh.group = "legs";
    thigh.placement = {
        {0.1f, 0.2f, 0.05f}, glm::angleAxis(0.5f, glm::normalize(glm::vec3(1, 2, 3))), {0.2f, 0.3f, 0.1f}};
    rig = addPair(rig, thigh, plan).value();
  }

  void edit(const Result<Rig>& edited) {
    ASSERT_TRUE(edited) << edited.error().text();
    rig = keepTwins(rig, rig, edited.value(), plan);
    ASSERT_TRUE(validate(rig));
  }
};

/// Every linked pair consists of mirror images, up to a few units in the last place.
void expectExact(const Rig& rig, const MirrorPlan& plan) {
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const int twin = twinOf(rig, static_cast<int>(i));
    if (twin < 0) continue;
    const Primitive& other = rig.primitives[static_cast<std::size_t>(twin)];
    const Result<Primitive> image = mirroredPrimitive(plan, rig.primitives[i]);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->bone, other.bone);
    EXPECT_LT(glm::length(image->placement.center - other.placement.center),
              2e-6f * (1.0f + glm::length(other.placement.center)));
    EXPECT_LT(glm::length(image->placement.radii - other.placement.radii), 1e-6f * glm::length(other.placement.radii));
    for (int part = 0; part < 4; ++part)
      EXPECT_NEAR(image->placement.rotation[part], other.placement.rotation[part], 2e-6f);
    EXPECT_NEAR(image->placement.shape.belly, other.placement.shape.belly, 1e-6f);
    EXPECT_LT(glm::length(image->placement.shape.bend - other.placement.shape.bend), 1e-6f);
    EXPECT_EQ(image->placement.shape.core, other.placement.shape.core);
    EXPECT_EQ(image->reach, other.reach);
    EXPECT_EQ(image->amount, other.amount);
    EXPECT_EQ(image->sign, other.sign);
    EXPECT_EQ(image->group, other.group);
    EXPECT_EQ(image->territory, other.territory);
  }
}

TEST(Twins, AddsAMuscleOnBothSides) {
  const Scene scene;
  ASSERT_EQ(scene.rig.primitives.size(), 2u);
  EXPECT_EQ(scene.rig.primitives[1].name, "thigh R");
  EXPECT_EQ(scene.rig.primitives[1].bone, "leg R");
  EXPECT_EQ(scene.rig.primitives[1].mirror, "thigh L");
  EXPECT_EQ(scene.rig.primitives[0].mirror, "thigh R");
  expectExact(scene.rig, scene.plan);
}

TEST(Twins, MuscleInThePlaneStaysSingle) {
  Scene scene;
  Primitive belly;
  belly.name = "belly";
  belly.bone = "spine";
  belly.placement.radii = {0.2f, 0.3f, 0.1f};
  scene.edit(addPair(scene.rig, belly, scene.plan));
  EXPECT_EQ(scene.rig.primitives.size(), 3u);
  EXPECT_FALSE(mirrorToOtherSide(scene.rig, 2, scene.plan));
}

TEST(Twins, PairWithoutASideInItsNameIsNamedByPosition) {
  for (const float x : {0.3f, -0.3f}) {
    for (const bool later : {false, true}) {
      Scene scene;
      Primitive belly;
      belly.name = "belly";
      belly.bone = "spine";
      belly.placement = {{x, 0.1f, 0.2f}, glm::quat(1, 0, 0, 0), {0.2f, 0.3f, 0.1f}};
      // A name taken on one side: both move on to the next number.
      Primitive taken = belly;
      taken.name = "belly R";
      scene.edit(addPrimitive(scene.rig, taken));
      const int first = static_cast<int>(scene.rig.primitives.size());
      if (later) {
        scene.edit(addPrimitive(scene.rig, belly));
        scene.edit(mirrorToOtherSide(scene.rig, first, scene.plan));
      } else {
        scene.edit(addPair(scene.rig, belly, scene.plan));
      }
      ASSERT_EQ(twinOf(scene.rig, first), first + 1);
      const std::string& one = scene.rig.primitives[static_cast<std::size_t>(first)].name;
      const std::string& other = scene.rig.primitives[static_cast<std::size_t>(first) + 1].name;
      EXPECT_EQ(mirroredName(one), other);
      EXPECT_TRUE(one.starts_with("belly ")) << one;
      // The leg determines which side is left.
      for (const int index : {first, first + 1}) {
        const Primitive& muscle = scene.rig.primitives[static_cast<std::size_t>(index)];
        const auto placeOf = [&](const std::string& bone, const glm::vec3& point) {
          const glm::mat4& bind =
              scene.plan.skeleton.bones[static_cast<std::size_t>(*scene.plan.skeleton.findBone(bone))].bindInWorld;
          return distanceTo(scene.plan.plane, glm::dvec3(bind * glm::vec4(point, 1.0f)));
        };
        const bool withLeft = placeOf(muscle.bone, muscle.placement.center) * placeOf("leg L", glm::vec3(0.0f)) > 0.0;
        EXPECT_EQ(sideNamed(muscle.name), withLeft ? Side::kLeft : Side::kRight) << muscle.name;
      }
      expectExact(scene.rig, scene.plan);
    }
  }
}

TEST(Twins, NameWithSeveralSidesIsKept) {
  Scene scene;
  Primitive belt;
  belt.name = "left to right";
  belt.bone = "spine";
  belt.placement = {{0.3f, 0.1f, 0.2f}, glm::quat(1, 0, 0, 0), {0.2f, 0.3f, 0.1f}};
  scene.edit(addPair(scene.rig, belt, scene.plan));
  EXPECT_EQ(scene.rig.primitives[2].name, "left to right");
  EXPECT_EQ(scene.rig.primitives[3].name, "left to right 2");
}

TEST(Twins, EveryFieldFollowsInBothDirections) {
  Scene scene;
  for (const int leads : {0, 1}) {
    const int follows = 1 - leads;
    Placement placement = scene.rig.primitives[static_cast<std::size_t>(leads)].placement;
    placement.center += glm::vec3(0.01f, 0.02f, -0.03f);
    placement.radii.y *= 1.25f;
    scene.edit(setPlacement(scene.rig, leads, placement));
    expectExact(scene.rig, scene.plan);
    scene.edit(test::setReach(scene.rig, leads, 1.7f + static_cast<float>(leads)));
    scene.edit(test::setSign(scene.rig, leads, leads == 0 ? -1 : 1));
    scene.edit(
        editPrimitives(scene.rig, std::array{leads}, [&](Primitive& p) { p.amount = leads == 0 ? 0.5f : 1.5f; }));
    scene.edit(test::setGroupOf(scene.rig, leads, leads == 0 ? "torso" : "legs"));
    scene.edit(test::setTerritory(scene.rig, leads,
                                  std::vector<std::string>{leads == 0 ? "leg L" : "shin R", "spine", "elsewhere"}));
    expectExact(scene.rig, scene.plan);
    EXPECT_EQ(scene.rig.primitives[static_cast<std::size_t>(follows)].territory,
              (std::vector<std::string>{leads == 0 ? "leg R" : "shin L", "spine", "elsewhere"}));
    scene.edit(test::setBone(scene.rig, leads, leads == 0 ? "shin L" : "spine", placement));
    EXPECT_EQ(scene.rig.primitives[static_cast<std::size_t>(follows)].bone, leads == 0 ? "shin R" : "spine");
    scene.edit(test::setBone(scene.rig, leads, leads == 0 ? "leg L" : "leg R", placement));
    expectExact(scene.rig, scene.plan);
  }
}

TEST(Twins, ShapesAreMirrored) {
  Scene scene;
  const auto shaped = [&](int index, const Shape& shape) {
    Placement placement = scene.rig.primitives[static_cast<std::size_t>(index)].placement;
    placement.shape = shape;
    scene.edit(setPlacement(scene.rig, index, placement));
    expectExact(scene.rig, scene.plan);
  };
  shaped(0, {0.5f, 0.2f, {0.3f, -0.4f}});
  const Shape& twin = scene.rig.primitives[1].placement.shape;
  EXPECT_EQ(twin.core, 0.5f);
  EXPECT_EQ(std::abs(twin.belly), 0.2f);
  EXPECT_EQ(glm::abs(twin.bend), glm::vec2(0.3f, 0.4f));
  // A reflection flips an odd number of axes, since the image is kept right-handed.
  const float turned = twin.belly / 0.2f * (twin.bend.x / 0.3f) * (twin.bend.y / -0.4f);
  EXPECT_LT(turned, 0.0f);
  shaped(1, {0.1f, -0.1f, {0.0f, 1.0f}});
  EXPECT_EQ(scene.rig.primitives[0].placement.shape.core, 0.1f);
}

TEST(Twins, BellyIsLimitedByTheTwinsOwnReach) {
  Scene scene;
  scene.rig.primitives[1].reach = 3.0f;  // A pair that was never exact.
  Placement placement = scene.rig.primitives[0].placement;
  placement.shape.belly = mostBelly(0.0f, scene.rig.primitives[0].reach);
  scene.edit(setPlacement(scene.rig, 0, placement));
  EXPECT_EQ(scene.rig.primitives[1].reach, 3.0f);
  EXPECT_EQ(std::abs(scene.rig.primitives[1].placement.shape.belly), mostBelly(0.0f, 3.0f));
}

TEST(Twins, UneditedFieldsKeepTheirBits) {
  Scene scene;
  for (int i = 0; i < 50; ++i) {
    const Placement before0 = scene.rig.primitives[0].placement;
    const Placement before1 = scene.rig.primitives[1].placement;
    Placement pulled = i % 2 == 0 ? before0 : before1;
    pulled.radii.z += 0.001f;
    scene.edit(setPlacement(scene.rig, i % 2, pulled));
    EXPECT_EQ(scene.rig.primitives[0].placement.center, before0.center);
    EXPECT_EQ(scene.rig.primitives[0].placement.rotation, before0.rotation);
    EXPECT_EQ(scene.rig.primitives[1].placement.center, before1.center);
    EXPECT_EQ(scene.rig.primitives[1].placement.rotation, before1.rotation);
    EXPECT_EQ(scene.rig.primitives[0].placement.radii, scene.rig.primitives[1].placement.radii);
  }
}

TEST(Twins, EditOfBothFollowsTheFirstUnlessTheyAgree) {
  Scene scene;
  Rig both = scene.rig;
  both.primitives[0].reach = 1.5f;
  both.primitives[1].reach = 2.5f;
  both.primitives[0].placement.center.x += 0.1f;
  both.primitives[1].placement.center.x += 0.1f;
  const Rig kept = keepTwins(scene.rig, scene.rig, both, scene.plan);
  EXPECT_EQ(kept.primitives[0].placement.center, both.primitives[0].placement.center);
  EXPECT_EQ(kept.primitives[1].reach, 1.5f);
  expectExact(kept, scene.plan);
  EXPECT_EQ(keepTwins(scene.rig, scene.rig, kept, scene.plan), kept);
}

TEST(Twins, GestureRebuiltFromItsStartStillFollows) {
  Scene scene;
  const Rig start = scene.rig;
  Rig shown = start;
  for (const float x : {0.1f, 0.2f, 0.0f}) {
    Rig wanted = start;
    wanted.primitives[0].placement.center.x += x;
    shown = keepTwins(start, shown, wanted, scene.plan);
    expectExact(shown, scene.plan);
  }
  EXPECT_EQ(shown, start);
}

TEST(Twins, DragBackToItsStartReturnsTheTwin) {
  Scene scene;
  const Rig start = scene.rig;
  Rig shown = start;
  for (const float x : {0.1f, 0.3f, 0.0f}) {
    Rig wanted = shown;
    wanted.primitives[1].placement.center = start.primitives[1].placement.center + glm::vec3(x, 0, 0);
    shown = keepTwins(start, shown, wanted, scene.plan);
    expectExact(shown, scene.plan);
  }
}

TEST(Twins, UnlinkedTwinsStayInPlace) {
  Scene scene;
  scene.edit(clearMirror(scene.rig, 0));
  const Primitive before = scene.rig.primitives[1];
  scene.edit(test::setReach(scene.rig, 0, 3.0f));
  EXPECT_EQ(scene.rig.primitives[1].reach, before.reach);
  scene.edit(linkTwins(scene.rig, 1, 0, scene.plan));
  EXPECT_EQ(scene.rig.primitives[0].reach, before.reach);
  EXPECT_EQ(scene.rig.primitives[0].name, "thigh L");
  expectExact(scene.rig, scene.plan);
}

TEST(Twins, MoveToABoneWithoutCounterpartKeepsTheLink) {
  Scene scene;
  scene.plan.twinOf[static_cast<std::size_t>(*scene.plan.skeleton.findBone("spine"))] = -1;
  const Primitive before = scene.rig.primitives[1];
  scene.edit(test::setBone(scene.rig, 0, "spine", scene.rig.primitives[0].placement));
  EXPECT_EQ(scene.rig.primitives[1].bone, before.bone);
  EXPECT_EQ(scene.rig.primitives[1].mirror, "thigh L");
  EXPECT_FALSE(mirrorToOtherSide(scene.rig, 0, scene.plan));
}

TEST(Twins, FlippingSwapsALinkedPairAndTwiceRestoresIt) {
  Scene scene;
  const Rig start = scene.rig;
  const std::vector<int> one{0};
  scene.edit(flipPrimitives(scene.rig, one, scene.plan));
  EXPECT_EQ(scene.rig.primitives[0].bone, "leg R");
  EXPECT_EQ(scene.rig.primitives[1].bone, "leg L");
  expectExact(scene.rig, scene.plan);
  scene.edit(flipPrimitives(scene.rig, one, scene.plan));
  EXPECT_EQ(scene.rig.primitives[0].bone, start.primitives[0].bone);
  expectExact(scene.rig, scene.plan);
}

TEST(Twins, CopiesOfPairsArePairs) {
  Scene scene;
  const std::vector<int> both{0, 1};
  scene.edit(duplicatePairs(scene.rig, both));
  ASSERT_EQ(scene.rig.primitives.size(), 4u);
  EXPECT_EQ(scene.rig.primitives[2].name, "thigh L 2");
  EXPECT_EQ(scene.rig.primitives[3].name, "thigh R 2");
  EXPECT_EQ(twinOf(scene.rig, 2), 3);
  const std::vector<int> one{0};
  scene.edit(duplicatePairs(scene.rig, one));
  EXPECT_EQ(twinOf(scene.rig, 4), -1);
  EXPECT_EQ(twinOf(scene.rig, 0), 1);
  EXPECT_EQ(withTwins(scene.rig, std::vector<int>{3, 4, 0}), (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Twins, NamesFollowIfTheSideIsClear) {
  Scene scene;
  scene.edit(renameWithTwin(scene.rig, 0, "quad L"));
  EXPECT_EQ(scene.rig.primitives[1].name, "quad R");
  EXPECT_EQ(twinOf(scene.rig, 0), 1);
  scene.edit(renameWithTwin(scene.rig, 1, "big one"));
  EXPECT_EQ(scene.rig.primitives[0].name, "quad L");
  EXPECT_EQ(twinOf(scene.rig, 0), 1);
  scene.edit(renameWithTwin(scene.rig, 0, "big L"));
  EXPECT_EQ(scene.rig.primitives[1].name, "big R");
}

/// One random edit; none: it was refused.
std::optional<Rig> randomEdit(Random& random, const Rig& rig, const Character& character, const MirrorPlan& plan) {
  const auto value = [](Result<Rig> result) { return result ? std::optional(result.value()) : std::nullopt; };
  const auto below = [&](std::size_t n) { return random.below(static_cast<int>(n)); };
  const std::size_t n = rig.primitives.size();
  const int index = n > 0 ? below(n) : 0;
  const std::string bone = character.skeleton.fileName(below(character.skeleton.bones.size()));
  const Placement placement{{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
                            random.rotation(),
                            {random.uniform(0.05f, 1), random.uniform(0.05f, 1), random.uniform(0.05f, 1)}};
  Primitive fresh;
  fresh.name = random.chance(0.5f) ? "muscle L" : "m" + std::to_string(random.below(9));
  fresh.bone = bone;
  fresh.placement = placement;
  std::vector<int> several;
  for (std::size_t i = 0; i < n; ++i) {
    if (random.chance(0.15f)) several.push_back(static_cast<int>(i));
  }
  switch (n == 0 ? 0 : random.below(14)) {
    case 0:
    case 1:
      return value(addPair(rig, fresh, plan));
    case 2:
      return value(addPrimitive(rig, fresh));
    case 3:
      return value(setPlacement(rig, index, placement));
    case 4:
      return value(test::setBone(rig, index, bone, placement));
    case 5:
      return value(test::setReach(rig, index, random.uniform(0.9f, 3)));
    case 6:
      return value(test::setSign(rig, index, random.chance(0.5f) ? 1 : -1));
    case 7:
      return n > 24 ? removePrimitives(rig, withTwins(rig, several)) : duplicatePairs(rig, several);
    case 8:
      return value(mirrorToOtherSide(rig, index, plan));
    case 9:
      return clearMirror(rig, index);
    case 10:
      return value(renameWithTwin(rig, index, random.chance(0.5f) ? "leg L" : "n" + std::to_string(random.below(20))));
    case 11:
      return value(flipPrimitives(rig, several, plan));
    case 12:
      return value(test::setTerritory(rig, index, std::vector<std::string>{bone}));
    default:
      break;
  }
  const int other = below(n);
  return other == index ? std::nullopt : value(linkTwins(rig, index, other, plan));
}

TEST(Twins, RandomEditsKeepPairsExactAndTheRigValid) {
  const auto character = test::makeTwoLegged();
  const MirrorPlan plan = makeMirrorPlan(*character);
  Random random(20);
  Rig rig;
  int done = 0;
  while (done < 600) {
    const std::optional<Rig> edited = randomEdit(random, rig, *character, plan);
    if (!edited) continue;
    rig = keepTwins(rig, rig, *edited, plan);
    ASSERT_TRUE(validate(rig)) << validate(rig).error().text();
    expectExact(rig, plan);
    if (testing::Test::HasFailure()) return;
    ++done;
  }
  EXPECT_GT(rig.primitives.size(), 5u);
}

}  // namespace
}  // namespace sinew
