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

std::vector<float> influenceWeights(const ControlMesh& mesh, const FieldView& bindField) {
  std::vector<float> omega(mesh.positions.size(), 0.0f);
  for (std::size_t v = 0; v < omega.size(); ++v) {
    for (const CarrierCandidate& candidate : bindField.lists->of(static_cast<int>(v))) {
      const UnitBallMap& ball = at(bindField.primitives, candidate.primitive).influence;
      if (ball.holds(mesh.positions[v])) omega[v] = 1.0f;
    }
  }
  return omega;
}

}  // namespace sinew
