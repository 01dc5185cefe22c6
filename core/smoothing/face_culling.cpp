// core/smoothing/face_culling.cpp: three normals, then the patch, then the reach of primitives.
#include "core/smoothing/face_culling.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr float kReachedMargin = 0.5f;  ///< Sine of how far beyond the horizon normals must point under a primitive.

class Culler {
 public:
  Culler(const ControlMesh& mesh, const Refinement& refinement, const FieldView& field,
         std::span<const glm::vec3> patchPositions, std::span<const glm::vec3> normals, const glm::vec3& eye)
      : mesh_(mesh), refinement_(refinement), field_(field), positions_(patchPositions), normals_(normals), eye_(eye) {}

  [[nodiscard]] bool isHidden(int t) const {
    const ControlTriangle& triangle = mesh_.triangles[static_cast<std::size_t>(t)];
    float least = 1.0f;
    for (const int vertex : triangle.vertices) least = std::min(least, away(vertex));
    if (least <= 0.0f || !patchFacesAway(t)) return false;
    return least >= kReachedMargin || !isReached(t);
  }

 private:
  /// Sine of the angle by which a control vertex's normal points beyond the horizon.
  [[nodiscard]] float away(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return glm::dot(normals_[v], normalizeOr(positions_[v] - eye_, -normals_[v]));
  }

  [[nodiscard]] std::span<const std::array<int, 3>> smallTriangles(int t) const {
    const auto count = static_cast<std::size_t>(refinement_.depth * refinement_.depth);
    return std::span(refinement_.triangles).subspan(static_cast<std::size_t>(t) * count, count);
  }

  [[nodiscard]] const glm::vec3& at(int refinedVertex) const { return positions_[static_cast<std::size_t>(refinedVertex)]; }

  [[nodiscard]] bool patchFacesAway(int t) const {
    return std::ranges::all_of(smallTriangles(t), [&](const std::array<int, 3>& small) {
      const glm::vec3 a = at(small[0]);
      return glm::dot(glm::cross(at(small[1]) - a, at(small[2]) - a), a - eye_) >= 0.0f;
    });
  }

  [[nodiscard]] bool isReached(int t) const {
    Bounds box;
    for (const std::array<int, 3>& small : smallTriangles(t)) {
      for (const int vertex : small) box.add(at(vertex));
    }
    const int carrier = refinement_.controlVertices + refinement_.controlEdges + t;
    return std::ranges::any_of(field_.lists->of(carrier), [&](const CarrierCandidate& candidate) {
      return carrier_walk::reaches(field_.primitives[static_cast<std::size_t>(candidate.primitive)].influence, box);
    });
  }

  const ControlMesh& mesh_;
  const Refinement& refinement_;
  const FieldView& field_;
  std::span<const glm::vec3> positions_;
  std::span<const glm::vec3> normals_;
  glm::vec3 eye_;
};

}  // namespace

FaceCulling cullFaces(const ControlMesh& mesh, const Refinement& refinement, const FieldView& field,
                      std::span<const glm::vec3> patchPositions, std::span<const glm::vec3> normals,
                      const glm::vec3& eye) {
  const Culler culler(mesh, refinement, field, patchPositions, normals, eye);
  const auto firstEdge = static_cast<std::size_t>(refinement.controlVertices);
  const std::size_t firstTriangle = firstEdge + static_cast<std::size_t>(refinement.controlEdges);
  FaceCulling culling;
  culling.triangles.resize(mesh.triangles.size(), 0);
  culling.carriers.assign(firstTriangle + mesh.triangles.size(), 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (culler.isHidden(static_cast<int>(t))) {
      culling.triangles[t] = 1;
      ++culling.culled;
      continue;
    }
    culling.carriers[firstTriangle + t] = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      culling.carriers[static_cast<std::size_t>(mesh.triangles[t].vertices[i])] = 0;
      culling.carriers[firstEdge + static_cast<std::size_t>(mesh.triangles[t].edges[i])] = 0;
    }
  }
  return culling;
}

}  // namespace sinew
