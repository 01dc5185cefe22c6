// tests/panels/clip_steps_test.cpp: adding and removing clip files as history steps: playback, ranges and keys.
#include "app/editor/edit.h"
#include "core/rig/animated_edit.h"
#include "sinew/character/pose.h"
#include "sinew/files/gltf_import.h"
#include "tests/panels/clip_files_editor.h"

namespace sinew::app {
namespace {

TEST_F(ClipFilesInEditor, AddingAFileIsOneStepAndPlaysItsFirstClip) {
  open("still.glb");
  EXPECT_EQ(addClips(state, folder_ / "walk.glb"), "");
  EXPECT_TRUE(state.open.transport.playing);
  EXPECT_EQ(playing(), "Walk");
  EXPECT_EQ(files(), Names{"walk.glb"});
  EXPECT_EQ(steps(), 1u);
  EXPECT_TRUE(state.document.commands.modified());
  EXPECT_FALSE(state.open.clipList.shown) << "all matched";
  state.open.transport.playing = false;
  state.open.transport.time = 0.7;
  settle();
  // Plays bit for bit as in its own file.
  const auto own = importClips(folder_ / "walk.glb");
  const Pose theirs = samplePose(own.value()->skeleton, own.value()->clips.front(), 0.7f);
  const auto theirKnee = static_cast<std::size_t>(own.value()->skeleton.findBone("knee").value());
  const auto ourKnee = static_cast<std::size_t>(state.character().skeleton.findBone("knee").value());
  EXPECT_EQ(state.live->pose().boneInWorld[ourKnee], theirs.boneInWorld[theirKnee]);
  const std::vector<glm::vec3> bent = state.live->surface().positions;

  act("edit/undo");
  EXPECT_TRUE(clips().empty());
  EXPECT_EQ(state.open.transport.clip, -1);
  EXPECT_NE(state.live->surface().positions, bent);
  EXPECT_FALSE(state.document.commands.modified());
  act("edit/redo");
  EXPECT_EQ(clips(), (Names{"Walk", "Run"}));
  choose(0);
  state.open.transport.time = 0.7;
  settle();
  EXPECT_EQ(state.live->surface().positions, bent);
}

TEST_F(ClipFilesInEditor, PlaybackContinuesWhileItsClipExists) {
  open("whole.glb");
  add("walk.glb");
  add("more.glb");
  EXPECT_EQ(clips(), (Names{"bend", "Walk", "Run", "Walk 2"}));
  choose(0);
  state.open.transport.time = 0.4;
  act("edit/undo");
  EXPECT_EQ(playing(), "bend");
  EXPECT_EQ(state.open.transport.time, 0.4);
  act("edit/redo");
  choose(3);
  state.open.transport.time = 0.3;
  removeClipFile(state, 0);
  settle();
  EXPECT_EQ(clips(), (Names{"bend", "Walk"}));
  EXPECT_EQ(state.open.transport.clip, 1) << "the same clip of more.glb";
  EXPECT_EQ(state.open.transport.time, 0.3);
  act("edit/undo");
  EXPECT_EQ(state.open.transport.clip, 3);
  EXPECT_EQ(state.open.transport.time, 0.3);
  act("edit/undo");
  EXPECT_EQ(playing(), "Walk") << "of walk.glb: a walk is shown where there is one";
}

TEST_F(ClipFilesInEditor, RedoReportsAFileThatIsMissing) {
  open("still.glb");
  add("walk.glb");
  act("edit/undo");
  std::filesystem::remove(folder_ / "walk.glb");
  state.session.messages.clear();
  act("edit/redo");
  EXPECT_TRUE(clips().empty());
  EXPECT_EQ(files(), Names{"walk.glb"});
  EXPECT_EQ(messagesWith("walk.glb"), 1);
  EXPECT_TRUE(shown("clip-files/locate/0"));
}

TEST_F(ClipFilesInEditor, RangesBelongToTheirClip) {
  open("still.glb");
  add("walk.glb");
  add("more.glb");
  setPlayRange(state.open.transport, {0.2, 0.5}, state.character());
  keepPlayRange(state);
  EXPECT_EQ(state.open.transport.clip, 2);
  removeClipFile(state, 0);
  settle();
  EXPECT_EQ(state.open.transport.clip, 0);
  EXPECT_NEAR(playRange(state.open.transport, state.character()).from, 0.2, 1e-9);
  act("edit/undo");
  EXPECT_EQ(state.open.transport.ranges.size(), 1u);
  EXPECT_TRUE(state.open.transport.ranges.contains(2));
  act("edit/undo");
  EXPECT_TRUE(state.open.transport.ranges.empty());
  act("edit/redo");
  act("edit/redo");
  EXPECT_TRUE(state.open.transport.ranges.contains(0));
}

TEST_F(ClipFilesInEditor, RangeOfMotionKeepsPlaying) {
  std::filesystem::copy_file(state.document.characterFile, folder_ / "copy.glb");
  add("copy.glb");
  EXPECT_EQ(clips(), (Names{"Walk", "Idle", "Walk 2", "Idle 2"}));
  act("play/range-of-motion");
  state.open.transport.playing = false;
  const std::string motion = playing();
  ASSERT_EQ(motion, "Range of motion");
  for (const char* way : {"edit/undo", "edit/redo"}) {
    act(way);
    EXPECT_EQ(playing(), motion) << way;
  }
  removeClipFile(state, 0);
  settle();
  EXPECT_EQ(clips(), (Names{"Walk", "Idle", motion}));
}

TEST_F(ClipFilesInEditor, KeysFollowTheirClips) {
  open("still.glb");
  addOne();
  add("walk.glb");
  add("more.glb");
  const NumberRef radius{Parameter::kRadiusX, 0};
  const auto key = [&](const std::string& clip, float value) {
    ASSERT_TRUE(edit(state, "Key", setKey(state.document.rig(), radius, clip, 0.5f, value)));
  };
  key("Walk", 0.1f);
  key("Walk 2", 0.2f);
  key("Run", 0.3f);
  const auto keyed = [&](const std::string& clip) {
    const AnimatedNumber* number = animationOf(muscle().animated, Parameter::kRadiusX);
    const auto track = std::ranges::find(number->keys, clip, &KeyTrack::clip);
    return track == number->keys.end() ? 0.0f : track->curve.points.front().y;
  };
  const Rig before = state.document.rig();
  const std::size_t done = steps();
  removeClipFile(state, 0);
  settle();
  EXPECT_EQ(steps(), done + 1);
  EXPECT_EQ(clips(), Names{"Walk"});
  EXPECT_EQ(keyed("Walk"), 0.2f) << "more.glb's keys go with its clip";
  EXPECT_EQ(keyed("Walk 2"), 0.1f) << "walk.glb's wait";
  EXPECT_EQ(keyed("Run"), 0.3f);
  ASSERT_TRUE(state.session.toast);
  EXPECT_NE(state.session.toast->text.find("keys of 2 numbers are kept"), std::string::npos)
      << state.session.toast->text;
  act("edit/undo");
  EXPECT_EQ(state.document.rig(), before);
  act("edit/redo");
  add("walk.glb");
  EXPECT_EQ(clips(), (Names{"Walk", "Walk 2", "Run"}));
  const AnimationClip& again = state.character().clips.at(1);
  EXPECT_EQ(again.addedFrom, "walk.glb");
  EXPECT_EQ(keyed(again.name), 0.1f);
}

}  // namespace
}  // namespace sinew::app
