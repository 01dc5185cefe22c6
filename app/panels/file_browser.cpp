// app/panels/file_browser.cpp: the path dialog's places, folders and files.

#include "app/panels/dialogs.h"

#include <imgui_stdlib.h>

#include <string>

#include "app/ui/code_points.h"
#include "app/ui/data_files.h"
#include "app/ui/reading_order.h"
#include "app/viewport/render/thumbnails.h"

namespace sinew::app {
namespace {

constexpr float kPlacesWidth = 150.0f;  // Design pixels.
constexpr float kDateWidth = 132.0f;
constexpr float kSizeWidth = 72.0f;
constexpr float kThumbnailHeight = 36.0f;

void drawPlaces(PanelUi& ui, float height) {
  FileDialogState& dialog = ui.state.dialogs.file;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kBackground.faded(0.55f));
  ImGui::BeginChild("places", {ui.px(kPlacesWidth), height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  for (const Place& place : places(ui.state.session.preferences.recentFiles, dataFile("assets"))) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float row = ImGui::GetTextLineHeight() + ui.px(8);
    ImGui::PushID(place.id.c_str());
    const bool chosen = ImGui::Selectable("##place", place.folder == dialog.folder, 0, {0.0f, row});
    ImGui::PopID();
    ui.widgets.note("dialog/place/" + place.id);
    tooltip(ui, place.folder.string());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    drawIcon(list, Icon::kFolder, {corner.x + ui.px(3), corner.y + ui.px(4)}, ui.px(15), palette::kMuted.packed());
    clippedText(list, {corner.x + ui.px(25), corner.y + ui.px(4)}, ImGui::GetContentRegionAvail().x - ui.px(25),
                palette::kText.packed(), place.name);
    if (chosen) enterFolder(dialog, place.folder);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

void drawCrumbs(PanelUi& ui) {
  FileDialogState& dialog = ui.state.dialogs.file;
  std::vector<std::filesystem::path> path;
  for (std::filesystem::path at = dialog.folder; !at.empty(); at = at.parent_path()) {
    path.push_back(at);
    if (at == at.parent_path()) break;
  }
  // The last ones, as many as there is room for.
  const float room = ImGui::GetContentRegionAvail().x - ui.px(70);
  float used = 0.0f;
  std::size_t shown = 0;
  while (shown < path.size()) {
    used += ImGui::CalcTextSize(path[shown].filename().c_str()).x + ui.px(18);
    if (shown > 0 && used > room) break;
    ++shown;
  }
  ImGui::PushStyleColor(ImGuiCol_Button, palette::kRaised.faded(0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(4), ImGui::GetStyle().FramePadding.y});
  for (std::size_t i = shown; i-- > 0;) {
    ImGui::SameLine(0.0f, ui.px(1));
    const std::string name = path[i].has_relative_path() ? path[i].filename().string() : "/";
    ImGui::PushStyleColor(ImGuiCol_Text, i == 0 ? palette::kText : palette::kMuted);
    // A single one may be longer than the room.
    const std::string text = shown == 1 ? fitted(name, room - ui.px(18)) : inReadingOrder(name);
    const bool chosen = ImGui::Button((text + "##crumb" + std::to_string(i)).c_str());
    ImGui::PopStyleColor();
    ui.widgets.note("dialog/crumb/" + std::to_string(i));
    if (i > 0 && path[i].has_relative_path()) {
      ImGui::SameLine(0.0f, ui.px(1));
      mutedText("/");
    }
    if (chosen) enterFolder(dialog, path[i]);
  }
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

void steerButton(PanelUi& ui, const char* id, Icon icon, const char* hint, bool possible,
                 void (*go)(FileDialogState&)) {
  ImGui::BeginDisabled(!possible);
  const bool pressed = iconButton(ui, id, icon, false, ImGui::GetFrameHeight());
  ImGui::EndDisabled();
  tooltip(ui, hint);
  ImGui::SameLine(0.0f, ui.px(2));
  if (pressed) go(ui.state.dialogs.file);
}

void drawSteering(PanelUi& ui) {
  FileDialogState& dialog = ui.state.dialogs.file;
  steerButton(ui, "dialog/back", Icon::kBack, "Back  (Alt+Left)", !dialog.back.empty(), goBack);
  steerButton(ui, "dialog/forward", Icon::kForward, "Forward  (Alt+Right)", !dialog.forward.empty(), goForward);
  steerButton(ui, "dialog/up", Icon::kUp, "The folder above  (Alt+Up)", dialog.folder.has_relative_path(), goUp);
  drawCrumbs(ui);
  const float size = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 2.0f * size - ui.px(2));
  if (iconButton(ui, "dialog/hidden", Icon::kHidden, ui.state.session.preferences.hiddenFiles, size)) {
    ui.state.session.preferences.hiddenFiles = !ui.state.session.preferences.hiddenFiles;
  }
  tooltip(ui, "Show hidden files and folders  (Ctrl+H)");
  ImGui::SameLine(0.0f, ui.px(2));
  if (iconButton(ui, "dialog/new-folder", Icon::kNewFolder, dialog.naming, size)) {
    dialog.naming = !dialog.naming;
    dialog.newFolder.clear();
    dialog.appearing = true;
  }
  tooltip(ui, "New folder");
}

void drawNewFolder(PanelUi& ui) {
  FileDialogState& dialog = ui.state.dialogs.file;
  if (!dialog.naming) return;
  if (dialog.appearing) ImGui::SetKeyboardFocusHere();
  dialog.appearing = false;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ui.px(104));
  const bool entered = ImGui::InputTextWithHint("##new-folder", "Name of the new folder", &dialog.newFolder,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note("dialog/new-folder-name");
  ImGui::SameLine();
  const bool pressed = textButton(ui, "dialog/create-folder", "Create", {ui.px(96), 0.0f});
  if (!(entered || pressed) || dialog.newFolder.empty()) return;
  const std::filesystem::path made = dialog.folder / dialog.newFolder;
  std::error_code failed;
  std::filesystem::create_directory(made, failed);
  dialog.naming = false;
  dialog.appearing = true;
  if (failed) dialog.error = made.string() + " cannot be made: " + failed.message();
  else enterFolder(dialog, made);
}

/// A column's title; a click sorts by the column.
void sortTitle(PanelUi& ui, const char* id, const char* title, bool newestFirst) {
  const bool active = ui.state.session.preferences.newestFirst == newestFirst;
  ImGui::PushStyleColor(ImGuiCol_Text, active ? palette::kText : palette::kMuted);
  const bool chosen = ImGui::Selectable(title, false, ImGuiSelectableFlags_DontClosePopups);
  ImGui::PopStyleColor();
  ui.widgets.note(id);
  if (active) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddLine({low.x, high.y}, {high.x, high.y}, palette::kAccent.packed(), ui.px(1.5f));
  }
  if (chosen) ui.state.session.preferences.newestFirst = newestFirst;
}

void drawTitles(PanelUi& ui) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  sortTitle(ui, "dialog/sort-name", "Name", false);
  ImGui::TableNextColumn();
  mutedText("Size");
  ImGui::TableNextColumn();
  sortTitle(ui, "dialog/sort-date", "Changed", true);
}

/// @param number  in the list, from 1: shown if no font has the letters of the name
void drawEntry(PanelUi& ui, const FolderEntry& entry, int number) {
  FileDialogState& dialog = ui.state.dialogs.file;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool tall = !entry.folder && dialog.kind == DialogKind::kOpen;  // With or without a thumbnail.
  const bool onScreen = ImGui::IsRectVisible({1.0f, ui.px(kThumbnailHeight)});
  const ImTextureID thumbnail =
      tall && onScreen ? thumbnailOf(ui, dialog.folder / entry.name, entry.when) : ImTextureID{};
  const float height = tall ? ui.px(kThumbnailHeight) : ImGui::GetTextLineHeight() + ui.px(4);
  const float top = 0.5f * (height - ImGui::GetTextLineHeight());
  const bool chosen = dialog.text == entry.name;
  const bool clicked = ImGui::Selectable(("##" + entry.name).c_str(), chosen,
                                         ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups |
                                             ImGuiSelectableFlags_SpanAllColumns,
                                         {0.0f, height});
  ui.widgets.note("dialog/entry/" + entry.name);
  if (chosen && dialog.reveal) ImGui::SetScrollHereY(0.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width =
      ui.px(kThumbnailHeight) * static_cast<float>(kThumbnailSize.x) / static_cast<float>(kThumbnailSize.y);
  if (thumbnail) {
    list.AddImageRounded(thumbnail, {corner.x, corner.y + 1.0f}, {corner.x + width, corner.y + height - 1.0f},
                         {0.0f, 0.0f}, {1.0f, 1.0f}, 0xffffffffu, ui.px(3));
  } else {
    drawIcon(list, entry.folder ? Icon::kFolder : Icon::kFile, {corner.x + ui.px(3), corner.y + top}, ui.px(15),
             (entry.folder ? palette::kAccent : palette::kMuted).packed());
  }
  const float textLeft = tall ? width + ui.px(8) : ui.px(25);
  const bool cut =
      clippedText(list, {corner.x + textLeft, corner.y + top}, ImGui::GetContentRegionAvail().x - textLeft,
                  palette::kText.packed(), readableName(entry.name, entry.folder ? "folder" : "file", number));
  if (cut) tooltip(ui, entry.name);
  const auto column = [&] {
    ImGui::TableNextColumn();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + top);
  };
  column();
  if (!entry.folder) mutedText(sizeText(entry.bytes).c_str());
  column();
  mutedText(dateText(entry.when).c_str());
  if (!clicked) return;
  dialog.overwriteAsked = false;
  dialog.error.clear();
  dialog.appearing = true;
  if (entry.folder) {
    enterFolder(dialog, dialog.folder / entry.name);
    return;
  }
  const bool saves = dialog.kind == DialogKind::kSaveAs;  // Saves a rig beside its character, never over it.
  dialog.text = saves ? withRigEnding(entry.name).string() : entry.name;
  const bool opens =
      dialog.kind == DialogKind::kOpen || dialog.kind == DialogKind::kReference || dialog.kind == DialogKind::kSculpt;
  if (ImGui::IsMouseDoubleClicked(0) && opens) confirmPath(ui.state);
}

void drawEntries(PanelUi& ui, float height) {
  FileDialogState& dialog = ui.state.dialogs.file;
  refresh(dialog.listing, dialog.folder, listingOptions(ui.state));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kBackground);
  ImGui::BeginChild("entries", {0.0f, height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  const std::vector<FolderEntry> entries = dialog.listing.entries;  // Entering a folder reads another.
  if (ImGui::BeginTable("files", 3, ImGuiTableFlags_ScrollY)) {
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, ui.px(kSizeWidth));
    ImGui::TableSetupColumn("changed", ImGuiTableColumnFlags_WidthFixed, ui.px(kDateWidth));
    drawTitles(ui);
    int number = 0;
    for (const FolderEntry& entry : entries) {
      drawEntry(ui, entry, ++number);
      if (dialog.kind == DialogKind::kNone) break;
    }
    if (entries.empty()) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      if (dialog.kind == DialogKind::kSavePicture || dialog.kind == DialogKind::kReference ||
          dialog.kind == DialogKind::kPicturesPlace)
        mutedText("No pictures here.");
      else if (dialog.kind == DialogKind::kExportPlace) mutedText("No characters here.");
      else if (dialog.kind == DialogKind::kJobPlace) mutedText("No jobs here.");
      else if (dialog.kind == DialogKind::kSculpt) mutedText("No sculpts here.");
      else mutedText(dialog.filter == FileFilter::kRigs ? "No rigs here." : "No characters or rigs here.");
    }
    dialog.reveal = false;
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

}  // namespace

void drawFolderBrowser(PanelUi& ui, float height) {
  drawSteering(ui);
  drawNewFolder(ui);
  drawPlaces(ui, height);
  ImGui::SameLine(0.0f, ui.px(8));
  if (ui.state.dialogs.file.kind != DialogKind::kNone) drawEntries(ui, height);
}

}  // namespace sinew::app
