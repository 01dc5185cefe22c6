// app/editor/toast.h: the short note of what has just been done, or why it was not.
#pragma once

#include <optional>
#include <string>

namespace sinew::app {

/// Shown for a time that depends on its length, then fades. Asks for no answer; what has to stay is a Message.
struct Toast {
  std::string text;
  bool refusal = false;  ///< Something was not done: shown longer.
  double since = 0.0;    ///< FrameState::now when it was said.
};

/// 1: fully shown, then less; 0: gone.
[[nodiscard]] float opacity(const Toast& toast, double now);
/// Seconds until it looks different; none: it is gone.
[[nodiscard]] std::optional<double> secondsToChange(const Toast& toast, double now);

}  // namespace sinew::app
