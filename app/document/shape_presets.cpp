// app/document/shape_presets.cpp: the numbers of the named shapes.
#include "app/document/shape_presets.h"

#include <algorithm>

#include "core/geometry/affine_image.h"

namespace sinew::app {
namespace {

Shape shapeOf(ShapePreset preset, const glm::vec3& radii) {
  switch (preset) {
    case ShapePreset::kEllipsoid:
      break;
    case ShapePreset::kCapsule:  // Ends as round as the sides are.
      return {std::max(0.0f, 1.0f - 0.5f * (radii.x + radii.z) / radii.y), 0.0f, {}};
    case ShapePreset::kCylinder:
      return {0.9f, 0.0f, {}};
    case ShapePreset::kEgg:
      return {0.0f, -0.25f, {}};  // Limbs are thicker towards the body.
    case ShapePreset::kCone:
      return {0.85f, -0.3f, {}};
    case ShapePreset::kSpindle:
      return {0.0f, 0.0f, {0.0f, 0.6f}};
  }
  return {};
}

}  // namespace

const char* nameOf(ShapePreset preset) {
  switch (preset) {
    case ShapePreset::kEllipsoid:
      break;
    case ShapePreset::kCapsule:
      return "capsule";
    case ShapePreset::kCylinder:
      return "cylinder";
    case ShapePreset::kEgg:
      return "egg";
    case ShapePreset::kCone:
      return "cone";
    case ShapePreset::kSpindle:
      return "bent spindle";
  }
  return "ellipsoid";
}

Placement shaped(ShapePreset preset, const Placement& placement, float reach) {
  if (preset == ShapePreset::kEllipsoid) return placement;
  Placement result = withLongAxisY(placement);
  result.shape = legalShape(shapeOf(preset, result.radii), reach);
  return result;
}

}  // namespace sinew::app
