// core/include/sinew/character/mesh_part.h: a named part of the mesh: body, shirt, eyes.
#pragma once

#include <string>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// The triangles of one mesh of the file with one material, for each node that shows it.
struct MeshPart {
  std::string name;  ///< The mesh's, or the material's if the mesh has several; made unique. Not empty.
  int material = 0;  ///< Index into Character::materials.
};

}  // namespace sinew
