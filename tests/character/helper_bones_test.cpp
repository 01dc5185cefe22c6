// tests/character/helper_bones_test.cpp: helper bones move no skin.

#include "core/character/joint_roles.h"

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/character/bindings.h"
#include "core/character/range_of_motion.h"
#include "tests/support/characters/real_characters.h"

namespace sinew {
namespace {

Skeleton skeletonOf(const std::vector<int>& parents) {
  Skeleton skeleton;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    Bone bone;
    bone.name = "bone " + std::to_string(i);
    bone.parent = parents[i];
    bone.node = static_cast<int>(i);
    bone.bindInWorld[3] = glm::vec4(0.0f, static_cast<float>(i), 0.0f, 1.0f);
    skeleton.bones.push_back(bone);
    skeleton.nodes.push_back({bone.name, bone.parent, {}});
  }
  finishBones(skeleton);
  return skeleton;
}

// Definition, bone by bone: a bone with skin has this one as an ancestor, or is it.
bool isAboveSkin(const Skeleton& skeleton, const std::vector<bool>& skin, int bone) {
  for (std::size_t i = 0; i < skin.size(); ++i) {
    for (int b = static_cast<int>(i); skin[i] && b >= 0; b = skeleton.bones[static_cast<std::size_t>(b)].parent) {
      if (b == bone) return true;
    }
  }
  return false;
}

TEST(HelperBones, HaveNoSkinOnThemOrTheirDescendants) {
  std::mt19937 random(11);
  for (int round = 0; round < 500; ++round) {
    std::vector<int> parents{-1};
    std::vector<bool> skin{random() % 4 == 0};
    const std::size_t count = 1 + random() % 20;
    while (parents.size() < count) {
      parents.push_back(static_cast<int>(random() % (parents.size() + 1)) - 1);
      skin.push_back(random() % 4 == 0);
    }
    const Skeleton skeleton = skeletonOf(parents);
    const bool any = std::ranges::find(skin, true) != skin.end();
    const std::vector<bool> helpers = helperBones(skeleton, skin);
    ASSERT_EQ(helpers.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(helpers[i], any && !isAboveSkin(skeleton, skin, static_cast<int>(i))) << round << ": " << i;
    }
    // The parent of a bone that is no helper is none either: hiding helpers leaves no hole in the tree.
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_FALSE(!helpers[i] && parents[i] >= 0 && helpers[static_cast<std::size_t>(parents[i])]);
    }
  }
}

TEST(HelperBones, DoNotExistWithoutSkinInformation) {
  const Skeleton skeleton = skeletonOf({-1, 0, 1});
  EXPECT_EQ(helperBones(skeleton, {}), std::vector<bool>(3, false));
  EXPECT_EQ(helperBones(skeleton, {false, false, false}), std::vector<bool>(3, false));
}

TEST(HelperBones, AreExcludedFromTheRangeOfMotion) {
  const Skeleton skeleton = skeletonOf({-1, 0, 1, 1, 3, 0});
  RangeOfMotionHints hints;
  hints.carriesSkin = {true, true, true, false, false, false};
  const std::vector<bool> helpers = helperBones(skeleton, hints.carriesSkin);
  std::set<int> moved;
  for (const MovementStep& step : rangeOfMotionSteps(skeleton, hints)) {
    for (const JointMovement& movement : step) moved.insert(movement.bone);
  }
  EXPECT_EQ(moved, (std::set<int>{1, 2}));
  for (const int bone : moved) EXPECT_FALSE(helpers[static_cast<std::size_t>(bone)]);
}

// A helper moves no vertex, judged by the weights alone.
TEST(HelperBones, MoveNoVertexOfRealCharacters) {
  for (const char* file : {"robot.glb", "Fox.glb", "greenman.glb"}) {
    const auto character = test::realCharacter(file);
    if (!character) GTEST_SKIP() << "left out: no " << file;
    const std::vector<bool> helpers = helperBones(*character);
    for (const Influence& influence : character->mesh.influences) {
      const int bone = character->skeleton.bindings[static_cast<std::size_t>(influence.binding)].bone;
      ASSERT_FALSE(influence.weight > 0.0f && helpers[static_cast<std::size_t>(bone)]) << file;
    }
    for (std::size_t i = 0; i < helpers.size(); ++i) {
      const std::string& name = character->skeleton.bones[i].name;
      const bool known = name.starts_with("PoleTarget") || name.starts_with("socket_hand");
      EXPECT_TRUE(helpers[i] || !known) << name;
    }
  }
}

}  // namespace
}  // namespace sinew
