// app/panels/curve_editor.cpp: a small picture of a driver's curve or a sheet's profile whose points can be dragged.

#include "app/panels/curve_editor.h"

#include <imgui_internal.h>  // NoNav: for the mouse alone.

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/editor/animate.h"
#include "app/panels/field_edit.h"

namespace sinew::app {
namespace {

constexpr float kHeight = 92.0f;  // Design pixels, as all here.
constexpr float kInset = 6.0f;
constexpr float kPoint = 3.5f;
constexpr float kLeastGutter = 34.0f;
constexpr float kReach = 9.0f;      // A press this near to a point grabs it.
constexpr float kLabel = 0.84f;     // Fraction of the font.
constexpr float kCurvePad = 0.08f;  // Fraction of the range, around the curve.
constexpr int kCurveSteps = 96;

/// The position of the plot and the ranges it shows.
struct Plot {
  glm::vec2 low;  ///< Window coordinates of the plot, inside its frame.
  glm::vec2 high;
  glm::vec4 axes;

  [[nodiscard]] glm::vec2 at(const glm::vec2& point) const {
    const glm::vec2 fraction = (point - glm::vec2(axes)) / (glm::vec2(axes.z, axes.w) - glm::vec2(axes));
    return {low.x + fraction.x * (high.x - low.x), high.y - fraction.y * (high.y - low.y)};
  }
  [[nodiscard]] glm::vec2 pointAt(const glm::vec2& place) const {
    const glm::vec2 fraction((place.x - low.x) / (high.x - low.x), (high.y - place.y) / (high.y - low.y));
    return glm::vec2(axes) + glm::clamp(fraction, 0.0f, 1.0f) * (glm::vec2(axes.z, axes.w) - glm::vec2(axes));
  }
};

int pointUnder(const Plot& plot, const Curve& curve, const glm::vec2& mouse, float reach) {
  int nearest = -1;
  for (int i = 0; i < static_cast<int>(curve.points.size()); ++i) {
    const float away = glm::distance(plot.at(curve.points[static_cast<std::size_t>(i)]), mouse);
    if (away > reach) continue;
    reach = away;
    nearest = i;
  }
  return nearest;
}

ImVec2 labelSize(const std::string& text) {
  return ImGui::GetFont()->CalcTextSizeA(kLabel * ImGui::GetFontSize(), FLT_MAX, 0.0f, text.c_str());
}

/// @param anchor  the point of the text that is drawn at `at`, 0..1
void drawLabel(const glm::vec2& at, const glm::vec2& anchor, const std::string& text) {
  const ImVec2 size = labelSize(text);
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), kLabel * ImGui::GetFontSize(),
                                      {at.x - anchor.x * size.x, at.y - anchor.y * size.y}, palette::kMuted.packed(),
                                      text.c_str());
}

/// Least x, least y, most x, most y of the points.
glm::vec4 rangeOf(const Curve& curve) {
  glm::vec2 low = curve.points.front();
  glm::vec2 high = low;
  for (const glm::vec2& point : curve.points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  return {low, high};
}

/// The ranges to show: least x, least y, most x, most y.
glm::vec4 axesOf(const Curve& curve, const CurveView& view) {
  const std::optional<float>& now = view.now;
  glm::vec4 range = rangeOf(curve);
  if (view.shown) {
    range = {glm::min(glm::vec2(range), glm::vec2(*view.shown)),
             glm::max(glm::vec2(range.z, range.w), glm::vec2(view.shown->z, view.shown->w))};
  }
  glm::vec2 low(range);
  glm::vec2 high(range.z, range.w);
  if (now) {
    low.x = std::min(low.x, *now);
    high.x = std::max(high.x, *now);
  }
  const auto pad = [](float& least, float& most) {
    const float flat = std::max(0.1f, 0.2f * std::abs(least));
    const float room = most - least > 1e-6f ? kCurvePad * (most - least) : flat;
    least -= room;
    most += room;
  };
  pad(low.x, high.x);
  pad(low.y, high.y);
  return {low, high};
}

/// Labels the range of the points: values at the left, inputs below.
void drawLabels(PanelUi& ui, const Plot& plot, const glm::vec4& range, const CurveView& view) {
  const float left = plot.low.x - ui.px(kInset);
  drawLabel({left, plot.at({range.x, range.w}).y}, {1.0f, 0.5f}, view.valueText(range.w));
  if (range.w > range.y) drawLabel({left, plot.at({range.x, range.y}).y}, {1.0f, 0.5f}, view.valueText(range.y));
  const float below = plot.high.y + ui.px(2);
  drawLabel({plot.at({range.x, range.y}).x, below}, {0.0f, 0.0f}, view.inputText(range.x));
  if (range.z > range.x) drawLabel({plot.at({range.z, range.y}).x, below}, {1.0f, 0.0f}, view.inputText(range.z));
}

void drawPlot(PanelUi& ui, const Plot& plot, const Curve& curve, const CurveView& view, int lit, int chosen) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto window = [](const glm::vec2& p) { return ImVec2{p.x, p.y}; };
  if (plot.axes.y < 0.0f && plot.axes.w > 0.0f) {
    const float zero = plot.at({0.0f, 0.0f}).y;
    list.AddLine({plot.low.x, zero}, {plot.high.x, zero}, palette::kLine.packed());
  }
  std::vector<ImVec2> line;
  for (int i = 0; i <= kCurveSteps; ++i) {
    const float x = plot.axes.x + (plot.axes.z - plot.axes.x) * static_cast<float>(i) / kCurveSteps;
    const float y = view.drawn ? view.drawn(x) : valueAt(curve, x);
    // A step is drawn upright.
    if (curve.kind == CurveKind::kStep && !line.empty()) line.push_back({plot.at({x, y}).x, line.back().y});
    line.push_back(window(plot.at({x, y})));
  }
  list.AddPolyline(line.data(), static_cast<int>(line.size()), palette::kDriven.packed(), 0, ui.px(1.5f));
  if (view.now) {
    const glm::vec2 at = plot.at({*view.now, valueAt(curve, *view.now)});
    list.AddLine({at.x, plot.low.y}, {at.x, plot.high.y}, palette::kAccent.faded(0.8f).packed());
    list.AddCircleFilled(window(at), ui.px(2.5f), palette::kAccent.packed());
  }
  for (int i = 0; i < static_cast<int>(curve.points.size()); ++i) {
    const glm::vec2 at = plot.at(curve.points[static_cast<std::size_t>(i)]);
    const float radius = ui.px(i == lit ? kPoint + 1.5f : kPoint);
    list.AddCircleFilled(window(at), radius, (i == chosen ? palette::kText : palette::kDriven).packed());
    list.AddCircle(window(at), radius, palette::kBackground.packed());
    ui.widgets.note(view.id + "/" + std::to_string(i), {at.x - radius, at.y - radius, 2.0f * radius, 2.0f * radius});
  }
}

/// Moves a point, between its neighbors.
Curve withMoved(Curve curve, int index, glm::vec2 to, float least) {
  std::vector<glm::vec2>& points = curve.points;
  if (index > 0) to.x = std::max(to.x, points[static_cast<std::size_t>(index) - 1].x + least);
  if (index + 1 < static_cast<int>(points.size())) {
    to.x = std::min(to.x, points[static_cast<std::size_t>(index) + 1].x - least);
  }
  points[static_cast<std::size_t>(index)] = to;
  return curve;
}

}  // namespace

Curve withPoint(Curve curve, const glm::vec2& point) {
  const auto after = std::ranges::upper_bound(curve.points, point.x, {}, [](const glm::vec2& p) { return p.x; });
  if (after != curve.points.begin() && (after - 1)->x == point.x) return curve;
  curve.points.insert(after, point);
  return curve;
}

void drawCurveEditor(PanelUi& ui, const Curve& curve, const Curve& atStart, const CurveView& view) {
  AnimateState& animate = ui.state.open.animate;
  PointDrag& drag = animate.drag;
  const bool dragging = drag.item == view.id;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(ImGui::GetContentRegionAvail().x, ui.px(40)), ui.px(kHeight)};
  ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                                            palette::kBackground.packed(), ImGui::GetStyle().FrameRounding);
  const float inset = ui.px(kInset);
  const glm::vec4 range = rangeOf(dragging ? atStart : curve);
  const float gutter =
      std::max({labelSize(view.valueText(range.y)).x, labelSize(view.valueText(range.w)).x, ui.px(kLeastGutter)});
  const Plot plot{{corner.x + gutter + 2.0f * inset, corner.y + inset},
                  {corner.x + size.x - inset, corner.y + size.y - inset - kLabel * ImGui::GetFontSize()},
                  dragging ? drag.axes : axesOf(curve, view)};
  drawLabels(ui, plot, rangeOf(curve), view);
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  ImGui::InvisibleButton(("##" + view.id).c_str(), size);
  ImGui::PopItemFlag();
  const bool hovered = ImGui::IsItemHovered();
  const glm::vec2 mouse(ImGui::GetMousePos().x, ImGui::GetMousePos().y);
  const int under = hovered && !dragging ? pointUnder(plot, curve, mouse, ui.px(kReach)) : -1;
  std::optional<Curve> wanted;
  if (ImGui::IsItemActivated()) {
    drag = {view.id, under, plot.axes, {}};
    if (under >= 0) drag.grip = plot.at(curve.points[static_cast<std::size_t>(under)]) - mouse;
    animate.chosen = view.place;
    animate.chosen.point = under;
    if (under < 0 && ImGui::IsMouseDoubleClicked(0)) wanted = withPoint(curve, plot.pointAt(mouse));
  } else if (dragging && ImGui::IsItemActive() && drag.point >= 0 &&
             drag.point < static_cast<int>(atStart.points.size()) && ImGui::IsMouseDragging(0, 1.0f)) {
    const float least = 0.002f * (plot.axes.z - plot.axes.x);
    wanted = withMoved(atStart, drag.point, plot.pointAt(mouse + drag.grip), least);
  }
  editField(ui, view.id, view.label, wanted.has_value(), [&] { return view.changed(*wanted); });
  if (ImGui::IsItemDeactivated() && drag.item == view.id) drag = {};
  if (hovered && !dragging) {
    if (under >= 0) {
      animate.pointedPoint = view.place;
      animate.pointedPoint.point = under;
    }
    if (under >= 0 && ImGui::IsMouseClicked(1)) removePointedPoint(ui.state);
    tooltip(ui, under >= 0 ? view.inputText(curve.points[static_cast<std::size_t>(under)].x) + ": " +
                                 view.valueText(curve.points[static_cast<std::size_t>(under)].y) +
                                 "\nDrag moves the point. Right click or Delete removes it"
                           : view.hint);
  }
  CurvePoint chosen = animate.chosen;
  const int chosenPoint = chosen.point;
  chosen.point = view.place.point;
  drawPlot(ui, plot, curve, view, dragging ? drag.point : under, chosen == view.place ? chosenPoint : -1);
}

}  // namespace sinew::app
