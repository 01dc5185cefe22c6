// core/surface/projection/candidates.h: primitives that pieces of the mesh can see; a walk over reached vertices.
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
#include "core/rig/posed_cliques.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// A primitive with its territory weights m_i at a carrier's corners; unused corners hold 0.
struct CarrierCandidate {
  int primitive = 0;
  int slot = 0;  ///< See Candidate::slot.
  std::array<float, 3> weights{};

  friend bool operator==(const CarrierCandidate&, const CarrierCandidate&) = default;
  /// m_i at barycentric coordinates of the carrier.
  [[nodiscard]] float weightAt(const std::array<float, 3>& barycentric) const {
    return weights[0] * barycentric[0] + weights[1] * barycentric[1] + weights[2] * barycentric[2];
  }
};

/// How the groups at some carriers blend.
struct CliqueSet {
  CliqueLevels drawn;  ///< Of the links' amounts as drawn. Empty: all groups add up.
  AnimatedCliques animated;
};

/// Candidate lists per carrier: control vertices first, then edges (corners: smaller vertex, larger), then triangles.
/// The vertices on an edge use the edge's own list, whichever triangle they are seen from: no crack can open.
struct CandidateLists {
  std::vector<int> begin;  ///< [V+E+T+1]
  std::vector<CarrierCandidate> items;
  std::vector<int> cliqueSet;         ///< [V+E+T] index into cliqueSets.
  std::vector<CliqueSet> cliqueSets;  ///< In [0] all groups add up.
  CliqueSizes most;                   ///< Of any set as drawn.

  [[nodiscard]] std::span<const CarrierCandidate> of(int carrier) const {
    const int first = at(begin, carrier);
    return std::span(items).subspan(toIndex(first), toIndex(at(begin, carrier + 1) - first));
  }
};

/// The clique sets of some lists for the amounts that links have in a pose. Keeps its memory.
class PosedCliqueSets {
 public:
  /// @param amounts  [Rig::links]
  void pose(const CandidateLists& lists, std::span<const float> amounts);

  [[nodiscard]] CliqueLevelsView of(int set) const { return at(views_, set); }
  [[nodiscard]] const CliqueSizes& most() const { return most_; }  ///< Of any set.

 private:
  std::vector<PosedCliques> sets_;
  std::vector<CliqueLevelsView> views_;
  CliqueGrowth growth_;
  CliqueSizes most_;
};

/// Carriers see the same and have the same sets; the cliques of these may differ.
[[nodiscard]] bool sameSeen(const CandidateLists& a, const CandidateLists& b);

/// @param layers  pieces that are not skin see nothing; null: all is skin
[[nodiscard]] CandidateLists makeCandidateLists(const ControlMesh& mesh, const Attachment& attachment,
                                                const MeshLayers* layers = nullptr);

/// The same lists with other links.  @param attachment  of the same places
[[nodiscard]] CandidateLists relinked(const CandidateLists& lists, const Attachment& attachment);

/// The lists without the hidden primitives, whose indices stay in use: slots and cliques are those of the remaining
/// groups. Does not read territories again.  @param hidden [A]
[[nodiscard]] CandidateLists withoutHidden(const CandidateLists& lists, const Attachment& attachment,
                                           const std::vector<bool>& hidden);

/// A refined vertex and its coordinates in its carrier: a control vertex, edge or triangle.
struct CarriedVertex {
  int index = 0;                       ///< Refined vertex.
  int carrier = 0;                     ///< As in CandidateLists.
  std::array<int, 3> corners{};        ///< Control vertices; corners[2] repeats on edges, all repeat on vertices.
  std::array<float, 3> barycentric{};  ///< Weights of the corners; unused ones are 0.
};

[[nodiscard]] inline CarriedVertex controlCarried(int v) { return {v, v, {v, v, v}, {1.0f, 0.0f, 0.0f}}; }
[[nodiscard]] CarriedVertex edgeCarried(const ControlMesh& mesh, const Refinement& refinement, int edge, int vertex);
[[nodiscard]] CarriedVertex insideCarried(const ControlMesh& mesh, const Refinement& refinement, int triangle,
                                          int vertex);
/// Finds the carrier first.
[[nodiscard]] CarriedVertex carriedVertex(const ControlMesh& mesh, const Refinement& refinement, int vertex);

/// Posed primitives and the carriers that may see them.
struct FieldView {
  std::span<const PosedPrimitive> primitives;
  const CandidateLists* lists = nullptr;
  std::span<const std::uint8_t> skipped = {};  ///< [V+E+T] 1: leave this carrier out (face_culling.h); or empty.
  const PosedCliqueSets* posedSets = nullptr;  ///< Null: links have the amounts as drawn.

  [[nodiscard]] CliqueLevelsView cliquesIn(int set) const {
    return posedSets ? posedSets->of(set) : CliqueLevelsView(at(lists->cliqueSets, set).drawn);
  }
  [[nodiscard]] CliqueLevelsView cliquesOf(int carrier) const { return cliquesIn(at(lists->cliqueSet, carrier)); }
};

namespace carrier_walk {

/// Gap between a ball and a box (< 0: they overlap), and distance of the ball's far side from the box.
struct Span {
  float gap = 0.0f;
  float farthest = 0.0f;
};

inline Span spanTo(const UnitBallMap& influence, const Bounds& box) {
  const float apart = glm::distance(influence.center, glm::clamp(influence.center, box.low, box.high));
  return {apart - influence.boundingRadius, apart + influence.boundingRadius};
}

/// Extent from the box of the influences connected, through each other, with one that overlaps it; 0 if none does. A
/// ray from the box leaves all of these before it meets any other.
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

/// Memory reused from walk to walk.
struct WalkScratch {
  std::vector<CarrierCandidate> near;
  std::vector<carrier_walk::Span> spans;
};

/// Primitives that a walk considers.
enum class Reach {
  kOverlapping,  ///< Those whose influence overlaps the carrier, and those connected with them.
  kAll,          ///< All candidates of the carrier.
};

/// Part `index` of `of` equal parts of the control vertices, edges and triangles.
struct WalkShare {
  std::size_t index = 0;
  std::size_t of = 1;

  [[nodiscard]] int begin(int count) const { return static_cast<int>(toIndex(count) * index / of); }
  [[nodiscard]] int end(int count) const { return static_cast<int>(toIndex(count) * (index + 1) / of); }
};

/// Calls visit(const CarriedVertex&, std::span<const CarrierCandidate> near), in order, for every refined vertex in
/// the share whose carrier has primitives to consider: `near`.  @param positions [V'] world.
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
    const Bounds box = boundsOf(positions.subspan(toIndex(first), toIndex(count)));
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

  const auto visitCarrier = [&](int carrier, int first, int count, auto carried) {
    if (!gather(carrier, first, count)) return;
    for (int v = first; v < first + count; ++v) visit(carried(v), near);
  };
  for (int v = share.begin(refinement.controlVertices); v < share.end(refinement.controlVertices); ++v) {
    visitCarrier(v, v, 1, controlCarried);
  }
  for (int e = share.begin(refinement.controlEdges); e < share.end(refinement.controlEdges); ++e) {
    visitCarrier(refinement.controlVertices + e, refinement.edgeVertex(e, 1), refinement.edgeVertices(e),
                 [&](int v) { return edgeCarried(mesh, refinement, e, v); });
  }
  const int triangles = static_cast<int>(mesh.triangles.size());
  for (int t = share.begin(triangles); t < share.end(triangles); ++t) {
    visitCarrier(refinement.controlVertices + refinement.controlEdges + t, at(refinement.insideBegin, t),
                 refinement.insideVertices(t), [&](int v) { return insideCarried(mesh, refinement, t, v); });
  }
}

}  // namespace sinew
