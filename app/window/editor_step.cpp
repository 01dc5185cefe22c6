// app/window/editor_step.cpp: one frame, in order.

#include "app/window/editor_step.h"

#include <imgui.h>
#include <imgui_internal.h>  // ClearActiveID, which 1.86 keeps to itself.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <vector>

#include "app/document/listed_muscles.h"
#include "app/editor/actions.h"
#include "app/editor/bindings.h"
#include "app/editor/blending_edit.h"
#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/export_commands.h"
#include "app/editor/export_error.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/editor/line_commands.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/reference_commands.h"
#include "app/editor/session.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/panels.h"
#include "app/ui/keyboard_focus.h"
#include "app/viewport/tools/viewport_input.h"
#include "core/geometry/stopwatch.h"

namespace sinew::app {
namespace {

/// A text field is active. (ImGui's WantTextInput alone lasts a frame too long, and would lose a key.)
bool isTyping() { return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive(); }

/// The user has assigned Tab to an action.
bool tabIsAnAction(const EditorState& state, const RawInput& input) {
  if (input.pressedKey != GLFW_KEY_TAB) return false;
  return ownerOf({GLFW_KEY_TAB, input.control, input.shift, input.alt}, state.session.preferences) != nullptr;
}

/// Esc closes what lies over the picture, if nothing is selected and no tool draws.
bool closesWhatIsOpen(EditorState& state, const RawInput& input) {
  if (input.pressedKey != GLFW_KEY_ESCAPE || input.control || input.shift || input.alt) return false;
  const Selection& selection = state.document.selection;
  const bool draws = addsMuscles(state.view.tools.tool);
  const bool busy = !selection.primitives.empty() || selection.bone >= 0 || state.open.layers.chosen >= 0 || draws ||
                    editsTerritory(state) || state.open.animate.drivenKey.isOn() || state.open.gestureItem != 0;
  if (busy) return false;
  if (state.view.bare.latched) state.view.bare.latched = false;
  else if (state.open.muscleSet.shown) closeSet(state);
  else if (isFitting(state)) cancelFit(state);
  else if (state.open.sculptFit.shown) closeFit(state);
  else if (state.open.check.shown) closeCheck(state);
  else if (state.open.bodyParts.shown) toggleBodyParts(state);
  else if (state.open.clipList.shown) toggleClipList(state);
  else if (state.open.reference.shown) toggleReferencePanel(state);
  else return false;
  return true;
}

/// Esc first leaves the active number field, then hides the focus ring.
bool leavesRing(const RawInput& input) {
  if (input.pressedKey != GLFW_KEY_ESCAPE || !focusShown()) return false;
  if (ImGui::IsAnyItemActive()) ImGui::ClearActiveID();
  else dropFocus();
  return true;
}

void movePose(EditorState& state, const RawInput& input, double seconds) {
  if (!state.hasCharacter()) return;
  const bool leftPressed = input.pressedButton == static_cast<int>(MouseButton::kLeft);
  if (!holdsPose(state.view.tools, leftPressed)) advance(state.open.transport, seconds, state.character());
  const FlexState& flex = state.open.flex;
  state.open.transport.flex = flex.shown();
  state.open.transport.flexedLines = flex.selectedAlone ? flexingLines(state.document) : std::vector<int>();
  state.live->movePose(state.open.transport);
}

}  // namespace

void EditorStep::run(EditorState& state, const RawInput& input, const Fonts& fonts, double seconds) {
  Stopwatch watch;
  followExports(state);
  followFit(state);
  followOpenedPages(state);
  // A press on a panel ends a drag without a button, before the panel begins its own gesture.
  if (!viewportFree_ && input.pressedButton >= 0) keepDrag(state.view.tools, state.document);
  const bool viewportFree = viewportFree_ = runInterface(state, input, fonts);
  double interface = watch.lap();
  movePose(state, input, seconds);
  watch.lap();
  runTools(state, input, viewportFree, seconds);
  interface += watch.lap();
  updateSurface(state);
  state.session.stats.ui = interface;
}

/// Keys and panels. @return whether the mouse is over the uncovered picture
bool EditorStep::runInterface(EditorState& state, const RawInput& input, const Fonts& fonts) {
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  const bool dragging = ownsKeyboard(state.view.tools);
  const bool ringTakes = !dragging && !tabIsAnAction(state, input) && moveFocus(widgets_, input);
  if (!popup && !isTyping() && !dragging && !ringTakes && !leavesRing(input) && !closesWhatIsOpen(state, input)) {
    runShortcut(state, input);
  }
  state.frame.arrowsTaken = false;
  state.open.animate.pointed.clear();
  state.open.animate.pointedPoint = {};
  widgets_.beginFrame();
  PanelUi ui(state, widgets_, fonts);
  const bool viewportFree = drawLayout(ui);
  wakeAfter_ = ui.wakeAfter;
  return viewportFree;
}

void EditorStep::runTools(EditorState& state, const RawInput& input, bool viewportFree, double seconds) {
  cameraMoves_ = false;
  if (!state.hasCharacter()) return;
  if (state.open.frameWanted) {
    frameInPicture(state, boundsOf(state.live->surface().positions), false);
    state.open.frameWanted = false;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const InterfaceClaims claims{viewportFree, ImGui::IsMouseDoubleClicked(0)};
  const glm::vec2 pixelsPerUnit{io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y};
  const ViewportInput own = viewportInput(input, claims, state.frame.viewport, pixelsPerUnit, seconds);
  const ViewportContext context{state.document,
                                state.live->pose(),
                                *state.live,
                                state.view.display,
                                state.frame.viewportPixels,
                                state.frame.uiScale * pixelsPerUnit.x,
                                &state.open.transport.overrides,
                                hiddenBones(state),
                                state.open.transport.playing};
  const std::size_t before = state.document.commands.position();
  state.frame.route = routeInput(state.view.tools, own, context);
  if (state.document.commands.position() != before) state.open.refusal.clear();
  cameraMoves_ = isMoving(state.view.tools.camera);
  if (state.frame.route.refusal) refuse(state, *state.frame.route.refusal);
  if (!state.frame.route.said.empty()) say(state, state.frame.route.said);
  if (state.frame.route.menu) state.open.viewportMenu = {*state.frame.route.menu, true};
}

void EditorStep::updateSurface(EditorState& state) {
  if (!state.hasCharacter()) return;
  followClipFiles(state);
  state.live->movePose(state.open.transport);  // The pose tool may have rotated a joint.
  followEdits(state.document);
  completeSheets(state.document);
  forgetSettledWarnings(state);
  const Result<bool> updated = state.live->update(state.document, surfaceView(state));
  if (!updated) addMessage(state.session, MessageKind::kError, updated.error().plainText());
  updateExportError(state);
  updateLeft(state);
  state.session.stats.stages = state.live->report().seconds;
  const std::pair prepared(state.session.documentsOpened, state.document.commands.revision());
  state.session.stats.prepare = std::exchange(prepared_, prepared) == prepared ? 0.0 : state.live->prepareSeconds();
}

}  // namespace sinew::app
