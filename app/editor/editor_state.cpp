// app/editor/editor_state.cpp: how long toasts are shown, and how they fade.
#include "app/editor/editor_state.h"

#include <algorithm>

namespace sinew::app {
namespace {

constexpr double kLeastSeconds = 2.0;
constexpr double kMostSeconds = 8.0;
constexpr double kRefusalSeconds = 1.5;    ///< Extra time for a reason.
constexpr double kSecondsPerByte = 0.045;  ///< About reading speed.
constexpr double kFadeSeconds = 0.4;
constexpr double kFadeStep = 1.0 / 30.0;

double shownSeconds(const Toast& toast) {
  const double reading = kSecondsPerByte * static_cast<double>(toast.text.size());
  return std::clamp(reading, kLeastSeconds, kMostSeconds) + (toast.refusal ? kRefusalSeconds : 0.0);
}

}  // namespace

float opacity(const Toast& toast, double now) {
  const double fading = now - toast.since - shownSeconds(toast);
  return static_cast<float>(std::clamp(1.0 - fading / kFadeSeconds, 0.0, 1.0));
}

std::optional<double> secondsToChange(const Toast& toast, double now) {
  const double left = shownSeconds(toast) - (now - toast.since);
  if (left <= -kFadeSeconds) return std::nullopt;
  return std::max(left, kFadeStep);
}

}  // namespace sinew::app
