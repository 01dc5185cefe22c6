// core/surface/projection/projection_scratch.h: memory that projection keeps from frame to frame.
#pragma once

#include <algorithm>
#include <vector>

#include "core/rig/field.h"
#include "core/surface/projection/candidates.h"
#include "core/surface/roots/lane_terms.h"
#include "core/surface/roots/ray_field.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// What is found out about some vertices.
struct VertexCounts {
  int projected = 0;
  int unresolved = 0;
  int anchorFallbacks = 0;
  double residualMax = 0.0;
};

/// For vertices one after the other.
struct VertexScratch {
  WalkScratch walk;
  std::vector<Candidate> candidates;
  FieldScratch field;
  RayField ray;
  RayScratch roots;
  VertexCounts counts;
};

/// For the tiles of one range.
struct TileScratch {
  VertexCounts counts;
  VertexScratch vertices;  ///< For those that the vector path leaves to the scalar one.
  LaneScratch lanes;
  std::vector<LaneTerm> lines;  ///< In `replace`: along each vertex's line, in both directions.
  std::vector<int> near;        ///< Has room for the tile with the most candidates.
  std::vector<carrier_walk::Span> spans;
  std::vector<int> uncertified;  ///< Vertices whose first root the vector path cannot vouch for; as many fit.
};

/// Reused from vertex to vertex and from frame to frame, so that nothing is allocated once it has grown. Its contents
/// carry nothing from one frame to the next. One a surface that is being made: what it starts with is for the thread
/// that calls.
struct ProjectionScratch : VertexScratch {
  std::vector<float> omega;           ///< [V'] in `replace`.
  std::vector<VertexScratch> shares;  ///< Scratch of the parts that a frame's vertices are divided into.
  std::vector<TileScratch> tiles;     ///< Scratch of the ranges that a frame's tiles are divided into.
};

inline void add(const VertexCounts& part, VertexCounts& sum) {
  sum.projected += part.projected;
  sum.unresolved += part.unresolved;
  sum.anchorFallbacks += part.anchorFallbacks;
  sum.residualMax = std::max(sum.residualMax, part.residualMax);
}

/// Adds what has been found out to a frame's report.
inline void tell(const VertexScratch& scratch, SmoothingReport& report) {
  report.projected += scratch.counts.projected;
  report.unresolved += scratch.counts.unresolved;
  report.anchorFallbacks = scratch.counts.anchorFallbacks;
  report.residualMax = std::max(report.residualMax, scratch.counts.residualMax);
}

}  // namespace sinew
