// core/surface/projection/projection_scratch.h: memory that projection reuses from frame to frame.
#pragma once

#include <algorithm>
#include <vector>

#include "core/rig/field.h"
#include "core/surface/projection/candidates.h"
#include "core/surface/roots/lane_terms.h"
#include "core/surface/roots/ray_field.h"
#include "sinew/surface/surface.h"

namespace sinew {

struct VertexCounts {
  int projected = 0;
  int unresolved = 0;
  int anchorFallbacks = 0;
  double residualMax = 0.0;
};

/// For vertices one by one.
struct VertexScratch {
  WalkScratch walk;
  std::vector<Candidate> candidates;
  FieldScratch field;
  RayField ray;
  RayScratch roots;
  VertexCounts counts;
};

/// For a range of tiles.
struct TileScratch {
  VertexCounts counts;
  VertexScratch vertices;  ///< For vertices that the vector path leaves to the scalar path.
  LaneScratch lanes;
  std::vector<LaneTerm> lines;  ///< In `replace`: along each vertex's line, in both directions.
  std::vector<int> near;        ///< Fits the tile with the most candidates.
  std::vector<carrier_walk::Span> spans;
  std::vector<int> uncertified;  ///< Vertices whose first root the vector path cannot certify. All vertices fit.
};

/// Reused from frame to frame for its memory alone. One per surface in the making; the base is for the calling thread.
struct ProjectionScratch : VertexScratch {
  std::vector<float> omega;           ///< [V'] in `replace`.
  std::vector<VertexScratch> shares;  ///< For the parts of a frame's vertices.
  std::vector<TileScratch> tiles;     ///< For the ranges of a frame's tiles.
};

/// Fills scratch.candidates with those of `near` that have weight at a vertex.
inline void gatherCandidates(const CarriedVertex& vertex, std::span<const CarrierCandidate> near,
                             VertexScratch& scratch) {
  scratch.candidates.clear();
  for (const CarrierCandidate& candidate : near) {
    const float weight = candidate.weightAt(vertex.barycentric);
    if (weight > 0.0f) scratch.candidates.push_back({candidate.primitive, weight, candidate.slot});
  }
}

inline void add(const VertexCounts& part, VertexCounts& sum) {
  sum.projected += part.projected;
  sum.unresolved += part.unresolved;
  sum.anchorFallbacks += part.anchorFallbacks;
  sum.residualMax = std::max(sum.residualMax, part.residualMax);
}

inline void addToReport(const VertexCounts& counts, SmoothingReport& report) {
  report.projected += counts.projected;
  report.unresolved += counts.unresolved;
  report.anchorFallbacks = counts.anchorFallbacks;
  report.residualMax = std::max(report.residualMax, counts.residualMax);
}

}  // namespace sinew
