// core/include/sinew/character/character.h: a character imported from a file; read-only after import.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/animation_clip.h"
#include "sinew/character/body_part.h"
#include "sinew/character/material.h"
#include "sinew/character/mesh_part.h"
#include "sinew/character/skeleton.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/geometry/morph_target.h"

namespace sinew {

/// Control mesh + morph targets + skeleton + clips + materials. docs/design.md.
struct Character {
  std::string name;                       ///< File name without folder and ending.
  ControlMesh mesh;                       ///< With every morph target at 0.
  std::vector<MorphTarget> morphTargets;  ///< For each node in the order of its mesh.
  std::vector<MorphSet> morphSets;        ///< Expressions; their names differ from those of targets.
  Skeleton skeleton;
  std::vector<BodyPart> bodyParts;  ///< Each part at most once; empty if the file names none.
  std::vector<AnimationClip> clips;
  std::vector<Material> materials;  ///< At least one.
  std::vector<Texture> textures;
  std::vector<MeshPart> parts;       ///< For ControlTriangle::part, in file order.
  std::vector<std::string> ignored;  ///< Contents of the file that Sinew does not use, each with the reason.
  float height = 1.0f;               ///< H: y extent of the welded mesh in the bind pose (largest extent if flat); > 0.
};

}  // namespace sinew
