// core/smoothing/finish/fold_guard.h: lifted skin must not turn inside out. docs/design.md, Folds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/finish/fold.h"
#include "core/smoothing/finish/fold_watch.h"

namespace sinew {

/// Takes lifted skin back towards the patch where refined triangles turn over.
///
/// Where rise directions converge, a triangle's area as seen along the patch shrinks as it is lifted; below zero it
/// shows its back, a black slit. Each triangle with q below 1/4 (fold.h) asks its corners to keep the share
/// (3/4) / (1 - q) of their lift: what would leave it 1/4 if its area fell evenly. What it asks is weighted by how far
/// q can be trusted. A corner keeps the least share it is asked for. That is repeated up to 64 times. Every round reads
/// the one before alone, so the order of triangles does not matter, and what a vertex keeps is a continuous function of
/// all positions. An unmoved vertex stays, and none is lifted further.
class FoldGuard {
 public:
  /// @param control  ascending: the control triangles that may ask; all that hold a moved vertex, or fewer.
  /// @param positions [V'] world, in and out.
  /// @return [V'] the share of its lift that each vertex kept, 1 where it was left alone; empty if all were. Valid
  /// until the next call.
  std::span<const float> apply(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control,
                               const PatchView& patch, std::span<glm::vec3> positions);

 private:
  [[nodiscard]] bool gather(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control,
                            bool onlyLowered, const PatchView& patch, std::span<const glm::vec3> positions);
  void lower(const PatchView& patch, std::span<glm::vec3> positions);

  std::vector<float> kept_;              ///< [V'] of all rounds.
  std::vector<float> asked_;             ///< [V'] in this round; 1: nothing is asked.
  std::vector<int> asking_;              ///< Vertices with asked_ < 1.
  std::vector<int> lowered_;             ///< Vertices of the last round's asking_.
  std::vector<std::uint8_t> isLowered_;  ///< [V'] 1: in lowered_.
  FoldWatch watch_;
};

}  // namespace sinew
