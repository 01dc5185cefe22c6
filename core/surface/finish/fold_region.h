// core/surface/finish/fold_region.h: the triangles in and around folds, where their removal has to look.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/finish/fold.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_pairs.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// A refined triangle with what its area is measured against.
struct FoldTriangle {
  int index = 0;
  std::array<int, 3> corners{};
  glm::vec3 face{0.0f};  ///< Face vector of its patch.
  float whole = 0.0f;    ///< Squared length of that.
  float trust = -1.0f;   ///< trustIn; below 0: not asked for yet.
};

/// The refined triangles of all control triangles in which one folds, and of those that share a control vertex with
/// them. Grows as more fold. Kept from pose to pose for its memory.
class FoldRegion {
 public:
  /// Finds the folds. Everything that is passed must outlive the use of the region.
  /// @param rings  of the refinement.  @param moved  beyond its triangles nothing can fold.
  /// @param pairs  of the vertices of moved.refined, as in the patch and in positions.
  /// @param least  q below which a triangle counts.
  void find(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
            const MovedTriangles& moved, const PatchView& patch, const VertexPairs& pairs,
            std::span<const glm::vec3> positions, float least);

  [[nodiscard]] std::span<FoldTriangle> triangles() { return triangles_; }

  /// How far the area of one of triangles() can be trusted.
  [[nodiscard]] float trustOf(FoldTriangle& triangle) const {
    if (triangle.trust < 0.0f) {
      triangle.trust = trustIn(*refinement_, static_cast<std::size_t>(triangle.index), patch_, triangle.face);
    }
    return triangle.trust;
  }

  /// A triangle folds: what is around its control triangle belongs to the region from the next grow() on.
  void add(const FoldTriangle& folding);
  void grow();

 private:
  void findShrunk(std::span<const int> asked, const VertexPairs& pairs, float least);
  [[nodiscard]] FoldTriangle triangleOf(int index) const;

  const ControlMesh* mesh_ = nullptr;
  const Refinement* refinement_ = nullptr;
  const VertexRings* rings_ = nullptr;
  std::span<const std::uint8_t> isControl_;
  PatchView patch_;
  std::vector<FoldTriangle> triangles_;
  std::vector<int> first_;               ///< [T] of a control triangle's in triangles_; -1: outside.
  std::vector<std::uint8_t> isFolding_;  ///< [T] one of a control triangle's has folded.
  std::vector<std::uint8_t> isNear_;     ///< [V] a corner of a control triangle in which one folds.
  std::vector<int> folding_;             ///< Control triangles that fold since the last grow().
  std::vector<int> near_;                ///< Scratch.
  std::vector<int> shrunk_;              ///< Refined triangles with q below what was asked for.
};

}  // namespace sinew
