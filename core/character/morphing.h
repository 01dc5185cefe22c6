// core/character/morphing.h: the control mesh with its morph targets at some weights, in the bind pose.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/character.h"

namespace sinew {

/// Positions and normals that stand in for the mesh's while targets move something. Remembers the weights it was made
/// with, so that weights that stay cost nothing: one object goes with one character.
struct MorphedMesh {
  bool isMorphed = false;             ///< Else the mesh's own hold, and the two lists do not.
  std::vector<glm::vec3> positions;   ///< [V] bind pose, world.
  std::vector<glm::vec3> normals;     ///< [V] unit: the mesh's own, to the bit, where no face beside has changed.
  std::vector<bool> changed;          ///< [T] faces with a corner that has moved.
  std::vector<float> madeWith;        ///< [targets] weights; what the lists are made with.
  std::vector<glm::vec3> fanNormals;  ///< [fans] of creased wedges (morphFans).
  std::vector<bool> fanChanged;       ///< [fans]
  bool fansMade = false;
};

/// As an import of the file would give it with its base positions so changed, welded as the base is: v = v0 + sum of
/// w dv, normals by the angles of the faces.
/// @param weights [targets] finite.
void morph(const Character& character, std::span<const float> weights, MorphedMesh& out);

/// The normals of creased wedges (mesh/creases.h) whose faces have changed, bind pose. Which edges are creases is
/// that of the base.
/// @param creased  a mesh with the character's vertices.  @param morphed  by morph; its fan lists are filled.
void morphFans(const ControlMesh& creased, MorphedMesh& morphed);

/// What targets weigh in a pose. @param weights [targets] or empty: as in the file.
[[nodiscard]] std::vector<float> morphWeightsOr(const Character& character, std::span<const float> weights);

}  // namespace sinew
