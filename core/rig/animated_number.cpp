// core/rig/animated_number.cpp: names of kinds, curves, and the table of parameters.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "core/geometry/affine_image.h"
#include "core/rig/rig_edit.h"
#include "sinew/rig/animated_number.h"
#include "sinew/rig/parameter.h"
#include "sinew/rig/rig.h"

namespace sinew {
namespace {

template <class Kind, std::size_t N>
using Names = std::array<std::pair<Kind, const char*>, N>;

constexpr Names<CurveKind, 3> kCurves{
    {{CurveKind::kSmooth, "smooth"}, {CurveKind::kLinear, "linear"}, {CurveKind::kStep, "step"}}};
constexpr Names<DriverInputKind, 7> kInputs{{{DriverInputKind::kBend, "bend"},
                                             {DriverInputKind::kTwist, "twist"},
                                             {DriverInputKind::kAxis, "axis"},
                                             {DriverInputKind::kPose, "pose"},
                                             {DriverInputKind::kLength, "length"},
                                             {DriverInputKind::kDistance, "distance"},
                                             {DriverInputKind::kChannel, "channel"}}};
constexpr Names<DriverMode, 3> kModes{
    {{DriverMode::kAdd, "add"}, {DriverMode::kMultiply, "multiply"}, {DriverMode::kReplace, "replace"}}};

template <class Kind, std::size_t N>
const char* nameIn(const Names<Kind, N>& names, Kind kind) {
  return std::ranges::find(names, kind, &std::pair<Kind, const char*>::first)->second;
}

template <class Kind, std::size_t N>
std::optional<Kind> named(const Names<Kind, N>& names, const std::string& name) {
  const auto found = std::ranges::find_if(names, [&](const auto& row) { return name == row.second; });
  return found == names.end() ? std::nullopt : std::optional(found->first);
}

}  // namespace

const char* nameOf(CurveKind kind) { return nameIn(kCurves, kind); }
const char* nameOf(DriverInputKind kind) { return nameIn(kInputs, kind); }
const char* nameOf(DriverMode mode) { return nameIn(kModes, mode); }
std::optional<CurveKind> curveKindNamed(const std::string& name) { return named(kCurves, name); }
std::optional<DriverInputKind> driverInputKindNamed(const std::string& name) { return named(kInputs, name); }
std::optional<DriverMode> driverModeNamed(const std::string& name) { return named(kModes, name); }

const AnimatedNumber* animationOf(const std::vector<AnimatedNumber>& animated, Parameter parameter) {
  const auto found = std::ranges::find(animated, parameter, &AnimatedNumber::parameter);
  return found == animated.end() ? nullptr : &*found;
}

const KeyTrack* trackIn(const std::vector<KeyTrack>& tracks, const std::string& clip) {
  if (clip.empty()) return nullptr;
  const KeyTrack* everywhere = nullptr;
  for (const KeyTrack& track : tracks) {
    if (track.clip == clip) return &track;
    if (track.clip.empty()) everywhere = &track;
  }
  return everywhere;
}

// Fritsch and Carlson, Monotone Piecewise Cubic Interpolation, 1980.

namespace {

double slopeBetween(const glm::vec2& a, const glm::vec2& b) {
  return (static_cast<double>(b.y) - static_cast<double>(a.y)) / (static_cast<double>(b.x) - static_cast<double>(a.x));
}

/// Slope at a point: the harmonic mean of those on both sides, weighted by the lengths (Fritsch and Butland, 1984),
/// which keeps every piece monotone; 0 at the ends and extrema of the curve.
double slopeAt(const std::vector<glm::vec2>& points, std::size_t i) {
  if (i == 0 || i + 1 == points.size()) return 0.0;
  const double before = slopeBetween(points[i - 1], points[i]);
  const double after = slopeBetween(points[i], points[i + 1]);
  if (!(before * after > 0.0)) return 0.0;
  const double widthBefore = static_cast<double>(points[i].x) - static_cast<double>(points[i - 1].x);
  const double widthAfter = static_cast<double>(points[i + 1].x) - static_cast<double>(points[i].x);
  const double a = 2.0 * widthAfter + widthBefore;
  const double b = widthAfter + 2.0 * widthBefore;
  return (a + b) / (a / before + b / after);
}

float smoothBetween(const std::vector<glm::vec2>& points, std::size_t i, float x) {
  const glm::vec2& from = points[i];
  const glm::vec2& to = points[i + 1];
  const double width = static_cast<double>(to.x) - static_cast<double>(from.x);
  const double u = (static_cast<double>(x) - static_cast<double>(from.x)) / width;
  const double rise = static_cast<double>(to.y) - static_cast<double>(from.y);
  const double u2 = u * u;
  const double u3 = u2 * u;
  const double y = static_cast<double>(from.y) + rise * (3.0 * u2 - 2.0 * u3) +
                   width * (slopeAt(points, i) * (u3 - 2.0 * u2 + u) + slopeAt(points, i + 1) * (u3 - u2));
  return static_cast<float>(y);
}

/// In double, so that differences of large numbers stay finite.
float straightBetween(const glm::vec2& from, const glm::vec2& to, float x) {
  const double u = (static_cast<double>(x) - static_cast<double>(from.x)) /
                   (static_cast<double>(to.x) - static_cast<double>(from.x));
  return static_cast<float>(static_cast<double>(from.y) +
                            u * (static_cast<double>(to.y) - static_cast<double>(from.y)));
}

}  // namespace

float valueAt(const Curve& curve, float x) {
  const std::vector<glm::vec2>& points = curve.points;
  assert(!points.empty());
  if (!(x > points.front().x)) return points.front().y;
  if (x >= points.back().x) return points.back().y;
  const auto next = std::ranges::upper_bound(points, x, {}, [](const glm::vec2& point) { return point.x; });
  const auto i = static_cast<std::size_t>(next - points.begin()) - 1;
  if (curve.kind == CurveKind::kStep) return points[i].y;
  const glm::vec2& from = points[i];
  const glm::vec2& to = points[i + 1];
  const float y = curve.kind == CurveKind::kSmooth ? smoothBetween(points, i, x) : straightBetween(from, to, x);
  return std::clamp(y, std::min(from.y, to.y), std::max(from.y, to.y));  // Rounding could leave the interval.
}

namespace {

constexpr float kUnbounded = std::numeric_limits<float>::max();
constexpr float kLeastOfDrawn = 0.01f;  // Fraction of a radius as drawn.
constexpr float kLeastReach = 1.05f;
constexpr float kMostReach = 16.0f;
constexpr float kLeastSkinBlend = 1e-4f;

struct Row {
  Parameter parameter;
  ParameterOwner owner;
  const char* name;
  const char* words;
  float least;
  float most;
};

constexpr auto kPrimitive = ParameterOwner::kPrimitive;
constexpr auto kLine = ParameterOwner::kLine;

// In the order of Parameter, without the numbers of shapes. For the lower limit of radii see legalNumber().
constexpr std::array kParameterRows{
    Row{Parameter::kAmount, kPrimitive, "amount", "Amount", 0.0f, kMostAmount},
    Row{Parameter::kCenterX, kPrimitive, "center.x", "Centre X", -kUnbounded, kUnbounded},
    Row{Parameter::kCenterY, kPrimitive, "center.y", "Centre Y", -kUnbounded, kUnbounded},
    Row{Parameter::kCenterZ, kPrimitive, "center.z", "Centre Z", -kUnbounded, kUnbounded},
    Row{Parameter::kRadiusX, kPrimitive, "radii.x", "Radius X", 0.0f, kUnbounded},
    Row{Parameter::kRadiusY, kPrimitive, "radii.y", "Radius Y", 0.0f, kUnbounded},
    Row{Parameter::kRadiusZ, kPrimitive, "radii.z", "Radius Z", 0.0f, kUnbounded},
    Row{Parameter::kReach, kPrimitive, "reach", "Reach", kLeastReach, kMostReach},
    Row{Parameter::kActivation, kLine, "activation", "Activation by hand", 0.0f, 1.0f},
    Row{Parameter::kVolume, kLine, "volume", "Volume", 0.0f, kMostVolume},
    Row{Parameter::kRest, kLine, "rest", "Rest length", kLeastRest, kMostRest},
    Row{Parameter::kFlexHeight, kLine, "flex.height", "Flex height", kLeastFlex, kMostFlex},
    Row{Parameter::kFlexWidth, kLine, "flex.width", "Flex width", kLeastFlex, kMostFlex},
    Row{Parameter::kSkinBlend, ParameterOwner::kSurface, "skin_blend", "Skin blend", kLeastSkinBlend, kMostSkinBlend},
    Row{Parameter::kGrooves, ParameterOwner::kSurface, "grooves", "Grooves", 0.0f, kMostGrooves},
    Row{Parameter::kMorphWeight, ParameterOwner::kMorph, "weight", "Weight", kLeastMorphWeight, kMostMorphWeight},
    Row{Parameter::kLinkAmount, ParameterOwner::kLink, "link_amount", "Link amount", 0.0f, 1.0f}};

const ShapeNumber& shapeNumberOf(Parameter parameter) {
  return shapeNumbers()[static_cast<std::size_t>(parameter) - static_cast<std::size_t>(Parameter::kShape)];
}

Row rowOf(Parameter parameter) {
  if (isShape(parameter)) {
    const ShapeNumber& number = shapeNumberOf(parameter);
    return {parameter, kPrimitive, number.name, number.words, number.low, number.high};
  }
  const auto index = static_cast<std::size_t>(parameter);
  return kParameterRows[parameter < Parameter::kShape ? index : index - kShapeNumbers];
}

template <class Owner>
float read(const Owner& owner, Parameter parameter) {
  const float* number = numberIn(const_cast<Owner&>(owner), parameter);
  return number == nullptr ? 0.0f : *number;
}

/// A number of a Primitive or of MuscleNumbers.
template <class Owner>
float* muscleNumber(Owner& owner, Parameter parameter) {
  Placement& placement = owner.placement;
  switch (parameter) {
    case Parameter::kAmount:
      return &owner.amount;
    case Parameter::kCenterX:
      return &placement.center.x;
    case Parameter::kCenterY:
      return &placement.center.y;
    case Parameter::kCenterZ:
      return &placement.center.z;
    case Parameter::kRadiusX:
      return &placement.radii.x;
    case Parameter::kRadiusY:
      return &placement.radii.y;
    case Parameter::kRadiusZ:
      return &placement.radii.z;
    case Parameter::kReach:
      return &owner.reach;
    default:
      return isShape(parameter) ? &shapeNumberOf(parameter).member(placement.shape) : nullptr;
  }
}

}  // namespace

ParameterOwner ownerOf(Parameter parameter) { return rowOf(parameter).owner; }

const char* nameOf(Parameter parameter) { return rowOf(parameter).name; }

const char* wordsFor(Parameter parameter) { return rowOf(parameter).words; }

std::optional<Parameter> parameterNamed(const std::string& name) {
  for (int i = 0; i <= static_cast<int>(Parameter::kLinkAmount); ++i) {
    const Row row = rowOf(static_cast<Parameter>(i));
    if (row.name == name) return row.parameter;
  }
  return std::nullopt;
}

float* numberIn(Primitive& primitive, Parameter parameter) { return muscleNumber(primitive, parameter); }

float* numberIn(MuscleNumbers& numbers, Parameter parameter) { return muscleNumber(numbers, parameter); }

float* numberIn(LineSettings& line, Parameter parameter) {
  switch (parameter) {
    case Parameter::kActivation:
      return &line.base;
    case Parameter::kVolume:
      return &line.volume;
    case Parameter::kRest:
      return &line.rest;
    case Parameter::kFlexHeight:
      return &line.flex.x;
    case Parameter::kFlexWidth:
      return &line.flex.y;
    default:
      return nullptr;
  }
}

float* numberIn(SurfaceSettings& surface, Parameter parameter) {
  switch (parameter) {
    case Parameter::kSkinBlend:
      return &surface.skinBlend;
    case Parameter::kGrooves:
      return &surface.grooves;
    default:
      return nullptr;
  }
}

float* numberIn(MorphWeight& morph, Parameter parameter) {
  return parameter == Parameter::kMorphWeight ? &morph.weight : nullptr;
}

float* numberIn(Link& link, Parameter parameter) {
  return parameter == Parameter::kLinkAmount ? &link.amount : nullptr;
}

float numberOf(const Primitive& primitive, Parameter parameter) { return read(primitive, parameter); }

float numberOf(const LineSettings& line, Parameter parameter) { return read(line, parameter); }

float numberOf(const SurfaceSettings& surface, Parameter parameter) { return read(surface, parameter); }

float legalNumber(Parameter parameter, float value, float drawn) {
  if (!std::isfinite(value)) return drawn;
  const Row row = rowOf(parameter);
  const float least = isRadius(parameter) ? kLeastOfDrawn * drawn : row.least;
  return std::clamp(value, least, row.most);
}

}  // namespace sinew
