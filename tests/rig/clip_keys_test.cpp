// tests/rig/clip_keys_test.cpp: keys follow renamed clips.

#include "core/rig/animated_edit.h"

#include <random>

#include <gtest/gtest.h>

#include "sinew/rig/rig_edit.h"

namespace sinew {
namespace {

KeyTrack track(const std::string& clip, float value) { return {clip, {{{0.0f, value}}}, {}}; }

/// Every kind of owner has a track in each clip.
Rig rigKeyedIn(const std::vector<std::string>& clips) {
  Rig rig;
  rig.primitives.resize(1);
  rig.lines.resize(1);
  rig.morphs.resize(1);
  AnimatedNumber number;
  float value = 0.0f;
  for (const std::string& clip : clips) {
    number.keys.push_back(track(clip, value));
    rig.channels.push_back({"effort", track(clip, value)});
    value += 1.0f;
  }
  for (auto* animated :
       {&rig.primitives[0].animated, &rig.lines[0].animated, &rig.morphs[0].animated, &rig.surface.animated}) {
    animated->push_back(number);
  }
  return rig;
}

TEST(ClipKeys, AreCountedForEveryOwner) {
  const Rig rig = rigKeyedIn({"Walk", "Run"});
  EXPECT_EQ(countKeyTracks(rig, "Walk"), 5u);
  EXPECT_EQ(countKeyTracks(rig, "Jump"), 0u);
}

TEST(ClipKeys, FollowRenamedClipsAndBack) {
  const Rig rig = rigKeyedIn({"Walk", "Walk 2", "Run", ""});
  const Rig swapped = withClipsRenamed(rig, {{"Walk", "Walk 2"}, {"Walk 2", "Walk"}});
  EXPECT_EQ(swapped.surface.animated[0].keys[0], track("Walk 2", 0.0f));
  EXPECT_EQ(swapped.surface.animated[0].keys[1], track("Walk", 1.0f));
  EXPECT_EQ(swapped.channels[0].track, track("Walk 2", 0.0f));
  EXPECT_EQ(swapped.surface.animated[0].keys[2], track("Run", 2.0f));
  EXPECT_EQ(swapped.surface.animated[0].keys[3], track("", 3.0f)) << "of every clip";
  EXPECT_EQ(withClipsRenamed(swapped, {{"Walk", "Walk 2"}, {"Walk 2", "Walk"}}), rig);
  EXPECT_EQ(withClipsRenamed(rig, {}), rig);
  EXPECT_EQ(withClipsRenamed(rig, {{"Walk", "Walk"}, {"Run", "Run"}}), rig);
}

TEST(ClipKeys, OfAMissingClipAreReplaced) {
  const Rig rig = rigKeyedIn({"Walk", "Walk 2"});
  const Rig renamed = withClipsRenamed(rig, {{"Walk 2", "Walk"}});
  ASSERT_EQ(renamed.lines[0].animated[0].keys.size(), 1u);
  EXPECT_EQ(renamed.lines[0].animated[0].keys[0], track("Walk", 1.0f));
  ASSERT_EQ(renamed.channels.size(), 1u);
  EXPECT_EQ(renamed.channels[0].track, track("Walk", 1.0f));
  // A channel stays when its last track is removed, since drivers read it.
  const Rig stale = withClipsRenamed(rigKeyedIn({"Walk"}), {{"Walk 2", "Walk"}});
  EXPECT_TRUE(stale.lines[0].animated.empty());
  EXPECT_EQ(stale.channels.size(), 1u);
}

/// For any permutation of names: as many tracks, and each clip once in every list.
TEST(ClipKeys, NeverNameAClipTwice) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::string> clips{"a", "b", "c", "d"};
    const Rig rig = rigKeyedIn(clips);
    std::vector<std::string> names = clips;
    for (std::size_t i = names.size(); i > 1; --i) std::swap(names[i - 1], names[random() % i]);
    std::map<std::string, std::string> renamed;
    for (std::size_t i = 0; i < clips.size(); ++i) renamed[clips[i]] = names[i];
    const Rig after = withClipsRenamed(rig, renamed);
    for (const std::string& clip : clips) EXPECT_EQ(countKeyTracks(after, clip), 5u);
  }
}

}  // namespace
}  // namespace sinew
