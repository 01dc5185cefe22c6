// core/surface/patches/patch.h: curved patches over control triangles: position and normal of refined vertices.
//
// An edge vertex is computed from its edge's two ends alone, in the edge's own direction: no cracks by construction.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/refinement.h"

namespace sinew {

// Patches, directions and the normals of creases, an edge or a control
// triangle a lane, by instruction set.

/// The arguments of evaluatePatches (patch.h).
struct PatchInputs {
  PatchKind kind = PatchKind::kPn;
  const ControlMesh* mesh = nullptr;
  const Refinement* refinement = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<glm::vec3> outPositions;
  std::span<glm::vec3> outNormals;
};

/// The arguments of interpolateDirections.
struct DirectionInputs {
  const ControlMesh* mesh = nullptr;
  const Refinement* refinement = nullptr;
  std::span<const glm::vec3> control;
  std::span<glm::vec3> out;
};

/// The arguments of evaluateShading; drawn vertices that no creased wedge reaches are left as they are.
struct ShadingInputs {
  PatchKind kind = PatchKind::kPn;
  const ControlMesh* mesh = nullptr;
  const Refinement* refinement = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> wedgeNormals;
  std::span<glm::vec3> outNormals;
};

/// All fill the vertices on edges and inside triangles; places of control vertices and wedges are left as they are.
/// Nothing is allocated.
struct PatchKernels {
  void (*patches)(const PatchInputs& inputs) = nullptr;
  void (*directions)(const DirectionInputs& inputs) = nullptr;
  void (*shading)(const ShadingInputs& inputs) = nullptr;
};

/// All give the same bits.  @param set  not kScalar; one that this machine runs.
[[nodiscard]] PatchKernels patchKernels(InstructionSet set);

/// Fills all refined vertices from skinned control vertices.
/// pn: cubic position, quadratic normal (Vlachos et al. 2001). phong: Boubekeur & Alexa 2008, alpha 3/4. spherigon:
/// Volino & Magnenat-Thalmann 1998, corner weights squared. flat: barycentric; for all but pn the normal is barycentric
/// too.
/// @param positions, normals [V] world, normals unit.  @param outPositions, outNormals [V'] world, normals unit.
void evaluatePatches(PatchKind kind, const ControlMesh& mesh, const Refinement& refinement,
                     std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                     std::span<glm::vec3> outPositions, std::span<glm::vec3> outNormals);

/// Directions of control vertices at all refined vertices: barycentric and renormalized, along an edge from its two
/// ends alone. @param control [V] unit.  @param out [V'] unit.
void interpolateDirections(const ControlMesh& mesh, const Refinement& refinement, std::span<const glm::vec3> control,
                           std::span<glm::vec3> out);

/// Interpolates values of the control vertices linearly.  @param control [V].  @param out [V'].
void interpolateValues(const ControlMesh& mesh, const Refinement& refinement, std::span<const float> control,
                       std::span<float> out);

/// Fills the normals of all drawn vertices by the same rules from the wedges' normals; what no creased wedge reaches
/// keeps the patch's. Drawn vertices between wedges of equal normals get equal ones: no seam shows.
/// @param mesh creased (mesh/creases.h); the refinement is of it.  @param positions [V] world.
/// @param wedgeNormals [W] world, unit.  @param patchNormals [V'] as evaluatePatches made them.
/// @param outNormals [D] world, unit.
void evaluateShading(PatchKind kind, const ControlMesh& mesh, const Refinement& refinement,
                     std::span<const glm::vec3> positions, std::span<const glm::vec3> wedgeNormals,
                     std::span<const glm::vec3> patchNormals, std::span<glm::vec3> outNormals);

}  // namespace sinew
