// core/smoothing/projection/projection_scratch.h: memory that projection keeps from frame to frame.
#pragma once

#include <vector>

#include "core/blending/field.h"
#include "core/smoothing/projection/carrier_walk.h"
#include "core/smoothing/roots/lane_terms.h"
#include "core/smoothing/roots/ray_field.h"

namespace sinew {

/// Reused from vertex to vertex and from frame to frame, so that nothing is allocated once it has grown. Its contents
/// carry nothing from one frame to the next. One a thread.
struct ProjectionScratch {
  WalkScratch walk;
  std::vector<Candidate> candidates;
  FieldScratch field;
  RayField ray;
  RayScratch roots;
  LaneScratch lanes;
  std::vector<int> nearInTile;
  std::vector<int> uncertified;  ///< Vertices that the vector path left to the scalar one in the last frame.
  std::vector<int> shaped;       ///< Those it did not look at, near primitives that are no ellipsoids.
};

}  // namespace sinew
