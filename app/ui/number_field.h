// app/ui/number_field.h: every number that can be dragged or typed, as a field or as a slider.
#pragma once

#include <cfloat>
#include <string>
#include <string_view>

#include <imgui.h>

#include "app/ui/ui.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// What is typed into a number field: a number, or arithmetic that gives one.

struct Typed {
  double value = 0.0;
  bool relative = false;  ///< "+= 0.1", "-=", "*=" or "/=": made from the value that was there.
};

/// Numbers with a decimal point (or comma, whatever the locale), + - * / ^, brackets, pi and sqrt(). In front of it one
/// of += -= *= /= changes `current`. A unit of the field's own at the end ("%", "°", "deg", "x") is ignored.
/// Error: the reason says what is wrong, in a few words.
[[nodiscard]] Result<Typed> evaluate(std::string_view text, double current);

/// What came of typing, for who asks.
struct Typing {
  bool relative = false;  ///< The value is made from the one at the beginning ("+=0.1"), or is that one again.
  std::string refusal;    ///< The field is left with a text that gives no number: why. The value is as before.
};

/// How a number is shown and changed; all in shown units.
struct NumberLook {
  const char* format = "%.3f";
  float speed = 0.01f;  ///< Per window coordinate of a drag; of sliders the range and width decide.
  float least = -FLT_MAX;
  float most = FLT_MAX;
  float step = 0.0f;         ///< Ctrl goes from multiple to multiple; 0: no steps.
  bool whole = false;        ///< Whole numbers only.
  bool logarithmic = false;  ///< Sliders: equal ways are equal factors. least > 0.
  bool clampTyped = true;    ///< What is typed is brought into the range; else its caller answers.
  Typing* typing = nullptr;  ///< Filled in each frame in which something is typed.
};

/// As on the handles in the picture: a drag with Shift goes a tenth as far, one with Ctrl from step to step (with both,
/// in tenths of a step). A double click, or Ctrl and a click, types: a number or arithmetic (expression.h).
/// @return whether the value changed.
bool numberField(const char* label, float& value, const NumberLook& look);

/// The same with the part left of the value filled, so that nothing lies over the number; a drag across the whole width
/// goes through the whole range.
bool numberSlider(Ui& ui, const char* label, float& value, const NumberLook& look);

/// As a field shows it.
[[nodiscard]] std::string numberText(const char* format, float value);

/// The nearest multiple of a step within a range; the value itself if the step is 0.
[[nodiscard]] float toStep(float value, float step, float least, float most);

}  // namespace sinew::app
