// core/surface/workspace.h: memory for smoothing one surface after another. One per thread.
#pragma once

#include <span>
#include <vector>

#include "core/surface/face_culling.h"
#include "core/surface/finish/cloth_lift.h"
#include "core/surface/finish/crease_lift.h"
#include "core/surface/finish/fold.h"
#include "core/surface/finish/fold_spread.h"
#include "core/surface/finish/lifted_heights.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/shading_normals.h"
#include "core/surface/projection/projection_scratch.h"

namespace sinew {

/// Reused from pose to pose, so that a frame allocates nothing; never read before it is written in the same frame.
struct Workspace {
  std::vector<glm::vec3> patchPositions;  ///< [V'] world; the surface before projection.
  std::vector<glm::vec3> patchNormals;    ///< [V']
  std::vector<glm::vec3> wedgeNormals;
  FaceCulling culling;

  // Projection.
  std::vector<glm::vec3> controlRise;     ///< [V] `swell`: rise directions in the pose.
  std::vector<glm::vec3> rise;            ///< [V']
  std::vector<glm::vec3> flatPositions;   ///< [V'] `replace`: the mesh without elevation.
  std::vector<glm::vec3> flatNormals;     ///< [V']
  std::vector<glm::vec3> anchorsInWorld;  ///< [V']
  ProjectionScratch projection;

  // Folds and normals.
  MovedTriangles movedTriangles;
  std::vector<float> rawHeights;  ///< [V'] as projected.
  CreaseLift creaseLift;
  LiftedHeights liftedHeights;
  SlopeBound slopeBound;
  LiftFilter liftFilter;
  std::span<const float> filtered;  ///< [V'] weights of liftFilter.
  VertexPairs pairs;                ///< Corners of movedTriangles, as the last stage left them.
  FoldRegion foldRegion;
  FoldMesh foldMesh;
  FoldSpread foldSpread;
  ClothLift clothLift;
  ShadingNormals shadingNormals;
};

}  // namespace sinew
