// app/ui/expression.h: what is typed into a number field: a number, or arithmetic that gives one.
#pragma once

#include <string_view>

#include "sinew/geometry/result.h"

namespace sinew::app {

struct Typed {
  double value = 0.0;
  bool relative = false;  ///< "+= 0.1", "-=", "*=" or "/=": made from the value that was there.
};

/// Numbers with a decimal point (or comma, whatever the locale), + - * / ^, brackets, pi and sqrt(). In front of it one
/// of += -= *= /= changes `current`. A unit of the field's own at the end ("%", "°", "deg", "x") is ignored.
/// Error: the reason says what is wrong, in a few words.
[[nodiscard]] Result<Typed> evaluate(std::string_view text, double current);

}  // namespace sinew::app
