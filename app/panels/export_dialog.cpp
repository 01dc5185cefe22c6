// app/panels/export_dialog.cpp: File > Export: the character for games, and as a farm job.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <imgui_stdlib.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/document/folder_listing.h"
#include "app/editor/export_commands.h"
#include "app/panels/dialogs.h"
#include "app/ui/number_field.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"
#include "core/geometry/index_table.h"

namespace sinew::app {

// Rows that other dialogs share.

bool countSlider(PanelUi& ui, const char* id, int& count, const char* format, int least, int most) {
  auto shown = static_cast<float>(count);
  ImGui::SetNextItemWidth(-1.0f);
  const NumberLook look{format, 0.0f, static_cast<float>(least), static_cast<float>(most), 1.0f, true};
  const bool changed = numberSlider(ui, (std::string("##") + id).c_str(), shown, look);
  if (changed) count = static_cast<int>(shown);
  ui.widgets.note(id);
  return changed;
}

bool enterConfirms() {
  const bool pressed = ImGui::IsKeyPressed(GLFW_KEY_ENTER, false) || ImGui::IsKeyPressed(GLFW_KEY_KP_ENTER, false);
  return pressed && !ImGui::IsAnyItemActive();
}

void dialogComplaint(const std::string& error, const std::string& question) {
  ImGui::PushStyleColor(ImGuiCol_Text, error.empty() ? palette::kWarning : palette::kError);
  ImGui::TextWrapped("%s", error.empty() ? question.c_str() : error.c_str());
  ImGui::PopStyleColor();
}

bool placeRow(PanelUi& ui, const char* id, const char* text, ExportPlace& place, PlaceChanges changes) {
  dialogLabel(ui, text, kExportLabels);
  const float button = ui.px(96);
  ImGui::SetNextItemWidth(-button - ui.px(8));
  ImGui::PushID(id);
  const bool entered = ImGui::InputTextWithHint(
      "##name", "Name", &place.name, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note(id);
  if (ImGui::IsItemEdited()) {
    changes.error.clear();
    changes.overwriteAsked = false;
  }
  ImGui::SameLine(0.0f, ui.px(8));
  changes.browse = textButton(ui, std::string(id) + "-browse", "Choose...", {button, 0.0f});
  ImGui::PopID();
  ImGui::SetCursorPosX(ui.px(kExportLabels));
  mutedLine(ui, "in " + place.folder.string());
  ImGui::Dummy({0.0f, ui.px(6)});
  return entered;
}

namespace {

using Field = bool ExportFields::*;

template <Field kField>
Possible kindHas(const EditorState& state) {
  return withExport(state).also(chosenKind(state.dialogs).fields.*kField,
                                "The chosen kind of export has no such setting");
}
template <Field kField>
Possible kindHasClips(const EditorState& state) {
  const Possible kind = kindHas<kField>(state);
  if (!kind) return kind;
  return {!exportableClips(chosenKind(state.dialogs), state.character()).empty(), "This character has no clips"};
}
Possible refined(const EditorState& state) {
  const bool original =
      chosenKind(state.dialogs).fields.mesh && state.dialogs.exporting.settings.mesh == ExportMesh::kOriginal;
  return kindHas<&ExportFields::depth>(state).also(!original, "Choose the refined mesh first");
}
/// The detail of this export: the rig's, unless the dialog has changed it.
SmoothingSettings detailNow(const EditorState& state) {
  SmoothingSettings now = state.document.rig().smoothing;
  state.dialogs.exporting.settings.detail.apply(now);
  return now;
}
Possible exportsAdaptive(const EditorState& state) {
  return refined(state).also(detailNow(state).detail == DetailKind::kAdaptive, "Choose adaptive detail first");
}
Possible exportsUniform(const EditorState& state) {
  return refined(state).also(detailNow(state).detail == DetailKind::kUniform, "Choose uniform detail first");
}
Possible hasAdvanced(const EditorState& state) {
  const ExportFields& fields = chosenKind(state.dialogs).fields;
  return withExport(state).also(fields.weights || fields.helpers, "The chosen kind of export has no such setting");
}

const Control kExportKindRow{"export/kind/muscle joints", "Export: kind of character",
                             "game engine skinned baked morph helper format"};
const Control kExportMesh{"export/mesh/refined", "Export: mesh", "refined original vertices",
                          kindHas<&ExportFields::mesh>};
const Control kExportDetail{"export/detail/adaptive", "Export: detail", "adaptive uniform subdivision", refined};
const Control kExportTolerance{"export/tolerance", "Export: tolerance", "adaptive error fine", exportsAdaptive};
const Control kExportDepth{"export/depth", "Export: depth", "subdivision level fine", exportsUniform};
const Control kExportClips{"export/clips/chosen", "Export: clips", "animations all chosen",
                           kindHasClips<&ExportFields::clips>};
const Control kExportOneClip{"export/one-clip", "Export: clip", "animation baked",
                             kindHasClips<&ExportFields::oneClip>};
const Control kExportFrames{"export/fps", "Export: frames a second", "fps rate speed",
                            kindHasClips<&ExportFields::oneClip>};
const Control kExportBound{"export/bound", "Export: distance", "error morph targets accuracy",
                           kindHas<&ExportFields::bound>};
const Control kExportSubsteps{"export/substeps", "Export: substeps", "samples frame", kindHas<&ExportFields::bound>};
const Control kExportJoints{"export/joints", "Export: joints", "helper bones number", kindHas<&ExportFields::helpers>};
const Control kExportAdvanced{"export/advanced", "Export: advanced settings", "more weights scale", hasAdvanced};
const Control kExportWeights{"export/weights/transferred", "Export: weights", "skin refitted transferred",
                             kindHas<&ExportFields::weights>, kExportAdvanced.id};
const Control kExportScale{"export/scale/full", "Export: joint scale", "uniform none uneven",
                           kindHas<&ExportFields::helpers>, kExportAdvanced.id};

constexpr std::size_t kClipRows = 6;  // More of them scroll.

void label(PanelUi& ui, const char* text) { dialogLabel(ui, text, kExportLabels); }
void explain(PanelUi& ui, const std::string& text) { dialogExplain(ui, text.c_str(), kExportLabels); }

void kindRow(PanelUi& ui) {
  label(ui, "Kind");
  std::vector<const char*> titles;
  for (const ExportKind& kind : exportKinds()) titles.push_back(kind.title);
  Dialogs& dialogs = ui.state.dialogs;
  if (titles.size() == 1) {  // Nothing to choose.
    ImGui::TextUnformatted(titles.front());
    ui.widgets.note("export/kind");
  } else {
    const int clicked = segmented(ui, "export/kind", titles.data(), static_cast<int>(titles.size()),
                                  static_cast<int>(dialogs.exporting.kind), ImGui::GetContentRegionAvail().x);
    if (clicked >= 0) chooseKind(dialogs, static_cast<std::size_t>(clicked));
  }
  explain(ui, chosenKind(dialogs).purpose);
}

void meshRow(PanelUi& ui) {
  ExportSettings& settings = ui.state.dialogs.exporting.settings;
  label(ui, "Mesh");
  const int clicked = chooseWord(ui, "export/mesh", {"Refined", "Original"}, static_cast<int>(settings.mesh));
  if (clicked >= 0) settings.mesh = static_cast<ExportMesh>(clicked);
  explain(ui, settings.mesh == ExportMesh::kRefined
                  ? "As smooth as in the picture: every triangle of the file is divided."
                  : "The file's own vertices in their own order, moved to where the muscles take them. Morph targets "
                    "stay.");
}

/// The detail of the exported mesh: the rig's, or another one for this export.
void detailRows(PanelUi& ui) {
  ExportSettings& settings = ui.state.dialogs.exporting.settings;
  const SmoothingSettings& ofRig = ui.state.document.rig().smoothing;
  SmoothingSettings now = detailNow(ui.state);
  label(ui, "Detail");
  const bool wasAdaptive = now.detail == DetailKind::kAdaptive;
  const int clicked = chooseWord(ui, "export/detail", {"Adaptive", "Uniform"}, wasAdaptive ? 0 : 1);
  if (clicked >= 0) now.detail = clicked == 0 ? DetailKind::kAdaptive : DetailKind::kUniform;
  const bool adaptive = now.detail == DetailKind::kAdaptive;
  label(ui, adaptive ? "Tolerance" : "Depth");
  ImGui::SetNextItemWidth(-1.0f);
  if (adaptive) {
    float percent = 100.0f * now.tolerance;
    if (numberSlider(ui, "##tolerance", percent,
                     {"%.2f %%", 0.0f, 100.0f * kLeastTolerance, 100.0f * kMostTolerance, 0.01f, false, true})) {
      now.tolerance = percent / 100.0f;
    }
  } else {
    countSlider(ui, kExportDepth.id, now.depth, "%.0f", 1, kMaxDepth);
  }
  if (adaptive) ui.widgets.note(kExportTolerance.id);
  settings.detail = {};
  if (now.detail != ofRig.detail) settings.detail.kind = now.detail;
  if (adaptive && now.tolerance != ofRig.tolerance) settings.detail.tolerance = now.tolerance;
  if (!adaptive && now.depth != ofRig.depth) settings.detail.depth = now.depth;
  const std::string asInRig = settings.detail == DetailOverride{} ? ", as in the rig." : ".";
  if (adaptive) {
    return explain(ui, "Fine where muscles shape the skin: triangles lie within " +
                           numberText("%.2g %%", 100.0f * now.tolerance) + " of the height" + asInRig);
  }
  const long long n = now.depth;
  const auto triangles = static_cast<long long>(ui.state.character().mesh.triangles.size()) * n * n;
  explain(ui, "Every triangle becomes " + std::to_string(n) + " x " + std::to_string(n) + ": " + grouped(triangles) +
                  " triangles" + asInRig);
}

void drawClip(PanelUi& ui, const std::string& name, std::size_t index) {
  std::vector<std::string>& chosen = ui.state.dialogs.exporting.settings.clips;
  const auto found = std::ranges::find(chosen, name);
  bool kept = found != chosen.end();
  ImGui::PushID(static_cast<int>(index));
  const bool changed = ImGui::Checkbox("##kept", &kept);
  ImGui::PopID();
  ui.widgets.note("export/clip/" + std::to_string(index));
  ImGui::SameLine();
  ImGui::TextUnformatted(fitted(name, ImGui::GetContentRegionAvail().x).c_str());
  if (!changed) return;
  ui.state.dialogs.exporting.error.clear();
  if (kept) chosen.push_back(name);
  else chosen.erase(found);
}

void keepClipThatPlays(EditorState& state) {
  const int clip = state.open.transport.clip;
  if (clip < 0 || at(state.character().clips, clip).turnsBindPose) return;
  state.dialogs.exporting.settings.clips.push_back(at(state.character().clips, clip).name);
}

void oneClipRows(PanelUi& ui) {
  ExportDialogState& dialog = ui.state.dialogs.exporting;
  const std::vector<std::string> names = exportableClips(chosenKind(ui.state.dialogs), ui.state.character());
  if (names.empty()) return;
  const std::string chosen = chosenOneClip(ui.state);
  label(ui, "Clip");
  ImGui::SetNextItemWidth(-1.0f);
  const bool open = ImGui::BeginCombo("##one-clip", inReadingOrder(chosen).c_str(), ImGuiComboFlags_HeightLarge);
  ui.widgets.note(kExportOneClip.id);
  if (open) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      const std::string shown = fitted(names[i], ImGui::GetContentRegionAvail().x);
      if (ImGui::Selectable(shown.c_str(), names[i] == chosen)) dialog.oneClip = names[i];
      ImGui::PopID();
      ui.widgets.note("export/one-clip/" + std::to_string(i));
    }
    ImGui::EndCombo();
  }
  ImGui::Dummy({0.0f, ui.px(6)});
  label(ui, "Frames");
  auto rate = static_cast<float>(dialog.settings.framesPerSecond);
  ImGui::SetNextItemWidth(-1.0f);
  if (numberSlider(ui, "##fps", rate, {"%.0f a second", 0.0f, 1.0f, 120.0f, 1.0f, true})) {
    dialog.settings.framesPerSecond = static_cast<double>(rate);
  }
  ui.widgets.note(kExportFrames.id);
  ImGui::Dummy({0.0f, ui.px(6)});
}

void boundRow(PanelUi& ui) {
  ExportSettings& settings = ui.state.dialogs.exporting.settings;
  label(ui, "Distance");
  auto bound = static_cast<float>(settings.bound);
  ImGui::SetNextItemWidth(-1.0f);
  NumberLook look{"%.2f %%", 0.0f, 0.01f, 5.0f, 0.01f};
  look.logarithmic = true;
  if (numberSlider(ui, "##bound", bound, look)) {
    settings.bound = std::round(1000.0 * static_cast<double>(bound)) / 1000.0;
  }
  ui.widgets.note(kExportBound.id);
  explain(ui, "Largest error of a vertex in any frame, percent of the height. A smaller one needs more morph targets.");
  label(ui, "Substeps");
  countSlider(ui, kExportSubsteps.id, settings.substeps, "%.0f a frame", 1, kMostSubsteps);
  explain(ui, "Samples baked in each frame. Several also limit the error between frames.");
}

void clipRows(PanelUi& ui) {
  ExportDialogState& dialog = ui.state.dialogs.exporting;
  const std::vector<std::string> names = exportableClips(chosenKind(ui.state.dialogs), ui.state.character());
  if (names.empty()) return;
  label(ui, "Clips");
  const std::string all = "All (" + std::to_string(names.size()) + ")";
  const int clicked = chooseWord(ui, "export/clips", {all.c_str(), "Chosen"}, dialog.chosenClips ? 1 : 0);
  if (clicked >= 0) {
    dialog.chosenClips = clicked == 1;
    dialog.error.clear();
    if (dialog.chosenClips && dialog.settings.clips.empty()) keepClipThatPlays(ui.state);
  }
  if (dialog.chosenClips) {
    ImGui::SetCursorPosX(ui.px(kExportLabels));
    const auto rows = static_cast<float>(std::min(names.size(), kClipRows));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kRaised.faded(0.6f));
    ImGui::BeginChild("clips", {0.0f, rows * ImGui::GetFrameHeightWithSpacing() + ui.px(8)}, true);
    for (std::size_t i = 0; i < names.size(); ++i) drawClip(ui, names[i], i);
    ImGui::EndChild();
    ImGui::PopStyleColor();
  }
  ImGui::Dummy({0.0f, ui.px(6)});
}

void weightsRow(PanelUi& ui) {
  ExportSettings& settings = ui.state.dialogs.exporting.settings;
  label(ui, "Weights");
  const int clicked = chooseWord(ui, "export/weights", {"Transferred", "Refitted"}, static_cast<int>(settings.weights));
  if (clicked >= 0) settings.weights = static_cast<ExportWeights>(clicked);
  explain(ui, settings.weights == ExportWeights::kRefitted
                  ? "Fitted to the muscles' surface over the clips and the range of motion: closest to the picture."
                  : "The weights of the file, as they are painted there.");
}

/// The scaling that the engine supports.
void jointScaleRow(PanelUi& ui) {
  ExportSettings& settings = ui.state.dialogs.exporting.settings;
  label(ui, "Joint scale");
  const int clicked =
      chooseWord(ui, "export/scale", {"Full", "Uniform", "None"}, static_cast<int>(settings.jointScale));
  if (clicked >= 0) settings.jointScale = static_cast<JointScale>(clicked);
  switch (settings.jointScale) {
    case JointScale::kFull:
      return explain(ui, "Along each axis, as three.js, Godot, Unity, Unreal and Blender can.");
    case JointScale::kUniform:
      return explain(ui, "Alike along all axes, for engines that cannot scale unevenly.");
    case JointScale::kNone:
      return explain(ui, "For engines that cannot scale joints: two for each muscle line.");
  }
}

void helperRow(PanelUi& ui) {
  ExportSettings& settings = ui.state.dialogs.exporting.settings;
  label(ui, "Joints");
  countSlider(ui, kExportJoints.id, settings.helpers, "%.0f", 0, kMostHelpers);
  explain(ui, "The most joints to add, where they bring the mesh closest to the picture.");
}

/// @param clips  false: no row for the clips
void drawExportSettings(PanelUi& ui, bool clips) {
  ExportDialogState& dialog = ui.state.dialogs.exporting;
  kindRow(ui);
  const ExportFields& fields = chosenKind(ui.state.dialogs).fields;
  if (fields.mesh) meshRow(ui);
  if (fields.depth && (!fields.mesh || dialog.settings.mesh == ExportMesh::kRefined)) detailRows(ui);
  if (fields.clips && clips) clipRows(ui);
  if (fields.oneClip && clips) oneClipRows(ui);
  if (fields.bound) boundRow(ui);
  if (fields.helpers) helperRow(ui);
  if (!fields.weights && !fields.helpers) return;
  ImGui::SetNextItemOpen(dialog.advanced);
  dialog.advanced = ImGui::TreeNodeEx("Advanced", ImGuiTreeNodeFlags_NoTreePushOnOpen);
  ui.widgets.note(kExportAdvanced.id);
  ImGui::Dummy({0.0f, ui.px(2)});
  if (dialog.advanced && fields.weights) weightsRow(ui);
  if (dialog.advanced && fields.helpers) jointScaleRow(ui);
}

bool drawPlace(PanelUi& ui, const char* id, const char* text, DialogKind kind) {
  ExportDialogState& dialog = ui.state.dialogs.exporting;
  bool browse = false;
  const bool entered =
      placeRow(ui, id, text, placeOf(ui.state.dialogs, kind), {dialog.error, dialog.overwriteAsked, browse});
  if (browse) browseForPlace(ui.state, kind);
  return entered;
}

Possible withOtherRigs(const EditorState& state) {
  const Possible farm = withFarmJob(state);
  if (!farm) return farm;
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::absolute(state.document.rigFile, ignored).parent_path();
  return {rigsIn(folder).size() > 1, "The folder has no other rig"};
}
Possible withAllRigs(const EditorState& state) {
  return withOtherRigs(state).also(state.dialogs.exporting.wholeFolder, "Choose all rigs of the folder first");
}

const Control kExportFile{"export/place", "Export: file", "path folder name"};
const Control kExportWrite{"export/ok", "Export: write the file", "start run"};
const Control kFarmJob{"farm/job", "Farm job: folder", "path place"};
const Control kFarmRigs{"farm/rigs/this one", "Farm job: rigs", "folder all open one", withOtherRigs};
const Control kFarmTarget{"farm/target/slurm", "Farm job: farm", "slurm make deadline shell target"};
const Control kFarmTasks{"farm/tasks", "Farm job: tasks", "machines array number", withAllRigs};

constexpr float kExportDialogWidth = 560.0f;  // Design pixels.

/// Drawn only if the folder has other rigs.
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

/// Drawn only for several rigs: one rig is one task.
void tasksRow(PanelUi& ui) {
  const std::size_t rigs = farmRigs(ui.state).size();
  if (rigs < 2) return;
  dialogLabel(ui, "Tasks", kExportLabels);
  int tasks = farmTasks(ui.state);
  const int most = static_cast<int>(std::min<std::size_t>(rigs, kMostTasks));
  if (countSlider(ui, kFarmTasks.id, tasks, "%.0f", 1, most)) ui.state.dialogs.exporting.tasks = tasks;
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
  dialogComplaint(dialog.error, asked);
  ui.widgets.note("export/complaint");
}

/// @return whether to close the dialog
bool drawEnd(PanelUi& ui, const char* verb, bool entered) {
  ExportDialogState& dialog = ui.state.dialogs.exporting;
  drawExportDialogComplaint(ui);
  const float width = ui.px(104);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2.0f * width - ui.px(8));
  const bool canceled = textButton(ui, "export/cancel", dialog.overwriteAsked ? "Keep" : "Cancel", {width, 0.0f});
  ImGui::SameLine(0.0f, ui.px(8));
  const bool confirmed = accentButton(ui, kExportWrite.id, dialog.overwriteAsked ? "Replace" : verb, {width, 0.0f});
  if (confirmed || entered) return confirmExport(ui.state);
  if (!canceled && !escapePressed(ui)) return false;
  if (dialog.overwriteAsked) {
    dialog.overwriteAsked = false;
    return false;
  }
  closeExportDialog(ui.state.dialogs);
  return true;
}

/// @param rows  the content; returns whether Enter was pressed in a name
void drawDialog(PanelUi& ui, ExportDialog which, const char* title, const char* verb, bool (*rows)(PanelUi&)) {
  // The path dialog replaces it while it is open.
  if (ui.state.dialogs.exporting.shown != which || ui.state.dialogs.file.kind != DialogKind::kNone) return;
  placeDialog(ui, kExportDialogWidth);
  drawModal(ui, title, [&] {
    const bool confirmed = enterConfirms();
    const bool entered = rows(ui) || confirmed;
    const bool browsing = ui.state.dialogs.file.kind != DialogKind::kNone;
    return browsing || drawEnd(ui, verb, entered);
  });
}

}  // namespace

void drawExportDialog(PanelUi& ui) {
  drawDialog(ui, ExportDialog::kCharacter, "Export the character", "Export", drawCharacter);
}

void drawFarmDialog(PanelUi& ui) {
  drawDialog(ui, ExportDialog::kFarmJob, "Export as a farm job", "Write job", drawFarm);
}

}  // namespace sinew::app
