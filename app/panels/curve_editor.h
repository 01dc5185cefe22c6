// app/panels/curve_editor.h: a small picture of a driver's curve or a sheet's profile whose points can be dragged.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/panels/panel_ui.h"

namespace sinew::app {

struct CurveView {
  std::string id;            ///< The widget's.
  CurvePoint place;          ///< Which curve; `point` is not read.
  std::optional<float> now;  ///< The current input.
  std::function<std::string(float)> inputText;
  std::function<std::string(float)> valueText;
  const char* label = "";                            ///< The undo step's.
  std::function<Result<Rig>(const Curve&)> changed;  ///< The rig with another curve.
  std::function<float(float)> drawn = {};            ///< The function that the points give; empty: valueAt().
  std::optional<glm::vec4> shown = {};               ///< Least x, least y, most x, most y, at least; empty: the points.
  const char* hint = "The number for each input. Double-click adds a point. The upright line is now";
};

/// Fills the width. One undo step each: dragging a point, a double click that adds one, a right click that removes one.
/// @param atStart  the curve before the current gesture
void drawCurveEditor(PanelUi& ui, const Curve& curve, const Curve& atStart, const CurveView& view);

/// @return the curve with a point inserted; unchanged if there is one at its x
[[nodiscard]] Curve withPoint(Curve curve, const glm::vec2& point);

}  // namespace sinew::app
