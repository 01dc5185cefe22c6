// app/panels/questions.cpp: what becomes of unsaved changes, and of work that a crash left behind.
#include <array>
#include <string>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/document/file_stamp.h"
#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/editor/disk_conflict.h"
#include "app/editor/export_commands.h"
#include "app/editor/open_file.h"
#include "app/editor/session.h"
#include "app/panels/dialogs.h"
#include "app/panels/panel_ui.h"
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

// A rig's character is missing: locate it, or leave the rig closed.

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

// A character was dropped on one with muscles: do they go on it?

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

// The rig's file has changed on disk since it was opened: which one stays.

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
