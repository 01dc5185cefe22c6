// core/rig/parameter.cpp: one row a parameter.
#include "sinew/rig/parameter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/geometry/affine_image.h"
#include "core/rig/rig_edit_several.h"
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

// In the order of Parameter, without the numbers of shapes. Radii have limits of their own kind (legalNumber).
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
    Row{Parameter::kMorphWeight, ParameterOwner::kMorph, "weight", "Weight", kLeastMorphWeight, kMostMorphWeight}};

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

/// Reading through the same table of members changes nothing.
template <class Owner>
float read(const Owner& owner, Parameter parameter) {
  const float* number = numberIn(const_cast<Owner&>(owner), parameter);
  return number == nullptr ? 0.0f : *number;
}

/// A number of a primitive, or of MuscleNumbers, whose members have the same names.
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
  for (int i = 0; i <= static_cast<int>(Parameter::kMorphWeight); ++i) {
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
  return parameter == Parameter::kSkinBlend ? &surface.skinBlend : nullptr;
}

float* numberIn(MorphWeight& morph, Parameter parameter) {
  return parameter == Parameter::kMorphWeight ? &morph.weight : nullptr;
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
