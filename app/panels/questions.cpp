// app/panels/questions.cpp: what becomes of unsaved changes; which keys there are.

#include <imgui.h>

#include <string>

#include "app/panels/commands.h"
#include "app/panels/panels.h"

namespace sinew::app {
namespace {

constexpr const char* kUnsavedTitle = "Unsaved changes";
constexpr const char* kKeysTitle = "Keys and mouse";

void centerNext(Ui& ui, float designWidth) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * display.x, 0.45f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({ui.px(designWidth), 0.0f});
}

bool escapePressed() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false); }

enum class Answer { kNone, kSave, kDiscard, kCancel };

Answer askUnsaved(Ui& ui) {
  Answer answer = Answer::kNone;
  ImGui::TextWrapped("\"%s\" has changes that are not saved.", ui.state.document.name().c_str());
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 size{ui.px(104), 0.0f};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 3.0f * size.x - 2.0f * ui.px(8));
  if (ImGui::Button("Cancel", size)) answer = Answer::kCancel;
  ui.widgets.note("unsaved/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  if (ImGui::Button("Discard", size)) answer = Answer::kDiscard;
  ui.widgets.note("unsaved/discard");
  ImGui::SameLine(0.0f, ui.px(8));
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.45f));
  if (ImGui::Button("Save", size)) answer = Answer::kSave;
  ImGui::PopStyleColor();
  ui.widgets.note("unsaved/save");
  return escapePressed() ? Answer::kCancel : answer;
}

void keyRow(const char* what, const std::string& keys) {
  ImGui::TableNextColumn();
  mutedText(what);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(keys.c_str());
}

void mouseRows() {
  keyRow("Orbit", "drag beside the handles, Alt+left, middle");
  keyRow("Pan", "right drag, Shift+middle");
  keyRow("Zoom", "wheel");
  keyRow("Lock an axis while dragging", "X  Y  Z");
  keyRow("Snap / precise", "Ctrl / Shift while dragging");
  keyRow("Type a value while dragging", "digits, Enter");
  keyRow("Cancel a drag", "Esc, right button");
}

void actionRows() {
  for (const Action& item : actions()) {
    if (item.shortcut.key == 0) continue;
    std::string keys = textOf(item.shortcut);
    if (item.second.key != 0) keys += "  or  " + textOf(item.second);
    keyRow(item.label, keys);
  }
}

}  // namespace

void drawUnsavedQuestion(Ui& ui) {
  EditorState& state = ui.state;
  if (state.question.kind == IntentKind::kNone) return;
  if (!ImGui::IsPopupOpen(kUnsavedTitle)) ImGui::OpenPopup(kUnsavedTitle);
  centerNext(ui, 400);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kUnsavedTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    const Answer answer = askUnsaved(ui);
    if (answer != Answer::kNone) {
      const Intent intent = state.question;
      state.question = {};
      ImGui::CloseCurrentPopup();
      if (answer == Answer::kDiscard) perform(state, intent);
      if (answer == Answer::kSave) save(state, intent);
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

void drawKeySheet(Ui& ui) {
  if (!ui.state.keySheet) return;
  if (!ImGui::IsPopupOpen(kKeysTitle)) ImGui::OpenPopup(kKeysTitle);
  centerNext(ui, 820);
  pushDialogStyle(ui);
  bool open = true;
  if (ImGui::BeginPopupModal(kKeysTitle, &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(3)});
    if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingStretchProp)) {
      actionRows();
      mouseRows();
      ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    ImGui::Dummy({0.0f, ui.px(4)});
    const bool closed = ImGui::Button("Close", {ui.px(104), 0.0f});
    ui.widgets.note("keys/close");
    if (closed || !open || escapePressed() || ImGui::IsMouseClicked(1)) {
      ui.state.keySheet = false;
      ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
