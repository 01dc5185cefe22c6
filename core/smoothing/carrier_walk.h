#pragma once  // core/smoothing/carrier_walk.h: visits the refined vertices that a primitive can reach in this pose.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/blending/field.h"
#include "core/smoothing/candidates.h"
#include "core/smoothing/refinement.h"

namespace sinew {

/// A refined vertex with what its carrier (control vertex, edge or triangle) lends it.
struct CarriedVertex {
  int index = 0;                          ///< Refined vertex.
  int carrier = 0;                        ///< As in CandidateLists.
  std::array<int, 3> corners{};           ///< Control vertices; corners[2] repeats on edges, all repeat on vertices.
  std::array<float, 3> barycentric{};     ///< Weights of the corners; unused ones are 0.
};

/// Posed primitives and the lists that say who may see them.
struct FieldView {
  std::span<const PosedPrimitive> primitives;
  const CandidateLists* lists = nullptr;
  std::span<const std::uint8_t> skipped = {};  ///< [V+E+T] 1: this carrier is not asked for (face_culling.h); or empty.
};

namespace carrier_walk {

/// Box around a carrier's refined vertices, grown by `margin`.
inline Bounds boundsOfRun(std::span<const glm::vec3> positions, int first, int count, float margin) {
  Bounds box = boundsOf(positions.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)));
  box.low -= margin;
  box.high += margin;
  return box;
}

inline bool reaches(const UnitBallMap& influence, const Bounds& box) {
  const glm::vec3 nearest = glm::clamp(influence.center, box.low, box.high);
  const glm::vec3 apart = influence.center - nearest;
  return glm::dot(apart, apart) < influence.boundingRadius * influence.boundingRadius;
}

}  // namespace carrier_walk

/// Calls visit(const CarriedVertex&, std::span<const CarrierCandidate> near) for every refined vertex of every carrier
/// that has at least one primitive within `margin` of its vertices' box; `near` holds those. Order is that of the
/// refined vertices. @param positions [V'] world.
template <class Visit>
void forEachReachable(const ControlMesh& mesh, const Refinement& refinement, const FieldView& field,
                      std::span<const glm::vec3> positions, float margin, Visit&& visit) {
  std::vector<CarrierCandidate> near;
  const auto gather = [&](int carrier, int first, int count) {
    near.clear();
    if (!field.skipped.empty() && field.skipped[static_cast<std::size_t>(carrier)]) return false;
    const std::span<const CarrierCandidate> all = field.lists->of(carrier);
    if (all.empty() || count == 0) return false;
    const Bounds box = carrier_walk::boundsOfRun(positions, first, count, margin);
    for (const CarrierCandidate& candidate : all) {
      const UnitBallMap& influence = field.primitives[static_cast<std::size_t>(candidate.primitive)].influence;
      if (carrier_walk::reaches(influence, box)) near.push_back(candidate);
    }
    return !near.empty();
  };
  const float n = static_cast<float>(refinement.depth);

  for (int v = 0; v < refinement.controlVertices; ++v) {
    if (gather(v, v, 1))
      visit(CarriedVertex{v, v, {v, v, v}, {1.0f, 0.0f, 0.0f}}, std::span<const CarrierCandidate>(near));
  }
  for (int e = 0; e < refinement.controlEdges; ++e) {
    const int carrier = refinement.controlVertices + e;
    if (refinement.edgeVertices == 0 || !gather(carrier, refinement.edgeVertex(e, 1), refinement.edgeVertices))
      continue;
    const auto& ends = mesh.edges[static_cast<std::size_t>(e)].vertices;
    for (int step = 1; step < refinement.depth; ++step) {
      const float w = static_cast<float>(step) / n;
      visit(CarriedVertex{refinement.edgeVertex(e, step), carrier, {ends[0], ends[1], ends[1]}, {1.0f - w, w, 0.0f}},
            std::span<const CarrierCandidate>(near));
    }
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const int carrier = refinement.controlVertices + refinement.controlEdges + t;
    if (!gather(carrier, refinement.interiorVertex(t, 0), refinement.interiorVertices)) continue;
    for (int i = 0; i < refinement.interiorVertices; ++i) {
      const auto& [j, k] = refinement.interior[static_cast<std::size_t>(i)];
      visit(CarriedVertex{refinement.interiorVertex(t, i),
                          carrier,
                          mesh.triangles[static_cast<std::size_t>(t)].vertices,
                          {static_cast<float>(refinement.depth - j - k) / n, static_cast<float>(j) / n,
                           static_cast<float>(k) / n}},
            std::span<const CarrierCandidate>(near));
    }
  }
}

}  // namespace sinew
