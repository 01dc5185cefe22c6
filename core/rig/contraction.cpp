// core/rig/contraction.cpp: girth and activation. Logarithm and exponential function are series, so that every
// machine and every standard library gives the same bits.
#include "core/rig/contraction.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace sinew {
namespace {

constexpr double kLn2High = 0x1.62e42feep-1;  ///< Its products with whole numbers below 2^21 are exact.
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

/// `low` where x is not a number.
double clamp(double x, double low, double high) { return std::min(high, std::max(low, x)); }

/// ln x to 2e-15 + 1e-13 |ln x|, for normal numbers above 0; any number for others.
double naturalLog(double x) {
  constexpr std::uint64_t kRootOfHalf = 0x3FE6A09E667F3BCD;
  constexpr std::uint64_t kOne = 0x3FF0000000000000;
  // x = 2^k m, m from sqrt(1/2) to sqrt(2).
  const std::uint64_t shifted = std::bit_cast<std::uint64_t>(x) + (kOne - kRootOfHalf);
  const double k = static_cast<double>(static_cast<int>(shifted >> 52) - 1023);
  const double m = std::bit_cast<double>((shifted & 0x000FFFFFFFFFFFFF) + kRootOfHalf);
  // ln m = 2 atanh s.
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  const double z2 = z * z;
  const double low = (1.0 + 1.0 / 3.0 * z) + z2 * (1.0 / 5.0 + 1.0 / 7.0 * z);
  const double high = (1.0 / 9.0 + 1.0 / 11.0 * z) + z2 * (1.0 / 13.0 + 1.0 / 15.0 * z);
  const double series = low + (z2 * z2) * high;
  return k * kLn2High + (k * kLn2Low + (s + s) * series);
}

/// e^x to 4e-13 of itself; x beyond 700 counts as 700, below -700 as -700. Not finite: any number.
double exponential(double x) {
  constexpr double kMagic = 0x1.8p52;  // Adding it rounds to a whole number, which is left in the lowest bits.
  x = clamp(x, -700.0, 700.0);
  // x = k ln 2 + r.
  const double rounded = x * 0x1.71547652b82fep0 + kMagic;
  const double k = rounded - kMagic;
  const double r = (x - k * kLn2High) - k * kLn2Low;
  const double r2 = r * r;
  const double r4 = r2 * r2;
  const double low = (1.0 + r) + r2 * (1.0 / 2.0 + 1.0 / 6.0 * r);
  const double middle = (1.0 / 24.0 + 1.0 / 120.0 * r) + r2 * (1.0 / 720.0 + 1.0 / 5040.0 * r);
  const double high = (1.0 / 40320.0 + 1.0 / 362880.0 * r) + 1.0 / 3628800.0 * r2;
  const double series = low + r4 * (middle + r4 * high);
  return series * std::bit_cast<double>((std::bit_cast<std::uint64_t>(rounded) + 1023) << 52);
}

/// ln of a stretch, leveling off at both limits; slope 1 at rest.
double softenedLog(double stretch, const GirthRest& rest) {
  const double x = naturalLog(stretch);
  const double limit = x < 0.0 ? rest.least : rest.most;
  const double e = exponential(clamp((x + x) / limit, -80.0, 80.0));
  return limit * ((e - 1.0) / (e + 1.0));  // The hyperbolic tangent.
}

}  // namespace

double bellyShare(const LineSettings& settings) {
  return 1.0 - static_cast<double>(settings.tendons.x) - static_cast<double>(settings.tendons.y);
}

double bellyStretch(double stretch, const LineSettings& settings) {
  constexpr double kLeast = 0.1;  // Share of the rest length's belly that is left, however short the line.
  const double belly = bellyShare(settings);
  const double tendons = 1.0 - belly;
  return std::max(kLeast * belly, stretch - tendons) / belly;
}

GirthRest girthRest(const LineSettings& settings) {
  GirthRest rest{static_cast<double>(settings.volume), -std::log(static_cast<double>(settings.limits.x)),
                 std::log(static_cast<double>(settings.limits.y)), 0.0};
  rest.inBind = softenedLog(bellyStretch(1.0 / static_cast<double>(settings.rest), settings), rest);
  return rest;
}

double girth(double bellyStretch, const GirthRest& rest) {
  return exponential(-0.5 * rest.volume * (softenedLog(bellyStretch, rest) - rest.inBind));
}

double activation(double stretch, const LineSettings& settings, double added) {
  const double full = static_cast<double>(settings.full);
  const double shortened = clamp((1.0 - stretch) / (1.0 - full), 0.0, 1.0);
  const double smooth = shortened * shortened * (3.0 - (shortened + shortened));
  const double base = static_cast<double>(settings.base) + added;
  return clamp(base + static_cast<double>(settings.gain) * smooth, 0.0, 1.0);
}

}  // namespace sinew
