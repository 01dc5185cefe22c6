// core/character/skinning_kernel.h: linear blend skinning with one vertex per SIMD lane, for each instruction set.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// Arguments for vertices. All but `matrices` are [V]. Nothing is allocated.
struct SkinInputs {
  const ControlMesh* mesh = nullptr;
  std::span<const glm::mat4> matrices;    ///< [bindings] from the bind pose to the pose.
  std::span<const glm::vec3> positions;   ///< Bind pose; empty: only directions.
  std::span<const glm::vec3> directions;  ///< Bind pose, unit; transformed as normals.
  std::span<glm::vec3> outPositions;      ///< [positions]
  std::span<glm::vec3> outDirections;     ///< Unit.
};

/// Arguments for wedges. Wedges that are not creased keep their value in `out`.
struct WedgeInputs {
  const ControlMesh* mesh = nullptr;
  std::span<const glm::mat4> matrices;
  std::span<const Wedge> wedges;                  ///< [W] with vertices of the mesh.
  std::span<const glm::vec3> fanNormals;          ///< [fans] replace the normals of wedges,
  const std::vector<bool>* fanChanged = nullptr;  ///< [fans] where this is true; null: nowhere.
  std::span<glm::vec3> out;                       ///< [W] unit.

  [[nodiscard]] const glm::vec3& normalOf(const Wedge& wedge) const {
    const auto fan = static_cast<std::size_t>(wedge.fan);
    return fanChanged != nullptr && (*fanChanged)[fan] ? fanNormals[fan] : wedge.normal;
  }
};

struct SkinKernels {
  void (*vertices)(const SkinInputs& inputs, std::size_t begin,
                   std::size_t end) = nullptr;  ///< A range of `directions`.
  void (*wedges)(const WedgeInputs& inputs) = nullptr;
};

/// The results do not depend on the set, bit for bit.  @param set  not kScalar; available on this machine.
[[nodiscard]] SkinKernels skinKernels(InstructionSet set);

}  // namespace sinew
