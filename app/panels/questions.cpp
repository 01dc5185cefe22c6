// app/panels/questions.cpp: unsaved changes, running exports, recovery, a missing or another character, changed files.
#include <array>
#include <string>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/document/file_stamp.h"
#include "app/document/listed_muscles.h"
#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/editor/export_commands.h"
#include "app/editor/open_file.h"
#include "app/editor/session.h"
#include "app/panels/dialogs.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

enum class Answer { kNone, kSave, kDiscard, kCancel };

Answer askUnsaved(PanelUi& ui) {
  Answer answer = Answer::kNone;
  ImGui::TextWrapped("\"%s\" has changes that are not saved.", inReadingOrder(ui.state.document.name()).c_str());
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 size{ui.px(104), 0.0f};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 3.0f * size.x - 2.0f * ui.px(8));
  if (textButton(ui, "unsaved/cancel", "Cancel", size)) answer = Answer::kCancel;
  ImGui::SameLine(0.0f, ui.px(8));
  if (textButton(ui, "unsaved/discard", "Discard", size)) answer = Answer::kDiscard;
  ImGui::SameLine(0.0f, ui.px(8));
  if (accentButton(ui, "unsaved/save", "Save", size)) answer = Answer::kSave;
  return escapePressed(ui) ? Answer::kCancel : answer;
}

/// @return whether the question is answered
bool askExport(PanelUi& ui) {
  SessionState& session = ui.state.session;
  const std::vector<ExportStand> stands = session.exports.stands();
  if (stands.empty()) {  // They have ended meanwhile.
    perform(ui.state, {IntentKind::kQuit, {}});
    return true;
  }
  std::string names;
  for (const ExportStand& stand : stands) names += (names.empty() ? "" : ", ") + stand.file.filename().string();
  ImGui::TextWrapped("%s %s not written yet.", inReadingOrder(names).c_str(), stands.size() == 1 ? "is" : "are");
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 size{ui.px(128), 0.0f};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 3.0f * size.x - 2.0f * ui.px(8));
  const bool stay = textButton(ui, "export-question/cancel", "Cancel", size);
  ImGui::SameLine(0.0f, ui.px(8));
  const bool now = textButton(ui, "export-question/now", "Quit without", size);
  ImGui::SameLine(0.0f, ui.px(8));
  const bool later = accentButton(ui, "export-question/later", "Quit when done", size);
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
  heading(ui, left.name().c_str());
  ui.widgets.note("recovery/name/" + place);
  tooltip(ui, (left.rigFile.empty() ? left.characterFile : left.rigFile).string());
  const std::string age = ageText(left.when, std::filesystem::file_time_type::clock::now());
  mutedText((muscleCount(left.primitives) + ", " + age + (left.rigFile.empty() ? ", never saved" : "")).c_str());
  ImGui::TableNextColumn();
  ImGui::Dummy({0.0f, ui.px(2)});
  ImGui::PushID(static_cast<int>(index));
  if (accentButton(ui, "recovery/recover/" + place, "Recover", size)) choice = Choice::kRecover;
  ImGui::SameLine(0.0f, ui.px(8));
  if (textButton(ui, "recovery/discard/" + place, "Discard", size)) choice = Choice::kDiscard;
  ImGui::PopID();
  return choice;
}

/// @return whether the question is answered
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
  mutedParagraph("Recovered work opens as unsaved changes; files on disk stay as they are until you save.");
  ImGui::Dummy({0.0f, ui.px(4)});
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - ui.px(104));
  const bool later = textButton(ui, "recovery/later", "Later", {ui.px(104), 0.0f}, "Ask again at the next start");
  if (choice == Choice::kDiscard) discardRecovery(state, chosen);
  if (choice == Choice::kRecover) request(state, {IntentKind::kRecover, chosen});
  return choice == Choice::kRecover || later || state.session.leftBehind.empty() || escapePressed(ui);
}

}  // namespace

void drawUnsavedQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (state.dialogs.question.kind == IntentKind::kNone) return;
  placeDialog(ui, 400);
  drawModal(ui, "Unsaved changes", [&] {
    const Answer answer = askUnsaved(ui);
    if (answer == Answer::kNone) return false;
    const Intent intent = std::exchange(state.dialogs.question, {});
    if (answer == Answer::kDiscard) perform(state, intent);
    if (answer == Answer::kSave) save(state, intent);
    return true;
  });
}

void drawExportQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.dialogs.exportQuestion) return;
  placeDialog(ui, 460);
  drawModal(ui, "An export is running", [&] {
    if (askExport(ui)) state.dialogs.exportQuestion = false;
    return !state.dialogs.exportQuestion;
  });
}

void drawRecoveryQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (!state.dialogs.recovery) return;
  placeDialog(ui, 560);
  drawModal(ui, "Unsaved work found", [&] {
    if (askRecoveries(ui)) state.dialogs.recovery = false;
    return !state.dialogs.recovery;
  });
}

// A rig's character is missing: locate it, or leave the rig closed.

namespace {

void placeQuestion(PanelUi& ui, float width) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * display.x, 0.45f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({ui.px(width), 0.0f});
}

enum class LocateAnswer { kNone, kLocate, kCancel };

LocateAnswer askLocate(PanelUi& ui) {
  const LocateState& missing = ui.state.dialogs.locate;
  LocateAnswer answer = LocateAnswer::kNone;
  ImGui::TextWrapped("The character of \"%s\" is missing or cannot be read:",
                     missing.rigFile.filename().string().c_str());
  ImGui::Dummy({0.0f, ui.px(2)});
  mutedParagraph(missing.characterFile.lexically_normal().string());
  ImGui::Dummy({0.0f, ui.px(6)});
  const ImVec2 narrow{ui.px(104), 0.0f};
  const ImVec2 wide{ui.px(132), 0.0f};
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - narrow.x - wide.x - ui.px(8));
  if (textButton(ui, "locate/cancel", "Cancel", narrow)) answer = LocateAnswer::kCancel;
  ImGui::SameLine(0.0f, ui.px(8));
  if (accentButton(ui, "locate/locate", "Locate file...", wide)) answer = LocateAnswer::kLocate;
  return escapePressed(ui) ? LocateAnswer::kCancel : answer;
}

}  // namespace

void drawLocateQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (state.dialogs.locate.rigFile.empty() || state.dialogs.recovery) return;  // One question at a time.
  placeQuestion(ui, 460);
  drawModal(ui, "Character not found", [&] {
    const LocateAnswer answer = askLocate(ui);
    if (answer == LocateAnswer::kNone) return false;
    if (answer == LocateAnswer::kLocate) showLocateDialog(state);
    state.dialogs.locate = {};
    return true;
  });
}

// A character was dropped on one with muscles: should it get them?

namespace {

enum class KeepMusclesAnswer { kNone, kKeep, kOpenWithout, kAddClips, kCancel };

std::string musclesOf(const Document& document) {
  const std::size_t count = allLeads(document.rig()).size();
  return (count == 1 ? "the muscle" : "the " + std::to_string(count) + " muscles") + " of \"" + document.name() + '"';
}

KeepMusclesAnswer askKeepMuscles(PanelUi& ui) {
  KeepMusclesAnswer answer = KeepMusclesAnswer::kNone;
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
  if (textButton(ui, "keep-muscles/cancel", "Cancel", narrow)) answer = KeepMusclesAnswer::kCancel;
  ImGui::SameLine(0.0f, ui.px(8));
  if (hasClips) {
    if (textButton(ui, "keep-muscles/clips", "Add its clips", {clips, 0.0f})) answer = KeepMusclesAnswer::kAddClips;
    ImGui::SameLine(0.0f, ui.px(8));
  }
  if (textButton(ui, "keep-muscles/without", "Open without them", wide)) answer = KeepMusclesAnswer::kOpenWithout;
  ImGui::SameLine(0.0f, ui.px(8));
  if (accentButton(ui, "keep-muscles/keep", "Keep the muscles", wide)) answer = KeepMusclesAnswer::kKeep;
  return escapePressed(ui) ? KeepMusclesAnswer::kCancel : answer;
}

}  // namespace

void drawKeepMusclesQuestion(PanelUi& ui) {
  EditorState& state = ui.state;
  if (state.dialogs.keepMuscles.empty()) return;
  placeDialog(ui, state.dialogs.droppedHasClips ? 570.0f : 460.0f);
  drawModal(ui, "Keep the muscles?", [&] {
    const KeepMusclesAnswer answer = askKeepMuscles(ui);
    if (answer == KeepMusclesAnswer::kNone) return false;
    const std::filesystem::path file = std::exchange(state.dialogs.keepMuscles, {});
    if (answer == KeepMusclesAnswer::kKeep) request(state, {IntentKind::kOpenWithMuscles, file});
    if (answer == KeepMusclesAnswer::kAddClips) addClips(state, file);
    if (answer == KeepMusclesAnswer::kOpenWithout) request(state, {IntentKind::kOpenFile, file});
    return true;
  });
}

// The rig's file has changed on disk since it was opened: which version to keep.

namespace {

constexpr float kConflictWidth = 520.0f;  // Design pixels.
constexpr float kButtonWidth = 132.0f;

using Command = void (*)(EditorState&);

/// An answer, and what it does with the two versions.
struct ConflictAnswer {
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

std::array<ConflictAnswer, 3> answersOf(const EditorState& state, const std::string& name) {
  const bool gone = state.dialogs.conflict.found == OnDisk::kGone;
  const bool waits = state.dialogs.conflict.then.kind != IntentKind::kNone;
  const std::string beside = freeNameBeside(state.document.rigFile).filename().string();
  return {ConflictAnswer{"conflict/both", gone ? "Save as new file" : "Keep both",
                         "Save this window's version as \"" + beside + '"', saveBeside},
          ConflictAnswer{
              "conflict/reload", waits ? "Discard mine" : "Reload",
              waits ? "Give up this window's changes" : "Give up this window's changes and open the version on disk",
              discardForDisk},
          ConflictAnswer{"conflict/overwrite", gone ? "Save again" : "Overwrite",
                         gone ? "Write \"" + name + "\" again" : "Replace the version on disk by this window's",
                         saveOverDisk}};
}

bool answerRow(PanelUi& ui, const ConflictAnswer& answer, bool first) {
  const ImVec2 size{ui.px(kButtonWidth), 0.0f};
  const bool pressed =
      first ? accentButton(ui, answer.id, answer.label, size) : textButton(ui, answer.id, answer.label, size);
  ImGui::SameLine(0.0f, ui.px(12));
  ImGui::AlignTextToFramePadding();
  mutedParagraph(answer.effect);
  return pressed;
}

/// @return the answer's command; null: none yet
Command askConflict(PanelUi& ui) {
  const std::string name = ui.state.document.rigFile.filename().string();
  const bool gone = ui.state.dialogs.conflict.found == OnDisk::kGone;
  explain(ui, name, ui.state.dialogs.conflict.found);
  Command given = nullptr;
  bool first = true;
  const bool entered = ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) && !ImGui::IsWindowAppearing();
  for (const ConflictAnswer& answer : answersOf(ui.state, name)) {
    // A file that is gone cannot be loaded.
    const bool offered =
        !gone || answer.give != discardForDisk || ui.state.dialogs.conflict.then.kind != IntentKind::kNone;
    if (!offered) continue;
    if (answerRow(ui, answer, first) || (first && entered)) given = answer.give;
    first = false;
  }
  ImGui::Dummy({0.0f, ui.px(2)});
  if (textButton(ui, "conflict/cancel", "Cancel", {ui.px(kButtonWidth), 0.0f})) given = leaveUnsaved;
  return escapePressed(ui) ? leaveUnsaved : given;
}

}  // namespace

void drawConflictQuestion(PanelUi& ui) {
  if (ui.state.dialogs.conflict.found == OnDisk::kSame) return;
  placeQuestion(ui, kConflictWidth);
  drawModal(ui, "Changed on disk", [&] {
    const Command given = askConflict(ui);
    if (given != nullptr) given(ui.state);
    return given != nullptr;
  });
}

}  // namespace sinew::app
