// app/ui/number_field.h: numbers that are dragged or typed, as fields and sliders.
#pragma once

#include <cfloat>
#include <string>
#include <string_view>

#include <imgui.h>

#include "app/ui/ui.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

struct Typed {
  double value = 0.0;
  bool relative = false;  ///< "+= 0.1", "-=", "*=" or "/="
};

/// Arithmetic: numbers with a decimal point or comma, + - * / ^, brackets, pi, sqrt(); a leading += -= *= or /= changes
/// `current`. Ignores a unit at the end ("%", "°", "deg", "x"). Error: a short reason.
[[nodiscard]] Result<Typed> evaluate(std::string_view text, double current);

/// Result of typing into a field.
struct Typing {
  bool relative = false;  ///< The value changes the former one ("+=0.1"), or is unchanged.
  std::string refusal;    ///< Why the text gave no number when the field was left. The value is unchanged.
};

/// How a number is shown and changed, in shown units.
struct NumberLook {
  const char* format = "%.3f";
  float speed = 0.01f;  ///< Per window coordinate of a drag; sliders use range and width.
  float least = -FLT_MAX;
  float most = FLT_MAX;
  float step = 0.0f;         ///< Ctrl snaps to multiples; 0: no steps.
  bool whole = false;        ///< Whole numbers only.
  bool logarithmic = false;  ///< Logarithmic slider. least > 0.
  bool clampTyped = true;    ///< Clamps typed values to the range; else the caller checks them.
  Typing* typing = nullptr;  ///< Filled while something is typed.
};

/// A drag with Shift moves a tenth as far, with Ctrl from step to step (with both, in tenths of a step). A double click
/// or Ctrl+click types a number or arithmetic. @return whether the value changed
bool numberField(const char* label, float& value, const NumberLook& look);

/// The same as a slider with a filled bar; a drag across the width covers the range.
bool numberSlider(Ui& ui, const char* label, float& value, const NumberLook& look);

[[nodiscard]] std::string numberText(const char* format, float value);

/// The nearest multiple of a step within a range; the value if the step is 0.
[[nodiscard]] float toStep(float value, float step, float least, float most);

}  // namespace sinew::app
