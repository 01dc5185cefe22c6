// app/panels/outliner.cpp: the tab Muscles: bones as a tree with their muscles, and the context menus of both.

#include <imgui_stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <string>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/outliner.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/outliner_row.h"
#include "app/panels/panels.h"
#include "app/ui/code_points.h"
#include "app/ui/keyboard_focus.h"
#include "app/ui/reading_order.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

Possible withHelpers(const EditorState& state) {
  const bool any = std::ranges::find(state.open.helperBones, true) != state.open.helperBones.end();
  return withCharacter(state).also(any, "This character has no helper bones");
}

const Control kFindMuscles{"outliner/search", "Search muscles and bones", "filter find list tree"};
const Control kOnlyWithMuscles{"outliner/only-with-muscles", "Only bones with muscles", "filter hide empty"};
const Control kHelperBones{"outliner/helper-bones", "Show helper bones", "ik targets sockets hidden", withHelpers};
const Control kOutlinerOrder{"outliner/order/bones", "Order of the muscles", "bones regions groups list tree sort"};

SharedEnds endsOfBones(const std::vector<std::string>& names) {
  return sharedEnds(std::vector<std::string_view>(names.begin(), names.end()));
}

SharedEnds endsOfMuscles(const Rig& rig) {
  std::vector<std::string_view> names;
  for (const int lead : allLeads(rig)) names.emplace_back(muscleName(rig, lead));
  return sharedEnds(names);
}

OutlinerContent gather(const EditorState& state) {
  const Skeleton& skeleton = state.character().skeleton;
  OutlinerContent frame{state.document.commands.sharedRig(), skeleton, {}, {}, {}, {}, 0.0f, {}, {}, {}, {}};
  frame.boneOf = boneOfEach(*frame.rig, skeleton);
  frame.effective = effectiveVisibility(state.document.visibility, *frame.rig, skeleton, frame.boneOf);
  frame.boneOf = listedBones(*frame.rig, skeleton, std::move(frame.boneOf));
  if (editsTerritory(state)) {
    frame.territory.assign(skeleton.bones.size(), false);
    for (const int bone : shownTerritory(state)) at(frame.territory, bone) = true;
  }
  frame.boneNames = shownBoneNames(skeleton);
  frame.boneEnds = endsOfBones(frame.boneNames);
  frame.muscleEnds = endsOfMuscles(*frame.rig);
  const OutlinerState& outliner = state.view.outliner;
  frame.hiddenBones = hiddenBones(state);
  frame.rows = outlinerRows(*frame.rig, skeleton, frame.boneOf,
                            {state.view.outlinerFilter, outliner.onlyWithMuscles, &outliner.folded,
                             outliner.unattachedFolded, outliner.order, frame.hiddenBones});
  return frame;
}

std::string helperHint(std::ptrdiff_t count) {
  if (count == 0) return "Skin follows every bone: there are no helper bones";
  return (count == 1 ? std::string("1 helper bone") : std::to_string(count) + " helper bones") +
         ": show bones that no skin follows, such as targets, poles and ends";
}

void drawSearch(PanelUi& ui) {
  const float button = ImGui::GetFrameHeight();
  const float width = ImGui::GetContentRegionAvail().x - 2.0f * (button + ui.px(4));
  const std::string hint = fitted(kFindMuscles.label, width - 2.0f * ImGui::GetStyle().FramePadding.x);
  ImGui::SetNextItemWidth(width);
  ImGui::InputTextWithHint("##search", hint.c_str(), &ui.state.view.outlinerFilter);
  ui.widgets.note(kFindMuscles.id);
  ImGui::SameLine(0.0f, ui.px(4));
  bool& only = ui.state.view.outliner.onlyWithMuscles;
  if (iconButton(ui, kOnlyWithMuscles.id, Icon::kFilter, only, button, "Only bones with muscles on them or below")) {
    only = !only;
  }
  ImGui::SameLine(0.0f, ui.px(4));
  bool& helpers = ui.state.view.outliner.helperBones;
  const std::ptrdiff_t count = std::ranges::count(ui.state.open.helperBones, true);
  ImGui::BeginDisabled(count == 0);
  if (iconButton(ui, kHelperBones.id, Icon::kBone, helpers && count > 0, button, helperHint(count))) {
    helpers = !helpers;
  }
  ImGui::EndDisabled();
}

void drawOrder(PanelUi& ui) {
  OutlinerOrder& order = ui.state.view.outliner.order;
  const int chosen = chooseWord(ui, "outliner/order", {"Bones", "Regions", "Groups"}, static_cast<int>(order));
  if (chosen >= 0) order = static_cast<OutlinerOrder>(chosen);
}

/// Scrolls once to a muscle that has just become the active one.
void reveal(PanelUi& ui, const OutlinerContent& frame) {
  EditorState& state = ui.state;
  const int index = state.document.activePrimitive();
  if (index < 0 || static_cast<std::size_t>(index) >= frame.rig->primitives.size()) return;
  const PrimitiveId active = at(frame.rig->primitives, index).id();
  if (active == state.open.revealed) return;
  const auto found = std::ranges::find_if(
      frame.rows, [&](const OutlinerRow& row) { return row.kind == RowKind::kMuscle && row.index == index; });
  if (found == frame.rows.end()) {
    const int bone = at(frame.boneOf, index);
    if (bone < 0) state.view.outliner.unattachedFolded = false;
    unfoldTo(state, bone);
    unfoldParts(state, index);
    // The next frame finds it, unless the search hides it.
    if (!state.view.outlinerFilter.empty()) state.open.revealed = active;
    return;
  }
  state.open.revealed = active;
  const float top = static_cast<float>(found - frame.rows.begin()) * frame.rowHeight;
  const float height = ImGui::GetWindowHeight();
  if (top < ImGui::GetScrollY() || top + frame.rowHeight > ImGui::GetScrollY() + height) {
    ImGui::SetScrollY(std::max(0.0f, top - 0.4f * height));
  }
}

void keyboard(PanelUi& ui, const OutlinerContent& frame) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsWindowFocused() || io.WantTextInput || io.KeyCtrl || io.KeyAlt || frame.rows.empty()) return;
  if (focusShown()) return;  // The arrows move the ring.
  ui.state.frame.arrowsTaken = true;
  if (ImGui::IsKeyPressed(GLFW_KEY_DOWN)) moveCursor(ui.state, frame.rows, 1, io.KeyShift);
  if (ImGui::IsKeyPressed(GLFW_KEY_UP)) moveCursor(ui.state, frame.rows, -1, io.KeyShift);
}

void drawRows(PanelUi& ui) {
  OutlinerContent frame = gather(ui.state);
  frame.rowHeight = ImGui::GetTextLineHeight() + ui.px(6);
  reveal(ui, frame);
  keyboard(ui, frame);
  if (frame.rows.empty()) {
    ImGui::Dummy({0.0f, ui.px(6)});
    const std::string start = howToStart(ui, action("tool/add-muscle"));
    mutedParagraph(ui.state.view.outlinerFilter.empty() ? "No muscles yet: " + start + " and drag on the skin."
                   : frame.hiddenBones.empty()          ? "Nothing found."
                                                        : "Nothing found. Helper bones are hidden.");
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(frame.rows.size()), frame.rowHeight);
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) drawOutlinerRow(ui, frame, row);
  }
}

/// Names what is hidden, with a button that shows it.
void drawFooter(PanelUi& ui, const std::string& text) {
  ImGui::Separator();
  ImGui::AlignTextToFramePadding();
  const float button = buttonWidth("Show all");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x - button - ui.px(6);
  const bool cut = clippedText(*ImGui::GetWindowDrawList(), {at.x, at.y + ImGui::GetStyle().FramePadding.y}, room,
                               palette::kMuted.packed(), text);
  const ImVec2 end{at.x + room, at.y + ImGui::GetFrameHeight()};
  tooltipWhile(ui, cut && ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end), text);
  ImGui::SetCursorScreenPos({at.x + room + ui.px(6), at.y});
  if (textButton(ui, "outliner/show-all", "Show all")) showAll(ui.state.document);
}

}  // namespace

void drawOutliner(PanelUi& ui) {
  drawSearch(ui);
  drawOrder(ui);
  const bool footer = anythingHidden(ui.state.document);
  const std::string hidden = footer ? hiddenText(ui.state.document) : "";
  const float below = footer ? ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y : 0.0f;
  ImGui::BeginChild("outliner-tree", {0.0f, -below});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0f, 0.0f});
  drawRows(ui);
  ImGui::PopStyleVar();
  ImGui::EndChild();
  if (footer) drawFooter(ui, hidden.empty() ? "Some bones are hidden" : hidden);
}

// The context menus of muscles and bones.

namespace {

/// Uses the menu bar's spacing, which is wider than the outliner's. If true, call endContextMenu().
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
  if (contextItem(ui, "     New group", "group-new")) groupSelection(ui.state);
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
  if (isBelly(*frame.rig, index)) {
    actionItem(ui, "edit/break-sheet");
  } else {
    boneSubmenu(ui, frame);
    actionItem(ui, "tool/territory");
  }
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
  if (contextItem(ui, "Add muscle on this bone", "add-muscle")) addMuscle(ui.state, bone);
  const std::vector<int> below = musclesUnder(bone, frame.skeleton, frame.boneOf);
  if (contextItem(ui, "Select its muscles", "select-muscles", !below.empty())) selectMuscles(ui.state.document, below);
  const std::vector<int> selected = selectedIndices(ui.state.document);
  if (contextItem(ui, "Move selected muscles here", "move-here", !selected.empty())) {
    reparentMuscles(ui.state, selected, bone);
  }
  ImGui::Separator();
  const std::string& path = at(frame.skeleton.bones, bone).path;
  Visibility& visibility = ui.state.document.visibility;
  const bool hidden = visibility.hidden.bones.contains(path);
  if (contextItem(ui, hidden ? "Show its muscles" : "Hide its muscles", "hide-bone")) {
    visibility.setBone(Mark::kHidden, path, !hidden);
  }
  const bool locked = visibility.locked.bones.contains(path);
  if (contextItem(ui, locked ? "Unlock its muscles" : "Lock its muscles", "lock-bone")) {
    visibility.setBone(Mark::kLocked, path, !locked);
  }
  actionItem(ui, "view/show-all");
  ImGui::Separator();
  if (contextItem(ui, "Open all below", "unfold")) setFolded(ui.state, bone, false, true);
  if (contextItem(ui, "Close all below", "fold")) setFolded(ui.state, bone, true, true);
  endContextMenu();
}

}  // namespace sinew::app
