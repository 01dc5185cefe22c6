// core/surface/triangle_classes.cpp: counts the corners inside.
#include "core/surface/triangle_classes.h"

#include <algorithm>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew {

namespace {

constexpr std::size_t kFewClassified = 4096;  ///< Triangles or vertices for one thread.

}  // namespace

std::vector<TriangleClass> classifyTriangles(const ControlMesh& mesh, std::span<const float> omega) {
  std::vector<TriangleClass> classes(mesh.triangles.size());
  forEachIndex(classes.size(), kFewClassified, [&](std::size_t t) {
    const auto isInside = [&](int vertex) { return at(omega, vertex) > 0.0f; };
    const auto inside = std::ranges::count_if(mesh.triangles[t].vertices, isInside);
    classes[t] = inside == 3   ? TriangleClass::kImplicit
                 : inside == 0 ? TriangleClass::kNormal
                               : TriangleClass::kStraddling;
  });
  return classes;
}

std::vector<float> influenceWeights(const ControlMesh& mesh, const FieldView& bindField) {
  std::vector<float> omega(mesh.positions.size(), 0.0f);
  forEachIndex(omega.size(), kFewClassified / 4, [&](std::size_t v) {
    const bool isInside =
        std::ranges::any_of(bindField.lists->of(static_cast<int>(v)), [&](const CarrierCandidate& candidate) {
          return at(bindField.primitives, candidate.primitive).influence.holds(mesh.positions[v]);
        });
    if (isInside) omega[v] = 1.0f;
  });
  return omega;
}

}  // namespace sinew
