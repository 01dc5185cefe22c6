// app/panels/keep_muscles_question.cpp: a character was dropped on one with muscles: do they go on it?

#include <imgui.h>

#include <string>
#include <utility>

#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/panels/dialog_parts.h"
#include "app/panels/dialogs.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr const char* kKeepMusclesTitle = "Keep the muscles?";

enum class KeepMusclesQuestionAnswer { kNone, kKeep, kOpenWithout, kAddClips, kCancel };

std::string musclesOf(const Document& document) {
  const std::size_t count = document.rig().primitives.size();
  return (count == 1 ? "the muscle" : "the " + std::to_string(count) + " muscles") + " of \"" + document.name() + '"';
}

KeepMusclesQuestionAnswer askKeepMusclesQuestion(PanelUi& ui) {
  KeepMusclesQuestionAnswer answer = KeepMusclesQuestionAnswer::kNone;
  const bool hasClips = ui.state.dialogs.droppedHasClips;
  const std::string text = "Open \"" + ui.state.dialogs.keepMuscles.filename().string() + "\" with " +
                           musclesOf(ui.state.document) + ", each where it belongs on the other body?" +
                           (hasClips ? " Or keep this character open and add the clips of the file to it?" : "");
  ImGui::TextWrapped("%s", inReadingOrder(text).c_str());
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 narrow{ui.px(92), 0.0f};
  const ImVec2 wide{ui.px(148), 0.0f};
  const float clips = hasClips ? ui.px(110) : 0.0f;
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - narrow.x - 2.0f * wide.x - 2.0f * ui.px(8) -
                       (hasClips ? clips + ui.px(8) : 0.0f));
  if (ImGui::Button("Cancel", narrow)) answer = KeepMusclesQuestionAnswer::kCancel;
  ui.widgets.note("keep-muscles/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  if (hasClips) {
    if (ImGui::Button("Add its clips", {clips, 0.0f})) answer = KeepMusclesQuestionAnswer::kAddClips;
    ui.widgets.note("keep-muscles/clips");
    ImGui::SameLine(0.0f, ui.px(8));
  }
  if (ImGui::Button("Open without them", wide)) answer = KeepMusclesQuestionAnswer::kOpenWithout;
  ui.widgets.note("keep-muscles/without");
  ImGui::SameLine(0.0f, ui.px(8));
  if (accentButton("Keep the muscles", wide)) answer = KeepMusclesQuestionAnswer::kKeep;
  ui.widgets.note("keep-muscles/keep");
  return escapePressed(ui) ? KeepMusclesQuestionAnswer::kCancel : answer;
}

}  // namespace

void drawKeepMusclesQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (state.dialogs.keepMuscles.empty()) return;
  if (!ImGui::IsPopupOpen(kKeepMusclesTitle)) ImGui::OpenPopup(kKeepMusclesTitle);
  placeDialog(ui, state.dialogs.droppedHasClips ? 570.0f : 460.0f);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kKeepMusclesTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    const KeepMusclesQuestionAnswer answer = askKeepMusclesQuestion(ui);
    if (answer != KeepMusclesQuestionAnswer::kNone) {
      ImGui::CloseCurrentPopup();
      const std::filesystem::path file = std::exchange(state.dialogs.keepMuscles, {});
      if (answer == KeepMusclesQuestionAnswer::kKeep) request(state, {IntentKind::kOpenWithMuscles, file});
      if (answer == KeepMusclesQuestionAnswer::kAddClips) addClips(state, file);
      if (answer == KeepMusclesQuestionAnswer::kOpenWithout) request(state, {IntentKind::kOpenFile, file});
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
