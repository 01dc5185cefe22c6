// app/panels/outliner.cpp: bones as a tree with their muscles under them.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "app/panels/commands.h"
#include "app/panels/panels.h"

namespace sinew::app {
namespace {

/// What the tree needs, gathered once a frame.
struct Tree {
  const Skeleton& skeleton;
  const Rig& rig;
  std::vector<std::vector<int>> musclesOfBone;
  std::vector<int> unattached;
  std::vector<bool> shown;  ///< By the filter: the bone, or anything under it, matches.
  bool filtered = false;
};

bool contains(const std::string& text, const std::string& part) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::ranges::search(text, part, same).begin() != text.end() || part.empty();
}

Tree gather(const EditorState& state) {
  const Skeleton& skeleton = state.character().skeleton;
  const Rig& rig = state.document.rig();
  Tree tree{skeleton, rig, std::vector<std::vector<int>>(skeleton.bones.size()), {}, {}, !state.outlinerFilter.empty()};
  const std::vector<int> bones = bonesOfPrimitives(rig, skeleton);
  for (std::size_t i = 0; i < bones.size(); ++i) {
    auto& list = bones[i] >= 0 ? tree.musclesOfBone[static_cast<std::size_t>(bones[i])] : tree.unattached;
    list.push_back(static_cast<int>(i));
  }
  tree.shown.assign(skeleton.bones.size(), !tree.filtered);
  if (!tree.filtered) return tree;
  for (std::size_t b = skeleton.bones.size(); b-- > 0;) {
    const bool muscle = std::ranges::any_of(tree.musclesOfBone[b], [&](int i) {
      return contains(rig.primitives[static_cast<std::size_t>(i)].name, state.outlinerFilter);
    });
    if (muscle || contains(skeleton.bones[b].name, state.outlinerFilter)) tree.shown[b] = true;
    const int parent = skeleton.bones[b].parent;
    if (tree.shown[b] && parent >= 0) tree.shown[static_cast<std::size_t>(parent)] = true;
  }
  return tree;
}

void drawRenameField(Ui& ui) {
  RenameState& rename_ = ui.state.rename;
  if (rename_.appearing) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1.0f);
  const bool entered = ImGui::InputText("##rename", &rename_.text,
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.widgets.note("outliner/rename");
  const bool left = !rename_.appearing && ImGui::IsItemDeactivated();
  rename_.appearing = false;
  if (entered) {
    ui.state.fieldError = rename(ui.state, rename_.primitive, rename_.text);
  }
  if (entered || left) rename_ = {};
}

void muscleMenu(Ui& ui, const std::string& name) {
  if (!ImGui::BeginPopupContextItem()) return;
  if (!ui.state.document.selection.contains(name)) ui.state.document.selection.set(name);
  for (const char* id : {"edit/rename", "edit/duplicate", "edit/delete", "view/frame"}) {
    const Action& item = action(id);
    if (ImGui::MenuItem(item.label, textOf(item.shortcut).c_str(), false, item.enabled(ui.state))) run(item, ui.state);
    ui.widgets.note(std::string("context/") + id);
  }
  ImGui::EndPopup();
}

void drawMuscle(Ui& ui, const Tree& tree, int index) {
  const Primitive& primitive = tree.rig.primitives[static_cast<std::size_t>(index)];
  Selection& selection = ui.state.document.selection;
  if (tree.filtered && !contains(primitive.name, ui.state.outlinerFilter) &&
      !contains(primitive.bone, ui.state.outlinerFilter)) {
    return;
  }
  if (ui.state.rename.primitive == primitive.name) {
    drawRenameField(ui);
    return;
  }
  const bool selected = selection.contains(primitive.name);
  const std::string name = primitive.name;  // The rig may change below.
  const int sign = primitive.sign;
  ImGui::PushID(index);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (ImGui::Selectable("##muscle", selected, ImGuiSelectableFlags_AllowDoubleClick,
                        {0.0f, ImGui::GetTextLineHeight() + ui.px(4)})) {
    const bool add = ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift;
    add ? selection.toggle(name) : selection.set(name);
    if (ImGui::IsMouseDoubleClicked(0)) startRename(ui.state, name);
  }
  ui.widgets.note("outliner/muscle/" + name);
  if (name == selection.active() && name != ui.state.revealed) {
    if (!ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
    ui.state.revealed = name;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float icon = ui.px(13);
  drawIcon(list, sign > 0 ? Icon::kMuscle : Icon::kCarve, {corner.x + ui.px(2), corner.y + ui.px(3)}, icon,
           palette::kAccent.packed());
  list.AddText({corner.x + icon + ui.px(9), corner.y + ui.px(2)}, palette::kText.packed(), name.c_str());
  muscleMenu(ui, name);
  ImGui::PopID();
}

void drawAddButton(Ui& ui, int bone, const ImVec2& rowLow, const ImVec2& rowHigh, bool selected) {
  const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(rowLow, rowHigh);
  if (!selected && !hovered) return;
  const float size = rowHigh.y - rowLow.y;
  const ImVec2 back = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - size, rowLow.y});
  const std::string id = selected ? "outliner/add" : "outliner/add-hovered";
  if (iconButton(ui, id, Icon::kPlus, false, size)) addMuscle(ui.state, bone);
  tooltip(ui, "Add muscle on this bone");
  ImGui::SetCursorScreenPos(back);
}

void boneMenu(Ui& ui, int bone) {
  if (!ImGui::BeginPopupContextItem()) return;
  ui.state.document.selection.bone = bone;
  const bool chosen = ImGui::MenuItem("Add muscle on this bone");
  ui.widgets.note("context/add-muscle");
  if (chosen) addMuscle(ui.state, bone);
  ImGui::EndPopup();
}

void drawBone(Ui& ui, const Tree& tree, int index);

void drawUnderBone(Ui& ui, const Tree& tree, int index) {
  const auto b = static_cast<std::size_t>(index);
  for (const int muscle : tree.musclesOfBone[b]) drawMuscle(ui, tree, muscle);
  for (const int child : tree.skeleton.bones[b].children) drawBone(ui, tree, child);
}

void drawBone(Ui& ui, const Tree& tree, int index) {
  const auto b = static_cast<std::size_t>(index);
  if (!tree.shown[b]) return;
  const Bone& bone = tree.skeleton.bones[b];
  Selection& selection = ui.state.document.selection;
  const bool leaf = bone.children.empty() && tree.musclesOfBone[b].empty();
  const bool selected = selection.bone == index;
  ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_SpanAvailWidth |
                             ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_AllowItemOverlap;
  if (leaf) flags |= ImGuiTreeNodeFlags_Leaf;
  if (selected) flags |= ImGuiTreeNodeFlags_Selected;
  ImGui::PushID(bone.path.c_str());
  const bool open = ImGui::TreeNodeEx("##bone", flags, "%s", bone.name.c_str());
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  ui.widgets.note("outliner/bone/" + tree.skeleton.fileName(index));
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) {
    selection.primitives.clear();
    selection.bone = index;
  }
  boneMenu(ui, index);
  drawAddButton(ui, index, low, high, selected);
  if (open) {
    drawUnderBone(ui, tree, index);
    ImGui::TreePop();
  }
  ImGui::PopID();
}

void drawUnattached(Ui& ui, const Tree& tree) {
  if (tree.unattached.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  const bool open = ImGui::TreeNodeEx("Unattached", ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
  ImGui::PopStyleColor();
  ui.widgets.note("outliner/unattached");
  tooltip(ui, "Their bones are not in this character. They are kept and saved.");
  if (!open) return;
  for (const int muscle : tree.unattached) drawMuscle(ui, tree, muscle);
  ImGui::TreePop();
}

}  // namespace

void drawOutliner(Ui& ui) {
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", "Search", &ui.state.outlinerFilter);
  ui.widgets.note("outliner/search");
  ImGui::BeginChild("outliner-tree");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.px(3), ui.px(2)});
  // Commands may replace the rig while the tree is drawn; this keeps the one being drawn alive.
  const auto rig = ui.state.document.commands.sharedRig();
  const Tree tree = gather(ui.state);
  drawUnattached(ui, tree);
  for (std::size_t b = 0; b < tree.skeleton.bones.size(); ++b) {
    if (tree.skeleton.bones[b].parent < 0) drawBone(ui, tree, static_cast<int>(b));
  }
  ImGui::PopStyleVar(2);
  ImGui::EndChild();
}

}  // namespace sinew::app
