// tests/bodies/mend_drawn_test.cpp: drawn muscles laid along one bone: their position, and that check() reports nothing
// about them.

#include "core/bodies/mend.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "core/bodies/check.h"
#include "core/bodies/relaid_belly.h"
#include "core/rig/line_edit.h"
#include "tests/bodies/drawn_muscles.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::test {
namespace {

constexpr BellyBone kBoth[] = {BellyBone::kOrigin, BellyBone::kInsertion};

/// Unit ball -> world of the bind pose.
glm::mat4 shapeOf(const Primitive& primitive, const Character& character) {
  const Bone& bone = at(character.skeleton.bones, *character.skeleton.findBone(primitive.bone));
  return shapeInWorld(primitive.placement, 1.0f, bone.bindInWorld);
}

float apart(const glm::mat4& a, const glm::mat4& b) {
  float most = 0.0f;
  for (int i = 0; i < 4; ++i) most = std::max(most, glm::distance(glm::vec3(a[i]), glm::vec3(b[i])));
  return most;
}

class RelaidBellies : public testing::TestWithParam<const char*> {
 protected:
  const std::shared_ptr<const Character> character =
      std::string(GetParam()) == "two legs" ? makeTwoLegged() : bundledCharacter(GetParam());
  const Motions motions{character};
  const std::vector<BellyChoice> drawn = drawnMuscles(*character, 2, 17);

  template <typename Test>
  void forEach(const Test& test) {
    ASSERT_FALSE(drawn.empty());
    for (const BellyChoice& choice : drawn) {
      SCOPED_TRACE(choice.line->insertion.bone);
      const BellyTrial trial(choice, SurfaceSettings{}, motions);
      if (!trial.canTell()) continue;
      test(choice, RelaidBelly(choice, trial, *character));
    }
  }
};

TEST_P(RelaidBellies, DrawnMuscleStaysAndItsOtherEndMovesTowardsTheJoint) {
  forEach([&](const BellyChoice& choice, const RelaidBelly& relaid) {
    const LineRest before = lineRest(*choice.line, *character).value();
    const glm::dvec3 joint(jointBetween(before, *character));
    for (const BellyBone bone : kBoth) {
      const BellyChoice other = relaid.asDrawn(bone, 0.5f);
      EXPECT_LT(apart(shapeOf(other.primitive, *character), shapeOf(choice.primitive, *character)),
                1e-4f * character->height);
      const LineRest after = lineRest(*other.line, *character).value();
      const bool atOrigin = bone == BellyBone::kOrigin;
      EXPECT_EQ(other.primitive.bone, atOrigin ? choice.line->origin.bone : choice.line->insertion.bone);
      const auto& [own, ownBefore] =
          atOrigin ? std::tie(after.origin, before.origin) : std::tie(after.insertion, before.insertion);
      const auto& [far, farBefore] =
          atOrigin ? std::tie(after.insertion, before.insertion) : std::tie(after.origin, before.origin);
      EXPECT_LT(glm::distance(own.inBind, ownBefore.inBind), 1e-5 * static_cast<double>(character->height));
      EXPECT_LT(glm::distance(far.inBind - joint, 0.5 * (farBefore.inBind - joint)),
                1e-5 * static_cast<double>(character->height));
      EXPECT_EQ(far.bone, farBefore.bone);
    }
  });
}

TEST_P(RelaidBellies, ShorterBellyLiesBetweenItsTendonsUnderSkinOfItsBone) {
  int made = 0;
  forEach([&](const BellyChoice& choice, const RelaidBelly& relaid) {
    for (const BellyBone bone : kBoth) {
      const auto other = relaid.shorter(bone, 1.0f, 0.45f);
      if (!other) continue;
      ++made;
      const LineRest rest = lineRest(*other->line, *character).value();
      const glm::mat4 shape = shapeOf(other->primitive, *character);
      const float half = glm::length(glm::vec3(shape[1]));
      const auto length = static_cast<float>(rest.length);
      EXPECT_NEAR(2.0f * half, (1.0f - 0.1f - 0.45f) * length, 1e-4f * length);
      EXPECT_GT(std::abs(glm::dot(glm::normalize(glm::dvec3(shape[1])), rest.direction)), 0.999);
      // Position along the line.
      const glm::vec3 own = relaid.ownEnd(bone);
      const glm::vec3 towards = glm::vec3(rest.direction) * (bone == BellyBone::kOrigin ? 1.0f : -1.0f);
      EXPECT_GT(glm::dot(glm::vec3(shape[3]) - own, towards), 0.0f);
      const glm::vec3 over = glm::vec3(shape[3]) + glm::vec3(shape[2]);
      const auto skin = relaid.skin(bone).nearest(over);
      ASSERT_TRUE(skin.has_value());
      EXPECT_LT(glm::distance(skin->origin, over), half) << "under skin of its bone";
      EXPECT_EQ(other->line->origin.bone, choice.line->origin.bone);
      EXPECT_EQ(other->line->insertion.bone, choice.line->insertion.bone);
    }
  });
  EXPECT_GT(made, 0);
}

TEST_P(RelaidBellies, BellyUnderFirmSkinFollowsTheSkinAndIsNoLonger) {
  int made = 0;
  forEach([&](const BellyChoice& choice, const RelaidBelly& relaid) {
    const float drawnHalf = glm::length(glm::vec3(shapeOf(choice.primitive, *character)[1]));
    for (const BellyBone bone : kBoth) {
      for (const float inwards : {0.0f, 1.0f}) {
        const auto other = relaid.under(bone, 0.5f, 0.45f, inwards);
        if (!other) continue;
        ++made;
        const glm::mat4 shape = shapeOf(other->primitive, *character);
        EXPECT_LE(glm::length(glm::vec3(shape[1])), 1.001f * drawnHalf);
        const glm::vec3 top(shape[3] + shape[2]);
        const float near = 1.5f * glm::length(glm::vec3(shape[2]));
        EXPECT_TRUE(std::ranges::any_of(relaid.skin(bone).firm(), [&](const OwnTriangle& own) {
          const glm::vec3 along = glm::normalize(glm::vec3(shape[1]));
          return glm::distance(own.frame.origin, top) < near && std::abs(glm::dot(along, own.frame.normal())) < 0.87f;
        }));
        EXPECT_TRUE(lineRest(*other->line, *character).ok());
      }
    }
  });
  EXPECT_GT(made, 0);
}

TEST_P(RelaidBellies, LargerBellyKeepsItsTopAndLength) {
  forEach([&](const BellyChoice& choice, const RelaidBelly&) {
    const glm::mat4 before = shapeOf(choice.primitive, *character);
    const glm::mat4 after = shapeOf(larger(choice, 1.4f).primitive, *character);
    EXPECT_LT(glm::distance(glm::vec3(before[3] + before[2]), glm::vec3(after[3] + after[2])),
              1e-5f * character->height);
    EXPECT_NEAR(glm::length(glm::vec3(after[1])), glm::length(glm::vec3(before[1])), 1e-5f * character->height);
    EXPECT_NEAR(glm::length(glm::vec3(after[0])), 1.4f * glm::length(glm::vec3(before[0])), 1e-5f * character->height);
  });
}

TEST_P(RelaidBellies, CleanMusclesPassTheCheck) {
  int found = 0;
  int lined = 0;
  int count = 0;
  int compared = 0;
  forEach([&](const BellyChoice& choice, const RelaidBelly& relaid) {
    ++count;
    found += check(rigOf(choice), motions).empty() ? 0 : 1;
    const auto muscle = withDrawnMuscle(choice, SurfaceSettings{}, motions);
    ASSERT_TRUE(muscle.has_value());
    EXPECT_EQ(muscle->isClean, check(rigOf(muscle->choice), motions).empty()) << muscle->choice.said;
    EXPECT_FALSE(muscle->choice.said.empty());
    lined += muscle->choice.line ? 1 : 0;
    std::vector<std::optional<BellyChoice>> others;
    for (const BellyBone bone : kBoth) {
      for (const float tendon : {0.3f, 0.6f}) others.push_back(relaid.shorter(bone, 1.0f, tendon));
      for (const float inwards : {0.0f, 1.0f}) others.push_back(relaid.under(bone, 0.5f, 0.3f, inwards));
    }
    for (std::optional<BellyChoice>& other : others) {
      if (!other || !relaid.isNear(*other)) continue;
      learnFull(*other->line, motions);
      const BellyTrial trial(*other, SurfaceSettings{}, motions);
      if (!trial.canTell() || trial.trouble(kMendedMargin) > kMendedMargin) continue;
      ++compared;
      EXPECT_LE(relaid.distanceOf(muscle->choice), relaid.distanceOf(*other) + 1e-4f * character->height)
          << muscle->choice.said;
    }
    if (muscle->choice.line) {
      const glm::mat4 before = shapeOf(choice.primitive, *character);
      const float off =
          glm::distance(glm::vec3(before[3]), glm::vec3(shapeOf(muscle->choice.primitive, *character)[3]));
      // Larger ones lie somewhat deeper.
      EXPECT_LT(off, 1.2f * std::max(3.0f * glm::length(glm::vec3(before[1])), 0.1f * character->height));
    }
    EXPECT_EQ(muscle->choice.primitive.line.empty(), !muscle->choice.line);
    if (const auto nearer = withNearerEnd(choice, SurfaceSettings{}, motions)) {
      EXPECT_TRUE(check(rigOf(*nearer), motions).empty());
      EXPECT_LT(apart(shapeOf(nearer->primitive, *character), shapeOf(choice.primitive, *character)),
                1e-4f * character->height);
    }
  });
  EXPECT_GT(found, 0) << "else there is nothing to mend here";
  std::printf("  %d compared\n", compared);
  EXPECT_GE(3 * lined, 2 * count) << "most of them flex";
}

TEST_P(RelaidBellies, EndAcrossTwoJointsCanMoveToTheBoneBetween) {
  int lined = 0;
  int count = 0;
  int moved = 0;
  for (const BellyChoice& choice : drawnMuscles(*character, 1, 5, 2)) {
    const auto muscle = withDrawnMuscle(choice, SurfaceSettings{}, motions);
    ASSERT_TRUE(muscle.has_value());
    ++count;
    EXPECT_EQ(muscle->isClean, check(rigOf(muscle->choice), motions).empty()) << muscle->choice.said;
    if (!muscle->choice.line) continue;
    ++lined;
    const Skeleton& skeleton = character->skeleton;
    const int lower = *skeleton.findBone(choice.line->insertion.bone);
    const std::string& between = skeleton.fileName(at(skeleton.bones, lower).parent);
    const MuscleLine& line = *muscle->choice.line;
    const bool originMoved = line.origin.bone != choice.line->origin.bone;
    const bool insertionMoved = line.insertion.bone != choice.line->insertion.bone;
    EXPECT_FALSE(originMoved && insertionMoved);
    EXPECT_EQ(line.origin.bone, originMoved ? between : choice.line->origin.bone);
    EXPECT_EQ(line.insertion.bone, insertionMoved ? between : choice.line->insertion.bone);
    moved += originMoved || insertionMoved ? 1 : 0;
  }
  std::printf("  %s: %d over two joints, %d on a line, %d with an end on the bone between\n", GetParam(), count, lined,
              moved);
  EXPECT_GT(count, 0);
  EXPECT_GE(2 * lined, count);
}

INSTANTIATE_TEST_SUITE_P(Characters, RelaidBellies, testing::Values("humanoid.glb", "horse.glb", "two legs"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::ranges::replace_if(
                               name, [](char c) { return c == '.' || c == ' '; }, '_');
                           return name;
                         });

TEST(OwnSkin, BelongsToItsBoneAndFindsTheNearestPoint) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> anywhere(-1.0f, 2.0f);
  for (const auto& character : {makeLimb(), makeTwoLegged()}) {
    for (int bone = 0; bone < static_cast<int>(character->skeleton.bones.size()); ++bone) {
      const OwnSkin skin(*character, bone);
      EXPECT_EQ(skin.bone(), bone);
      for (const OwnTriangle& own : skin.firm()) {
        const auto& corners = at(character->mesh.triangles, own.triangle).vertices;
        EXPECT_TRUE(std::ranges::any_of(corners, [&](int v) { return strongestBone(*character, v) == bone; }));
      }
      const glm::vec3 point(anywhere(random), anywhere(random), anywhere(random));
      const auto nearest = skin.nearest(point);
      EXPECT_EQ(nearest.has_value(), !skin.firm().empty());
      for (const OwnTriangle& own : skin.firm()) {
        EXPECT_LE(glm::distance(nearest->origin, point), glm::distance(own.frame.origin, point) + 1e-6f);
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
