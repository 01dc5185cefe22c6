// tests/support/surface/shading_error.h: how far the shading of flat triangles is off that of a much finer surface.
#pragma once

#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/surface.h"

namespace sinew::test {

struct ShadingError {
  double area = 0.0;       ///< Of the fine surface, world units squared.
  double off = 0.0;        ///< Part of it whose shading normal is more than 5 degrees off.
  double movedArea = 0.0;  ///< The same of what muscles have moved.
  double movedOff = 0.0;

  void add(const ShadingError& other);
};

/// Compares normals at the middles of the fine triangles with those interpolated in the flat ones around them.
/// @param fine  uniform.  @param flat  of the same mesh and pose
[[nodiscard]] ShadingError shadingError(const ControlMesh& mesh, const Surface& fine, const Surface& flat);

}  // namespace sinew::test
