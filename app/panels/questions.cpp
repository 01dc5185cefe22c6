// app/panels/questions.cpp: what becomes of unsaved changes, and of work that a crash left behind.

#include <imgui.h>

#include <string>

#include "app/editor/commands.h"
#include "app/editor/export_commands.h"
#include "app/editor/session.h"
#include "app/panels/dialog_parts.h"
#include "app/panels/dialogs.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr const char* kUnsavedTitle = "Unsaved changes";
constexpr const char* kExportTitle = "An export is running";
constexpr const char* kRecoveryTitle = "Unsaved work found";

enum class QuestionsAnswer { kNone, kSave, kDiscard, kCancel };

QuestionsAnswer askUnsaved(PanelUi& ui) {
  QuestionsAnswer answer = QuestionsAnswer::kNone;
  ImGui::TextWrapped("\"%s\" has changes that are not saved.", inReadingOrder(ui.state.document.name()).c_str());
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 size{ui.px(104), 0.0f};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 3.0f * size.x - 2.0f * ui.px(8));
  if (ImGui::Button("Cancel", size)) answer = QuestionsAnswer::kCancel;
  ui.widgets.note("unsaved/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  if (ImGui::Button("Discard", size)) answer = QuestionsAnswer::kDiscard;
  ui.widgets.note("unsaved/discard");
  ImGui::SameLine(0.0f, ui.px(8));
  if (accentButton("Save", size)) answer = QuestionsAnswer::kSave;
  ui.widgets.note("unsaved/save");
  return escapePressed(ui) ? QuestionsAnswer::kCancel : answer;
}

/// @return whether the question is over.
bool askExport(PanelUi& ui) {
  SessionState& session = ui.state.session;
  const std::vector<ExportStand> stands = session.exports.stands();
  if (stands.empty()) {  // Done meanwhile.
    perform(ui.state, {IntentKind::kQuit, {}});
    return true;
  }
  std::string names;
  for (const ExportStand& stand : stands) names += (names.empty() ? "" : ", ") + stand.file.filename().string();
  ImGui::TextWrapped("%s %s not written yet.", inReadingOrder(names).c_str(), stands.size() == 1 ? "is" : "are");
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 size{ui.px(128), 0.0f};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 3.0f * size.x - 2.0f * ui.px(8));
  const bool stay = ImGui::Button("Cancel", size);
  ui.widgets.note("export-question/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  const bool now = ImGui::Button("Quit without", size);
  ui.widgets.note("export-question/now");
  ImGui::SameLine(0.0f, ui.px(8));
  const bool later = accentButton("Quit when done", size);
  ui.widgets.note("export-question/later");
  if (now) session.quit = true;
  if (later) quitAfterExports(ui.state);
  return now || later || stay || escapePressed(ui);
}

std::string muscleCount(int count) { return count == 1 ? std::string("1 muscle") : std::to_string(count) + " muscles"; }

enum class Choice { kNone, kRecover, kDiscard };

Choice askRecovery(PanelUi& ui, const LeftBehind& left, std::size_t index) {
  Choice choice = Choice::kNone;
  const std::string place = std::to_string(index);
  const ImVec2 size{ui.px(92), 0.0f};
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushFont(ui.fonts.strong);
  ImGui::TextUnformatted(inReadingOrder(left.name()).c_str());
  ImGui::PopFont();
  ui.widgets.note("recovery/name/" + place);
  tooltip(ui, (left.rigFile.empty() ? left.characterFile : left.rigFile).string());
  const std::string age = ageText(left.when, std::filesystem::file_time_type::clock::now());
  mutedText((muscleCount(left.primitives) + ", " + age + (left.rigFile.empty() ? ", never saved" : "")).c_str());
  ImGui::TableNextColumn();
  ImGui::Dummy({0.0f, ui.px(2)});
  ImGui::PushID(static_cast<int>(index));
  if (accentButton("Recover", size)) choice = Choice::kRecover;
  ui.widgets.note("recovery/recover/" + place);
  ImGui::SameLine(0.0f, ui.px(8));
  if (ImGui::Button("Discard", size)) choice = Choice::kDiscard;
  ui.widgets.note("recovery/discard/" + place);
  ImGui::PopID();
  return choice;
}

/// @return whether the question is over.
bool askRecoveries(PanelUi& ui) {
  EditorState& state = ui.state;
  ImGui::TextWrapped("The editor did not exit normally. These unsaved changes were kept:");
  ImGui::Dummy({0.0f, ui.px(4)});
  Choice choice = Choice::kNone;
  std::filesystem::path chosen;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ui.px(6), ui.px(5)});
  if (ImGui::BeginTable("left", 2, ImGuiTableFlags_BordersInnerH)) {
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("actions", ImGuiTableColumnFlags_WidthFixed, 2.0f * ui.px(92) + ui.px(8));
    for (std::size_t i = 0; i < state.session.leftBehind.size(); ++i) {
      const Choice here = askRecovery(ui, state.session.leftBehind[i], i);
      if (here == Choice::kNone) continue;
      choice = here;
      chosen = state.session.leftBehind[i].file;
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  ImGui::Dummy({0.0f, ui.px(4)});
  ImGui::PushTextWrapPos(0.0f);
  mutedText("Recovered work opens as unsaved changes; files on disk stay as they are until you save.");
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0.0f, ui.px(4)});
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - ui.px(104));
  const bool later = ImGui::Button("Later", {ui.px(104), 0.0f});
  ui.widgets.note("recovery/later");
  tooltip(ui, "Ask again at the next start");
  if (choice == Choice::kDiscard) discardRecovery(state, chosen);
  if (choice == Choice::kRecover) request(state, {IntentKind::kRecover, chosen});
  return choice == Choice::kRecover || later || state.session.leftBehind.empty() || escapePressed(ui);
}

}  // namespace

void drawUnsavedQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (state.dialogs.question.kind == IntentKind::kNone) return;
  if (!ImGui::IsPopupOpen(kUnsavedTitle)) ImGui::OpenPopup(kUnsavedTitle);
  placeDialog(ui, 400);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kUnsavedTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    const QuestionsAnswer answer = askUnsaved(ui);
    if (answer != QuestionsAnswer::kNone) {
      const Intent intent = state.dialogs.question;
      state.dialogs.question = {};
      ImGui::CloseCurrentPopup();
      if (answer == QuestionsAnswer::kDiscard) perform(state, intent);
      if (answer == QuestionsAnswer::kSave) save(state, intent);
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

void drawExportQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.dialogs.exportQuestion) return;
  if (!ImGui::IsPopupOpen(kExportTitle)) ImGui::OpenPopup(kExportTitle);
  placeDialog(ui, 460);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kExportTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    if (askExport(ui)) {
      state.dialogs.exportQuestion = false;
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

void drawRecoveryQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.dialogs.recovery) return;
  if (!ImGui::IsPopupOpen(kRecoveryTitle)) ImGui::OpenPopup(kRecoveryTitle);
  placeDialog(ui, 560);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kRecoveryTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    if (askRecoveries(ui)) {
      state.dialogs.recovery = false;
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
