// app/panels/inspector/inspector_shape.cpp: what makes a capsule, an egg or a bent spindle of a muscle.

#include <imgui.h>

#include <span>
#include <string>

#include "app/panels/inspector/inspector.h"
#include "core/primitives/affine_image.h"
#include "core/primitives/shape_numbers.h"

namespace sinew::app {
namespace {

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
void shapeRow(PanelUi& ui, const Subjects& subjects, std::span<const ShapeNumber> key) {
  beginRow(ui, key.front().row);
  const float gap = ui.px(4);
  const auto count = static_cast<float>(key.size());
  const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1.0f)) / count;
  for (const ShapeNumber& number : key) {
    if (&number != &key.front()) ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(width);
    shapeField(ui, subjects, static_cast<int>(&number - shapeNumbers().data()));
  }
}

/// "ellipsoid" or what it is made into; a click unfolds the rows that change it.
bool foldRow(PanelUi& ui, const Subjects& subjects) {
  bool& open = ui.state.view.inspector.shapeOpen;
  const bool shaped = subjects.differ([](const Primitive& p) { return p.placement.shape; }) ||
                      !subjects.shown().placement.shape.isPlain();
  const bool onLine = !subjects.shown().line.empty();
  beginRow(ui, "Shape");
  const std::string text = std::string(shaped ? "shaped" : "ellipsoid") + (onLine ? "" : ", on one bone");
  if (ImGui::Button(fitted(text, ImGui::GetContentRegionAvail().x - ui.px(12)).c_str(), {-1.0f, 0.0f})) open = !open;
  ui.widgets.note("inspector/shape");
  tooltip(ui, text + "\nShow or hide the numbers that make it differ from an ellipsoid" +
                  (onLine ? "." : ", and the bone that the other end is attached to."));
  return open;
}

}  // namespace

void drawShapeRows(PanelUi& ui, const Subjects& subjects) {
  if (!foldRow(ui, subjects)) return;
  for (const std::span<const ShapeNumber> key : shapeKeys()) shapeRow(ui, subjects, key);
  drawOtherEndRow(ui, subjects);
}

}  // namespace sinew::app
