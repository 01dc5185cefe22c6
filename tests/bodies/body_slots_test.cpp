// tests/bodies/body_slots_test.cpp: body parts, recognized from the names of many programs and without names.
#include "core/character/body_slots.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "core/bodies/body_map.h"
#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/character_parts.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/named_bodies.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

using test::Stance;
using Names = std::map<std::string, std::string>;

Names namesOf(const Skeleton& skeleton, const BodySlots& slots) {
  Names names;
  for (const BodySlot slot : allBodySlots()) {
    if (slots[slot].bone >= 0) names[nameOf(slot)] = at(skeleton.bones, slots[slot].bone).name;
  }
  return names;
}

Names found(const Character& character) {
  const MirrorPlan plan = makeMirrorPlan(character);
  SlotHints hints;
  hints.twinOf = plan.twinOf;
  hints.planeNormal = glm::vec3(plan.plane.normal);
  hints.height = character.height;
  return namesOf(character.skeleton, findBodySlots(character.skeleton, hints));
}

/// Differences of two tables, one per line; empty: none.
std::string differences(const Names& found, const Names& expected) {
  std::string text;
  const auto list = [&](const Names& all, const Names& other, const char* what) {
    for (const auto& [slot, name] : all) {
      const auto same = other.find(slot);
      if (same == other.end() || same->second != name) text += std::string(what) + ' ' + slot + ": " + name + '\n';
    }
  };
  list(found, expected, "found");
  list(expected, found, "expected");
  return text;
}

/// A radius split from the bone of the humerus is not in the tables.
void addCutForearm(const test::NamedBody& body, Names& expected) {
  if (!body.quadruped || expected.contains("frontLower.L")) return;
  for (const char* side : {".L", ".R"})
    expected[std::string("frontLower") + side] = expected[std::string("frontUpper") + side];
}

TEST(BodySlots, FindsAllPartsInEveryNamingStyle) {
  for (const test::NamedBody& body : test::namedBodies()) {
    for (const Stance stance : {Stance::kArmsLevel, Stance::kArmsDown}) {
      Names expected;
      const Character character = characterOf(body, stance, expected);
      addCutForearm(body, expected);
      EXPECT_EQ(differences(found(character), expected), "")
          << body.style << (stance == Stance::kArmsDown ? ", arms down" : "");
    }
  }
}

/// The same skeleton with its bones in another order, parents still first.
Character reordered(const Character& character) {
  const auto& bones = character.skeleton.bones;
  std::vector<int> order(bones.size());
  std::iota(order.begin(), order.end(), 0);
  const auto depth = [&](int bone) {
    int steps = 0;
    for (; bone >= 0; bone = at(bones, bone).parent) ++steps;
    return steps;
  };
  std::ranges::stable_sort(order, [&](int a, int b) { return depth(a) != depth(b) ? depth(a) < depth(b) : a > b; });
  std::vector<int> now(bones.size());
  Character other = character;
  other.skeleton = {};
  for (const int old : order) {
    const Bone& bone = at(bones, old);
    at(now, old) = static_cast<int>(other.skeleton.bones.size());
    test::addBone(other.skeleton, bone.name, bone.parent < 0 ? -1 : at(now, bone.parent),
                  glm::vec3(bone.bindInWorld[3]));
  }
  finishBones(other.skeleton);
  return other;
}

Character moved(Character character, const glm::mat4& by, float scale) {
  for (Bone& bone : character.skeleton.bones) {
    const glm::vec3 joint(by * glm::vec4(scale * glm::vec3(bone.bindInWorld[3]), 1.0f));
    bone.bindInWorld = glm::translate(glm::mat4(1.0f), joint);
  }
  finishBones(character.skeleton);
  character.height *= scale;
  return character;
}

TEST(BodySlots, DoNotDependOnOrderScaleOrOrientation) {
  for (const test::NamedBody& body : test::namedBodies()) {
    Names expected;
    const Character character = characterOf(body, Stance::kArmsLevel, expected);
    addCutForearm(body, expected);
    EXPECT_EQ(differences(found(reordered(character)), expected), "") << body.style;
    EXPECT_EQ(differences(found(moved(character, glm::mat4(1.0f), 100.0f)), expected), "") << body.style;
    const bool unnamed = body.style.starts_with("Unnamed");  // Their mirror plane is an axis plane.
    for (const float degrees : {90.0f, 180.0f, unnamed ? 270.0f : 37.0f}) {
      const glm::mat4 turn = glm::rotate(glm::mat4(1.0f), glm::radians(degrees), glm::vec3(0, 1, 0));
      EXPECT_EQ(differences(found(moved(character, turn, 1.0f)), expected), "") << body.style << ", " << degrees;
    }
  }
}

TEST(BodySlots, DoNotDependOnThePrefixOfNames) {
  for (const test::NamedBody& body : test::namedBodies()) {
    Names expected;
    Character character = characterOf(body, Stance::kArmsDown, expected);
    addCutForearm(body, expected);
    for (Bone& bone : character.skeleton.bones) bone.name = "hero:" + bone.name;
    finishBones(character.skeleton);
    for (auto& [slot, name] : expected) name = "hero:" + name;
    EXPECT_EQ(differences(found(character), expected), "") << body.style;
  }
}

TEST(BodySlots, RandomTreesGiveEachBoneAtMostOnce) {
  test::Random random(7);
  constexpr const char* kNames[] = {"Bone",  "LeftArm", "RightArm", "thigh.L", "thigh.R", "Head",
                                    "spine", "l",       "hand_r",   "",        "頭",      "tail"};
  for (int round = 0; round < 10000; ++round) {
    Skeleton skeleton;
    const int count = 1 + random.below(24);
    for (int i = 0; i < count; ++i) {
      const glm::vec3 joint(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      test::addBone(skeleton, kNames[random.below(12)], random.below(i + 1) - 1,
                    random.chance(0.1f) ? glm::vec3(0.0f) : joint);
    }
    finishBones(skeleton);
    SlotHints hints;
    if (random.chance(0.8f)) {
      const MirrorPlan plan = pairBones(skeleton, {}, 2.0f);
      hints.twinOf = plan.twinOf;
    }
    if (random.chance(0.3f)) hints.carriesSkin.assign(skeleton.bones.size(), random.chance(0.5f));
    const BodySlots slots = findBodySlots(skeleton, hints);
    for (const SlotBone& slot : slots.bones) {
      ASSERT_LT(slot.bone, count);
      ASSERT_EQ(slot.bone < 0, slot.confidence == SlotConfidence::kMissing);
      const auto same = std::ranges::count(slots.bones, slot.bone, &SlotBone::bone);
      const int most = slot.from > 0.0f || slot.to < 1.0f ? 2 : 1;
      ASSERT_TRUE(slot.bone < 0 || same <= most) << round << differences(namesOf(skeleton, slots), {});
    }
  }
}

struct Real {
  const char* file;
  BodyKind kind;
  Names parts;  ///< Center and left ones.
};

Names partsOf(const Character& character) {
  Names names = namesOf(character.skeleton, bodySlots(character, makeMirrorPlan(character)));
  std::erase_if(names, [](const auto& part) { return part.first.ends_with(".R"); });
  return names;
}

const std::vector<Real>& realBodies() {
  static const std::vector<Real> kAll{
      {"Fox.glb",
       BodyKind::kQuadruped,
       {{"hips", "b_Hip_01"},
        {"spine", "b_Spine01_02"},
        {"chest", "b_Spine02_03"},
        {"neck", "b_Neck_04"},
        {"head", "b_Head_05"},
        {"tail", "b_Tail01_012"},
        {"frontUpper.L", "b_LeftUpperArm_09"},
        {"frontLower.L", "b_LeftForeArm_010"},
        {"frontFoot.L", "b_LeftHand_011"},
        {"hindUpper.L", "b_LeftLeg01_015"},
        {"hindLower.L", "b_LeftLeg02_016"},
        {"hindFoot.L", "b_LeftFoot01_017"}}},
      {"Husky.glb",
       BodyKind::kQuadruped,
       {{"hips", "Back"},
        {"spine", "Torso"},
        {"chest", "Torso2"},
        {"upperChest", "Torso3"},
        {"neck", "Neck1"},
        {"head", "Head"},
        {"tail", "Tail1"},
        {"shoulder.L", "FrontShoulder.L"},
        {"frontUpper.L", "FrontUpperLeg.L"},
        {"frontLower.L", "FrontLowerLeg.L"},
        {"frontFoot.L", "IKFrontLeg.L"},
        {"hindUpper.L", "BackLeg.L"},
        {"hindLower.L", "BackUpperLeg.L"},
        {"hindFoot.L", "BackLowerLeg.L"}}},
      {"Bull.glb",
       BodyKind::kQuadruped,
       {{"hips", "Back"},
        {"spine", "Torso"},
        {"chest", "Torso2"},
        {"upperChest", "Torso3"},
        {"neck", "Neck1"},
        {"head", "Head"},
        {"tail", "Tail1"},
        {"shoulder.L", "FrontShoulder.L"},
        {"frontUpper.L", "FrontUpperLeg.L"},
        {"frontLower.L", "FrontUpperLeg.L"},
        {"frontFoot.L", "FrontLowerLeg.L"},
        {"hindUpper.L", "BackLeg.L"},
        {"hindLower.L", "BackUpperLeg.L"},
        {"hindFoot.L", "BackLowerLeg.L"}}},
      {"man.glb",
       BodyKind::kHumanoid,
       {{"hips", "Hips"},
        {"spine", "Abdomen"},
        {"chest", "Torso"},
        {"upperChest", "Chest"},
        {"neck", "Neck"},
        {"head", "Head"},
        {"shoulder.L", "Shoulder.L"},
        {"upperArm.L", "UpperArm.L"},
        {"lowerArm.L", "LowerArm.L"},
        {"hand.L", "Hand.L"},
        {"upperLeg.L", "UpperLeg.L"},
        {"lowerLeg.L", "LowerLeg.L"},
        {"foot.L", "Foot.L"}}},
      {"fighter.glb",
       BodyKind::kHumanoid,
       {{"hips", "Hips"},
        {"spine", "Abdomen"},
        {"chest", "Torso"},
        {"upperChest", "Chest"},
        {"neck", "Neck"},
        {"head", "Head"},
        {"shoulder.L", "Shoulder.L"},
        {"upperArm.L", "UpperArm.L"},
        {"lowerArm.L", "LowerArm.L"},
        {"hand.L", "Hand.L"},
        {"upperLeg.L", "UpperLeg.L"},
        {"lowerLeg.L", "LowerLeg.L"}}},
      {"RobotExpressive.glb",
       BodyKind::kHumanoid,
       {{"hips", "Hips"},
        {"spine", "Abdomen"},
        {"chest", "Torso"},
        {"neck", "Neck"},
        {"head", "Head"},
        {"shoulder.L", "Shoulder.L"},
        {"upperArm.L", "UpperArm.L"},
        {"lowerArm.L", "LowerArm.L"},
        {"upperLeg.L", "UpperLeg.L"},
        {"lowerLeg.L", "LowerLeg.L"},
        {"foot.L", "Foot.L"}}},
      {"cesium_man.gltf",
       BodyKind::kHumanoid,
       {{"hips", "joint 0"},
        {"spine", "joint 1"},
        {"chest", "joint 2"},
        {"neck", "joint 3"},
        {"head", "joint 4"},
        {"upperArm.L", "joint 5"},
        {"lowerArm.L", "joint 7"},
        {"hand.L", "joint 9"},
        {"upperLeg.L", "joint 11"},
        {"lowerLeg.L", "joint 13"},
        {"foot.L", "joint 15"},
        {"toes.L", "joint 17"}}},
      {"Trex.glb",
       BodyKind::kHumanoid,
       {{"hips", "Body"},
        {"tail", "Tail1"},
        {"shoulder.L", "FrontLeg.L"},
        {"upperArm.L", "FrontUpLeg.L"},
        {"lowerArm.L", "FrontLowLeg.L"},
        {"hand.L", "FrontFoot.L"},
        {"upperLeg.L", "BackUpLeg.L"},
        {"lowerLeg.L", "BackLowLeg.L"},
        {"foot.L", "BackFoot.L"}}},
      {"greenman.glb", BodyKind::kHumanoid, {{"hand.L", "hand_L"}, {"upperLeg.L", "hip_L"}, {"lowerLeg.L", "leg_L"}}},
  };
  return kAll;
}

TEST(BodySlots, MatchRealCharacters) {
  for (const Real& real : realBodies()) {
    const auto character = test::realCharacter(real.file);
    if (!character) SINEW_SKIP_WITHOUT_CHARACTERS();
    EXPECT_EQ(differences(partsOf(*character), real.parts), "") << real.file;
    EXPECT_EQ(bodySlots(*character, makeMirrorPlan(*character)).kind, real.kind) << real.file;
  }
}

TEST(BodySlots, CanBeCorrectedByTheRig) {
  Names expected;
  const Character character = characterOf(test::namedBodies().front(), Stance::kArmsLevel, expected);
  const std::vector<SlotCorrection> corrections{
      {"upperArm.L", "mixamorig:LeftForeArm"}, {"head", ""}, {"hand.L", "there is no such bone"}};
  const BodySlots slots = bodySlots(character, makeMirrorPlan(character), corrections);
  EXPECT_EQ(at(character.skeleton.bones, slots.boneOf(Slot::kUpperArm)).name, "mixamorig:LeftForeArm");
  EXPECT_EQ(slots[{Slot::kUpperArm}].confidence, SlotConfidence::kGiven);
  EXPECT_EQ(slots.boneOf(Slot::kHead), -1);
}

}  // namespace
}  // namespace sinew
