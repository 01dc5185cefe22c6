// app/panels/export_dialog.cpp: File > Export: a character for games, and as a farm job.
#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/document/folder_listing.h"
#include "app/editor/export_commands.h"
#include "app/panels/dialog_parts.h"
#include "app/panels/dialogs.h"
#include "app/panels/export_rows.h"
#include "app/ui/number_field.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

const Control kExportFile{"export/place", "Export: file", "path folder name"};
const Control kExportWrite{"export/ok", "Export: write the file", "start run"};
const Control kFarmJob{"farm/job", "Farm job: folder", "path place"};

constexpr float kExportDialogWidth = 560.0f;  // Design pixels.

/// Only where there are others.
void rigsRow(PanelUi& ui) {
  ExportDialogState& dialog = ui.state.dialogs.exporting;
  if (dialog.rigs.size() < 2) return;
  dialogLabel(ui, "Rigs", kExportLabels);
  const std::string all = "All " + std::to_string(dialog.rigs.size()) + " in its folder";
  const int clicked = chooseWord(ui, "farm/rigs", {"This one", all.c_str()}, dialog.wholeFolder ? 1 : 0);
  if (clicked >= 0) {
    dialog.wholeFolder = clicked == 1;
    dialog.error.clear();
    dialog.overwriteAsked = false;
  }
  std::string names;
  for (const std::filesystem::path& rig : farmRigs(ui.state)) {
    names += (names.empty() ? "" : ", ") + nameWithoutEnding(rig);
  }
  ImGui::SetCursorPosX(ui.px(kExportLabels));
  mutedLine(ui, names);
  ImGui::Dummy({0.0f, ui.px(6)});
}

void targetRow(PanelUi& ui) {
  Dialogs& dialogs = ui.state.dialogs;
  dialogLabel(ui, "Farm", kExportLabels);
  std::vector<const char*> titles;
  for (const FarmTarget& target : farmTargets()) titles.push_back(target.title);
  const FarmTarget* const chosen = findFarmTarget(dialogs.exporting.target);
  const int clicked = segmented(ui, "farm/target", titles.data(), static_cast<int>(titles.size()),
                                static_cast<int>(chosen - farmTargets().data()), ImGui::GetContentRegionAvail().x);
  if (clicked >= 0) chooseTarget(dialogs, at(farmTargets(), clicked));
  const std::string hint = std::string("Run it with ") + findFarmTarget(dialogs.exporting.target)->runWith +
                           ". Rigs are read when it runs; files that exist by then are kept.";
  dialogExplain(ui, hint.c_str(), kExportLabels);
}

/// One rig is one task.
void tasksRow(PanelUi& ui) {
  const std::size_t rigs = farmRigs(ui.state).size();
  if (rigs < 2) return;
  dialogLabel(ui, "Tasks", kExportLabels);
  auto tasks = static_cast<float>(farmTasks(ui.state));
  ImGui::SetNextItemWidth(-1.0f);
  const auto most = static_cast<float>(std::min<std::size_t>(rigs, kMostTasks));
  if (numberSlider(ui, "##tasks", tasks, {"%.0f", 0.0f, 1.0f, most, 1.0f, true})) {
    ui.state.dialogs.exporting.tasks = static_cast<int>(tasks);
  }
  ui.widgets.note("farm/tasks");
  dialogExplain(ui, "Each makes its share of the rigs, on its own machine.", kExportLabels);
}

bool drawCharacter(PanelUi& ui) {
  drawExportSettings(ui, true);
  ImGui::Separator();
  ImGui::Dummy({0.0f, ui.px(4)});
  return drawPlace(ui, kExportFile.id, "File", DialogKind::kExportPlace);
}

bool drawFarm(PanelUi& ui) {
  const ExportDialogState& dialog = ui.state.dialogs.exporting;
  rigsRow(ui);
  drawExportSettings(ui, !dialog.wholeFolder);
  ImGui::Separator();
  ImGui::Dummy({0.0f, ui.px(4)});
  const bool entered = drawPlace(ui, kExportFile.id, dialog.wholeFolder ? "Files" : "File", DialogKind::kExportPlace);
  targetRow(ui);
  tasksRow(ui);
  return drawPlace(ui, kFarmJob.id, "Job", DialogKind::kJobPlace) || entered;
}

void drawExportDialogComplaint(PanelUi& ui) {
  const ExportDialogState& dialog = ui.state.dialogs.exporting;
  if (dialog.error.empty() && !dialog.overwriteAsked) return;
  std::string asked;
  if (dialog.overwriteAsked) {
    const std::vector<std::filesystem::path> files = replacedFiles(ui.state);
    for (const std::filesystem::path& file : files) {
      asked += (asked.empty() ? "" : " and ") + file.filename().string();
    }
    asked += files.size() == 1 ? " already exists. Replace it?" : " already exist. Replace them?";
  }
  ImGui::PushStyleColor(ImGuiCol_Text, dialog.error.empty() ? palette::kWarning : palette::kError);
  ImGui::TextWrapped("%s", dialog.error.empty() ? asked.c_str() : dialog.error.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note("export/complaint");
}

/// @return whether the dialog is over.
bool drawEnd(PanelUi& ui, const char* verb, bool entered) {
  ExportDialogState& dialog = ui.state.dialogs.exporting;
  drawExportDialogComplaint(ui);
  const float width = ui.px(104);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * width - ui.px(8));
  const bool canceled = ImGui::Button(dialog.overwriteAsked ? "Keep" : "Cancel", {width, 0.0f});
  ui.widgets.note("export/cancel");
  ImGui::SameLine(0.0f, ui.px(8));
  const bool confirmed = accentButton(dialog.overwriteAsked ? "Replace" : verb, {width, 0.0f});
  ui.widgets.note(kExportWrite.id);
  if (confirmed || entered) return confirmExport(ui.state);
  if (!canceled && !escapePressed(ui)) return false;
  if (dialog.overwriteAsked) {
    dialog.overwriteAsked = false;
    return false;
  }
  closeExportDialog(ui.state.dialogs);
  return true;
}

/// @param rows  draws them; returns whether Enter was pressed in a name
void drawDialog(PanelUi& ui, ExportDialog which, const char* title, const char* verb, bool (*rows)(PanelUi&)) {
  // The path dialog takes its place while it is open.
  if (ui.state.dialogs.exporting.shown != which || ui.state.dialogs.file.kind != DialogKind::kNone) return;
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  placeDialog(ui, kExportDialogWidth);
  pushDialogStyle(ui);
  if (ImGui::BeginPopupModal(title, nullptr, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    // Enter is the button, unless it ends the typing of a number.
    const bool free = !ImGui::IsAnyItemActive();
    const bool pressed = ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) || ImGui::IsKeyPressed(GLFW_KEY_KP_ENTER, false);
    const bool entered = rows(ui) || (free && pressed);
    const bool browsing = ui.state.dialogs.file.kind != DialogKind::kNone;
    if (browsing || drawEnd(ui, verb, entered)) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  popDialogStyle();
}

}  // namespace

void drawExportDialog(PanelUi& ui) {
  drawDialog(ui, ExportDialog::kCharacter, "Export the character", "Export", drawCharacter);
}

void drawFarmDialog(PanelUi& ui) {
  drawDialog(ui, ExportDialog::kFarmJob, "Export as a farm job", "Write job", drawFarm);
}

}  // namespace sinew::app
