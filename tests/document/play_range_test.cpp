// tests/document/play_range_test.cpp: play ranges stay with their clips while clip files are added and removed.
#include "app/document/command_stack.h"

#include <gtest/gtest.h>

namespace sinew::app {
namespace {

/// One clip for each file; "": the character's own.
Character withClipsOf(const std::vector<std::string>& files) {
  Character character;
  for (const std::string& file : files) {
    AnimationClip clip;
    clip.name = "Walk";
    clip.addedFrom = file;
    character.clips.push_back(clip);
  }
  return character;
}

TEST(ClipIds, AreUniqueEvenForEqualNames) {
  const Character character = withClipsOf({"", "", "a.glb", "b.glb", "a.glb"});
  const std::vector<ClipId> ids = clipIds(character);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(indexOf(character, ids[i]), static_cast<int>(i));
  EXPECT_EQ(indexOf(character, {"a.glb", 2}), -1);
  EXPECT_EQ(indexOf(character, {"c.glb", 0}), -1);
}

TEST(ClipIds, RangesFollowTheirClipsAndAreRestored) {
  const Character all = withClipsOf({"", "a.glb", "a.glb", "b.glb"});
  const Character fewer = withClipsOf({"", "b.glb"});
  const PlayRanges ranges{{0, {0.0, 1.0}}, {2, {0.1, 0.5}}, {3, {0.2, 0.6}}, {9, {0.0, 1.0}}};
  const KeptPlayRanges kept = keptRanges(ranges, all);
  EXPECT_EQ(kept.size(), 3u) << "there is no tenth clip";
  EXPECT_EQ(rangesOf(kept, fewer), (PlayRanges{{0, {0.0, 1.0}}, {1, {0.2, 0.6}}}));
  EXPECT_EQ(keptRanges(rangesOf(kept, all), all), kept);
}

}  // namespace
}  // namespace sinew::app
