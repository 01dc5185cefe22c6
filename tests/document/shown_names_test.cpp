// tests/document/shown_names_test.cpp: names are shown without their common prefix and suffix.

#include "app/document/shown_names.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::app {
namespace {

using Names = std::vector<std::string>;

Names withPrefix(const std::string& prefix, const Names& names) {
  Names all;
  for (const std::string& name : names) all.push_back(prefix + name);
  return all;
}

TEST(ShownNames, OmitThePrefixSharedByAll) {
  const std::pair<Names, Names> rows[] = {
      {{"Armature|Armature|Walk", "Armature|Armature|Run"}, {"Walk", "Run"}},
      {{"mixamorig:Hips", "mixamorig:Spine"}, {"Hips", "Spine"}},
      {{"a/b/Hips", "a/b/Spine"}, {"Hips", "Spine"}},
      {{"Armature|Walk|baselayer", "Armature|Run|baselayer"}, {"Walk", "Run"}},
      {{"Rig|A|Walk", "Rig|B|Walk"}, {"A", "B"}},
      // Part of a word is not dropped.
      {{"Armature|Walk", "Armature|Wave"}, {"Walk", "Wave"}},
      {{"Walk", "Wave"}, {"Walk", "Wave"}},
      // One name lacks the prefix.
      {{"root", "mixamorig:Hips"}, {"root", "mixamorig:Hips"}},
      // Words that few names share.
      {{"walk_fast", "walk_slow"}, {"walk_fast", "walk_slow"}},
      {{"Bone", "Bone.001"}, {"Bone", "Bone.001"}},
      // A single name.
      {{"Armature|Walk"}, {"Walk"}},
      {{"Armature|Walk|baselayer"}, {"Walk"}},
      {{"mixamo.com"}, {"mixamo.com"}},
      {{"Walk|"}, {"Walk|"}},
      {{"|"}, {"|"}},
      {{""}, {""}},
      {{}, {}},
      // Nothing would be left.
      {{"Armature|", "Armature|Run"}, {"Armature|", "Armature|Run"}},
      {{"Armature", "Armature|Run"}, {"Armature", "Run"}},
  };
  for (const auto& [names, wanted] : rows) EXPECT_EQ(withoutSharedParts(names), wanted);
}

TEST(ShownNames, OmitALeadingWordSharedByMost) {
  const Names bones{"Pelvis", "Spine", "Neck", "Head", "L Thigh", "R Thigh", "L Foot", "R Foot"};
  for (const char* prefix : {"Bip01_", "Bip01 ", "DEF-", "rig."}) {
    EXPECT_EQ(withoutSharedParts(withPrefix(prefix, bones)), bones) << prefix;
  }
  Names rooted = withPrefix("Bip01 ", bones);
  rooted.insert(rooted.begin(), "Bip01");
  EXPECT_EQ(withoutSharedParts(rooted).front(), "Bip01");
  EXPECT_EQ(withoutSharedParts(rooted).back(), "R Foot");
  const Names numbered = withPrefix("joint ", {"0", "1", "2", "3", "4", "5", "6", "7", "8"});
  EXPECT_EQ(withoutSharedParts(numbered), numbered);
  // Without the prefix two names would be equal: nothing is dropped.
  rooted.push_back("Bip01 Bip01");
  EXPECT_EQ(withoutSharedParts(rooted), rooted);
}

TEST(ShownNames, OmitATrailingWordSharedByMost) {
  const Names bones{"Pelvis", "Spine", "Neck", "Head", "L Thigh", "R Thigh", "L Foot", "R Foot"};
  const auto with = [&](const std::string& prefix, const std::string& suffix) {
    Names all = withPrefix(prefix, bones);
    for (std::string& name : all) name += suffix;
    return all;
  };
  for (const char* suffix : {"_Joint_01", "_jnt", ".x", "-bone", " Joint"}) {
    EXPECT_EQ(withoutSharedParts(with("", suffix)), bones) << suffix;
    EXPECT_EQ(withoutSharedParts(with("Bip01_", suffix)), bones) << suffix;
  }
  // The end of a word is no suffix, nor is one that a name lacks or that few share.
  const Names joined = with("", "Joint");
  EXPECT_EQ(withoutSharedParts(joined), joined);
  Names rooted = with("", "_Joint");
  rooted.push_back("root");
  EXPECT_EQ(withoutSharedParts(rooted), rooted);
  EXPECT_EQ(withoutSharedParts({"a_Joint", "b_Joint"}), (Names{"a_Joint", "b_Joint"}));
  // Only a number, or nothing, would be left.
  const Names numbered = [] {
    Names all;
    for (int i = 0; i < 9; ++i) all.push_back(std::to_string(i) + "_Joint");
    return all;
  }();
  EXPECT_EQ(withoutSharedParts(numbered), numbered);
  Names bare = with("", "_Joint");
  bare.push_back("_Joint");
  EXPECT_EQ(withoutSharedParts(bare), bare);
  // Names that differ only in their side.
  const Names sides{"a_L", "b_L", "c_L", "d_L", "e_L", "f_L", "g_L", "h_L"};
  EXPECT_EQ(withoutSharedParts(sides).front(), "a");
}

// Whatever the names: none becomes empty, none loses what the others keep, and different names stay different.
TEST(ShownNames, AreNeverEmptyNorAmbiguous) {
  std::mt19937 random(7);
  const Names parts{"a", "b", "Walk", "Armature", "x1", "|", "|", ":", "/", "_", "-", ".", " "};
  std::uniform_int_distribution<std::size_t> part(0, parts.size() - 1);
  for (int round = 0; round < 4000; ++round) {
    Names names;
    const std::string shared = parts[part(random)] + parts[part(random)];
    const std::size_t count = 1 + part(random);
    for (std::size_t i = 0; i < count; ++i) {
      names.push_back(random() % 8 == 0 ? "" : shared);
      for (std::size_t n = random() % 4; n > 0; --n) names.back() += parts[part(random)];
    }
    const Names shown = withoutSharedParts(names);
    ASSERT_EQ(shown.size(), names.size());
    EXPECT_EQ(std::set(shown.begin(), shown.end()).size(), std::set(names.begin(), names.end()).size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      EXPECT_EQ(shown[i].empty(), names[i].empty());
      EXPECT_NE(names[i].find(shown[i]), std::string::npos) << names[i] << " is shown as " << shown[i];
    }
  }
}

TEST(ShownNames, IgnoreTheGeneratedClip) {
  Character character = *test::makeLimb();
  character.clips = {{"Armature|Walk", 1.0f, {}, false}, {"Armature|Run", 1.0f, {}, false}, {"", 1.0f, {}, false}};
  character.clips.push_back({"Range of motion", 1.0f, {}, true});
  EXPECT_EQ(shownClipNames(character), (Names{"Walk", "Run", "clip 3", "Range of motion"}));
}

TEST(ShownNames, BoneNamesAreFoundByIndexAndByFileName) {
  Character character = *test::makeLimb();
  for (Bone& bone : character.skeleton.bones) bone.name = "mixamorig:" + bone.name;
  finishBones(character.skeleton);
  EXPECT_EQ(shownBoneName(character.skeleton, 1), "middle");
  EXPECT_EQ(shownBoneName(character.skeleton, "mixamorig:middle"), "middle");
  EXPECT_EQ(shownBoneName(character.skeleton, "mixamorig:nobody"), "mixamorig:nobody");
  EXPECT_EQ(shownBoneName(character.skeleton, -1), "");
}

TEST(ShownNames, RealCharactersHaveShortNames) {
  const auto robot = test::realCharacter("robot.glb");
  const auto cesium = test::realCharacter("cesium_man.gltf");
  if (!robot || !cesium) SINEW_SKIP_WITHOUT_CHARACTERS();
  EXPECT_EQ(shownClipNames(*robot)[6], "Running");
  EXPECT_EQ(shownBoneNames(robot->skeleton)[2], "Body");
  EXPECT_EQ(shownBoneNames(cesium->skeleton)[3], "joint 3");
}

}  // namespace
}  // namespace sinew::app
