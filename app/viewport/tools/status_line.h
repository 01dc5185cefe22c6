// app/viewport/tools/status_line.h: format of the status line.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace sinew::app {

/// `SUBJECT · ACT, ACT, ...`
/// SUBJECT: what is under the pointer or being done, with its numbers, as a noun: "biceps L on arm_L", "Move X 0.12".
/// ACT: an input, capitalised, and its effect, a verb in the third person: "Shift+click adds". Always in this order:
/// Click, Release, Drop; Drag; the wheel; Ctrl, Shift, Alt alone; X/Y/Z, digits; Enter, Esc. The plain input stands
/// before the same with Ctrl, Shift, Alt, Right.
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
