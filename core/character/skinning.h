// core/character/skinning.h: morph targets and linear blend skinning of the control mesh.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

/// The control mesh with morph targets, bind pose. Unchanged weights cost nothing; use one object for one character.
struct MorphedMesh {
  bool isMorphed = false;             ///< False: the mesh's own positions and normals apply.
  std::vector<glm::vec3> positions;   ///< [V] bind pose, world.
  std::vector<glm::vec3> normals;     ///< [V] unit; bit for bit the mesh's own where no adjacent face has changed.
  std::vector<bool> changed;          ///< [T] faces with a corner that has moved.
  std::vector<float> madeWith;        ///< [targets] weights of these lists.
  std::vector<glm::vec3> fanNormals;  ///< [fans] of creased wedges (morphFans).
  std::vector<bool> fanChanged;       ///< [fans]
  bool fansMade = false;
};

/// v = v0 + sum of w dv, with angle-weighted normals, as if imported with these base positions, but welded as the base.
/// @param weights [targets] finite.
void morph(const Character& character, std::span<const float> weights, MorphedMesh& out);

/// The normals of creased wedges (core/geometry/normals.h) whose faces have changed, bind pose. Creases stay those of
/// the base.
/// @param creased  a mesh with the character's vertices.  @param morphed  by morph(); its fan lists are filled.
void morphFans(const ControlMesh& creased, MorphedMesh& morphed);

/// Weights of all targets. @param weights [targets] or empty: as in the file.
[[nodiscard]] std::vector<float> morphWeightsOr(const Character& character, std::span<const float> weights);

/// The control mesh in a pose. World space.
struct SkinnedMesh {
  std::vector<glm::vec3> positions;   ///< [V]
  std::vector<glm::vec3> normals;     ///< [V] unit.
  std::vector<glm::mat4> matrices{};  ///< [bindings] from the bind pose to the pose; empty if not made by skin().
  MorphedMesh morphed{};              ///< The mesh before skinning.
};

/// Applies morph targets, then transforms each vertex by the weighted sum of its bindings' matrices and its normal by
/// the inverse transpose of that sum. In the bind pose with all targets at 0 the result is the control mesh up to
/// rounding. Reuses the output's memory; use one output for one character.
/// @param morphWeights [targets] or empty: as in the file.
void skin(const Character& character, const Pose& pose, std::span<const float> morphWeights, SkinnedMesh& out);
void skin(const Character& character, const Pose& pose, SkinnedMesh& out);  ///< The same with the pose's own weights.

/// Transforms other directions of the control vertices to the same pose, as normals.
/// @param bind [V] bind pose, unit.  @param skinned by skin().  @param out [V] world, unit; its memory is reused.
void skinDirections(const Character& character, std::span<const glm::vec3> bind, const SkinnedMesh& skinned,
                    std::vector<glm::vec3>& out);

/// The normals of all wedges in the same pose: their own for creased wedges, else those of their vertices.
/// @param wedges [W] of a mesh with the character's vertices.  @param skinned by skin(); if morphed, with the fans of
/// these wedges (morphFans).  @param out [W] world, unit; its memory is reused.
void skinWedgeNormals(const Character& character, std::span<const Wedge> wedges, const SkinnedMesh& skinned,
                      std::vector<glm::vec3>& out);

}  // namespace sinew
