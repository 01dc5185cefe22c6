// app/panels/conflict_question.cpp: the rig's file has changed on disk since it was opened: which one stays.

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <string>

#include "app/document/file_stamp.h"
#include "app/editor/disk_conflict.h"
#include "app/panels/dialogs.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr const char* kConflictQuestionTitle = "Changed on disk";
constexpr float kConflictQuestionWidth = 520.0f;  // Design pixels.
constexpr float kButtonWidth = 132.0f;

using Command = void (*)(EditorState&);

/// One answer: what it is called, and what becomes of the two versions.
struct ConflictQuestionAnswer {
  const char* id;
  const char* label;
  std::string effect;
  Command give;
};

void explain(PanelUi& ui, const std::string& name, OnDisk found) {
  if (found == OnDisk::kGone) {
    ImGui::TextWrapped("\"%s\" was moved or deleted after this window opened or saved it.",
                       inReadingOrder(name).c_str());
  } else {
    ImGui::TextWrapped("\"%s\" was changed by another window or program after this window opened or saved it.",
                       inReadingOrder(name).c_str());
  }
  ImGui::Dummy({0.0f, ui.px(6)});
}

std::array<ConflictQuestionAnswer, 3> answersOf(const EditorState& state, const std::string& name) {
  const bool gone = state.dialogs.conflict.found == OnDisk::kGone;
  const bool waits = state.dialogs.conflict.then.kind != IntentKind::kNone;
  const std::string beside = freeNameBeside(state.document.rigFile).filename().string();
  return {ConflictQuestionAnswer{"conflict/both", gone ? "Save as new file" : "Keep both",
                                 "Save this window's version as \"" + beside + '"', saveBeside},
          ConflictQuestionAnswer{
              "conflict/reload", waits ? "Discard mine" : "Reload",
              waits ? "Give up this window's changes" : "Give up this window's changes and open the version on disk",
              discardForDisk},
          ConflictQuestionAnswer{"conflict/overwrite", gone ? "Save again" : "Overwrite",
                                 gone ? "Write \"" + name + "\" again" : "Replace the version on disk by this window's",
                                 saveOverDisk}};
}

bool answerRow(PanelUi& ui, const ConflictQuestionAnswer& answer, bool first) {
  if (first) ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.45f));
  const bool pressed = ImGui::Button(answer.label, {ui.px(kButtonWidth), 0.0f});
  if (first) ImGui::PopStyleColor();
  ui.widgets.note(answer.id);
  ImGui::SameLine(0.0f, ui.px(12));
  ImGui::AlignTextToFramePadding();
  ImGui::PushTextWrapPos(0.0f);
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kMuted);
  ImGui::TextUnformatted(answer.effect.c_str());
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  return pressed;
}

/// @return what was answered; null: nothing yet.
Command askConflictQuestion(PanelUi& ui) {
  const std::string name = ui.state.document.rigFile.filename().string();
  const bool gone = ui.state.dialogs.conflict.found == OnDisk::kGone;
  explain(ui, name, ui.state.dialogs.conflict.found);
  Command given = nullptr;
  bool first = true;
  const bool entered = ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) && !ImGui::IsWindowAppearing();
  for (const ConflictQuestionAnswer& answer : answersOf(ui.state, name)) {
    // What is no longer there cannot be loaded.
    const bool offered =
        !gone || answer.give != discardForDisk || ui.state.dialogs.conflict.then.kind != IntentKind::kNone;
    if (!offered) continue;
    if (answerRow(ui, answer, first) || (first && entered)) given = answer.give;
    first = false;
  }
  ImGui::Dummy({0.0f, ui.px(2)});
  if (ImGui::Button("Cancel", {ui.px(kButtonWidth), 0.0f})) given = leaveUnsaved;
  ui.widgets.note("conflict/cancel");
  return escapePressed(ui) ? leaveUnsaved : given;
}

}  // namespace

void drawConflictQuestion(PanelUi& ui) {
  if (ui.state.dialogs.conflict.found == OnDisk::kSame) return;
  if (!ImGui::IsPopupOpen(kConflictQuestionTitle)) ImGui::OpenPopup(kConflictQuestionTitle);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * display.x, 0.45f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({ui.px(kConflictQuestionWidth), 0.0f});
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(kConflictQuestionTitle, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    if (const Command given = askConflictQuestion(ui)) {
      ImGui::CloseCurrentPopup();
      given(ui.state);
    }
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
