// app/panels/inspector_territory.cpp: the bones whose skin a muscle may move.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/outliner.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/bone_list.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"

namespace sinew::app {
namespace {

const Control kTerritorySection{"inspector/section/territory", "Section Territory", "bones skin"};
const Control kBones{"inspector/territory", "Bones", "of the territory skin region mask limit", nullptr,
                     kTerritorySection.id};
const Control kAddBone{"inspector/territory-add", "Add a bone to the territory", "skin region mask", nullptr,
                       kTerritorySection.id};

void reset(PanelUi& ui, const Subjects& subjects) {
  edit(ui.state, "Default territory of " + namedMuscles(*subjects.rig, subjects.indices),
       withDefaultTerritory(ui.state.document.rig(), subjects.indices));
}

/// "default" or "named", with the way back to the default.
void headRow(PanelUi& ui, const Subjects& subjects, std::size_t bones) {
  const bool differ = subjects.differ([](const Primitive& p) { return p.territory; });
  const bool named = subjects.shown().territory.has_value();
  beginRow(ui, kBones);
  ImGui::AlignTextToFramePadding();
  const std::string many = std::to_string(bones) + (bones == 1 ? " bone" : " bones");
  const std::string count = subjects.several() ? "" : ", " + many;
  const std::string kind = differ ? "mixed" : (named ? "named" : "default");
  const float buttons = (named || differ ? 2.0f : 1.0f) * (ImGui::GetFrameHeight() + ui.px(4));
  ImGui::TextUnformatted(fitted(kind + count, ImGui::GetContentRegionAvail().x - buttons).c_str());
  if (ImGui::IsItemClicked()) ui.state.view.inspector.territoryOpen = !ui.state.view.inspector.territoryOpen;
  ui.widgets.note(kBones.id);
  tooltip(ui, kind + count + "\nThe bones whose skin this muscle may move" +
                  (named ? ", as the rig names them."
                         : ": its own bone, its parent and its children. Click to list them."));
  const float button = ImGui::GetFrameHeight();
  const float right = ImGui::GetWindowContentRegionMax().x;
  if (named || differ) {
    ImGui::SameLine(right - 2.0f * button - ui.px(4));
    if (iconButton(ui, "inspector/territory-reset", Icon::kReset, false, button, "Back to the default")) {
      reset(ui, subjects);
    }
  }
  ImGui::SameLine(right - button);
  const Action& mode = action("tool/territory");
  if (iconButton(ui, "inspector/territory-edit", Icon::kTerritory, editsTerritory(ui.state), button,
                 tooltipOf(ui, mode))) {
    run(mode, ui.state);
  }
}

/// A bone of the territory with a cross that takes it out.
void boneRow(PanelUi& ui, const std::string& name, const std::string& shown, int bone) {
  const float indent = ui.px(6);
  const float size = ImGui::GetTextLineHeight() + ui.px(4);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x;
  const bool over = ImGui::IsMouseHoveringRect(at, {right, at.y + size}) && ImGui::IsWindowHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (over) list.AddRectFilled(at, {right, at.y + size}, palette::kRaised.packed(), ui.px(4));
  drawIcon(list, Icon::kBone, {at.x + indent, at.y + ui.px(3)}, ui.px(13),
           (bone >= 0 ? territoryTint() : palette::kWarning).packed());
  const std::string text = bone >= 0 ? shown : name + "  (not in this character)";
  const bool cut =
      clippedText(list, {at.x + indent + ui.px(20), at.y + ui.px(2)}, right - at.x - indent - ui.px(20) - size,
                  (bone >= 0 ? palette::kText : palette::kWarning).packed(), text);
  tooltipWhile(ui, (cut || text != name) && over && ImGui::GetMousePos().x < right - size, bone >= 0 ? name : text);
  if (bone < 0) {
    ImGui::Dummy({0.0f, size});
    return;
  }
  ImGui::SetCursorScreenPos({right - size, at.y});
  const std::string id = "inspector/territory-remove/" + name;
  const bool pressed = ImGui::InvisibleButton(id.c_str(), {size, size});
  ui.widgets.note(id);
  tooltip(ui, "Remove this bone from the territory");
  if (over) {
    drawIcon(list, Icon::kClose, {right - size + ui.px(2), at.y + ui.px(2)}, size - ui.px(4),
             (ImGui::IsItemHovered() ? palette::kText : palette::kMuted).packed());
  }
  if (pressed) toggleTerritoryBone(ui.state, bone);
}

void addRow(PanelUi& ui, const std::vector<int>& within) {
  ImGui::SetNextItemWidth(-1.0f);
  const bool open = ImGui::BeginCombo("##territory-add", "Add a bone...", ImGuiComboFlags_HeightLarge);
  ui.widgets.note(kAddBone.id);
  if (!open) return;
  const int near = within.empty() ? -1 : within.front();
  const int bone = boneList(ui, kAddBone.id, near, -1,
                            [&](int candidate) { return !std::ranges::binary_search(within, candidate); });
  if (bone >= 0) toggleTerritoryBone(ui.state, bone);
  ImGui::EndCombo();
}

}  // namespace

void drawTerritoryRows(PanelUi& ui, const Subjects& subjects) {
  if (!section(ui, kTerritorySection, "Territory")) return;
  const Skeleton& skeleton = ui.state.character().skeleton;
  const std::vector<int> within = subjects.bone < 0 ? std::vector<int>{}
                                                    : territoryBones(subjects.shown(), subjects.bone,
                                                                     lineOf(*subjects.rig, subjects.shown()), skeleton);
  headRow(ui, subjects, within.size());
  if (subjects.several() || subjects.bone < 0) return;
  const bool named = subjects.shown().territory.has_value();
  if (!named && !editsTerritory(ui.state) && !ui.state.view.inspector.territoryOpen) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(1)});
  const std::vector<std::string> names = shownFileNames(skeleton);
  for (const int bone : within) boneRow(ui, skeleton.fileName(bone), at(names, bone), bone);
  for (const std::string& name : subjects.shown().territory.value_or(std::vector<std::string>{})) {
    if (!skeleton.findBone(name)) boneRow(ui, name, name, -1);
  }
  ImGui::PopStyleVar();
  addRow(ui, within);
}

}  // namespace sinew::app
