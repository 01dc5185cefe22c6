// app/panels/file_dialog.cpp: Open and Save As: a path field over a small file browser.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <string>

#include "app/panels/commands.h"
#include "app/panels/folder_listing.h"
#include "app/panels/panels.h"

namespace sinew::app {
namespace {

void close(EditorState& state) {
  state.dialog = {};
  ImGui::CloseCurrentPopup();
}

void enter(FileDialogState& dialog, const std::filesystem::path& folder) {
  dialog.folder = folder;
  if (dialog.kind == DialogKind::kOpen) dialog.text.clear();
  dialog.error.clear();
  dialog.appearing = true;
}

/// The file Save As would write.
std::filesystem::path saveTarget(const FileDialogState& dialog) {
  return withRigEnding(resolveTyped(dialog.folder, dialog.text));
}

/// Save As would overwrite a file that is not this document's own.
bool replaces(const EditorState& state) {
  if (state.dialog.kind != DialogKind::kSaveAs || state.dialog.text.empty()) return false;
  std::error_code ignored;
  const std::filesystem::path target = saveTarget(state.dialog);
  return std::filesystem::is_regular_file(target, ignored) &&
         !std::filesystem::equivalent(target, state.document.rigFile, ignored);
}

void confirmOpen(EditorState& state, const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    state.dialog.error = "There is no file " + file.string();
    state.dialog.appearing = true;
    return;
  }
  close(state);
  request(state, {IntentKind::kOpenFile, file});
}

void confirmSave(EditorState& state) {
  const std::string error = saveTo(state, saveTarget(state.dialog));
  if (!error.empty()) {
    state.dialog.error = error;
    state.dialog.appearing = true;
    return;
  }
  const Intent then = state.dialog.then;
  close(state);
  perform(state, then);
}

void confirm(EditorState& state) {
  FileDialogState& dialog = state.dialog;
  if (dialog.text.empty()) return;
  const std::filesystem::path typed = resolveTyped(dialog.folder, dialog.text);
  std::error_code ignored;
  if (std::filesystem::is_directory(typed, ignored)) {
    enter(dialog, typed);
  } else if (dialog.kind == DialogKind::kOpen) {
    confirmOpen(state, typed);
  } else {
    confirmSave(state);
  }
}

void entryRow(Ui& ui, const FolderEntry& entry) {
  FileDialogState& dialog = ui.state.dialog;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight() + ui.px(6);
  const bool clicked =
      ImGui::Selectable(("##" + entry.name).c_str(), dialog.text == entry.name,
                        ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups, {0.0f, height});
  ui.widgets.note("dialog/entry/" + entry.name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  drawIcon(list, entry.folder ? Icon::kFolder : Icon::kFile, {corner.x + ui.px(4), corner.y + ui.px(3)}, ui.px(15),
           (entry.folder ? palette::kAccent : palette::kMuted).packed());
  list.AddText({corner.x + ui.px(26), corner.y + ui.px(3)}, palette::kText.packed(), entry.name.c_str());
  if (!clicked) return;
  if (entry.folder) {
    enter(dialog, (dialog.folder / entry.name).lexically_normal());
    return;
  }
  dialog.text = entry.name;
  dialog.error.clear();
  if (ImGui::IsMouseDoubleClicked(0) && dialog.kind == DialogKind::kOpen) confirm(ui.state);
}

void browser(Ui& ui) {
  FileDialogState& dialog = ui.state.dialog;
  if (iconButton(ui, "dialog/up", Icon::kStart, false, ImGui::GetFrameHeight())) {
    if (dialog.folder.has_parent_path()) enter(dialog, dialog.folder.parent_path());
  }
  tooltip(ui, "The folder above");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  mutedText(dialog.folder.string().c_str());
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kBackground);
  ImGui::BeginChild("entries", {0.0f, ui.px(280)}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  const std::vector<FolderEntry> entries = listFolder(dialog.folder, dialog.kind == DialogKind::kSaveAs);
  if (entries.empty()) mutedText(dialog.kind == DialogKind::kOpen ? "No characters or rigs here." : "No rigs here.");
  for (const FolderEntry& entry : entries) {
    entryRow(ui, entry);
    if (ui.state.dialog.kind == DialogKind::kNone) break;
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

void buttons(Ui& ui) {
  EditorState& state = ui.state;
  const bool replacing = replaces(state);
  if (!state.dialog.error.empty() || replacing) {
    ImGui::PushStyleColor(ImGuiCol_Text, state.dialog.error.empty() ? palette::kWarning : palette::kError);
    ImGui::TextWrapped(
        "%s", state.dialog.error.empty() ? "This file exists and will be replaced." : state.dialog.error.c_str());
    ImGui::PopStyleColor();
  }
  const char* verb = state.dialog.kind == DialogKind::kOpen ? "Open" : (replacing ? "Replace" : "Save");
  const float width = ui.px(96);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * width - ui.px(8));
  const bool cancelled = ImGui::Button("Cancel", {width, 0.0f});
  ui.widgets.note("dialog/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.45f));
  const bool confirmed = ImGui::Button(verb, {width, 0.0f});
  ImGui::PopStyleColor();
  ui.widgets.note("dialog/ok");
  if (confirmed) confirm(state);
  if (cancelled || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) close(state);
}

}  // namespace

void drawFileDialog(Ui& ui) {
  FileDialogState& dialog = ui.state.dialog;
  if (dialog.kind == DialogKind::kNone) return;
  const char* title = dialog.kind == DialogKind::kOpen ? "Open a character or a rig" : "Save the rig as";
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * display.x, 0.46f * display.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({ui.px(600), 0.0f});
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    browser(ui);
    if (dialog.kind != DialogKind::kNone) {
      if (dialog.appearing) ImGui::SetKeyboardFocusHere();
      dialog.appearing = false;  // What follows may ask for the focus again.
      ImGui::SetNextItemWidth(-1.0f);
      const bool entered = ImGui::InputTextWithHint(
          "##path", "Path", &dialog.text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
      ui.widgets.note("dialog/path");
      if (ImGui::IsItemEdited()) dialog.error.clear();
      if (entered) confirm(ui.state);
    }
    if (dialog.kind != DialogKind::kNone) buttons(ui);
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace sinew::app
