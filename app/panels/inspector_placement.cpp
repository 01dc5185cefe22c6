// app/panels/inspector_placement.cpp: where a muscle is: center, rotation, radii, in units or per cent of the
// height.

#include <imgui.h>

#include <cmath>
#include <string>

#include <glm/gtc/quaternion.hpp>

#include "app/editor/commands.h"
#include "app/panels/inspector.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

const Control kPlacementSection{"inspector/section/placement", "Section Placement", "centre rotation radii"};
const Control kLengthUnits{"inspector/lengths/units", "Lengths in units or % of the height", "per cent percent",
                           nullptr, kPlacementSection.id};
const Control kCenter{"inspector/center.x", "Centre", "center position place move x y z", nullptr,
                      kPlacementSection.id};
const Control kRotation{"inspector/rotation.x", "Rotation", "angle turn orientation x y z", nullptr,
                        kPlacementSection.id};
const Control kRadii{"inspector/radius.x", "Radii", "radius size scale thickness length x y z", nullptr,
                     kPlacementSection.id};

constexpr const char* kDegreeFormat = "%.1f\xc2\xb0";
constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr const char* kAxisTitles[] = {"X", "Y", "Z"};
constexpr Tint kAxisTints[] = {{0.90f, 0.40f, 0.42f}, {0.53f, 0.79f, 0.39f}, {0.38f, 0.60f, 0.95f}};
constexpr float kLengthStep = 0.01f;  ///< Fraction of the height; as on the handles.
constexpr float kDegreeStep = 15.0f;
constexpr float kFirstRadius = 0.05f;  ///< Fraction of the height: what Reset gives.

/// What turns lengths of the rig into what is shown.
struct Lengths {
  const Skeleton& skeleton;
  float perWorld = 1.0f;  ///< Shown units per character unit.
  float height = 1.0f;    ///< In shown units.
  const char* format = "%.3f";

  /// Character units per unit of a bone's axis, in the bind pose; 1 to the bit where the bone does not scale.
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

/// Three narrow fields in a row.
template <class MakeField>
void vectorRow(PanelUi& ui, const Subjects& subjects, const Control& control, MakeField makeField) {
  beginWideRow(ui, control.label);
  const float gap = ui.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
  const ImVec2 padding = ImGui::GetStyle().FramePadding;
  // Where there is little room it is for the digits.
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
    NumberField field{std::string("inspector/center.") + kAxisNames[i],
                      "Move",
                      lengths.format,
                      0.002f * lengths.height,
                      -FLT_MAX,
                      FLT_MAX,
                      {},
                      {},
                      {},
                      {},
                      Together::kAdd,
                      {}};
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

/// Angles for showing: the typed ones as long as the rotation is the one they made, else from the rotation.
glm::vec3 degreesOf(const EulerState& euler, const Primitive& primitive) {
  if (euler.primitive == primitive.id() && euler.rotation == primitive.placement.rotation) return euler.degrees;
  return glm::degrees(glm::eulerAngles(primitive.placement.rotation));
}

void rotationRow(PanelUi& ui, const Subjects& subjects) {
  EulerState& euler = ui.state.open.euler;
  const Primitive& shown = subjects.shown();
  euler = {shown.id(), shown.placement.rotation, degreesOf(euler, shown)};
  vectorRow(ui, subjects, kRotation, [&](int i) {
    NumberField field{std::string("inspector/rotation.") + kAxisNames[i],
                      "Rotate",
                      kDegreeFormat,
                      0.5f,
                      -FLT_MAX,
                      FLT_MAX,
                      {},
                      {},
                      {},
                      0.0f,
                      Together::kAdd,
                      {}};
    field.get = [i, &euler](const Primitive& p) { return degreesOf(euler, p)[i] + 0.0f; };  // -0 becomes 0.
    field.set = [i, &euler, &shown](Primitive& p, float value) {
      glm::vec3 degrees = degreesOf(euler, p);
      degrees[i] = value;
      p.placement.rotation = glm::normalize(glm::quat(glm::radians(degrees)));
      if (p.id() == shown.id()) euler = {p.id(), p.placement.rotation, degrees};
    };
    field.step = kDegreeStep;
    field.name = std::string("Rotation ") + kAxisTitles[i];
    field.hint = std::string("Turn about ") + kAxisNames[i] + ", in the bone's space";
    return field;
  });
}

void radiiRow(PanelUi& ui, const Subjects& subjects, const Lengths& lengths) {
  vectorRow(ui, subjects, kRadii, [&](int i) {
    NumberField field{std::string("inspector/radius.") + kAxisNames[i],
                      "Radius of",
                      lengths.format,
                      0.001f * lengths.height,
                      1e-4f * lengths.height,
                      FLT_MAX,
                      {},
                      {},
                      {},
                      kFirstRadius * lengths.height,
                      Together::kMultiply,
                      {}};
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
  // In a narrow panel the switch stands under the title.
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

}  // namespace sinew::app
