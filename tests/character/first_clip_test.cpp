// tests/character/first_clip_test.cpp: the clip selected by default, judged by its name.

#include "core/character/clip_names.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/characters/real_characters.h"

namespace sinew {
namespace {

std::vector<AnimationClip> clipsNamed(const std::vector<std::string>& names) {
  std::vector<AnimationClip> clips;
  for (const std::string& name : names) clips.push_back({name, 1.0f, {}, false});
  return clips;
}

std::string firstOf(const std::vector<std::string>& names) {
  const int first = firstClip(clipsNamed(names));
  return first < 0 ? "" : names[static_cast<std::size_t>(first)];
}

struct Row {
  std::vector<std::string> names;
  std::string first;
};

TEST(FirstClip, PrefersWalkThenIdleThenRun) {
  const Row rows[] = {
      {{"Survey", "Walk", "Run"}, "Walk"},
      {{"Death", "Run", "Idle", "Walk"}, "Walk"},
      {{"Death", "Run", "Idle"}, "Idle"},
      {{"Attack", "Jump", "Run"}, "Run"},
      {{"Dying", "Attack_01", "Jump", "Wave"}, "Jump"},
      {{"Die", "Attack"}, "Die"},
      {{"Armature|Death", "Armature|Run", "Armature|Walk_Cycle"}, "Armature|Walk_Cycle"},
      {{"death", "walking"}, "walking"},
      {{"fox_death", "Fox_Run_01"}, "Fox_Run_01"},
      {{"mixamo.com", "RunForward", "idle2"}, "idle2"},
      {{"swordattack", "dead", "slowwalk"}, "slowwalk"},
      {{"IDLE", "WALK"}, "WALK"},
      // Locomotion is preferred, but not combined with another action.
      {{"WalkAttack", "WalkDeath", "Idle"}, "Idle"},
      {{"Walk_Left", "Walk_Right", "Walk"}, "Walk"},
      {{"CrouchWalk", "WalkCycle"}, "WalkCycle"},
      {{"Walk_02", "Walk_01"}, "Walk_02"},
      // Words with the same beginning only.
      {{"Rune", "Runway", "Diet", "Deadlift"}, "Rune"},
      {{"Die", "Diet"}, "Diet"},
      {{"", "Walk"}, "Walk"},
      {{""}, ""},
  };
  for (const Row& row : rows) EXPECT_EQ(firstOf(row.names), row.first) << row.names.front();
  EXPECT_EQ(firstClip({}), -1);
}

// The order in the file decides between equals only: it cannot promote a worse kind.
TEST(FirstClip, DoesNotDependOnTheOrder) {
  std::vector<std::string> names{"Attack", "Death", "Idle", "Jump", "Run", "Walk"};
  do {
    EXPECT_EQ(firstOf(names), "Walk");
    EXPECT_EQ(firstOf(std::vector(names.begin(), names.begin() + 1)), names.front());
  } while (std::ranges::next_permutation(names).found);
}

TEST(FirstClip, SkipsEmptyClipsIfPossible) {
  std::vector<AnimationClip> clips = clipsNamed({"Walk", "Jump"});
  clips[0].duration = 0.0f;
  EXPECT_EQ(firstClip(clips), 1);
  clips[1].duration = 0.0f;
  EXPECT_EQ(firstClip(clips), 0);
}

TEST(FirstClip, IsAWalkOnRealCharacters) {
  const std::pair<const char*, const char*> kRows[] = {{"Fox.glb", "Walk"}, {"robot.glb", "Walking"}};
  for (const auto& [file, wanted] : kRows) {
    const auto character = test::realCharacter(file);
    if (!character) GTEST_SKIP() << "left out: no " << file;
    const int first = firstClip(character->clips);
    ASSERT_GE(first, 0) << file;
    EXPECT_NE(character->clips[static_cast<std::size_t>(first)].name.find(wanted), std::string::npos)
        << character->clips[static_cast<std::size_t>(first)].name;
  }
}

}  // namespace
}  // namespace sinew
