// core/character/skinning_kernel.h: linear blend skinning, a vertex a lane, by instruction set.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// What skinning.h passes to the kernel. All but `matrices` are [V]. Nothing is allocated.
struct SkinInputs {
  const ControlMesh* mesh = nullptr;
  std::span<const glm::mat4> matrices;    ///< [bindings] from the bind pose to the pose.
  std::span<const glm::vec3> positions;   ///< Bind pose; empty: not asked for.
  std::span<const glm::vec3> directions;  ///< Bind pose, unit; carried as normals are.
  std::span<glm::vec3> outPositions;      ///< [positions]
  std::span<glm::vec3> outDirections;     ///< Unit.
};

/// What skinWedgeNormals (skinning.h) passes: a wedge that is not creased keeps what `out` holds.
struct WedgeInputs {
  const ControlMesh* mesh = nullptr;
  std::span<const glm::mat4> matrices;
  std::span<const Wedge> wedges;                  ///< [W] theirs are the mesh's vertices.
  std::span<const glm::vec3> fanNormals;          ///< [fans] instead of a wedge's normal,
  const std::vector<bool>* fanChanged = nullptr;  ///< [fans] where true; null: nowhere.
  std::span<glm::vec3> out;                       ///< [W] unit.

  [[nodiscard]] const glm::vec3& normalOf(const Wedge& wedge) const {
    const auto fan = static_cast<std::size_t>(wedge.fan);
    return fanChanged != nullptr && (*fanChanged)[fan] ? fanNormals[fan] : wedge.normal;
  }
};

struct SkinKernels {
  void (*vertices)(const SkinInputs& inputs, std::size_t begin, std::size_t end) = nullptr;  ///< Of `directions`.
  void (*wedges)(const WedgeInputs& inputs) = nullptr;
};

/// All give the same bits.  @param set  not kScalar; one that this machine runs.
[[nodiscard]] SkinKernels skinKernels(InstructionSet set);

}  // namespace sinew
