// core/rig/parameter.cpp: one row a parameter.
#include "sinew/rig/parameter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sinew/rig/rig.h"

namespace sinew {
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

// In the order of Parameter. Radii and belly have limits of their own kind (legalNumber, legalShape).
constexpr std::array kRows{
    Row{Parameter::kAmount, kPrimitive, "amount", "Amount", 0.0f, kMostAmount},
    Row{Parameter::kCenterX, kPrimitive, "center.x", "Centre X", -kUnbounded, kUnbounded},
    Row{Parameter::kCenterY, kPrimitive, "center.y", "Centre Y", -kUnbounded, kUnbounded},
    Row{Parameter::kCenterZ, kPrimitive, "center.z", "Centre Z", -kUnbounded, kUnbounded},
    Row{Parameter::kRadiusX, kPrimitive, "radii.x", "Radius X", 0.0f, kUnbounded},
    Row{Parameter::kRadiusY, kPrimitive, "radii.y", "Radius Y", 0.0f, kUnbounded},
    Row{Parameter::kRadiusZ, kPrimitive, "radii.z", "Radius Z", 0.0f, kUnbounded},
    Row{Parameter::kReach, kPrimitive, "reach", "Reach", kLeastReach, kMostReach},
    Row{Parameter::kCore, kPrimitive, "core", "Straight", 0.0f, kMostCore},
    Row{Parameter::kBelly, kPrimitive, "belly", "Belly", -1.0f, 1.0f},
    Row{Parameter::kBendX, kPrimitive, "bend.x", "Bend X", -kMostBend, kMostBend},
    Row{Parameter::kBendZ, kPrimitive, "bend.z", "Bend Z", -kMostBend, kMostBend},
    Row{Parameter::kActivation, kLine, "activation", "Activation by hand", 0.0f, 1.0f},
    Row{Parameter::kVolume, kLine, "volume", "Volume", 0.0f, kMostVolume},
    Row{Parameter::kRest, kLine, "rest", "Rest length", kLeastRest, kMostRest},
    Row{Parameter::kFlexHeight, kLine, "flex.height", "Flex height", kLeastFlex, kMostFlex},
    Row{Parameter::kFlexWidth, kLine, "flex.width", "Flex width", kLeastFlex, kMostFlex},
    Row{Parameter::kSkinBlend, ParameterOwner::kSurface, "skin_blend", "Skin blend", kLeastSkinBlend, kMostSkinBlend}};

const Row& rowOf(Parameter parameter) { return kRows[static_cast<std::size_t>(parameter)]; }

/// Reading through the same table of members changes nothing.
template <class Owner>
float read(const Owner& owner, Parameter parameter) {
  const float* number = numberIn(const_cast<Owner&>(owner), parameter);
  return number == nullptr ? 0.0f : *number;
}

}  // namespace

ParameterOwner ownerOf(Parameter parameter) { return rowOf(parameter).owner; }

const char* nameOf(Parameter parameter) { return rowOf(parameter).name; }

const char* wordsFor(Parameter parameter) { return rowOf(parameter).words; }

std::optional<Parameter> parameterNamed(const std::string& name) {
  const auto found = std::ranges::find_if(kRows, [&](const Row& row) { return row.name == name; });
  return found == kRows.end() ? std::nullopt : std::optional(found->parameter);
}

float* numberIn(Primitive& primitive, Parameter parameter) {
  Placement& placement = primitive.placement;
  switch (parameter) {
    case Parameter::kAmount:
      return &primitive.amount;
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
      return &primitive.reach;
    case Parameter::kCore:
      return &placement.shape.core;
    case Parameter::kBelly:
      return &placement.shape.belly;
    case Parameter::kBendX:
      return &placement.shape.bend.x;
    case Parameter::kBendZ:
      return &placement.shape.bend.y;
    default:
      return nullptr;
  }
}

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
  return parameter == Parameter::kSkinBlend ? &surface.skinBlend : nullptr;
}

float numberOf(const Primitive& primitive, Parameter parameter) { return read(primitive, parameter); }

float numberOf(const LineSettings& line, Parameter parameter) { return read(line, parameter); }

float numberOf(const SurfaceSettings& surface, Parameter parameter) { return read(surface, parameter); }

float legalNumber(Parameter parameter, float value, float drawn) {
  if (!std::isfinite(value)) return drawn;
  const Row& row = rowOf(parameter);
  const float least = isRadius(parameter) ? kLeastOfDrawn * drawn : row.least;
  return std::clamp(value, least, row.most);
}

}  // namespace sinew
