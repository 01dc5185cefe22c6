// core/smoothing/triangle_classes.cpp: counts the corners inside.
#include "core/smoothing/triangle_classes.h"

#include <algorithm>

#include "core/base/at.h"

namespace sinew {

std::vector<TriangleClass> classifyTriangles(const ControlMesh& mesh, std::span<const float> omega) {
  std::vector<TriangleClass> classes;
  classes.reserve(mesh.triangles.size());
  for (const ControlTriangle& triangle : mesh.triangles) {
    const auto inside = std::ranges::count_if(triangle.vertices, [&](int vertex) { return at(omega, vertex) > 0.0f; });
    classes.push_back(inside == 3   ? TriangleClass::kImplicit
                      : inside == 0 ? TriangleClass::kNormal
                                    : TriangleClass::kStraddling);
  }
  return classes;
}

}  // namespace sinew
