// tests/panels/fit_sculpt_test.cpp: Muscles > Fit to a sculpt: one step, made again by its settings; cancel, undo.

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "app/editor/export_error.h"
#include "app/editor/fit_sculpt_commands.h"
#include "sinew/files/surface_export.h"
#include "sinew/surface/smoother.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

struct FitSculptPanel : HeadlessEditor {
  test::TemporaryFolder folder;
  std::filesystem::path sculpt = folder.path() / "sculpt.obj";

  /// A muscle with its twin, and a sculpt of the body with larger ones.
  void SetUp() override {
    HeadlessEditor::SetUp();
    state.document.symmetry = true;
    const auto bone = state.character().skeleton.findBone("thigh.L");
    addMuscle(state, bone.value_or(1));
    settle();
    Rig larger = state.document.rig();
    for (Primitive& primitive : larger.primitives) primitive.placement.radii *= 1.1f;
    larger.smoothing.detail = DetailKind::kUniform;
    larger.smoothing.depth = 3;
    Smoother smoother(state.document.character);
    ASSERT_TRUE(smoother.prepare(larger).ok());
    Surface surface;
    ASSERT_TRUE(smoother.smooth(bindPose(state.character().skeleton), surface));
    ASSERT_TRUE(exportSurface(surface, state.character(), sculpt).ok());
    before = steps();
  }
  void waitForFit() {
    for (int i = 0; i < 6000 && isFitting(state); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      frame();
    }
    EXPECT_FALSE(isFitting(state));
    settle();
  }
  [[nodiscard]] const SculptFitState& fit() const { return state.open.sculptFit; }

  std::size_t before = 0;
};

TEST_F(FitSculptPanel, AFitIsOneStepThatItsSettingsMakeAgain) {
  const Rig start = state.document.rig();
  ASSERT_EQ(takeSculpt(state, sculpt), "");
  settle();
  EXPECT_TRUE(shown("fit-sculpt/cancel") || !isFitting(state));
  waitForFit();
  ASSERT_TRUE(fit().result) << fit().complaint;
  EXPECT_EQ(steps(), before + 1);
  EXPECT_GT(fit().result->after.explained, fit().result->before.explained);
  EXPECT_NE(state.document.rig(), start);
  const Rig first = state.document.rig();
  state.open.sculptFit.hold = 1.0f;
  click("fit-sculpt/fit");
  waitForFit();
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(state.document.commands.stepCount(), before + 1);
  const Rig second = state.document.rig();
  EXPECT_NE(second, first);
  run(action("edit/undo"), state);
  settle();
  EXPECT_EQ(state.document.rig(), start);
  run(action("edit/redo"), state);
  settle();
  EXPECT_EQ(state.document.rig(), second);
  click("fit-sculpt/close");
  EXPECT_FALSE(shown("fit-sculpt/fit"));
}

TEST_F(FitSculptPanel, ACancelledFitChangesNothing) {
  const Rig start = state.document.rig();
  ASSERT_EQ(takeSculpt(state, sculpt), "");
  cancelFit(state);
  waitForFit();
  EXPECT_EQ(steps(), before);
  EXPECT_EQ(state.document.rig(), start);
  EXPECT_FALSE(fit().result);
  EXPECT_TRUE(fit().shown);
}

TEST_F(FitSculptPanel, AnEditMeanwhileIsKept) {
  ASSERT_EQ(takeSculpt(state, sculpt), "");
  addMuscle(state, 2);
  const Rig edited = state.document.rig();
  waitForFit();
  EXPECT_EQ(state.document.rig(), edited);
  EXPECT_NE(fit().complaint, "");
  startFit(state);
  waitForFit();
  EXPECT_TRUE(fitIsCurrent(state)) << fit().complaint;
}

TEST_F(FitSculptPanel, WhatIsLeftIsShownUntilTheNextEdit) {
  ASSERT_EQ(takeSculpt(state, sculpt), "");
  waitForFit();
  ASSERT_TRUE(fit().result) << fit().complaint;
  EXPECT_EQ(&shownSurface(state), &state.live->surface());
  click("fit-sculpt/left");
  settle();
  ASSERT_TRUE(showsLeft(state));
  EXPECT_EQ(&shownSurface(state), &fit().surface);
  EXPECT_EQ(fit().surface.displacement.size(), fit().surface.positions.size());
  run(action("edit/undo"), state);
  settle();
  EXPECT_FALSE(showsLeft(state));
  EXPECT_EQ(&shownSurface(state), &state.live->surface());
}

TEST_F(FitSculptPanel, TheDialogTakesTheFileOrSaysWhyNot) {
  run(action("muscles/fit-sculpt"), state);
  settle();
  ASSERT_EQ(state.dialogs.file.kind, DialogKind::kSculpt);
  const auto bad = folder.write("bad.obj", "v 1 2\n");
  const auto choose = [&](const std::filesystem::path& file) {
    press(kKeyA, true);
    type(file.string());
    press(kEnter);
  };
  choose(bad);
  EXPECT_NE(state.dialogs.file.error.find("three numbers"), std::string::npos) << state.dialogs.file.error;
  choose(sculpt);
  EXPECT_EQ(state.dialogs.file.kind, DialogKind::kNone);
  EXPECT_TRUE(fit().shown);
  waitForFit();
  EXPECT_TRUE(fit().result) << fit().complaint;
}

}  // namespace
}  // namespace sinew::app
