// app/panels/inspector_placement.cpp: center, rotation and radii of a muscle, and the bones whose skin it may move.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui_stdlib.h>
#include <glm/gtc/quaternion.hpp>

#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/outliner.h"
#include "app/editor/visibility_commands.h"
#include "app/panels/field_edit.h"
#include "app/panels/inspector.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"

namespace sinew::app {
namespace {

const Control kPlacementSection{"inspector/section/placement", "Section Placement", "centre rotation radii",
                                withSingleMuscle};
const Control kLengthUnits{"inspector/lengths/units", "Lengths in units or % of the height", "per cent percent",
                           withSingleMuscle, kPlacementSection.id};
const Control kCenter{"inspector/center.x", "Centre", "center position place move x y z", withSingleMuscle,
                      kPlacementSection.id};
const Control kRotation{"inspector/rotation.x", "Rotation", "angle turn orientation x y z", withSingleMuscle,
                        kPlacementSection.id};
const Control kRadii{"inspector/radius.x", "Radii", "radius size scale thickness length x y z", withSingleMuscle,
                     kPlacementSection.id};

constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr const char* kAxisTitles[] = {"X", "Y", "Z"};
constexpr Tint kAxisTints[] = {{0.90f, 0.40f, 0.42f}, {0.53f, 0.79f, 0.39f}, {0.38f, 0.60f, 0.95f}};
constexpr float kLengthStep = 0.01f;  ///< Fraction of the height, as for the handles.
constexpr float kDegreeStep = 15.0f;
constexpr float kFirstRadius = 0.05f;  ///< Fraction of the height: the value that Reset sets.

/// Converts lengths of the rig to shown units.
struct Lengths {
  const Skeleton& skeleton;
  float perWorld = 1.0f;  ///< Shown units per character unit.
  float height = 1.0f;    ///< In shown units.
  const char* format = "%.3f";

  /// Shown units per unit of a bone's axis in the bind pose; exactly perWorld if the bone does not scale.
  [[nodiscard]] float along(const Primitive& primitive, const glm::vec3& directionInBone) const {
    const std::optional<int> bone = skeleton.findBone(primitive.bone);
    if (!bone) return perWorld;
    const glm::mat3 linear(at(skeleton.bones, *bone).bindInWorld);
    const float length = glm::length(linear * directionInBone);
    return perWorld * (std::abs(length - 1.0f) < 1e-4f ? 1.0f : length);
  }
};

Lengths lengthsOf(const EditorState& state) {
  const float height = state.character().height;
  if (state.view.inspector.percent) return {state.character().skeleton, 100.0f / height, 100.0f, "%.2f%%"};
  return {state.character().skeleton, 1.0f, height, height > 20.0f ? "%.2f" : (height > 2.5f ? "%.3f" : "%.4f")};
}

glm::vec3 axis(int i) {
  glm::vec3 unit(0.0f);
  unit[i] = 1.0f;
  return unit;
}

/// Three fields in a row.
template <class MakeField>
void vectorRow(PanelUi& ui, const Subjects& subjects, const Control& control, MakeField makeField) {
  beginWideRow(ui, control.label);
  const float gap = ui.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  // In a narrow field the digits get the room of the padding.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {width < ui.px(60) ? ui.px(3) : padding.x, padding.y});
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const NumberField field = makeField(i);
    drawNumberField(ui, subjects, field);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, low.y + ui.px(4)},
                                              {low.x + ui.px(2), low.y + ImGui::GetFrameHeight() - ui.px(4)},
                                              kAxisTints[i].packed());
  }
  ImGui::PopStyleVar();
}

void centerRow(PanelUi& ui, const Subjects& subjects, const Lengths& lengths) {
  vectorRow(ui, subjects, kCenter, [&](int i) {
    NumberField field{std::string("inspector/center.") + kAxisNames[i], "Move", lengths.format,
                      0.002f * lengths.height};
    field.get = [i](const Primitive& p) { return p.placement.center[i]; };
    field.set = [i](Primitive& p, float value) { p.placement.center[i] = value; };
    field.scale = [i, &lengths](const Primitive& p) { return lengths.along(p, axis(i)); };
    if (subjects.bone >= 0) {
      const Bone& bone = at(lengths.skeleton.bones, subjects.bone);
      field.initial = 0.5f * bone.tip[i] * lengths.along(subjects.shown(), axis(i));
    }
    field.step = kLengthStep * lengths.height;
    field.name = std::string("Centre ") + kAxisTitles[i];
    field.parameter = static_cast<Parameter>(static_cast<int>(Parameter::kCenterX) + i);
    field.hint = std::string("Centre along the bone's ") + kAxisNames[i] + " axis; reset: the middle of the bone";
    return field;
  });
}

/// The angles to show: the typed ones as long as the rotation is theirs, else computed from the rotation.
glm::vec3 degreesOf(const EulerState& euler, const Primitive& primitive) {
  if (euler.primitive == primitive.id() && euler.rotation == primitive.placement.rotation) return euler.degrees;
  return glm::degrees(glm::eulerAngles(primitive.placement.rotation));
}

void rotationRow(PanelUi& ui, const Subjects& subjects) {
  EulerState& euler = ui.state.open.euler;
  const Primitive& shown = subjects.shown();
  euler = {shown.id(), shown.placement.rotation, degreesOf(euler, shown)};
  vectorRow(ui, subjects, kRotation, [&](int i) {
    NumberField field{std::string("inspector/rotation.") + kAxisNames[i], "Rotate", "%.1f\xc2\xb0", 0.5f};
    field.initial = 0.0f;
    field.get = [i, &euler](const Primitive& p) { return degreesOf(euler, p)[i] + 0.0f; };  // -0 becomes 0.
    field.set = [i, &euler, &shown](Primitive& p, float value) {
      glm::vec3 degrees = degreesOf(euler, p);
      degrees[i] = value;
      p.placement.rotation = glm::normalize(glm::quat(glm::radians(degrees)));
      if (p.id() == shown.id()) euler = {p.id(), p.placement.rotation, degrees};
    };
    field.step = kDegreeStep;
    field.name = std::string("Rotation ") + kAxisTitles[i];
    field.hint = std::string("Rotation about ") + kAxisNames[i] + ", in the bone's space";
    return field;
  });
}

void radiiRow(PanelUi& ui, const Subjects& subjects, const Lengths& lengths) {
  vectorRow(ui, subjects, kRadii, [&](int i) {
    NumberField field{std::string("inspector/radius.") + kAxisNames[i], "Radius of", lengths.format,
                      0.001f * lengths.height, 1e-4f * lengths.height};
    field.initial = kFirstRadius * lengths.height;
    field.together = Together::kMultiply;
    field.get = [i](const Primitive& p) { return p.placement.radii[i]; };
    field.set = [i](Primitive& p, float value) { p.placement.radii[i] = value; };
    field.scale = [i, &lengths](const Primitive& p) { return lengths.along(p, p.placement.rotation * axis(i)); };
    field.step = kLengthStep * lengths.height;
    field.name = std::string("Radius ") + kAxisTitles[i];
    field.parameter = static_cast<Parameter>(static_cast<int>(Parameter::kRadiusX) + i);
    field.hint = std::string("Radius along the muscle's own ") + kAxisNames[i] + " axis";
    return field;
  });
}

}  // namespace

void drawPlacementRows(PanelUi& ui, const Subjects& subjects) {
  // In a narrow panel the switch is below the title.
  const float room = ImGui::GetContentRegionAvail().x;
  const bool beside = room >= ui.px(200);
  const float width = beside ? ui.px(128) : room;
  if (!section(ui, kPlacementSection, "Placement", beside ? 136.0f : 0.0f)) return;
  if (beside) ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
  constexpr const char* kWords[] = {"Units", "% of H"};
  const int chosen = segmented(ui, "inspector/lengths", kWords, 2, ui.state.view.inspector.percent ? 1 : 0, width);
  if (chosen >= 0) ui.state.view.inspector.percent = chosen == 1;
  const Lengths lengths = lengthsOf(ui.state);
  centerRow(ui, subjects, lengths);
  rotationRow(ui, subjects);
  radiiRow(ui, subjects, lengths);
}

// The bones whose skin a muscle may move.

namespace {

const Control kTerritorySection{"inspector/section/territory", "Section Territory", "bones skin", withSingleMuscle};
const Control kBones{"inspector/territory", "Bones", "of the territory skin region mask limit", withSingleMuscle,
                     kTerritorySection.id};
const Control kAddBone{"inspector/territory-add", "Add a bone to the territory", "skin region mask", withSingleMuscle,
                       kTerritorySection.id};

void reset(PanelUi& ui, const Subjects& subjects) {
  edit(ui.state, "Default territory of " + namedMuscles(*subjects.rig, subjects.indices),
       withDefaultTerritory(ui.state.document.rig(), subjects.indices));
}

/// "default" or "named", with a button that resets to the default.
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

/// A bone of the territory with a button that removes it.
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
