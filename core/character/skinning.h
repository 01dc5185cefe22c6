// core/character/skinning.h: linear blend skinning of the control mesh.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

// The control mesh with its morph targets at some weights, in the bind pose.

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

/// The control mesh in a pose. World space.
struct SkinnedMesh {
  std::vector<glm::vec3> positions;   ///< [V]
  std::vector<glm::vec3> normals;     ///< [V] unit.
  std::vector<glm::mat4> matrices{};  ///< [bindings] from the bind pose to the pose; empty if skin() did not make it.
  MorphedMesh morphed{};              ///< What was skinned.
};

/// Morph targets first (core/character/skinning.h); then each vertex follows the weighted sum of its bindings'
/// matrices, its normal the inverse transpose of that sum. In the bind pose, with all targets at 0, the result is the
/// control mesh itself to rounding. Reuses the output's memory, so that one output goes with one character.
/// @param morphWeights [targets] or empty: as in the file.
void skin(const Character& character, const Pose& pose, std::span<const float> morphWeights, SkinnedMesh& out);
/// The same with the pose's own weights.
void skin(const Character& character, const Pose& pose, SkinnedMesh& out);

/// Other directions of the control vertices in the same pose, carried as normals are.
/// @param bind [V] bind pose, unit.  @param skinned as skin() made it.  @param out [V] world, unit; its memory is
/// reused.
void skinDirections(const Character& character, std::span<const glm::vec3> bind, const SkinnedMesh& skinned,
                    std::vector<glm::vec3>& out);

/// The normals of all wedges in the same pose: a creased wedge's own goes as its vertex's does, any other is its
/// vertex's.
/// @param wedges [W] of a mesh with the character's vertices (mesh/creases.h).  @param skinned as skin() made it; where
/// targets move something, with the fans of these wedges (morphFans).  @param out [W] world, unit; its memory is
/// reused.
void skinWedgeNormals(const Character& character, std::span<const Wedge> wedges, const SkinnedMesh& skinned,
                      std::vector<glm::vec3>& out);

}  // namespace sinew
