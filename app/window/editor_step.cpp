// app/window/editor_step.cpp: one frame, in order.

#include "app/window/editor_step.h"

#include <imgui.h>

#include <chrono>

#include "app/actions/actions.h"
#include "app/editor/commands.h"
#include "app/editor/viewport_input.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/panels.h"

namespace sinew::app {
namespace {

double secondsNow() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A text field has the keyboard. ImGui goes on wanting text for a frame after the field is left, and a key that
/// comes in that frame would be lost.
bool isTyping() { return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive(); }

void movePose(EditorState& state, const RawInput& input, double seconds) {
  if (!state.hasCharacter()) return;
  const bool leftPressed = input.pressedButton == static_cast<int>(MouseButton::kLeft);
  if (!holdsPose(state.tools, leftPressed)) advance(state.transport, seconds, state.character());
  state.live->movePose(state.transport);
}

}  // namespace

void EditorStep::run(EditorState& state, const RawInput& input, const Fonts& fonts, double seconds) {
  const double start = secondsNow();
  const bool viewportFree = runInterface(state, input, fonts);
  double interface = secondsNow() - start;
  movePose(state, input, seconds);
  const double toolsStart = secondsNow();
  runTools(state, input, viewportFree, seconds);
  interface += secondsNow() - toolsStart;
  updateSurface(state);
  state.stats.ui = interface;
}

/// Keys and panels. @return whether the mouse is over the picture and nothing lies in front of it.
bool EditorStep::runInterface(EditorState& state, const RawInput& input, const Fonts& fonts) {
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (!popup && !isTyping() && !ownsKeyboard(state.tools)) runShortcut(state, input);
  widgets_.beginFrame();
  PanelUi ui(state, widgets_, fonts);
  const bool viewportFree = drawLayout(ui);
  wakeAfter_ = ui.wakeAfter;
  return viewportFree;
}

void EditorStep::runTools(EditorState& state, const RawInput& input, bool viewportFree, double seconds) {
  cameraMoves_ = false;
  if (!state.hasCharacter()) return;
  if (state.frameWanted) {
    frameBounds(state.tools.camera, boundsOf(state.live->surface().positions), state.viewportPixels, false);
    state.frameWanted = false;
  }
  const ImGuiIO& io = ImGui::GetIO();
  const InterfaceClaims claims{viewportFree, isTyping(), ImGui::IsMouseDoubleClicked(0)};
  const glm::vec2 pixelsPerUnit{io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y};
  const ViewportInput own = viewportInput(input, claims, state.viewport, pixelsPerUnit, seconds);
  const ViewportContext context{state.document,
                                state.live->pose(),
                                &state.live->surface(),
                                state.display,
                                state.viewportPixels,
                                state.uiScale * pixelsPerUnit.x,
                                &state.transport.overrides};
  state.route = routeInput(state.tools, own, context);
  cameraMoves_ = isMoving(state.tools.camera);
  if (!state.route.refusal.empty()) addMessage(state, MessageKind::kError, state.route.refusal);
}

void EditorStep::updateSurface(EditorState& state) {
  if (!state.hasCharacter()) return;
  state.live->movePose(state.transport);  // The pose tool may have turned a joint.
  followEdits(state);
  followPose(state);
  const Result<bool> updated = state.live->update(state.document.commands, surfaceView(state));
  if (!updated) addMessage(state, MessageKind::kError, updated.error().text());
  state.stats.stages = state.live->surface().report.seconds;
  const std::pair prepared(state.documentsOpened, state.document.commands.revision());
  state.stats.prepare = std::exchange(prepared_, prepared) == prepared ? 0.0 : state.live->prepareSeconds();
}

}  // namespace sinew::app
