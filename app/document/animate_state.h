// app/document/animate_state.h: what the editor remembers while numbers are keyed and driven.
#pragma once

#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "sinew/rig/rig.h"

namespace sinew::app {

/// A number of the rig that keeps its owner through renames, undo and redo.
struct HeldNumber {
  Parameter parameter = Parameter::kAmount;
  PrimitiveId primitive;  ///< 0 if it is not a muscle's.
  LineId line;            ///< 0 if it is not a line's.
  std::string morph{};    ///< Name of the shape; empty if it is not one's.

  friend bool operator==(const HeldNumber&, const HeldNumber&) = default;
};

/// Set driven key: an edit of these numbers becomes a point at where the input is now.
struct DrivenKeyMode {
  std::vector<HeldNumber> numbers;  ///< One parameter's, the shown one first; empty: off.
  DriverInput input;

  [[nodiscard]] bool isOn() const { return !numbers.empty(); }
};

/// A drag of a point of a curve, or of a key in the timeline.
struct PointDrag {
  std::string item;      ///< Id of the widget; empty: none.
  int point = -1;        ///< Index when the drag began.
  glm::vec4 axes{0.0f};  ///< Least x, least y, most x, most y that the curve shows meanwhile.
  glm::vec2 grip{0.0f};  ///< From the point to the pointer, window coordinates.
};

/// A point of a driver's curve.
struct CurvePoint {
  HeldNumber number;
  int driver = -1;  ///< Index; -1: none.
  int point = -1;

  friend bool operator==(const CurvePoint&, const CurvePoint&) = default;
};

/// A number as it was drawn when it was keyed last.
struct KeyedNumber {
  HeldNumber number;
  float drawn = 0.0f;
};

struct AnimateState {
  std::vector<KeyedNumber> keyed;
  std::vector<HeldNumber> pointed;  ///< In the field that was under the pointer last frame, the shown one first.
  DrivenKeyMode drivenKey;
  PointDrag drag;
  CurvePoint chosen;           ///< Its numbers are shown under the curve.
  CurvePoint pointedPoint;     ///< Under the pointer in the last frame: what Delete removes.
  std::string menuRow;         ///< Id of the timeline's row whose menu is open,
  int menuKey = -1;            ///< and which key it was asked for on; -1: beside them.
  bool sectionWanted = false;  ///< The inspector unfolds Animation and scrolls to it with the next frame.
};

}  // namespace sinew::app
