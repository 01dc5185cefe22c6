// app/panels/inspector.cpp: the active muscle: name, bone, group, placement, reach, sign, territory.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "app/document/reparent.h"
#include "app/panels/commands.h"
#include "app/panels/panels.h"
#include "core/rig/attachment.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

constexpr const char* kDegreeFormat = "%.1f\xc2\xb0";
constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr Tint kAxisTints[] = {{0.90f, 0.40f, 0.42f}, {0.53f, 0.79f, 0.39f}, {0.38f, 0.60f, 0.95f}};

/// The active muscle while its panel is drawn.
struct Subject {
  int index = -1;
  Primitive primitive;
  int bone = -1;
};

Result<Rig> withPlacement(const Ui& ui, const Subject& subject, const Placement& placement) {
  return setPlacement(ui.state.document.rig(), subject.index, placement);
}

/// Three narrow fields in a row, one undo step each. @param apply  (value) -> Result<Rig>
template <class Apply>
void vectorField(Ui& ui, const char* label, const std::string& id, glm::vec3 value, float speed, float lowest,
                 const char* format, const char* undoLabel, Apply apply) {
  beginRow(ui, label);
  const float gap = ui.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
  ImGui::PushID(label);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    const float highest = std::isfinite(lowest) ? FLT_MAX : 0.0f;  // Equal limits: none.
    const bool edited = ImGui::DragFloat((std::string("##") + kAxisNames[axis]).c_str(), &value[axis], speed,
                                         std::isfinite(lowest) ? lowest : 0.0f, highest, format);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y + ui.px(4)}, {low.x + ui.px(2), high.y - ui.px(4)},
                                              kAxisTints[axis].packed());
    editField(ui, id + "." + kAxisNames[axis], undoLabel, edited, [&] { return apply(value); });
  }
  ImGui::PopID();
}

void nameRow(Ui& ui, const Subject& subject) {
  beginRow(ui, "Name");
  std::string text = subject.primitive.name;
  const bool entered = ImGui::InputText("##name", &text, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note("inspector/name");
  if (entered || ImGui::IsItemDeactivatedAfterEdit()) {
    ui.state.fieldError = rename(ui.state, subject.primitive.name, text);
  }
}

void moveToBone(Ui& ui, const Subject& subject, int bone) {
  const auto& matrices = ui.state.live->pose().boneInWorld;
  const Placement& before = subject.primitive.placement;
  const Placement placement = subject.bone < 0 ? before
                                               : carriedToBone(before, matrices[static_cast<std::size_t>(subject.bone)],
                                                               matrices[static_cast<std::size_t>(bone)]);
  const std::string& name = ui.state.character().skeleton.fileName(bone);
  applyFieldEdit(ui, "Change bone", setBone(ui.state.document.rig(), subject.index, name, placement));
}

void boneRow(Ui& ui, const Subject& subject) {
  const Skeleton& skeleton = ui.state.character().skeleton;
  beginRow(ui, "Bone");
  const std::string shown = subject.bone < 0 ? subject.primitive.bone + " (missing)" : subject.primitive.bone;
  const bool open = ImGui::BeginCombo("##bone", shown.c_str(), ImGuiComboFlags_HeightLarge);
  ui.widgets.note("inspector/bone");
  if (!open) return;
  for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
    const std::string& name = skeleton.fileName(bone);
    const bool chosen = ImGui::Selectable(name.c_str(), bone == subject.bone);
    ui.widgets.note("inspector/bone/" + name);
    if (bone == subject.bone && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
    if (chosen && bone != subject.bone) moveToBone(ui, subject, bone);
  }
  ImGui::EndCombo();
}

/// A new group with the muscle in it, as one step.
Result<Rig> inNewGroup(const Rig& rig, int index) {
  const std::string name = freeGroupName(rig, "group");
  Result<Rig> grown = addGroup(rig, name);
  return grown ? setGroupOf(grown.value(), index, name) : grown;
}

void groupRow(Ui& ui, const Subject& subject) {
  const auto rig = ui.state.document.commands.sharedRig();
  beginRow(ui, "Group");
  const bool open = ImGui::BeginCombo("##group", subject.primitive.group.c_str());
  ui.widgets.note("inspector/group");
  if (!open) return;
  for (const Group& group : rig->groups) {
    const bool chosen = ImGui::Selectable(group.name.c_str(), group.name == subject.primitive.group);
    ui.widgets.note("inspector/group/" + group.name);
    if (chosen) applyFieldEdit(ui, "Change group", setGroupOf(*rig, subject.index, group.name));
  }
  ImGui::Separator();
  const bool wanted = ImGui::Selectable("New group");
  ui.widgets.note("inspector/group-new");
  if (wanted) applyFieldEdit(ui, "New group", inNewGroup(*rig, subject.index));
  ImGui::EndCombo();
}

/// Angles for showing: the typed ones as long as the rotation is the one they made, else from the rotation.
glm::vec3 shownDegrees(EulerState& euler, const Primitive& primitive) {
  if (euler.primitive != primitive.name || euler.rotation != primitive.placement.rotation) {
    euler.primitive = primitive.name;
    euler.rotation = primitive.placement.rotation;
    euler.degrees = glm::degrees(glm::eulerAngles(primitive.placement.rotation));
  }
  return euler.degrees;
}

void placementRows(Ui& ui, const Subject& subject) {
  const float height = ui.state.character().height;
  const char* lengthFormat = height > 20.0f ? "%.2f" : (height > 2.5f ? "%.3f" : "%.4f");
  const Placement& before = subject.primitive.placement;
  vectorField(ui, "Centre", "inspector/center", before.center, 0.002f * height, -HUGE_VALF, lengthFormat, "Move",
              [&](const glm::vec3& value) {
                Placement placement = before;
                placement.center = value;
                return withPlacement(ui, subject, placement);
              });
  vectorField(ui, "Rotation", "inspector/rotation", shownDegrees(ui.state.euler, subject.primitive), 0.5f, -HUGE_VALF,
              kDegreeFormat, "Rotate", [&](const glm::vec3& value) {
                Placement placement = before;
                placement.rotation = glm::normalize(glm::quat(glm::radians(value)));
                ui.state.euler = {subject.primitive.name, placement.rotation, value};
                return withPlacement(ui, subject, placement);
              });
  vectorField(ui, "Radii", "inspector/radius", before.radii, 0.001f * height, 1e-4f * height, lengthFormat, "Scale",
              [&](const glm::vec3& value) {
                Placement placement = before;
                placement.radii = value;
                return withPlacement(ui, subject, placement);
              });
}

void influenceRows(Ui& ui, const Subject& subject) {
  beginRow(ui, "Reach");
  float reach = subject.primitive.reach;
  const bool edited = ImGui::DragFloat("##reach", &reach, 0.005f, 1.01f, 8.0f, "%.3f");
  editField(ui, "inspector/reach", "Reach", edited,
            [&] { return setReach(ui.state.document.rig(), subject.index, reach); });
  tooltip(ui, "How far the muscle's influence goes, in radii. More blends softer.");
  beginRow(ui, "Effect");
  const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ui.px(4));
  for (const int sign : {1, -1}) {
    if (sign < 0) ImGui::SameLine(0.0f, ui.px(4));
    const bool active = subject.primitive.sign == sign;
    if (active) ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent.faded(0.24f));
    const bool pressed = ImGui::Button(sign > 0 ? "Adds" : "Carves", {width, 0.0f});
    if (active) ImGui::PopStyleColor();
    ui.widgets.note(sign > 0 ? "inspector/adds" : "inspector/carves");
    if (pressed && !active) {
      applyFieldEdit(ui, sign > 0 ? "Add" : "Carve", setSign(ui.state.document.rig(), subject.index, sign));
    }
  }
}

void territoryRow(Ui& ui, const Subject& subject) {
  if (subject.bone < 0) return;
  const Skeleton& skeleton = ui.state.character().skeleton;
  beginRow(ui, "Territory");
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(4), ui.px(2)});
  bool first = true;
  for (const int bone : territoryBones(subject.primitive, subject.bone, skeleton)) {
    if (first) ImGui::AlignTextToFramePadding();
    first = false;
    ImGui::TextUnformatted(skeleton.bones[static_cast<std::size_t>(bone)].name.c_str());
  }
  ImGui::PopStyleVar();
  ImGui::EndGroup();
  ui.widgets.note("inspector/territory");
  tooltip(ui, subject.primitive.territory
                  ? "The bones whose skin this muscle may move, as the rig names them."
                  : "The bones whose skin this muscle may move: its bone, that one's parent and children.");
}

}  // namespace

void drawInspector(Ui& ui) {
  const int index = ui.state.document.activePrimitive();
  if (index < 0) {
    ImGui::PushTextWrapPos(0.0f);
    mutedText("Nothing selected. Click a muscle, or press M and drag on the skin to add one.");
    ImGui::PopTextWrapPos();
    return;
  }
  Subject subject{index, ui.state.document.rig().primitives[static_cast<std::size_t>(index)], -1};
  subject.bone = ui.state.character().skeleton.findBone(subject.primitive.bone).value_or(-1);
  ImGui::PushID(subject.primitive.name.c_str());
  nameRow(ui, subject);
  boneRow(ui, subject);
  groupRow(ui, subject);
  placementRows(ui, subject);
  influenceRows(ui, subject);
  territoryRow(ui, subject);
  ImGui::PopID();
}

}  // namespace sinew::app
