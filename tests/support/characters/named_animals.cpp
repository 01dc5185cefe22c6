// tests/support/characters/named_animals.cpp: the bones of animals on four legs.
#include "tests/support/characters/named_bodies.h"

namespace sinew::test {
namespace {

std::vector<NamedBone> horse() {
  return {{"Body", "", "ground"},
          {"Back", "Body", "hips", "hips"},
          {"Torso", "Back", "spine", "spine"},
          {"Torso2", "Torso", "spine2", "chest"},
          {"Torso3", "Torso2", "chest", "upperChest"},
          {"Neck1", "Torso3", "neck", "neck"},
          {"Neck2", "Neck1", "neck2"},
          {"Head", "Neck2", "head", "head"},
          {"FrontShoulder.L", "Torso3", "scapula", "shoulder"},
          {"FrontUpperLeg.L", "FrontShoulder.L", "shoulder", "frontUpper"},
          {"FrontLowerLeg.L", "FrontUpperLeg.L", "carpus", "frontFoot"},
          {"FrontFoot.L", "FrontLowerLeg.L", "hoof"},
          {"BackShoulder.L", "Back", "pelvisside"},
          {"BackLeg.L", "BackShoulder.L", "hip", "hindUpper"},
          {"BackUpperLeg.L", "BackLeg.L", "stifle", "hindLower"},
          {"BackLowerLeg.L", "BackUpperLeg.L", "hock", "hindFoot"},
          {"BackFoot.L", "BackLowerLeg.L", "hoofhind"},
          {"Tail1", "Back", "tail", "tail"},
          {"Tail2", "Tail1", "tail2"},
          {"PoleTarget.L", "Body", "pole"}};
}

std::vector<NamedBone> anatomicalHorse() {
  return {{"hips", "", "hips", "hips"},
          {"spine.1", "hips", "spine", "spine"},
          {"spine.2", "spine.1", "spine2", "chest"},
          {"chest", "spine.2", "chest", "upperChest"},
          {"neck.1", "chest", "neck", "neck"},
          {"neck.2", "neck.1", "neck2"},
          {"head", "neck.2", "head", "head"},
          {"scapula.L", "chest", "scapula", "shoulder"},
          {"upper_arm.L", "scapula.L", "shoulder", "frontUpper"},
          {"forearm.L", "upper_arm.L", "elbow", "frontLower"},
          {"cannon_front.L", "forearm.L", "carpus", "frontFoot"},
          {"pastern_front.L", "cannon_front.L", "pastern"},
          {"hoof_front.L", "pastern_front.L", "hoof"},
          {"thigh.L", "hips", "hip", "hindUpper"},
          {"shin.L", "thigh.L", "stifle", "hindLower"},
          {"cannon_hind.L", "shin.L", "hock", "hindFoot"},
          {"hoof_hind.L", "cannon_hind.L", "hoofhind"},
          {"tail.1", "hips", "tail", "tail"},
          {"tail.2", "tail.1", "tail2"}};
}

std::vector<NamedBone> fox() {
  return {{"_rootJoint", "", "ground"},
          {"b_Root_00", "_rootJoint", "ground"},
          {"b_Hip_01", "b_Root_00", "hips", "hips"},
          {"b_Spine01_02", "b_Hip_01", "spine", "spine"},
          {"b_Spine02_03", "b_Spine01_02", "chest", "chest"},
          {"b_Neck_04", "b_Spine02_03", "neck", "neck"},
          {"b_Head_05", "b_Neck_04", "head", "head"},
          {"b_LeftUpperArm_09", "b_Spine02_03", "shoulder", "frontUpper"},
          {"b_LeftForeArm_010", "b_LeftUpperArm_09", "elbow", "frontLower"},
          {"b_LeftHand_011", "b_LeftForeArm_010", "carpus", "frontFoot"},
          {"b_Tail01_012", "b_Hip_01", "tail", "tail"},
          {"b_Tail02_013", "b_Tail01_012", "tail2"},
          {"b_LeftLeg01_015", "b_Hip_01", "hip", "hindUpper"},
          {"b_LeftLeg02_016", "b_LeftLeg01_015", "stifle", "hindLower"},
          {"b_LeftFoot01_017", "b_LeftLeg02_016", "hock", "hindFoot"},
          {"b_LeftFoot02_018", "b_LeftFoot01_017", "hoofhind"}};
}

}  // namespace

std::vector<NamedBody> namedAnimals() {
  return {{"Quaternius horse", ".L", ".R", horse(), true},
          {"Horse", ".L", ".R", anatomicalHorse(), true},
          {"Fox", "Left", "Right", fox(), true}};
}

}  // namespace sinew::test
