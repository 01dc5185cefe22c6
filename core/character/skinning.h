// core/character/skinning.h: linear blend skinning of the control mesh.
#pragma once

#include <span>
#include <vector>

#include "core/character/morphing.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

/// The control mesh in a pose. World space.
struct SkinnedMesh {
  std::vector<glm::vec3> positions;   ///< [V]
  std::vector<glm::vec3> normals;     ///< [V] unit.
  std::vector<glm::mat4> matrices{};  ///< [bindings] from the bind pose to the pose; empty if skin() did not make it.
  MorphedMesh morphed{};              ///< What was skinned.
};

/// Morph targets first (core/character/morphing.h); then each vertex follows the weighted sum of its bindings'
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
