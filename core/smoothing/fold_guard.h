#pragma once  // core/smoothing/fold_guard.h: lifted skin must not turn inside out. docs/design.md, Folds.

#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/moved_triangles.h"

namespace sinew {

/// A patch in its pose.
struct PatchView {
  std::span<const glm::vec3> positions;  ///< [V'] world.
  std::span<const glm::vec3> normals;    ///< [V'] unit.
  std::span<const float> bindFronts;     ///< [T n^2] triangleFronts of the bind pose.
};

/// [T n^2] how much the refined triangles of a patch face along its normals: twice the area, along the mean of the
/// three normals, over the sum of the squared edges. 0.29 for a level equilateral triangle, less for thin ones, below 0
/// where the patch folds back.
[[nodiscard]] std::vector<float> triangleFronts(const Refinement& refinement, std::span<const glm::vec3> positions,
                                                std::span<const glm::vec3> normals);

/// Takes lifted skin back towards the patch where refined triangles turn over.
///
/// Where rise directions converge, a triangle's area as seen along the patch shrinks as it is lifted; below zero it
/// shows its back, a black slit. With q the lifted triangle's area over the patch's (signed, along the patch's face
/// normal), each triangle with q below 1/4 asks its corners to keep the share (3/4) / (1 - q) of their lift: what would
/// leave it 1/4 if its area fell evenly. It asks the less, the more the patch itself has squeezed it since the bind
/// pose (below 17 % of its front then), and nothing from 2 % on or where the patch folds back. A corner keeps the least
/// share it is asked for. That is repeated up to 32 times. Every round reads the one before alone, so the order of
/// triangles does not matter, and what a vertex keeps is a continuous function of all positions. An unmoved vertex
/// stays, and none is lifted further.
class FoldGuard {
 public:
  /// @param control  ascending: the control triangles that may ask; all that hold a moved vertex, or fewer.
  /// @param positions [V'] world, in and out.
  /// @return [V'] the share of its lift that each vertex kept, 1 where it was left alone; empty if all were. Valid
  /// until the next call.
  std::span<const float> apply(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control,
                               const PatchView& patch, std::span<glm::vec3> positions);

 private:
  [[nodiscard]] bool gather(const Refinement& refinement, std::span<const int> control, bool onlyLowered,
                            const PatchView& patch, std::span<const glm::vec3> positions);
  void lower(const PatchView& patch, std::span<glm::vec3> positions);
  void watchAround(const ControlMesh& mesh, std::span<const int> control);

  std::vector<float> kept_;       ///< [V'] of all rounds.
  std::vector<float> asked_;      ///< [V'] in this round; 1: nothing is asked.
  std::vector<int> asking_;       ///< Vertices with asked_ < 1.
  std::vector<int> lowered_;      ///< Vertices of the last round's asking_.
  std::vector<std::uint8_t> isLowered_;  ///< [V'] 1: in lowered_.
  std::vector<int> folding_;      ///< Control triangles that ask for something in this round.
  std::vector<int> watched_;      ///< Control triangles that may ask in the next one.
  std::vector<std::uint8_t> nearFolding_; ///< [V] control vertices of triangles that have ever asked.
};

}  // namespace sinew
