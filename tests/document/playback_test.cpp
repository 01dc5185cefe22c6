// tests/document/playback_test.cpp: time in a clip, and the surface that follows it.

#include "app/document/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "app/document/document.h"
#include "core/rig/animated_edit.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/rigs/rig_copies.h"

namespace sinew::app {
namespace {

Character characterWithClip(float duration) {
  Character character;
  AnimationClip clip;
  clip.duration = duration;
  character.clips = {clip, AnimationClip{}};
  return character;
}

TEST(Transport, LoopCarriesTheRemainderOver) {
  const Character character = characterWithClip(2.0f);
  Transport transport{0, 1.5, true, true, 1.0f};
  advance(transport, 1.0, character);
  EXPECT_NEAR(transport.time, 0.5, 1e-12);
  EXPECT_TRUE(transport.playing);
  advance(transport, 20.0, character);
  EXPECT_NEAR(transport.time, 0.5, 1e-9);
}

TEST(Transport, StopsAtTheEndWithoutLoopAndRestarts) {
  const Character character = characterWithClip(2.0f);
  Transport transport{0, 1.5, true, false, 1.0f};
  advance(transport, 1.0, character);
  EXPECT_EQ(transport.time, 2.0);
  EXPECT_FALSE(transport.playing);
  togglePlaying(transport, character);
  EXPECT_TRUE(transport.playing);
  EXPECT_EQ(transport.time, 0.0);
}

TEST(Transport, SpeedScalesTime) {
  const Character character = characterWithClip(10.0f);
  Transport transport{0, 0.0, true, true, 0.25f};
  advance(transport, 4.0, character);
  EXPECT_NEAR(transport.time, 1.0, 1e-9);
}

TEST(Transport, FrameStepsSnapWrapAndPause) {
  const Character character = characterWithClip(1.0f);
  Transport transport{0, 0.47, true, true, 1.0f};
  stepFrames(transport, 1, character);
  EXPECT_FALSE(transport.playing);
  EXPECT_NEAR(transport.time / kFrameSeconds, std::round(transport.time / kFrameSeconds), 1e-9);
  EXPECT_NEAR(transport.time, 15.0 / 30.0, 1e-9);
  transport.time = 0.0;
  stepFrames(transport, -1, character);
  EXPECT_NEAR(transport.time, 29.0 / 30.0, 1e-9);
  transport.loop = false;
  transport.time = 0.0;
  stepFrames(transport, -1, character);
  EXPECT_EQ(transport.time, 0.0);
}

TEST(Transport, BindPoseAndAnEmptyClipCannotPlay) {
  const Character character = characterWithClip(1.0f);
  for (const int clip : {-1, 1}) {
    Transport transport;
    chooseClip(transport, clip, character);
    togglePlaying(transport, character);
    EXPECT_FALSE(transport.playing);
    advance(transport, 1.0, character);
    stepFrames(transport, 3, character);
    EXPECT_EQ(transport.time, 0.0);
  }
}

TEST(Transport, ChosenClipStartsFromItsBeginning) {
  const Character character = characterWithClip(1.0f);
  Transport transport{0, 0.7, true, true, 1.0f};
  chooseClip(transport, 0, character);
  EXPECT_EQ(transport.time, 0.0);
  EXPECT_TRUE(transport.playing);
  chooseClip(transport, -1, character);
  EXPECT_FALSE(transport.playing);
}

class LiveSurfaceUpdate : public testing::Test {
 protected:
  void SetUp() override {
    auto opened = openDocument(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb");
    ASSERT_TRUE(opened.ok()) << opened.error().text();
    document = std::move(opened).value();
  }
  Document document;
};

TEST_F(LiveSurfaceUpdate, SmoothsOnlyWhenRigOrTimeChanges) {
  Transport transport{0, 0.0, false, true, 1.0f};
  auto live = LiveSurface::create(document, transport);
  ASSERT_TRUE(live.ok()) << live.error().text();
  const auto update = [&] {
    live.value().movePose(transport);
    return live.value().update(document).value();
  };
  EXPECT_FALSE(update());
  transport.time = 0.2;
  EXPECT_TRUE(update());
  EXPECT_FALSE(update());
  SmoothingSettings settings = document.rig().smoothing;
  settings.tolerance *= 0.3f;
  document.commands.apply("Tolerance", setSmoothing(document.rig(), settings).value());
  const std::size_t before = live.value().surface().positions.size();
  EXPECT_TRUE(update());
  EXPECT_GT(live.value().surface().positions.size(), before);
  document.commands.undo();
  EXPECT_TRUE(update());
  EXPECT_EQ(live.value().surface().positions.size(), before);
}

TEST_F(LiveSurfaceUpdate, DeferredSurfaceMatchesTheImmediateOne) {
  Document flexing = openDocument(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "horse-flex.rig.json").value();
  Transport transport{0, 0.0, false, true, 1.0f};
  auto eager = LiveSurface::create(flexing, transport);
  auto waiting = LiveSurface::create(flexing, transport);
  ASSERT_TRUE(eager.ok() && waiting.ok());
  SurfaceView onCard;
  onCard.onCard = true;
  const auto same = [&] {
    const Surface& a = eager.value().surface();
    const Surface& b = waiting.value().surface();
    return a.positions == b.positions && a.normals == b.normals && a.classes == b.classes;
  };
  for (const double time : {0.1, 0.2, 0.35}) {
    transport.time = time;
    for (LiveSurface* live : {&eager.value(), &waiting.value()}) live->movePose(transport);
    const std::size_t before = waiting.value().revision();
    EXPECT_TRUE(eager.value().update(flexing).value());
    EXPECT_TRUE(waiting.value().update(flexing, onCard).value());
    EXPECT_GT(waiting.value().revision(), before) << "another picture";
    EXPECT_EQ(waiting.value().report().seconds.total(), 0.0) << "nothing is made";
    EXPECT_EQ(waiting.value().report().refinedTriangles, eager.value().report().refinedTriangles);
    EXPECT_TRUE(same()) << time;
    EXPECT_GT(waiting.value().report().seconds.total(), 0.0);
    EXPECT_EQ(waiting.value().report().projected, eager.value().report().projected);
    EXPECT_FALSE(waiting.value().update(flexing, onCard).value()) << "nothing has changed";
  }
  // An edit that is deferred, then a visibility change that is not.
  flexing.commands.apply("Delete", removePrimitives(flexing.rig(), std::vector<int>{0}));
  EXPECT_TRUE(eager.value().update(flexing).value());
  EXPECT_TRUE(waiting.value().update(flexing, onCard).value());
  EXPECT_FALSE(waiting.value().update(flexing).value()) << "the same surface, made now";
  EXPECT_GT(waiting.value().report().seconds.total(), 0.0);
  EXPECT_TRUE(same());
}

TEST_F(LiveSurfaceUpdate, EditReachesTheSurfaceWithoutARigCopy) {
  Primitive muscle;
  muscle.bone = document.character->skeleton.bones.front().name;
  Rig rig = document.rig();
  for (int i = 0; i < 7; ++i) rig = addPrimitive(std::move(rig), muscle).value();
  document.commands.apply("Muscles", rig);
  auto live = LiveSurface::create(document, {});
  ASSERT_TRUE(live.ok()) << live.error().text();
  document.commands.apply("Rename", renamePrimitive(std::move(rig), 0, "other").value());
  const test::RigCopies copies(document.rig());
  ASSERT_TRUE(live.value().update(document).value());
  EXPECT_EQ(copies.count(), 0);
}

TEST_F(LiveSurfaceUpdate, DragFrameOfKeyedMusclesCopiesTheRigOnce) {
  Primitive muscle;
  muscle.bone = document.character->skeleton.bones.front().name;
  Rig rig = document.rig();
  const std::string clip = document.character->clips.front().name;
  for (int i = 0; i < 41; ++i) {
    rig = addPrimitive(std::move(rig), muscle).value();
    rig = setKey(std::move(rig), {Parameter::kAmount, i}, clip, 0.2f, 0.5f).value();
  }
  document.commands.apply("Muscles", std::move(rig));
  Transport transport{0, 0.0, false, true, 1.0f};
  auto live = LiveSurface::create(document, transport);
  ASSERT_TRUE(live.ok()) << live.error().text();
  document.commands.beginGesture("Move");
  Placement placement = document.rig().primitives[3].placement;
  for (int frame = 1; frame <= 5; ++frame) {
    placement.center.y += 0.01f;
    transport.time = 0.1 * frame;
    live.value().movePose(transport);
    const test::RigCopies copies(document.rig());
    document.commands.updateGesture(setPlacement(document.rig(), 3, placement).value());
    ASSERT_TRUE(live.value().update(document).value());
    EXPECT_EQ(document.posedRig(live.value().pose()).muscles.size(), document.rig().primitives.size());
    EXPECT_EQ(copies.count(), 1) << "the edit makes the history's new value";
  }
  document.commands.endGesture();
}

TEST_F(LiveSurfaceUpdate, RefusedRigKeepsTheSurfaceAndIsReportedOnce) {
  Transport transport{0, 0.0, false, true, 1.0f};
  auto live = LiveSurface::create(document, transport);
  ASSERT_TRUE(live.ok());
  const auto positions = live.value().surface().positions;
  Rig bad = document.rig();
  bad.surface.iso = 7.0f;
  document.commands.apply("Bad", bad);
  EXPECT_FALSE(live.value().update(document).ok());
  EXPECT_EQ(live.value().surface().positions, positions);
  EXPECT_TRUE(live.value().update(document).ok());
  // Another character to prepare for, still without a rig.
  SurfaceView without;
  without.hidden = {0};
  EXPECT_FALSE(live.value().update(document, without).ok());
  EXPECT_EQ(live.value().surface().positions, positions);
  document.commands.undo();
  EXPECT_TRUE(live.value().update(document).ok());
}

TEST_F(LiveSurfaceUpdate, AutoDepthFollowsTheSizeWithoutChangingTheDocument) {
  const Transport transport{0, 0.0, false, true, 1.0f};
  SmoothingSettings uniform = document.rig().smoothing;
  uniform.detail = DetailKind::kUniform;
  document.commands.apply("Detail", setSmoothing(document.rig(), uniform).value());
  auto live = LiveSurface::create(document, transport);
  ASSERT_TRUE(live.ok());
  const auto depthAt = [&](float pixels) {
    EXPECT_TRUE(live.value().update(document, {pixels}).ok());
    EXPECT_EQ(live.value().surface().report.depth, live.value().depth());
    return live.value().depth();
  };
  const int own = document.rig().smoothing.depth;
  EXPECT_EQ(depthAt(5000.0f), own);
  SmoothingSettings settings = document.rig().smoothing;
  settings.autoDepth = true;
  document.commands.apply("Auto depth", setSmoothing(document.rig(), settings).value());
  document.commands.markSaved();
  const std::size_t steps = document.commands.stepCount();
  EXPECT_EQ(depthAt(0.0f), own);
  EXPECT_EQ(depthAt(20.0f), 1);
  EXPECT_EQ(depthAt(0.0f), 1);
  EXPECT_EQ(depthAt(50000.0f), 8);
  EXPECT_EQ(document.commands.stepCount(), steps);
  EXPECT_FALSE(document.commands.modified());
  EXPECT_EQ(document.rig().smoothing.depth, own);
  document.commands.undo();
  EXPECT_EQ(depthAt(50000.0f), own);
}

TEST_F(LiveSurfaceUpdate, AutoToleranceFollowsTheSize) {
  SmoothingSettings settings = document.rig().smoothing;
  ASSERT_EQ(settings.detail, DetailKind::kAdaptive);
  settings.autoDepth = true;
  document.commands.apply("Auto detail", setSmoothing(document.rig(), settings).value());
  auto live = LiveSurface::create(document, {});
  ASSERT_TRUE(live.ok());
  const auto verticesAt = [&](float pixels) {
    EXPECT_TRUE(live.value().update(document, {pixels}).ok());
    return live.value().surface().positions.size();
  };
  const std::size_t small = verticesAt(100.0f);
  EXPECT_NEAR(live.value().tolerance(), 0.005f, 0.001f);
  const std::size_t large = verticesAt(2000.0f);
  EXPECT_NEAR(live.value().tolerance(), 0.00025f, 0.00005f);
  EXPECT_GT(large, small);
  EXPECT_EQ(verticesAt(2020.0f), large) << "a camera that breathes";
}

TEST_F(LiveSurfaceUpdate, DragKeepsTheMeshAndItsEndRefinesAgain) {
  Primitive muscle;
  muscle.bone = document.character->skeleton.bones.back().name;
  muscle.placement.radii = glm::vec3(0.05f * document.character->height);
  document.commands.apply("Muscle", addPrimitive(document.rig(), muscle).value());
  auto live = LiveSurface::create(document, {});
  ASSERT_TRUE(live.ok());
  const auto before = live.value().surface().refinement;
  document.commands.beginGesture("Grow");
  Rig grown = document.rig();
  grown.primitives[0].placement.radii *= 2.0f;
  document.commands.updateGesture(grown);
  ASSERT_TRUE(live.value().update(document).value()) << "the surface answers in the same frame";
  EXPECT_EQ(live.value().surface().refinement, before);
  document.commands.endGesture();
  ASSERT_TRUE(live.value().update(document).value());
  const auto after = LiveSurface::create(document, {});
  EXPECT_EQ(live.value().surface().refinement->triangles, after.value().surface().refinement->triangles);
  EXPECT_FALSE(live.value().update(document).value()) << "it has settled";
}

TEST(Transport, RangeThatEndsWithinHalfAFrameOfTheEndEndsThere) {
  Character character;
  character.clips.resize(1);
  character.clips[0].duration = static_cast<float>(60.3 * kFrameSeconds);
  Transport transport{0, 0.0, false, true, 1.0f};
  const double duration = clipDuration(transport, character);
  setPlayRange(transport, {1.0, 60.0 * kFrameSeconds}, character);
  EXPECT_EQ(playRange(transport, character).to, duration);
  setPlayRange(transport, {0.0, 60.0 * kFrameSeconds}, character);
  EXPECT_FALSE(hasPlayRange(transport)) << "it is the whole clip";
}

}  // namespace
}  // namespace sinew::app
