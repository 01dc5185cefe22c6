// app/viewport/tools/status_line.h: the one form of the status line.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace sinew::app {

/// A line is `SUBJECT · ACT, ACT, ...`.
/// SUBJECT: what is under the pointer, or what is being done with its numbers: "biceps L on arm_L", "Move X 0.12". A
/// noun, no instruction; names as the user wrote them.
/// ACT: an input, capitalised, and what it does, a verb in the third person: "Shift+click adds". In this order, which
/// no line changes: Click, Release, Drop; Drag; the wheel; Ctrl, Shift, Alt alone; X/Y/Z, digits; Enter, Esc. Of one
/// input the plain one stands before those with Ctrl, Shift, Alt, Right.
[[nodiscard]] inline std::string statusLine(std::string_view subject, std::initializer_list<std::string_view> acts) {
  std::string line(subject);
  std::string_view between = " \xc2\xb7 ";
  for (const std::string_view act : acts) {
    line += between;
    line += act;
    between = ", ";
  }
  return line;
}

}  // namespace sinew::app
