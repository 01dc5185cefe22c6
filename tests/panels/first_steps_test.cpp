// tests/panels/first_steps_test.cpp: Help > First steps: done in order, in another order, and abandoned.

#include "app/editor/session.h"

#include <imgui.h>

#include <string>

#include <imgui_internal.h>  // ImGui 1.86 lists a context's windows only here.

#include "app/editor/actions.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

class FirstStepsPanel : public HeadlessEditor {
 protected:
  void start() {
    run(action("help/first-steps"), state);
    settle();
    state.open.transport.playing = false;
    settle();
  }
  [[nodiscard]] bool done(FirstStep which) const { return state.view.firstSteps.done[static_cast<std::size_t>(which)]; }
  void turnView() {
    state.view.tools.camera.stand.yaw += 0.5f;
    settle();
  }
  void scaleFirst() {
    Placement placement = state.document.rig().primitives[0].placement;
    placement.radii *= 1.2f;
    state.document.commands.apply("Scale", setPlacementOf(placement));
    settle();
  }
};

TEST_F(FirstStepsPanel, OpensTheSampleWithNoStepDone) {
  start();
  EXPECT_EQ(state.document.rigFile, firstSample());
  EXPECT_TRUE(shown("first-steps/turn"));
  for (const bool each : state.view.firstSteps.done) EXPECT_FALSE(each);
  frame();
  for (const bool each : state.view.firstSteps.done) EXPECT_FALSE(each) << "looking on does nothing";
}

TEST_F(FirstStepsPanel, LinesAreNotCutOffInASmallWindow) {
  ImGui::GetIO().DisplaySize = {900.0f, 600.0f};
  start();
  int panels = 0;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    if (std::string(window->Name).find("/first-steps_") == std::string::npos) continue;
    ++panels;
    EXPECT_LE(window->ContentSize.x, window->InnerRect.GetWidth());
  }
  EXPECT_EQ(panels, 1);
}

TEST_F(FirstStepsPanel, StepsAreCheckedOffInAnyOrder) {
  start();
  addMuscle(state, 0);
  settle();
  EXPECT_TRUE(done(FirstStep::kAdd));
  EXPECT_TRUE(done(FirstStep::kSelect)) << "what was added is selected";
  EXPECT_FALSE(done(FirstStep::kScale));
  scaleFirst();
  EXPECT_TRUE(done(FirstStep::kScale));
  EXPECT_FALSE(done(FirstStep::kTurn));
  turnView();
  EXPECT_TRUE(done(FirstStep::kTurn));
  EXPECT_FALSE(firstStepsDone(state.view.firstSteps));
  state.document.visibility.bare = true;
  followFirstSteps(state);
  EXPECT_TRUE(firstStepsDone(state.view.firstSteps));
  // A finished step stays finished.
  state.document.visibility.bare = false;
  run(action("edit/undo"), state);
  run(action("edit/undo"), state);
  settle();
  EXPECT_TRUE(firstStepsDone(state.view.firstSteps));
  EXPECT_FALSE(shown("first-steps/turn"));
  click("first-steps/leave");
  EXPECT_FALSE(shown("first-steps/leave"));
}

TEST_F(FirstStepsPanel, CanBeClosedAndRestarted) {
  start();
  turnView();
  ASSERT_TRUE(done(FirstStep::kTurn));
  click("first-steps/leave");
  EXPECT_FALSE(state.view.firstSteps.shown);
  start();
  EXPECT_TRUE(state.view.firstSteps.shown);
  EXPECT_FALSE(done(FirstStep::kTurn));
}

TEST_F(FirstStepsPanel, PromptsAboutUnsavedChangesFirst) {
  addOne();
  start();
  EXPECT_TRUE(shown("unsaved/cancel"));
}

TEST_F(FirstStepsPanel, AnotherPanelReplacesItWhileOpen) {
  start();
  run(action("play/check"), state);
  settle();
  EXPECT_FALSE(shown("first-steps/leave"));
  click("check/close");
  EXPECT_TRUE(shown("first-steps/leave"));
}

}  // namespace
}  // namespace sinew::app
