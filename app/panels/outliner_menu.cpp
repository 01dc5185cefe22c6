// app/panels/outliner_menu.cpp: the context menus of muscles and bones.

#include <imgui.h>

#include <string>

#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/outliner.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/outliner_row.h"
#include "app/ui/code_points.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

/// With the menu bar's spacing: rows of the outliner stand closer together. True: endContextMenu() has to follow.
bool beginContextMenu(PanelUi& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(6)});
  const bool open = ImGui::BeginPopupContextItem();
  if (!open) ImGui::PopStyleVar();
  return open;
}

void endContextMenu() {
  ImGui::EndPopup();
  ImGui::PopStyleVar();
}

void actionItem(PanelUi& ui, const char* id) {
  const Action& item = action(id);
  const std::string keys = "   " + keyText(item, ui.state);
  const bool chosen = ImGui::MenuItem(item.label, keys.c_str(), false, item.enabled(ui.state));
  ui.widgets.note(std::string("context/") + id);
  tooltip(ui, hintOf(ui, item));
  if (chosen) run(item, ui.state);
}

bool item(PanelUi& ui, const char* label, const char* id, bool enabled = true) {
  const bool chosen = ImGui::MenuItem(label, nullptr, false, enabled);
  ui.widgets.note(std::string("context/") + id);
  return chosen;
}

/// A menu entry with the group's color before its name.
bool groupItem(PanelUi& ui, const Rig& rig, int group, bool chosen) {
  const std::string& name = at(rig.groups, group).name;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::MenuItem(("     " + inReadingOrder(shownGroupName(rig, group))).c_str(), nullptr, chosen);
  ui.widgets.note("context/group/" + name);
  ImGui::GetWindowDrawList()->AddCircleFilled({corner.x + ui.px(7), corner.y + 0.5f * ImGui::GetTextLineHeight()},
                                              ui.px(4), groupTint(rig, group).packed(), 16);
  return clicked;
}

void groupSubmenu(PanelUi& ui, const OutlinerContent& frame, int index) {
  const bool open = ImGui::BeginMenu("Move to group");
  ui.widgets.note("context/group");
  if (!open) return;
  const std::string& own = at(frame.rig->primitives, index).group;
  for (int group = 0; group < static_cast<int>(frame.rig->groups.size()); ++group) {
    const std::string& name = at(frame.rig->groups, group).name;
    if (groupItem(ui, *frame.rig, group, name == own)) moveToGroup(ui.state, selectedIndices(ui.state.document), name);
  }
  ImGui::Separator();
  if (item(ui, "     New group", "group-new")) groupSelection(ui.state);
  ImGui::EndMenu();
}

void boneSubmenu(PanelUi& ui, const OutlinerContent& frame) {
  const bool open = ImGui::BeginMenu("Move to bone");
  ui.widgets.note("context/bone");
  if (!open) return;
  for (int bone = 0; bone < static_cast<int>(frame.skeleton.bones.size()); ++bone) {
    if (isHidden(frame.hiddenBones, bone)) continue;
    ImGui::PushID(bone);
    const bool chosen = ImGui::MenuItem(inReadingOrder(at(frame.boneNames, bone)).c_str());
    ImGui::PopID();
    ui.widgets.note("context/bone/" + std::to_string(bone));
    if (chosen) reparentMuscles(ui.state, selectedIndices(ui.state.document), bone);
  }
  ImGui::EndMenu();
}

}  // namespace

void muscleMenu(PanelUi& ui, const OutlinerContent& frame, int index) {
  if (!beginContextMenu(ui)) return;
  const PrimitiveId muscle = at(frame.rig->primitives, index).id();
  if (!ui.state.document.selection.contains(muscle)) ui.state.document.selection.set(muscle);
  actionItem(ui, "view/frame");
  actionItem(ui, "edit/rename");
  actionItem(ui, "edit/duplicate");
  actionItem(ui, "edit/delete");
  ImGui::Separator();
  groupSubmenu(ui, frame, index);
  boneSubmenu(ui, frame);
  actionItem(ui, "tool/territory");
  ImGui::Separator();
  actionItem(ui, "view/hide");
  actionItem(ui, "view/lock");
  actionItem(ui, "view/isolate");
  actionItem(ui, "view/show-all");
  endContextMenu();
}

void boneMenu(PanelUi& ui, const OutlinerContent& frame, int bone) {
  if (!beginContextMenu(ui)) return;
  ui.state.document.selection.bone = bone;
  if (item(ui, "Add muscle on this bone", "add-muscle")) addMuscle(ui.state, bone);
  const std::vector<int> below = musclesUnder(bone, frame.skeleton, frame.boneOf);
  if (item(ui, "Select its muscles", "select-muscles", !below.empty())) selectMuscles(ui.state.document, below);
  const std::vector<int> selected = selectedIndices(ui.state.document);
  if (item(ui, "Move selected muscles here", "move-here", !selected.empty())) {
    reparentMuscles(ui.state, selected, bone);
  }
  ImGui::Separator();
  const std::string& path = at(frame.skeleton.bones, bone).path;
  Visibility& visibility = ui.state.document.visibility;
  const bool hidden = visibility.hidden.bones.contains(path);
  if (item(ui, hidden ? "Show its muscles" : "Hide its muscles", "hide-bone")) {
    visibility.setBone(Mark::kHidden, path, !hidden);
  }
  const bool locked = visibility.locked.bones.contains(path);
  if (item(ui, locked ? "Unlock its muscles" : "Lock its muscles", "lock-bone")) {
    visibility.setBone(Mark::kLocked, path, !locked);
  }
  actionItem(ui, "view/show-all");
  ImGui::Separator();
  if (item(ui, "Open all below", "unfold")) setFolded(ui.state, bone, false, true);
  if (item(ui, "Close all below", "fold")) setFolded(ui.state, bone, true, true);
  endContextMenu();
}

}  // namespace sinew::app
