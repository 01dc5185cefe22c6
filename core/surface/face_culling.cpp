// core/surface/face_culling.cpp: one-sided triangles that face away and that no muscle moves.
#include "core/surface/face_culling.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kBeyondHorizon = 2e-3f;  ///< Sine of the angle by which a small triangle must face away.

class Culler {
 public:
  Culler(const CullingScene& scene, const glm::vec3& eye) : scene_(scene), eye_(eye) {}

  [[nodiscard]] bool isHidden(int t) const {
    const ControlTriangle& triangle = at(scene_.character.mesh.triangles, t);
    const bool hasBack = at(scene_.character.materials, triangle.material).doubleSided;
    return !hasBack && patchFacesAway(t) && !moves(t);
  }

 private:
  [[nodiscard]] std::span<const std::array<int, 3>> smallTriangles(int t) const {
    return std::span(scene_.refinement.triangles)
        .subspan(toIndex(at(scene_.refinement.triangleBegin, t)), toIndex(scene_.refinement.refinedTriangles(t)));
  }

  [[nodiscard]] bool patchFacesAway(int t) const {
    return std::ranges::all_of(smallTriangles(t), [&](const std::array<int, 3>& small) {
      const glm::vec3 a = at(scene_.patchPositions, small[0]);
      const glm::vec3 normal =
          glm::cross(at(scene_.patchPositions, small[1]) - a, at(scene_.patchPositions, small[2]) - a);
      const glm::vec3 sight = a - eye_;
      const float facing = glm::dot(normal, sight);
      return facing >= 0.0f &&
             facing * facing >= kBeyondHorizon * kBeyondHorizon * glm::dot(normal, normal) * glm::dot(sight, sight);
    });
  }

  [[nodiscard]] bool moves(int t) const {
    if (!scene_.layers.empty() && at(scene_.layers, t) == SkinLayer::kCloth) return true;
    if (!scene_.classes.empty()) return at(scene_.classes, t) != TriangleClass::kNormal;
    const int carrier = scene_.refinement.controlVertices + scene_.refinement.controlEdges + t;
    return std::ranges::any_of(scene_.field.lists->of(carrier), [&](const CarrierCandidate& candidate) {
      return isReached(t, at(scene_.field.primitives, candidate.primitive).influence);
    });
  }

  [[nodiscard]] bool isReached(int t, const UnitBallMap& ball) const {
    return std::ranges::any_of(smallTriangles(t), [&](const std::array<int, 3>& small) {
      return std::ranges::any_of(small, [&](int vertex) { return ball.holds(at(scene_.patchPositions, vertex)); });
    });
  }

  const CullingScene& scene_;
  glm::vec3 eye_;
};

}  // namespace

void FaceCulling::clear() {
  triangles.clear();
  carriers.clear();
  culled = 0;
}

void cullFaces(const CullingScene& scene, const glm::vec3& eye, FaceCulling& out) {
  const ControlMesh& mesh = scene.character.mesh;
  const Culler culler(scene, eye);
  const auto firstEdge = static_cast<std::size_t>(scene.refinement.controlVertices);
  const std::size_t firstTriangle = firstEdge + static_cast<std::size_t>(scene.refinement.controlEdges);
  out.clear();
  out.triangles.resize(mesh.triangles.size(), 0);
  out.carriers.assign(firstTriangle + mesh.triangles.size(), 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (culler.isHidden(static_cast<int>(t))) {
      out.triangles[t] = 1;
      ++out.culled;
      continue;
    }
    out.carriers[firstTriangle + t] = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      at(out.carriers, mesh.triangles[t].vertices[i]) = 0;
      out.carriers[firstEdge + static_cast<std::size_t>(mesh.triangles[t].edges[i])] = 0;
    }
  }
}

}  // namespace sinew
