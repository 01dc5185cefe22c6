// tests/panels/timeline_test.cpp: timeline track, play ranges, posed joints and range of motion.

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/pose_commands.h"
#include "app/panels/timeline.h"
#include "core/character/range_of_motion.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

constexpr double kFrame = kFrameSeconds;

TEST(PlayRange, LoopsWithinItsEnds) {
  Character character;
  character.clips.resize(1);
  character.clips[0].duration = 3.0f;
  Transport transport{0, 1.4, true, true, 1.0f};
  setPlayRange(transport, {1.0, 1.5}, character);
  advance(transport, 0.3, character);
  EXPECT_NEAR(transport.time, 1.2, 1e-9);
  advance(transport, 50.0, character);
  EXPECT_GE(transport.time, 1.0);
  EXPECT_LT(transport.time, 1.5);
  transport.time = 0.2;  // Before the range: plays on into it.
  advance(transport, 0.1, character);
  EXPECT_NEAR(transport.time, 0.3, 1e-9);
  transport.time = 2.0;  // After the range: plays to the end, then into it.
  advance(transport, 0.5, character);
  EXPECT_NEAR(transport.time, 2.5, 1e-9);
  advance(transport, 0.6, character);
  EXPECT_NEAR(transport.time, 1.1, 1e-9);
}

TEST(PlayRange, StopsAtItsEndAndStepsWrapAround) {
  Character character;
  character.clips.resize(1);
  character.clips[0].duration = 3.0f;
  Transport transport{0, 1.4, true, false, 1.0f};
  setPlayRange(transport, {1.0, 1.5}, character);
  advance(transport, 1.0, character);
  EXPECT_FALSE(transport.playing);
  EXPECT_NEAR(transport.time, 1.5, 1e-9);
  togglePlaying(transport, character);
  EXPECT_NEAR(transport.time, 1.0, 1e-9);
  transport.loop = true;
  stepFrames(transport, -1, character);
  EXPECT_NEAR(transport.time, 1.5 - kFrame, 1e-9);
  stepFrames(transport, 1, character);
  EXPECT_NEAR(transport.time, 1.5, 1e-9);
}

TEST(PlayRange, SnapsToFramesAndLastsAtLeastOneFrame) {
  Character character;
  character.clips.resize(1);
  character.clips[0].duration = 2.0f;
  for (double from = -0.5; from < 3.0; from += 0.177) {
    for (double to = -0.5; to < 3.0; to += 0.213) {
      Transport transport{0, 0.0, false, true, 1.0f};
      setPlayRange(transport, {from, to}, character);
      const PlayRange range = playRange(transport, character);
      EXPECT_GE(range.from, 0.0);
      EXPECT_LE(range.to, 2.0);
      EXPECT_GE(range.to - range.from, kFrame - 1e-9) << from << " " << to;
      EXPECT_NEAR(range.from / kFrame, std::round(range.from / kFrame), 1e-6);
    }
  }
}

TEST(TimelineTrack, TicksAreFarEnoughApart) {
  for (double pixels = 0.01; pixels < 40.0; pixels *= 1.3) {
    const int step = tickStep(pixels, 58.0);
    EXPECT_TRUE(step * pixels >= 58.0 || step == 108000) << pixels;
  }
  EXPECT_EQ(tickStep(60.0, 58.0), 1);
}

TEST(TimelineTrack, KeysAreDrawnAtTheirTimes) {
  AnimationClip clip;
  clip.duration = 4.0f;
  Channel channel;
  channel.times = {0.0f, 1.0f, 1.01f, 4.0f};
  clip.channels = {channel, channel};
  const std::vector<float> all = keyDensity(clip, {0.0, 4.0}, 40);
  EXPECT_FLOAT_EQ(all[0], 0.5f);
  EXPECT_FLOAT_EQ(all[10], 1.0f);
  EXPECT_FLOAT_EQ(all[39], 0.5f);
  EXPECT_FLOAT_EQ(std::accumulate(all.begin(), all.end(), 0.0f), 2.0f);
  const std::vector<float> part = keyDensity(clip, {2.0, 3.0}, 10);
  EXPECT_EQ(std::accumulate(part.begin(), part.end(), 0.0f), 0.0f);
}

TEST(TimelineTrack, ZoomKeepsTheTimeUnderThePointerAndStaysInsideTheClip) {
  PlayRange span{0.0, 40.0};
  for (const float steps : {1.0f, 3.0f, 2.0f, -1.0f, 5.0f, -2.0f}) {
    const double share = (17.0 - span.from) / (span.to - span.from);
    const PlayRange next = zoomedSpan(span, 17.0, steps, 40.0);
    EXPECT_GE(next.from, 0.0);
    EXPECT_LE(next.to, 40.0);
    EXPECT_NEAR((17.0 - next.from) / (next.to - next.from), share, 1e-6);
    span = next;
  }
  for (const double at : {0.0, 1.0, 39.0, 40.0}) {
    const PlayRange wider = zoomedSpan({at < 20.0 ? 0.0 : 30.0, at < 20.0 ? 10.0 : 40.0}, at, -2.0f, 40.0);
    EXPECT_GE(wider.from, 0.0);
    EXPECT_LE(wider.to, 40.0) << at;
  }
  span = zoomedSpan(span, 17.0, -100.0f, 40.0);
  EXPECT_EQ(span.from, 0.0);
  EXPECT_EQ(span.to, 40.0);
  span = zoomedSpan(span, 17.0, 500.0f, 40.0);
  EXPECT_NEAR(span.to - span.from, 5.0 * kFrame, 1e-9);
}

class Timeline : public HeadlessEditor {
 protected:
  [[nodiscard]] double duration() const { return clipDuration(state.open.transport, state.character()); }
  [[nodiscard]] int bone(const char* name) const { return state.character().skeleton.findBone(name).value(); }
  void act(const char* id) {
    run(action(id), state);
    settle();
  }
};

TEST_F(Timeline, ClickOnTheTrackSetsTheTime) {
  state.open.transport.playing = true;
  click("timeline/scrub");
  EXPECT_NEAR(state.open.transport.time / duration(), 0.5, 0.01);
  EXPECT_FALSE(state.open.transport.playing);
  drag("timeline/scrub", {200.0f, 0.0f});
  const float width = widgets().rectangles().at("timeline/scrub").z;
  EXPECT_NEAR(state.open.transport.time / duration(), 0.5 + 200.0 / static_cast<double>(width), 0.01);
}

TEST_F(Timeline, DraggingAnEndSetsTheRangeAndDraggingTheBarMovesIt) {
  const float width = widgets().rectangles().at("timeline/scrub").z;
  drag("timeline/range.in", {0.25f * width, 0.0f});
  EXPECT_NEAR(playRange(state.open.transport, state.character()).from, 0.25 * duration(), 2.0 * kFrame);
  drag("timeline/range.out", {-0.5f * width, 0.0f});
  const PlayRange range = playRange(state.open.transport, state.character());
  EXPECT_NEAR(range.to, 0.5 * duration(), 2.0 * kFrame);
  drag("timeline/range", {0.2f * width, 0.0f});
  const PlayRange moved = playRange(state.open.transport, state.character());
  EXPECT_NEAR(moved.from - range.from, 0.2 * duration(), 2.0 * kFrame);
  EXPECT_NEAR(moved.to - moved.from, range.to - range.from, 1.1 * kFrame);
  doubleClick("timeline/range");
  EXPECT_EQ(playRange(state.open.transport, state.character()).to, duration());
}

TEST_F(Timeline, EveryRangeEditIsOneUndoStep) {
  const auto played = [&] { return playRange(state.open.transport, state.character()); };
  const float width = widgets().rectangles().at("timeline/scrub").z;
  std::vector<PlayRange> seen{played()};
  const auto keep = [&] {
    EXPECT_NE(played(), seen.back());
    seen.push_back(played());
    EXPECT_EQ(state.document.commands.stepCount(), seen.size() - 1);
  };
  drag("timeline/range.in", {0.25f * width, 0.0f});
  keep();
  drag("timeline/range.out", {-0.25f * width, 0.0f});
  keep();
  drag("timeline/range", {0.1f * width, 0.0f});
  keep();
  state.open.transport.time = 0.45 * duration();
  act("play/range-start");
  keep();
  state.open.transport.time = 0.55 * duration();
  act("play/range-end");
  keep();
  doubleClick("timeline/range");
  keep();
  for (std::size_t i = seen.size() - 1; i-- > 0;) {
    act("edit/undo");
    EXPECT_EQ(played(), seen[i]);
  }
  for (std::size_t i = 1; i < seen.size(); ++i) {
    act("edit/redo");
    EXPECT_EQ(played(), seen[i]);
  }
  EXPECT_FALSE(state.document.commands.modified()) << "what plays is no part of the file";
}

TEST_F(Timeline, UndoOfAnEditKeepsClipAndRange) {
  state.open.transport.time = 0.5 * duration();
  act("play/range-start");
  const PlayRange range = playRange(state.open.transport, state.character());
  addOne();
  const double time = state.open.transport.time;
  act("edit/undo");
  EXPECT_TRUE(state.document.rig().primitives.empty());
  EXPECT_EQ(playRange(state.open.transport, state.character()), range);
  EXPECT_EQ(state.open.transport.time, time);
}

TEST_F(Timeline, UndoOfARangeSwitchesToItsClip) {
  const int clip = state.open.transport.clip;
  state.open.transport.time = 0.5 * duration();
  act("play/range-start");
  const PlayRange range = playRange(state.open.transport, state.character());
  chooseClip(state.open.transport, -1, state.character());
  chooseClip(state.open.transport, clip, state.character());
  EXPECT_EQ(playRange(state.open.transport, state.character()), range) << "each clip keeps its range";
  chooseClip(state.open.transport, -1, state.character());
  act("edit/undo");
  EXPECT_EQ(state.open.transport.clip, clip);
  EXPECT_FALSE(hasPlayRange(state.open.transport));
}

TEST_F(Timeline, RangeEndsCannotPassEachOther) {
  drag("timeline/range.in", {5000.0f, 0.0f});
  const PlayRange range = playRange(state.open.transport, state.character());
  EXPECT_GE(range.to - range.from, kFrame - 1e-6);
  EXPECT_LE(range.to, duration());
}

TEST_F(Timeline, JumpsToStartAndEnd) {
  click("timeline/end");
  EXPECT_EQ(state.open.transport.time, duration());
  click("timeline/start");
  EXPECT_EQ(state.open.transport.time, 0.0);
}

TEST_F(Timeline, ButtonsStepLoopAndSetTheSpeed) {
  click("timeline/start");
  click("timeline/next");
  EXPECT_NEAR(state.open.transport.time, kFrame, 1e-9);
  click("timeline/previous");
  click("timeline/previous");
  EXPECT_NEAR(state.open.transport.time, duration() - kFrame, 1e-6) << "a clip that loops goes round";
  click("timeline/loop");
  EXPECT_FALSE(state.open.transport.loop);
  typeInto("timeline/speed", "0.25");
  EXPECT_EQ(state.open.transport.speed, 0.25f);
  EXPECT_EQ(steps(), 0u);
}

TEST_F(Timeline, ScrubbingDoesNotDisturbAGesture) {
  addOne();
  const std::size_t before = steps();
  state.document.commands.beginGesture("Drag");
  Placement placement = muscle().placement;
  placement.center.x += 0.01f;
  state.document.commands.updateGesture(setPlacementOf(placement));
  drag("timeline/scrub", {100.0f, 0.0f});
  EXPECT_TRUE(state.document.commands.inGesture());
  state.document.commands.endGesture();
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(muscle().placement.center, placement.center);
}

TEST_F(Timeline, PosedJointShowsAChipThatResetsIt) {
  EXPECT_FALSE(shown("timeline/posed"));
  const Pose plain = state.live->pose();
  state.open.transport.overrides.set(bone("upper_arm.L"), glm::angleAxis(1.0f, glm::vec3(0, 0, 1)));
  settle();
  ASSERT_TRUE(shown("timeline/posed"));
  EXPECT_NE(state.live->pose().boneInWorld, plain.boneInWorld);
  click("timeline/posed");
  EXPECT_EQ(state.view.tools.tool, ToolKind::kPose);
  click("timeline/pose-reset");
  EXPECT_FALSE(shown("timeline/posed"));
  EXPECT_EQ(state.live->pose().boneInWorld, plain.boneInWorld);
  EXPECT_FALSE(state.document.commands.modified());
}

TEST_F(Timeline, MirrorPoseUsesTheSelectedSideOrSwapsBoth) {
  const int left = bone("upper_arm.L");
  const int right = bone("upper_arm.R");
  chooseClip(state.open.transport, -1, state.character());
  state.open.transport.overrides.set(left, glm::angleAxis(0.7f, glm::vec3(0, 0, 1)));
  state.document.selection.bone = left;
  act("tool/pose-mirror");
  EXPECT_NE(state.open.transport.overrides.turnOf(left), glm::quat(1, 0, 0, 0));
  EXPECT_NE(state.open.transport.overrides.turnOf(right), glm::quat(1, 0, 0, 0));
  const auto tip = [&](const char* name) {
    return glm::vec3(state.live->pose().boneInWorld[static_cast<std::size_t>(bone(name))][3]);
  };
  const glm::vec3 a = tip("forearm.L");
  const glm::vec3 b = tip("forearm.R");
  EXPECT_LT(glm::length(b - glm::vec3(-a.x, a.y, a.z)), 0.02f * state.character().height);
  state.open.transport.overrides.set(right, glm::quat(1, 0, 0, 0));
  state.document.selection.bone = -1;
  act("tool/pose-mirror");
  EXPECT_EQ(state.open.transport.overrides.turnOf(left), glm::quat(1, 0, 0, 0));
  EXPECT_NE(state.open.transport.overrides.turnOf(right), glm::quat(1, 0, 0, 0));
}

TEST_F(Timeline, CopiedPoseCanBePasted) {
  state.open.transport.overrides.set(bone("chest"), glm::angleAxis(0.4f, glm::vec3(1, 0, 0)));
  state.open.transport.overrides.set(bone("thigh.R"), glm::angleAxis(0.9f, glm::vec3(0, 1, 0)));
  const PoseOverrides posed = state.open.transport.overrides;
  act("tool/pose-copy");
  act("tool/pose-reset");
  EXPECT_FALSE(isPosed(state));
  act("tool/pose-paste");
  EXPECT_EQ(state.open.transport.overrides, posed);
  state.document.selection.bone = bone("chest");
  act("tool/pose-reset-joint");
  EXPECT_EQ(state.open.transport.overrides.turns.size(), 1u);
}

TEST_F(Timeline, PoseAndRigEditsShareOneHistory) {
  const auto turn = [&](const char* name) {
    state.open.transport.overrides.set(bone(name), glm::angleAxis(0.4f, glm::vec3(1, 0, 0)));
    keepPose(state, std::string("Turn ") + name);
    settle();
  };
  const std::size_t start = steps();
  turn("chest");
  addMuscle(state, bone("chest"));
  const Rig rig = state.document.rig();
  turn("thigh.R");
  const PoseOverrides both = state.open.transport.overrides;
  EXPECT_EQ(steps(), start + 3);
  EXPECT_EQ(state.document.commands.label(start + 3), "Turn thigh.R");
  act("edit/undo");
  EXPECT_EQ(state.open.transport.overrides.turns.size(), 1u);
  EXPECT_EQ(state.document.rig(), rig) << "a step of the pose leaves the rig alone";
  act("edit/undo");
  EXPECT_NE(state.document.rig(), rig);
  EXPECT_EQ(state.open.transport.overrides.turns.size(), 1u) << "a step of the rig leaves the pose alone";
  act("edit/undo");
  EXPECT_FALSE(isPosed(state));
  EXPECT_FALSE(state.document.commands.modified());
  for (int i = 0; i < 3; ++i) act("edit/redo");
  EXPECT_EQ(state.open.transport.overrides, both);
  EXPECT_EQ(state.document.rig(), rig);
  act("edit/undo");
  turn("head");  // Undone poses are dropped.
  EXPECT_FALSE(state.document.commands.canRedo());
}

TEST_F(Timeline, ReopenKeepsThePoseInTheHistory) {
  state.open.transport.overrides.set(bone("chest"), glm::angleAxis(0.4f, glm::vec3(1, 0, 0)));
  keepPose(state, "Turn chest");
  const PoseOverrides posed = state.open.transport.overrides;
  perform(state, {IntentKind::kReopen, {}});
  EXPECT_EQ(state.open.transport.overrides, posed);
  addMuscle(state, bone("chest"));
  act("edit/undo");
  EXPECT_EQ(state.open.transport.overrides, posed);
}

TEST_F(Timeline, UndoKeepsTheRestOfTheSelectionActive) {
  addMuscle(state, bone("chest"));
  const PrimitiveId first = state.document.idAt(0);
  addMuscle(state, bone("head"));
  const std::size_t added = state.document.rig().primitives.size();
  state.document.selection.primitives = {first, state.document.idAt(static_cast<int>(added) - 1)};
  act("edit/undo");
  EXPECT_EQ(state.document.activePrimitive(), 0);
}

TEST_F(Timeline, HeldJointKeepsItsCurrentPose) {
  state.open.transport.time = 0.3;
  state.open.transport.overrides.set(bone("thigh.L"), glm::angleAxis(0.8f, glm::vec3(1, 0, 0)));
  settle();
  const auto thigh = static_cast<std::size_t>(bone("thigh.L"));
  const glm::mat4 before = state.live->pose().boneInWorld[thigh];
  const auto toHips = [&] {
    const auto hips = static_cast<std::size_t>(state.character().skeleton.bones[thigh].parent);
    return glm::transpose(turnFrame(state.live->pose().boneInWorld[hips])) *
           turnFrame(state.live->pose().boneInWorld[thigh]);
  };
  act("tool/pose-hold");
  for (int c = 0; c < 4; ++c) {
    EXPECT_LT(glm::length(state.live->pose().boneInWorld[thigh][c] - before[c]), 1e-4f);
  }
  const glm::mat3 held = toHips();
  state.open.transport.time = 0.9;
  settle();
  for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(toHips()[c] - held[c]), 1e-4f);
}

TEST_F(Timeline, RangeOfMotionIsAnAdditionalPlayingClip) {
  addOne();
  const std::size_t clips = state.character().clips.size();
  const std::size_t before = steps();
  click("timeline/clip");
  click("timeline/clip/range-of-motion");
  ASSERT_EQ(state.character().clips.size(), clips + 1);
  EXPECT_EQ(state.character().clips.back().name, kRangeOfMotionName);
  EXPECT_EQ(state.open.transport.clip, static_cast<int>(clips));
  EXPECT_TRUE(state.open.transport.playing);
  EXPECT_EQ(steps(), before);
  EXPECT_EQ(state.document.activePrimitive(), 0);
  state.open.transport.playing = false;
  state.open.transport.time = 0.4;
  settle();
  EXPECT_NE(state.live->pose().boneInWorld, bindPose(state.character().skeleton).boneInWorld);
  act("play/range-of-motion");
  EXPECT_EQ(state.character().clips.size(), clips + 1) << "made once";
  EXPECT_LT(state.open.transport.time, 0.1) << "from the start; it plays on";
}

}  // namespace
}  // namespace sinew::app
