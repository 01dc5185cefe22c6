// app/panels/inspector/inspector_shape.cpp: what makes a capsule, an egg or a bent spindle of a muscle.

#include <imgui.h>

#include <string>

#include "app/panels/inspector/inspector.h"
#include "core/primitives/affine_image.h"

namespace sinew::app {
namespace {

constexpr const char* kFormat = "%.2f";

/// Sets one number of the shape. An ellipsoid's longest axis becomes its y first: it is the one that shapes go along.
void reshape(Primitive& primitive, const std::function<void(Shape&)>& change) {
  Placement& placement = primitive.placement;
  if (placement.shape.isPlain()) placement = withLongAxisY(placement);
  change(placement.shape);
  placement.shape = legalShape(placement.shape, primitive.reach);
}

NumberField numberOf(const char* id, Parameter parameter, const char* undoLabel, float least, float most) {
  NumberField field{id, undoLabel, kFormat, 0.005f, least, most, {}, {}, {}, 0.0f, Together::kAdd, {}};
  field.step = 0.1f;
  field.name = wordsFor(parameter);
  field.parameter = parameter;
  return field;
}

void straightRow(PanelUi& ui, const Subjects& subjects) {
  beginRow(ui, "Straight");
  NumberField field = numberOf("inspector/core", Parameter::kCore, "Straighten", 0.0f, kMostCore);
  field.get = [](const Primitive& p) { return p.placement.shape.core; };
  field.set = [](Primitive& p, float value) { reshape(p, [value](Shape& shape) { shape.core = value; }); };
  field.hint = "Straight part along the longest axis: 0 is an ellipsoid, 0.9 a cylinder with rounded ends";
  ImGui::SetNextItemWidth(-1.0f);
  drawNumberField(ui, subjects, field);
}

void bellyRow(PanelUi& ui, const Subjects& subjects) {
  beginRow(ui, "Belly");
  const Primitive& shown = subjects.shown();
  const float most = mostBelly(shown.placement.shape.core, shown.reach);
  NumberField field = numberOf("inspector/belly", Parameter::kBelly, "Move the belly of", -most, most);
  field.get = [](const Primitive& p) { return p.placement.shape.belly; };
  field.set = [](Primitive& p, float value) { reshape(p, [value](Shape& shape) { shape.belly = value; }); };
  field.hint = "Where along the longest axis the muscle is thickest. A larger reach allows less";
  ImGui::SetNextItemWidth(-1.0f);
  drawNumberField(ui, subjects, field);
}

void bendField(PanelUi& ui, const Subjects& subjects, int i, const char* id, const char* hint) {
  NumberField field = numberOf(id, i == 0 ? Parameter::kBendX : Parameter::kBendZ, "Bend", -kMostBend, kMostBend);
  field.get = [i](const Primitive& p) { return p.placement.shape.bend[i]; };
  field.set = [i](Primitive& p, float value) { reshape(p, [i, value](Shape& shape) { shape.bend[i] = value; }); };
  field.hint = hint;
  drawNumberField(ui, subjects, field);
}

void bendRow(PanelUi& ui, const Subjects& subjects) {
  beginRow(ui, "Bend");
  const float gap = ui.px(4);
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2.0f;
  ImGui::SetNextItemWidth(width);
  bendField(ui, subjects, 0, "inspector/bend.x",
            "How far the middle is moved along the muscle's own x axis, in its radii");
  ImGui::SameLine(0.0f, gap);
  ImGui::SetNextItemWidth(width);
  bendField(ui, subjects, 1, "inspector/bend.z",
            "How far the middle is moved along the muscle's own z axis, in its radii");
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
  tooltip(ui, text + "\nShow or hide the straight part, the belly and the bend" +
                  (onLine ? "." : ", and the bone that the other end is attached to."));
  return open;
}

}  // namespace

void drawShapeRows(PanelUi& ui, const Subjects& subjects) {
  if (!foldRow(ui, subjects)) return;
  straightRow(ui, subjects);
  bellyRow(ui, subjects);
  bendRow(ui, subjects);
  drawOtherEndRow(ui, subjects);
}

}  // namespace sinew::app
