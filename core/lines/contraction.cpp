// core/lines/contraction.cpp: closed forms. docs/lines.md.
#include "core/lines/contraction.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr double kLeastBelly = 0.1;  // Of the rest length's belly, however short the line.

/// ln of a stretch, levelling off at both limits; slope 1 at rest.
double softened(double stretch, const GirthRest& rest) {
  const double x = std::log(stretch);
  const double limit = x < 0.0 ? rest.least : rest.most;
  return limit * std::tanh(x / limit);
}

}  // namespace

double bellyStretch(double stretch, const LineSettings& settings) {
  const double belly = 1.0 - static_cast<double>(settings.tendons.x) - static_cast<double>(settings.tendons.y);
  return std::max(stretch - (1.0 - belly), kLeastBelly * belly) / belly;
}

GirthRest girthRest(const LineSettings& settings) {
  GirthRest rest{static_cast<double>(settings.volume), -std::log(static_cast<double>(settings.limits.x)),
                 std::log(static_cast<double>(settings.limits.y)), 0.0};
  rest.inBind = softened(bellyStretch(1.0 / static_cast<double>(settings.rest), settings), rest);
  return rest;
}

double girth(double stretch, const GirthRest& rest) {
  return std::exp(-0.5 * rest.volume * (softened(stretch, rest) - rest.inBind));
}

double activation(double stretch, const LineSettings& settings, double added) {
  const double shortened = std::clamp((1.0 - stretch) / (1.0 - static_cast<double>(settings.full)), 0.0, 1.0);
  const double smooth = shortened * shortened * (3.0 - 2.0 * shortened);
  return std::clamp(static_cast<double>(settings.base) + added + static_cast<double>(settings.gain) * smooth, 0.0, 1.0);
}

}  // namespace sinew
