// core/surface/projection/candidates.h: which primitives each piece of the control mesh can ever see.
// Made once per edit.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/rig/attachment.h"
#include "core/rig/field.h"
#include "core/rig/mesh_layers.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// A primitive with its territory weights m_i at a carrier's corners; unused corners hold 0.
struct CarrierCandidate {
  int primitive = 0;
  int slot = 0;  ///< See Candidate::slot.
  std::array<float, 3> weights{};

  /// m_i at barycentric coordinates of the carrier.
  [[nodiscard]] float weightAt(const std::array<float, 3>& barycentric) const {
    return weights[0] * barycentric[0] + weights[1] * barycentric[1] + weights[2] * barycentric[2];
  }
};

/// Candidate lists per carrier: control vertices first, then edges (corners: smaller vertex, larger), then triangles.
/// Both triangles at an edge see its refined vertices through the edge's own list: the surface cannot crack there.
struct CandidateLists {
  std::vector<int> begin;  ///< [V+E+T+1]
  std::vector<CarrierCandidate> items;
  std::vector<int> cliqueSet;           ///< [V+E+T] index into cliqueSets.
  std::vector<CliqueLists> cliqueSets;  ///< [0] is empty: everything sums.

  [[nodiscard]] std::span<const CarrierCandidate> of(int carrier) const {
    const auto c = static_cast<std::size_t>(carrier);
    return std::span(items).subspan(static_cast<std::size_t>(begin[c]),
                                    static_cast<std::size_t>(begin[c + 1] - begin[c]));
  }
  [[nodiscard]] const CliqueLists& cliquesOf(int carrier) const { return at(cliqueSets, at(cliqueSet, carrier)); }
};

/// @param layers  pieces that are not skin see nothing; null: all is skin
[[nodiscard]] CandidateLists makeCandidateLists(const ControlMesh& mesh, const Attachment& attachment,
                                                const MeshLayers* layers = nullptr);

/// The lists as they would be without some primitives, which keep their indices: slots and cliques are those of the
/// groups that are left. Reads no territory anew.
/// @param hidden [A]
[[nodiscard]] CandidateLists withoutHidden(const CandidateLists& lists, const Attachment& attachment,
                                           const std::vector<bool>& hidden);

// Visits the refined vertices that a primitive can reach in this pose.

/// A refined vertex with what its carrier (control vertex, edge or triangle) lends it.
struct CarriedVertex {
  int index = 0;                       ///< Refined vertex.
  int carrier = 0;                     ///< As in CandidateLists.
  std::array<int, 3> corners{};        ///< Control vertices; corners[2] repeats on edges, all repeat on vertices.
  std::array<float, 3> barycentric{};  ///< Weights of the corners; unused ones are 0.
};

/// What an edge lends a refined vertex between its ends, a control triangle one inside it, and any piece any vertex
/// (which has to be found first).
[[nodiscard]] CarriedVertex edgeCarried(const ControlMesh& mesh, const Refinement& refinement, int edge, int vertex);
[[nodiscard]] CarriedVertex insideCarried(const ControlMesh& mesh, const Refinement& refinement, int triangle,
                                          int vertex);
[[nodiscard]] CarriedVertex carriedVertex(const ControlMesh& mesh, const Refinement& refinement, int vertex);

/// Posed primitives and the lists that say who may see them.
struct FieldView {
  std::span<const PosedPrimitive> primitives;
  const CandidateLists* lists = nullptr;
  std::span<const std::uint8_t> skipped = {};  ///< [V+E+T] 1: this carrier is not asked for (face_culling.h); or empty.
};

namespace carrier_walk {

/// Where a ball stands to a box: how far the gap between them is (< 0: they overlap) and how far its far side.
struct Span {
  float gap = 0.0f;
  float farthest = 0.0f;
};

inline Span spanTo(const UnitBallMap& influence, const Bounds& box) {
  const float apart = glm::distance(influence.center, glm::clamp(influence.center, box.low, box.high));
  return {apart - influence.boundingRadius, apart + influence.boundingRadius};
}

/// How far from the box the influences go that hang together with one that overlaps it; 0 if none does. A ray that
/// starts in the box meets no others before it is out of all influence.
inline float extentOf(std::span<const Span> spans) {
  float extent = 0.0f;
  for (bool grew = true; grew;) {
    grew = false;
    for (const Span& span : spans) {
      if (span.gap >= extent || span.farthest <= extent) continue;
      extent = span.farthest;
      grew = true;
    }
  }
  return extent;
}

}  // namespace carrier_walk

/// Memory that is reused from walk to walk.
struct WalkScratch {
  std::vector<CarrierCandidate> near;
  std::vector<carrier_walk::Span> spans;
};

/// Which primitives a walk asks for.
enum class Reach {
  kOverlapping,  ///< Carriers that some influence overlaps; with it come those it hangs together with.
  kAll,          ///< Every candidate, wherever it is.
};

/// One of so many equal parts, of control vertices, edges and triangles alike.
struct WalkShare {
  std::size_t index = 0;
  std::size_t of = 1;

  [[nodiscard]] int begin(int count) const { return static_cast<int>(toIndex(count) * index / of); }
  [[nodiscard]] int end(int count) const { return static_cast<int>(toIndex(count) * (index + 1) / of); }
};

/// Calls visit(const CarriedVertex&, std::span<const CarrierCandidate> near) for every refined vertex of every carrier
/// of the share that has a primitive to ask for; `near` holds those. Order is that of the refined vertices.
/// @param positions [V'] world.
template <class Visit>
void forEachReachable(const ControlMesh& mesh, const Refinement& refinement, const FieldView& field,
                      std::span<const glm::vec3> positions, Reach reach, const WalkShare& share, WalkScratch& scratch,
                      Visit&& visit) {
  std::vector<CarrierCandidate>& near = scratch.near;
  std::vector<carrier_walk::Span>& spans = scratch.spans;
  const auto gather = [&](int carrier, int first, int count) {
    near.clear();
    if (!field.skipped.empty() && at(field.skipped, carrier)) return false;
    const std::span<const CarrierCandidate> all = field.lists->of(carrier);
    if (all.empty() || count == 0) return false;
    if (reach == Reach::kAll) {
      near.assign(all.begin(), all.end());
      return true;
    }
    const Bounds box = boundsOf(positions.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)));
    spans.clear();
    for (const CarrierCandidate& candidate : all) {
      spans.push_back(carrier_walk::spanTo(at(field.primitives, candidate.primitive).influence, box));
    }
    const float extent = carrier_walk::extentOf(spans);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (spans[i].gap < extent) near.push_back(all[i]);
    }
    return !near.empty();
  };

  for (int v = share.begin(refinement.controlVertices); v < share.end(refinement.controlVertices); ++v) {
    if (gather(v, v, 1))
      visit(CarriedVertex{v, v, {v, v, v}, {1.0f, 0.0f, 0.0f}}, std::span<const CarrierCandidate>(near));
  }
  for (int e = share.begin(refinement.controlEdges); e < share.end(refinement.controlEdges); ++e) {
    const int carrier = refinement.controlVertices + e;
    const int first = refinement.edgeVertex(e, 1);
    const int count = refinement.edgeVertices(e);
    if (!gather(carrier, first, count)) continue;
    for (int v = first; v < first + count; ++v) {
      visit(edgeCarried(mesh, refinement, e, v), std::span<const CarrierCandidate>(near));
    }
  }
  const int triangles = static_cast<int>(mesh.triangles.size());
  for (int t = share.begin(triangles); t < share.end(triangles); ++t) {
    const int carrier = refinement.controlVertices + refinement.controlEdges + t;
    const int first = at(refinement.insideBegin, t);
    const int count = refinement.insideVertices(t);
    if (!gather(carrier, first, count)) continue;
    for (int v = first; v < first + count; ++v) {
      visit(insideCarried(mesh, refinement, t, v), std::span<const CarrierCandidate>(near));
    }
  }
}

}  // namespace sinew
