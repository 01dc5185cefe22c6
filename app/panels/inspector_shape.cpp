// app/panels/inspector_shape.cpp: what makes a capsule, an egg or a bent spindle of a muscle.

#include <imgui.h>

#include <algorithm>
#include <span>
#include <string>

#include "app/panels/inspector_lines.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

const Control kShapeRow{"inspector/shape", "Shape", "of the muscle ellipsoid capsule egg spindle form"};
/// In the order of shapeKeys().
const Control kShapeRows[] = {
    {"inspector/core", "Straight", "capsule cylinder core shape", nullptr, kShapeRow.id},
    {"inspector/belly", "Belly", "egg cone shape thicker end", nullptr, kShapeRow.id},
    {"inspector/bend.x", "Bend", "curve spindle shape sideways", nullptr, kShapeRow.id},
};

constexpr const char* kFormat = "%.2f";

/// Sets one number of the shape. An ellipsoid's longest axis becomes its y first: it is the one that shapes go along.
void reshape(Primitive& primitive, const ShapeNumber& number, float value) {
  primitive.placement = withLongAxisY(primitive.placement);
  Shape& shape = primitive.placement.shape;
  number.member(shape) = value;
  shape = legalShape(shape, primitive.reach);
}

void shapeField(PanelUi& ui, const Subjects& subjects, int index) {
  const ShapeNumber& number = shapeNumbers()[static_cast<std::size_t>(index)];
  const Primitive& shown = subjects.shown();
  const auto [low, high] = number.range(shown.placement.shape, shown.reach);
  NumberField field{std::string("inspector/") + number.name,
                    number.change,
                    kFormat,
                    0.005f,
                    low,
                    high,
                    {},
                    {},
                    {},
                    0.0f,
                    Together::kAdd,
                    number.hint};
  field.get = [&number](const Primitive& p) { return number.of(p.placement.shape); };
  field.set = [&number](Primitive& p, float value) { reshape(p, number, value); };
  field.step = 0.1f;
  field.name = number.words;
  field.parameter = shapeParameter(index);
  drawNumberField(ui, subjects, field);
}

/// The numbers of one key side by side.
void shapeRow(PanelUi& ui, const Subjects& subjects, std::span<const ShapeNumber> key, const Control& control) {
  beginRow(ui, control);
  const float gap = ui.px(4);
  const auto count = static_cast<float>(key.size());
  const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1.0f)) / count;
  for (const ShapeNumber& number : key) {
    if (&number != &key.front()) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    shapeField(ui, subjects, static_cast<int>(&number - shapeNumbers().data()));
  }
}

/// What the muscles are: "ellipsoid", or what it is made into; "mixed" where they differ. The bones are named where all
/// ride one.
std::string shapeText(const Subjects& subjects, bool anyRigid) {
  const bool mixed = subjects.differ([](const Primitive& p) { return p.placement.shape; });
  const char* shape = mixed ? "mixed" : (subjects.shown().placement.shape.isPlain() ? "ellipsoid" : "shaped");
  const bool onLines = subjects.differ([](const Primitive& p) { return p.line.empty(); });
  if (!anyRigid || onLines) return shape;
  return std::string(shape) + (subjects.several() ? ", each on one bone" : ", on one bone");
}

/// A click unfolds the rows that change the shape.
bool foldRow(PanelUi& ui, const Subjects& subjects) {
  bool& open = ui.state.view.inspector.shapeOpen;
  const bool anyRigid = std::ranges::any_of(
      subjects.indices, [&](int index) { return at(subjects.rig->primitives, index).line.empty(); });
  beginRow(ui, kShapeRow);
  const std::string text = shapeText(subjects, anyRigid);
  if (ImGui::Button(fitted(text, ImGui::GetContentRegionAvail().x - ui.px(12)).c_str(), {-1.0f, 0.0f})) open = !open;
  ui.widgets.note(kShapeRow.id);
  tooltip(ui, text + "\nShow or hide the numbers that make it differ from an ellipsoid" +
                  (!anyRigid ? "." : ", and the bone that the other end is attached to."));
  return open;
}

}  // namespace

void drawShapeRows(PanelUi& ui, const Subjects& subjects) {
  if (!foldRow(ui, subjects)) return;
  const Control* control = kShapeRows;
  for (const std::span<const ShapeNumber> key : shapeKeys()) shapeRow(ui, subjects, key, *control++);
  drawOtherEndRow(ui, subjects);
}

}  // namespace sinew::app
