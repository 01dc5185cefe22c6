// app/panels/locate_question.cpp: a rig's character is missing: locate it, or leave the rig closed.

#include <imgui.h>

#include <string>

#include "app/editor/open_file.h"
#include "app/panels/dialogs.h"

namespace sinew::app {
namespace {

constexpr const char* kLocateQuestionTitle = "Character not found";

enum class LocateQuestionAnswer { kNone, kLocate, kCancel };

LocateQuestionAnswer askLocateQuestion(PanelUi& ui) {
  const LocateState& missing = ui.state.dialogs.locate;
  LocateQuestionAnswer answer = LocateQuestionAnswer::kNone;
  ImGui::TextWrapped("The character of \"%s\" is missing or cannot be read:",
                     missing.rigFile.filename().string().c_str());
  ImGui::Dummy({0.0f, ui.px(2)});
  ImGui::PushTextWrapPos(0.0f);
  mutedText(missing.characterFile.lexically_normal().string().c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 narrow{ui.px(104), 0.0f};
  const ImVec2 wide{ui.px(132), 0.0f};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - narrow.x - wide.x - ui.px(8));
  if (ImGui::Button("Cancel", narrow)) answer = LocateQuestionAnswer::kCancel;
  ui.widgets.note("locate/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.45f));
  if (ImGui::Button("Locate file...", wide)) answer = LocateQuestionAnswer::kLocate;
  ImGui::PopStyleColor();
  ui.widgets.note("locate/locate");
  return escapePressed(ui) ? LocateQuestionAnswer::kCancel : answer;
}

}  // namespace

void drawLocateQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (state.dialogs.locate.rigFile.empty() || state.dialogs.recovery) return;  // One question at a time.
  if (!ImGui::IsPopupOpen(kLocateQuestionTitle)) ImGui::OpenPopup(kLocateQuestionTitle);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * display.x, 0.45f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({ui.px(460), 0.0f});
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kLocateQuestionTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    const LocateQuestionAnswer answer = askLocateQuestion(ui);
    if (answer != LocateQuestionAnswer::kNone) {
      ImGui::CloseCurrentPopup();
      if (answer == LocateQuestionAnswer::kLocate) showLocateDialog(state);
      state.dialogs.locate = {};
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
