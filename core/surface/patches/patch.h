// core/surface/patches/patch.h: curved patches over control triangles: positions and normals of refined vertices.
// An edge vertex depends on the two ends of its edge alone, taken in the edge's own direction, so no crack can open.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Arguments of evaluatePatches().
struct PatchInputs {
  PatchKind kind = PatchKind::kPn;
  const ControlMesh* mesh = nullptr;
  const Refinement* refinement = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<glm::vec3> outPositions;
  std::span<glm::vec3> outNormals;
};

/// Arguments of interpolateDirections().
struct DirectionInputs {
  const ControlMesh* mesh = nullptr;
  const Refinement* refinement = nullptr;
  std::span<const glm::vec3> control;
  std::span<glm::vec3> out;
};

/// Arguments of evaluateShading(). The kernel skips drawn vertices that no creased wedge reaches.
struct ShadingInputs {
  PatchKind kind = PatchKind::kPn;
  const ControlMesh* mesh = nullptr;
  const Refinement* refinement = nullptr;
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> wedgeNormals;
  std::span<glm::vec3> outNormals;
};

/// They fill the vertices on edges and inside triangles, an edge or triangle per lane, but not those at control
/// vertices and wedges. They allocate nothing.
struct PatchKernels {
  void (*patches)(const PatchInputs& inputs) = nullptr;
  void (*directions)(const DirectionInputs& inputs) = nullptr;
  void (*shading)(const ShadingInputs& inputs) = nullptr;
};

/// All sets give the same bits.  @param set  not kScalar; one that this machine runs.
[[nodiscard]] PatchKernels patchKernels(InstructionSet set);

/// Fills all refined vertices from skinned control vertices.
/// pn: cubic position, quadratic normal (Vlachos et al. 2001). phong: Boubekeur & Alexa 2008, alpha 3/4. spherigon:
/// Volino & Magnenat-Thalmann 1998, corner weights squared. flat: barycentric. All but pn interpolate normals
/// barycentrically.
/// @param positions, normals [V] world, normals unit.  @param outPositions, outNormals [V'] world, normals unit.
void evaluatePatches(PatchKind kind, const ControlMesh& mesh, const Refinement& refinement,
                     std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                     std::span<glm::vec3> outPositions, std::span<glm::vec3> outNormals);

/// Interpolates directions barycentrically; on an edge from its two ends alone.  @param control [V], out [V'] unit.
void interpolateDirections(const ControlMesh& mesh, const Refinement& refinement, std::span<const glm::vec3> control,
                           std::span<glm::vec3> out);

/// Interpolates values of the control vertices linearly.  @param control [V].  @param out [V'].
void interpolateValues(const ControlMesh& mesh, const Refinement& refinement, std::span<const float> control,
                       std::span<float> out);

/// Fills the normals of all drawn vertices by the same rules from the wedges' normals; vertices that no creased wedge
/// reaches keep the patch's normals. Between wedges of equal normals, drawn vertices get equal ones: no seam shows.
/// @param mesh creased (core/geometry/creases.h); its refinement.  @param positions [V] world.
/// @param wedgeNormals [W] world, unit.  @param patchNormals [V'] from evaluatePatches().
/// @param outNormals [D] world, unit.
void evaluateShading(PatchKind kind, const ControlMesh& mesh, const Refinement& refinement,
                     std::span<const glm::vec3> positions, std::span<const glm::vec3> wedgeNormals,
                     std::span<const glm::vec3> patchNormals, std::span<glm::vec3> outNormals);

}  // namespace sinew
