// core/lines/contraction.cpp: closed forms. docs/lines.md.
#include "core/lines/contraction.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr double kLeastBelly = 0.1;  // Of the rest length's belly, however short the line.

}  // namespace

double bellyStretch(double stretch, const LineSettings& settings) {
  const double belly = 1.0 - static_cast<double>(settings.tendons.x) - static_cast<double>(settings.tendons.y);
  return std::max(stretch - (1.0 - belly), kLeastBelly * belly) / belly;
}

double girth(double stretch, const LineSettings& settings) {
  const auto softened = [&](double of) {
    const double x = std::log(of);
    const double limit =
        x < 0.0 ? -std::log(static_cast<double>(settings.limits.x)) : std::log(static_cast<double>(settings.limits.y));
    return limit * std::tanh(x / limit);
  };
  const double inBind = bellyStretch(1.0 / static_cast<double>(settings.rest), settings);
  return std::exp(-0.5 * static_cast<double>(settings.volume) * (softened(stretch) - softened(inBind)));
}

double activation(double stretch, const LineSettings& settings, double added) {
  const double shortened = std::clamp((1.0 - stretch) / (1.0 - static_cast<double>(settings.full)), 0.0, 1.0);
  const double smooth = shortened * shortened * (3.0 - 2.0 * shortened);
  return std::clamp(static_cast<double>(settings.base) + added + static_cast<double>(settings.gain) * smooth, 0.0, 1.0);
}

}  // namespace sinew
