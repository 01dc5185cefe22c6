// core/include/sinew/geometry/morph_target.h: shapes that a file blends into its mesh (glTF 2.0, section 3.7.2.2).
#pragma once

#include <string>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew {

/// What one morph target adds to the control mesh in the bind pose, before skinning: weight * delta. A target that a
/// file shows on several nodes is there once a node. Weights beyond 0..1 are legal.
struct MorphTarget {
  std::string name;           ///< Of mesh.extras.targetNames, else the node's name with a number. Need not be unique.
  int node = 0;               ///< Number in the file of the node that shows the mesh.
  float weight = 0.0f;        ///< Where neither clip nor rig says more: the node's, else the mesh's.
  std::vector<int> vertices;  ///< [M] control vertices that move, ascending.
  std::vector<glm::vec3> deltas;  ///< [M] bind pose, world space, character units; finite.
};

}  // namespace sinew
