// core/include/sinew/mesh/mesh_part.h: skin, clothes and what is rigid: parts of a mesh, as the file divides it.
#pragma once

#include <string>

namespace sinew {

/// What muscles do to a part of the mesh.
enum class Layer {
  kSkin,   ///< They move it.
  kCloth,  ///< It goes with the skin below it and never sinks in.
  kRigid,  ///< They leave it alone: eyes, teeth, a helmet.
};

/// One mesh of the file with one material: a shirt, the eyes.
struct MeshPart {
  std::string name;            ///< Unique within the character, not empty.
  Layer layer = Layer::kSkin;  ///< As guessed from shape and name; a rig may say otherwise (Rig::layers).
};

}  // namespace sinew
