// app/panels/file_dialog.cpp: Open and Save As: a path field under a file browser.

#include "app/panels/dialogs.h"

#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <string>
#include <system_error>

#include "app/editor/clip_commands.h"
#include "app/editor/commands.h"
#include "app/editor/export_commands.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/editor/open_file.h"
#include "app/editor/picture_commands.h"
#include "app/editor/reference_commands.h"
#include "app/ui/reading_order.h"

namespace sinew::app {
namespace {

constexpr float kFileDialogWidth = 820.0f;  // Design pixels.
constexpr float kListHeight = 340.0f;

void close(EditorState& state) {
  state.dialogs.file = {};
  ImGui::CloseCurrentPopup();
}

/// Whether it chooses an existing file.
bool opens(const FileDialogState& dialog) {
  return dialog.kind == DialogKind::kOpen || dialog.kind == DialogKind::kReference ||
         dialog.kind == DialogKind::kSculpt;
}

void showFolder(FileDialogState& dialog, const std::filesystem::path& folder) {
  std::filesystem::path clean = folder.lexically_normal();
  if (!clean.has_filename() && clean.has_relative_path()) clean = clean.parent_path();  // Without the last slash.
  dialog.folder = std::move(clean);
  if (opens(dialog)) dialog.text.clear();
  dialog.error.clear();
  dialog.overwriteAsked = false;
  dialog.appearing = true;
}

std::filesystem::path saveTarget(const FileDialogState& dialog) {
  const std::filesystem::path typed = resolveTyped(dialog.folder, dialog.text);
  return dialog.kind == DialogKind::kSavePicture ? withPictureEnding(typed) : withRigEnding(typed);
}

/// Whether it chooses a file for another dialog, which asks before it replaces files.
bool choosesPlace(const FileDialogState& dialog) {
  return dialog.kind == DialogKind::kExportPlace || dialog.kind == DialogKind::kJobPlace ||
         dialog.kind == DialogKind::kPicturesPlace;
}

/// Whether it would overwrite a file that is not this document's own.
bool replaces(const EditorState& state) {
  std::error_code ignored;
  const std::filesystem::path target = saveTarget(state.dialogs.file);
  return std::filesystem::is_regular_file(target, ignored) &&
         !std::filesystem::equivalent(target, state.document.rigFile, ignored);
}

void complain(FileDialogState& dialog, const std::string& error) {
  dialog.error = error;
  dialog.appearing = true;
}

void confirmClips(EditorState& state, const std::filesystem::path& file) {
  const std::string gone = state.dialogs.file.clipsFor;
  const std::string error = gone.empty() ? addClips(state, file) : locateClipFile(state, gone, file);
  if (error.empty()) close(state);
  else complain(state.dialogs.file, error);
}

void confirmOpen(EditorState& state, const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    complain(state.dialogs.file, "There is no file " + file.string());
    return;
  }
  if (state.dialogs.file.kind == DialogKind::kSculpt) {
    if (const std::string error = takeSculpt(state, file); !error.empty()) complain(state.dialogs.file, error);
    else close(state);
    return;
  }
  if (state.dialogs.file.kind == DialogKind::kReference) {
    if (const std::string error = takeReference(state, file); !error.empty()) complain(state.dialogs.file, error);
    else close(state);
    return;
  }
  if (!state.dialogs.file.locateFor.empty()) {
    const std::filesystem::path rigFile = state.dialogs.file.locateFor;
    if (const std::string error = openWithCharacter(state, rigFile, file); !error.empty()) {
      complain(state.dialogs.file, error);
    } else {
      close(state);
    }
    return;
  }
  const IntentKind then = state.dialogs.file.then.kind;
  if (then == IntentKind::kAddClips) return confirmClips(state, file);
  close(state);
  request(state, {then == IntentKind::kNone ? IntentKind::kOpenFile : then, file});
}

void confirmPicture(EditorState& state) {
  const std::filesystem::path target = saveTarget(state.dialogs.file);
  std::error_code ignored;
  if (!std::filesystem::is_directory(target.parent_path(), ignored)) {
    complain(state.dialogs.file, "There is no folder " + target.parent_path().string());
    return;
  }
  close(state);
  wantPicture(state, target);
}

void confirmPlace(EditorState& state) {
  const FileDialogState& dialog = state.dialogs.file;
  const std::filesystem::path chosen = resolveTyped(dialog.folder, dialog.text).lexically_normal();
  std::error_code ignored;
  if (!std::filesystem::is_directory(chosen.parent_path(), ignored)) {
    complain(state.dialogs.file, "There is no folder " + chosen.parent_path().string());
    return;
  }
  if (dialog.kind == DialogKind::kPicturesPlace) takePicturesPlace(state.dialogs.pictures, chosen);
  else takePlace(state.dialogs, dialog.kind, chosen);
  close(state);
}

void confirmSave(EditorState& state) {
  if (choosesPlace(state.dialogs.file)) return confirmPlace(state);
  if (replaces(state) && !state.dialogs.file.overwriteAsked) {
    state.dialogs.file.overwriteAsked = true;
    state.dialogs.file.appearing = true;
    return;
  }
  if (state.dialogs.file.kind == DialogKind::kSavePicture) {
    confirmPicture(state);
    return;
  }
  const std::string error = saveTo(state, saveTarget(state.dialogs.file));
  if (!error.empty()) {
    complain(state.dialogs.file, error);
    return;
  }
  const Intent then = state.dialogs.file.then;
  close(state);
  perform(state, then);
}

/// Keys in the path field: Up and Down walk through the list, Tab completes.
int editPath(ImGuiInputTextCallbackData* data) {
  EditorState& state = *static_cast<EditorState*>(data->UserData);
  FileDialogState& dialog = state.dialogs.file;
  std::string text(data->Buf, static_cast<std::size_t>(data->BufTextLen));
  if (data->EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
    text = completePath(dialog.folder, text, listingOptions(state));
  } else if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory && !dialog.listing.entries.empty()) {
    const auto& entries = dialog.listing.entries;
    const auto at = std::ranges::find(entries, text, &FolderEntry::name);
    const auto last = static_cast<std::ptrdiff_t>(entries.size()) - 1;
    const std::ptrdiff_t step = data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
    const std::ptrdiff_t row = at == entries.end() ? (step > 0 ? 0 : last) : (at - entries.begin()) + step;
    text = entries[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(row, 0, last))].name;
    dialog.reveal = true;
  }
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, text.c_str());
  return 0;
}

const char* titleOf(const FileDialogState& dialog) {
  if (!dialog.locateFor.empty()) return "Locate the character";
  if (dialog.kind == DialogKind::kOpen && dialog.then.kind == IntentKind::kOpenWithMuscles)
    return "Character that gets the muscles";
  if (dialog.kind == DialogKind::kOpen && dialog.then.kind == IntentKind::kAddClips)
    return dialog.clipsFor.empty() ? "Add the clips of a file" : "Locate the file with the clips";
  if (dialog.kind == DialogKind::kSavePicture) return "Save the picture as";
  if (dialog.kind == DialogKind::kExportPlace) return "Where to export to";
  if (dialog.kind == DialogKind::kJobPlace) return "Where to write the job";
  if (dialog.kind == DialogKind::kPicturesPlace) return "Where to write the pictures";
  if (dialog.kind == DialogKind::kReference) return "Picture to work after";
  if (dialog.kind == DialogKind::kSculpt) return "Sculpt of this body";
  return dialog.kind == DialogKind::kOpen ? "Open a character or a rig" : "Save the rig as";
}

const char* hintOf(DialogKind kind) {
  if (kind == DialogKind::kPicturesPlace) return "Name of the pictures' file";
  if (kind == DialogKind::kSculpt) return "A .glb, .gltf, .vrm, .obj or .ply in the bind pose  (Tab completes)";
  if (kind == DialogKind::kReference) return "A .png, .jpg or .webp  (Tab completes)";
  if (kind == DialogKind::kSavePicture) return "Name of the picture";
  if (kind == DialogKind::kExportPlace) return "Name of the exported character";
  if (kind == DialogKind::kJobPlace) return "Name of the job's file";
  return kind == DialogKind::kOpen ? "Name or path  (Tab completes)" : "Name of the rig";
}

void drawPathField(PanelUi& ui) {
  FileDialogState& dialog = ui.state.dialogs.file;
  if (dialog.appearing && !dialog.naming) ImGui::SetKeyboardFocusHere();
  if (!dialog.naming) dialog.appearing = false;  // Set again by what follows.
  const bool wasEmpty = dialog.text.empty();
  ImGui::SetNextItemWidth(dialog.kind == DialogKind::kOpen ? -ui.px(158) : -1.0f);
  const bool entered =
      ImGui::InputTextWithHint("##path", hintOf(dialog.kind), &dialog.text,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                                   ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackHistory,
                               editPath, &ui.state);
  ui.widgets.note("dialog/path");
  if (ImGui::IsItemEdited()) {
    dialog.error.clear();
    dialog.overwriteAsked = false;
  }
  const bool active = ImGui::IsItemActive();
  if (entered) confirmPath(ui.state);
  else if (active && wasEmpty && ImGui::IsKeyPressed(GLFW_KEY_BACKSPACE, false)) goUp(dialog);
}

void drawFilter(PanelUi& ui) {
  FileDialogState& dialog = ui.state.dialogs.file;
  if (dialog.kind != DialogKind::kOpen) return;
  constexpr std::array kNames{"Characters and rigs", "Rigs", "Characters"};
  ImGui::SameLine(0.0f, ui.px(8));
  ImGui::SetNextItemWidth(-1.0f);
  const bool open = ImGui::BeginCombo("##filter", kNames[static_cast<std::size_t>(dialog.filter)]);
  ui.widgets.note("dialog/filter");
  if (!open) return;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (ImGui::Selectable(kNames[i], static_cast<std::size_t>(dialog.filter) == i)) {
      dialog.filter = static_cast<FileFilter>(i);
    }
    ui.widgets.note("dialog/filter/" + std::to_string(i));
  }
  ImGui::EndCombo();
}

void drawFileDialogComplaint(PanelUi& ui) {
  const FileDialogState& dialog = ui.state.dialogs.file;
  if (dialog.error.empty() && !dialog.overwriteAsked) return;
  const std::string asked = saveTarget(dialog).filename().string() + " already exists. Replace it?";
  ImGui::PushStyleColor(ImGuiCol_Text, dialog.error.empty() ? palette::kWarning : palette::kError);
  ImGui::TextWrapped("%s", inReadingOrder(dialog.error.empty() ? asked : dialog.error).c_str());
  ImGui::PopStyleColor();
}

void leave(EditorState& state) {
  if (state.dialogs.file.overwriteAsked || state.dialogs.file.naming) {
    state.dialogs.file.overwriteAsked = state.dialogs.file.naming = false;
    state.dialogs.file.appearing = true;
  } else {
    close(state);
  }
}

void drawButtons(PanelUi& ui) {
  EditorState& state = ui.state;
  const FileDialogState& dialog = state.dialogs.file;
  const char* saving = choosesPlace(dialog) ? "Choose" : (dialog.overwriteAsked ? "Replace" : "Save");
  const char* adding = dialog.clipsFor.empty() ? "Add" : "Locate";
  const char* opening = dialog.then.kind == IntentKind::kAddClips ? adding : "Open";
  const char* verb = opens(dialog) ? opening : saving;
  const float width = ui.px(96);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * width - ui.px(8));
  const bool canceled = textButton(ui, "dialog/cancel", dialog.overwriteAsked ? "Keep" : "Cancel", {width, 0.0f});
  ImGui::SameLine(0.0f, ui.px(8));
  const bool confirmed = accentButton(ui, "dialog/ok", verb, {width, 0.0f});
  if (confirmed) confirmPath(state);
  else if (canceled || escapePressed(ui)) leave(state);
}

void takeKeys(EditorState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  FileDialogState& dialog = state.dialogs.file;
  if (io.KeyAlt && ImGui::IsKeyPressed(GLFW_KEY_UP, false)) goUp(dialog);
  if (io.KeyAlt && ImGui::IsKeyPressed(GLFW_KEY_LEFT, false)) goBack(dialog);
  if (io.KeyAlt && ImGui::IsKeyPressed(GLFW_KEY_RIGHT, false)) goForward(dialog);
  if (io.KeyCtrl && ImGui::IsKeyPressed(GLFW_KEY_H, false)) {
    state.session.preferences.hiddenFiles = !state.session.preferences.hiddenFiles;
  }
}

}  // namespace

ListingOptions listingOptions(const EditorState& state) {
  FileFilter filter = state.dialogs.file.filter;
  if (state.dialogs.file.kind == DialogKind::kSaveAs) filter = FileFilter::kAll;
  if (state.dialogs.file.kind == DialogKind::kSavePicture) filter = FileFilter::kPictures;
  if (state.dialogs.file.kind == DialogKind::kExportPlace) filter = FileFilter::kCharacters;
  if (state.dialogs.file.kind == DialogKind::kJobPlace) filter = FileFilter::kJobs;
  if (state.dialogs.file.kind == DialogKind::kPicturesPlace) filter = FileFilter::kMovies;
  if (state.dialogs.file.kind == DialogKind::kReference) filter = FileFilter::kReferences;
  if (state.dialogs.file.kind == DialogKind::kSculpt) filter = FileFilter::kSculpts;
  return {filter, state.session.preferences.hiddenFiles, state.session.preferences.newestFirst};
}

void enterFolder(FileDialogState& dialog, const std::filesystem::path& folder) {
  dialog.back.push_back(dialog.folder);
  dialog.forward.clear();
  showFolder(dialog, folder);
}

void goBack(FileDialogState& dialog) {
  if (dialog.back.empty()) return;
  const std::filesystem::path folder = dialog.back.back();
  dialog.back.pop_back();
  dialog.forward.push_back(dialog.folder);
  showFolder(dialog, folder);
}

void goForward(FileDialogState& dialog) {
  if (dialog.forward.empty()) return;
  const std::filesystem::path folder = dialog.forward.back();
  dialog.forward.pop_back();
  dialog.back.push_back(dialog.folder);
  showFolder(dialog, folder);
}

void goUp(FileDialogState& dialog) {
  if (dialog.folder.has_relative_path()) enterFolder(dialog, dialog.folder.parent_path());
}

void confirmPath(EditorState& state) {
  FileDialogState& dialog = state.dialogs.file;
  if (dialog.text.empty()) return;
  const std::filesystem::path typed = resolveTyped(dialog.folder, dialog.text);
  std::error_code ignored;
  if (std::filesystem::is_directory(typed, ignored)) {
    if (!opens(dialog)) dialog.text.clear();
    enterFolder(dialog, typed);
  } else if (opens(dialog)) {
    confirmOpen(state, typed);
  } else {
    confirmSave(state);
  }
}

void drawFileDialog(PanelUi& ui) {
  FileDialogState& dialog = ui.state.dialogs.file;
  if (dialog.kind == DialogKind::kNone) return;
  const char* title = titleOf(dialog);
  placeDialog(ui, kFileDialogWidth);
  drawModal(ui, title, [&] {
    takeKeys(ui.state);
    drawFolderBrowser(ui, std::clamp(ImGui::GetIO().DisplaySize.y - ui.px(240), ui.px(90), ui.px(kListHeight)));
    if (dialog.kind != DialogKind::kNone) {
      drawPathField(ui);
      drawFilter(ui);
    }
    if (dialog.kind != DialogKind::kNone) drawFileDialogComplaint(ui);
    if (dialog.kind != DialogKind::kNone) drawButtons(ui);
    return false;  // close() closes it.
  });
}

}  // namespace sinew::app
