// core/include/sinew/rig/parameter.h: the numbers of a rig that keys and drivers may change. docs/muscles.md.
#pragma once

#include <optional>
#include <string>

#include "sinew/geometry/shape.h"

namespace sinew {

struct Primitive;
struct Link;
struct LineSettings;
struct MorphWeight;
struct SurfaceSettings;

enum class Parameter {
  // A primitive's.
  kAmount,
  kCenterX,
  kCenterY,
  kCenterZ,
  kRadiusX,
  kRadiusY,
  kRadiusZ,
  kReach,
  kShape,  ///< The first number of its shape; the others follow in the order of Shape's members (shapeParameter).
  // A muscle line's.
  kActivation = kShape + kShapeNumbers,  ///< LineSettings::base
  kVolume,
  kRest,
  kFlexHeight,
  kFlexWidth,
  // The surface's.
  kSkinBlend,
  kGrooves,
  // A morph target's.
  kMorphWeight,
  // A link's.
  kLinkAmount,
};

enum class ParameterOwner { kPrimitive, kLine, kSurface, kMorph, kLink };

[[nodiscard]] ParameterOwner ownerOf(Parameter parameter);
[[nodiscard]] constexpr bool isRadius(Parameter parameter) {
  return parameter >= Parameter::kRadiusX && parameter <= Parameter::kRadiusZ;
}
[[nodiscard]] constexpr bool isShape(Parameter parameter) {
  return parameter >= Parameter::kShape && parameter < Parameter::kActivation;
}
/// @param number  0 .. kShapeNumbers - 1
[[nodiscard]] constexpr Parameter shapeParameter(int number) {
  return static_cast<Parameter>(static_cast<int>(Parameter::kShape) + number);
}
/// A coordinate of the center, or a radius: character units, bone space.
[[nodiscard]] constexpr bool isLength(Parameter parameter) {
  return parameter >= Parameter::kCenterX && parameter <= Parameter::kRadiusZ;
}
[[nodiscard]] const char* nameOf(Parameter parameter);  ///< Name in files: "radii.x".
[[nodiscard]] std::optional<Parameter> parameterNamed(const std::string& name);
[[nodiscard]] const char* wordsFor(Parameter parameter);  ///< Label in the user interface: "Radius X".

[[nodiscard]] float* numberIn(Primitive& primitive, Parameter parameter);  ///< Null: the parameter has another owner.
[[nodiscard]] float* numberIn(LineSettings& line, Parameter parameter);
[[nodiscard]] float* numberIn(SurfaceSettings& surface, Parameter parameter);
[[nodiscard]] float* numberIn(MorphWeight& morph, Parameter parameter);
[[nodiscard]] float* numberIn(Link& link, Parameter parameter);
[[nodiscard]] float numberOf(const Primitive& primitive, Parameter parameter);
[[nodiscard]] float numberOf(const LineSettings& line, Parameter parameter);
[[nodiscard]] float numberOf(const SurfaceSettings& surface, Parameter parameter);

/// A value clamped to the parameter's range, or `drawn` if it is not finite.
/// @param drawn  the rig's own number: a radius is at least a hundredth of it.
[[nodiscard]] float legalNumber(Parameter parameter, float value, float drawn);

}  // namespace sinew
