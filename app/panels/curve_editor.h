// app/panels/curve_editor.h: a small picture of a driver's curve whose points can be dragged.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/panels/panel_ui.h"

namespace sinew::app {

struct CurveView {
  std::string id;            ///< The widget's.
  CurvePoint place;          ///< Which curve; `point` is not read.
  std::optional<float> now;  ///< The input where it is now.
  std::function<std::string(float)> inputText;
  std::function<std::string(float)> valueText;
  const char* label = "";  ///< The undo step's.
  /// The rig with another curve.
  std::function<Result<Rig>(const Curve&)> changed;
};

/// Fills the width. A drag of a point is one undo step, as are a double click that adds one and a right click that
/// removes one.
/// @param atStart  the curve before the gesture that is under way
void drawCurveEditor(PanelUi& ui, const Curve& curve, const Curve& atStart, const CurveView& view);

/// @return the curve with a point, in its place; as it is where one stands already
[[nodiscard]] Curve withPoint(Curve curve, const glm::vec2& point);

}  // namespace sinew::app
