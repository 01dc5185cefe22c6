// core/include/sinew/geometry/morph_target.h: morph targets (glTF 2.0, section 3.7.2.2).
#pragma once

#include <string>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew {

/// Adds weight * delta to the control mesh in the bind pose, before skinning. A target of a mesh on several nodes
/// exists once for each. Weights beyond 0..1 are legal.
struct MorphTarget {
  std::string name;           ///< From mesh.extras.targetNames, else the node's name with a number. Need not be unique.
  int node = 0;               ///< Index in the file of the node with the mesh.
  float weight = 0.0f;        ///< Default weight: the node's, else the mesh's.
  std::vector<int> vertices;  ///< [M] control vertices that move, ascending.
  std::vector<glm::vec3> deltas;  ///< [M] bind pose, world space, character units; finite.
};

}  // namespace sinew
