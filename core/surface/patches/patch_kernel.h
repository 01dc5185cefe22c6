// core/surface/patches/patch_kernel.h: patches, directions and the normals of creases, an edge or a control
// triangle a lane, by instruction set.
#pragma once

#include <span>

#include "core/geometry/instruction_set.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/refinement.h"

namespace sinew {

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

}  // namespace sinew
