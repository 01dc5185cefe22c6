// tests/rig/trial_rig_test.cpp: generated trial muscles: valid, repeatable, under the skin and above it.
#include "core/rig/trial_rig.h"

#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/attachment.h"
#include "core/rig/validation.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/bedded_rig.h"

namespace sinew::test {
namespace {

std::vector<std::shared_ptr<const Character>> characters() {
  std::vector<std::shared_ptr<const Character>> all{makeLimb(), makeTwoLegged(), makeTube(), makeStrip()};
  for (const char* file : {"Fox.glb", "greenman.glb", "cesium_man.gltf", "robot.glb"}) {
    if (auto character = realCharacter(file)) all.push_back(character);
  }
  return all;
}

TEST(TrialRig, IsValidRepeatableAndAttached) {
  for (const auto& character : characters()) {
    for (const int muscles : {0, 1, 12, 100}) {
      const Rig rig = trialRig(*character, muscles, 7);
      EXPECT_TRUE(validate(rig).ok()) << character->name;
      EXPECT_EQ(rig.primitives.size(), static_cast<std::size_t>(muscles));
      EXPECT_TRUE(rig == trialRig(*character, muscles, 7)) << character->name;
      const auto attachment = attach(rig, *character);
      ASSERT_TRUE(attachment.ok());
      EXPECT_TRUE(attachment.value().unattached.empty()) << character->name;
    }
    EXPECT_FALSE(trialRig(*character, 12, 7) == trialRig(*character, 12, 8)) << character->name;
  }
}

TEST(EmbeddedRig, LiesOnlyInTheSkinOfItsBone) {
  for (const auto& character : characters()) {
    const Rig rig = beddedRig(*character, 12);
    EXPECT_TRUE(validate(rig).ok()) << character->name;
    EXPECT_TRUE(rig == beddedRig(*character, 12)) << character->name;
    EXPECT_TRUE(rig.primitives.empty() || rig.primitives.size() == 12) << character->name;
    for (const Primitive& primitive : rig.primitives) {
      const int bone = character->skeleton.findBone(primitive.bone).value();
      const UnitBallMap influence = unitBallMap(primitive.placement, primitive.reach,
                                                character->skeleton.bones[static_cast<std::size_t>(bone)].bindInWorld);
      EXPECT_EQ(primitive.territory, std::vector<std::string>{primitive.bone});
      for (int v = 0; v < static_cast<int>(character->mesh.positions.size()); ++v) {
        const glm::vec3 p = character->mesh.positions[static_cast<std::size_t>(v)];
        if (glm::length(influence.toUnit * (p - influence.center)) >= 0.7f) continue;
        float own = 0.0f;
        for (const Influence& i : character->mesh.influencesOf(v)) {
          if (character->skeleton.bindings[static_cast<std::size_t>(i.binding)].bone == bone) own += i.weight;
        }
        EXPECT_GT(own, 0.5f) << character->name << ", " << primitive.name << ", vertex " << v;
      }
    }
  }
}

TEST(TrialRig, EveryMuscleContainsSkinAndHasAPlausibleSize) {
  for (const auto& character : characters()) {
    const Rig rig = trialRig(*character, 12, 1);
    std::set<std::string> bones;
    for (const Primitive& primitive : rig.primitives) {
      bones.insert(primitive.bone);
      const auto bone = static_cast<std::size_t>(character->skeleton.findBone(primitive.bone).value());
      const UnitBallMap visible = unitBallMap(primitive.placement, 1.0f, character->skeleton.bones[bone].bindInWorld);
      int inside = 0;
      for (const glm::vec3& p : character->mesh.positions) {
        inside += glm::length(visible.toUnit * (p - visible.center)) < 1.0f ? 1 : 0;
      }
      EXPECT_GT(inside, 0) << character->name << ", " << primitive.name;
      EXPECT_LT(visible.boundingRadius, 0.25f * character->height) << character->name << ", " << primitive.name;
      EXPECT_GT(visible.boundingRadius, 0.005f * character->height) << character->name << ", " << primitive.name;
    }
    EXPECT_GE(bones.size(), std::min<std::size_t>(2, character->skeleton.bones.size())) << character->name;
  }
}

}  // namespace
}  // namespace sinew::test
