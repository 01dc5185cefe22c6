// core/lines/contraction.cpp: the formulas of line_formulas.h, one number at a time.
#include "core/lines/contraction.h"

#include <cmath>

#include "core/lines/line_formulas.h"

namespace sinew {
namespace {

namespace lanes = HWY_NAMESPACE;
constexpr lanes::OneDouble kOne;

auto lane(double value) { return lanes::hn::Set(kOne, value); }
double number(lanes::hn::Vec<lanes::OneDouble> value) { return lanes::hn::GetLane(value); }

}  // namespace

double bellyShare(const LineSettings& settings) {
  return 1.0 - static_cast<double>(settings.tendons.x) - static_cast<double>(settings.tendons.y);
}

double bellyStretch(double stretch, const LineSettings& settings) {
  return number(lanes::bellyStretchOf(kOne, lane(stretch), lane(bellyShare(settings))));
}

GirthRest girthRest(const LineSettings& settings) {
  GirthRest rest{static_cast<double>(settings.volume), -std::log(static_cast<double>(settings.limits.x)),
                 std::log(static_cast<double>(settings.limits.y)), 0.0};
  const double inBind = bellyStretch(1.0 / static_cast<double>(settings.rest), settings);
  rest.inBind = number(lanes::softened(kOne, lane(inBind), lane(rest.least), lane(rest.most)));
  return rest;
}

double girth(double stretch, const GirthRest& rest) {
  return number(lanes::girthOf(kOne, lane(stretch), lane(-0.5 * rest.volume), lane(rest.least), lane(rest.most),
                               lane(rest.inBind)));
}

double activation(double stretch, const LineSettings& settings, double added) {
  const double base = static_cast<double>(settings.base) + added;
  return number(lanes::activationOf(kOne, lane(stretch), lane(static_cast<double>(settings.full)), lane(base),
                                    lane(static_cast<double>(settings.gain))));
}

}  // namespace sinew
