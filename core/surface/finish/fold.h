// core/surface/finish/fold.h: lifted triangles that have turned over, and the region around. docs/design.md, Folds.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/formulas.h"
#include "core/geometry/instruction_set.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

struct PatchView {
  std::span<const glm::vec3> positions;  ///< [V'] world.
  std::span<const glm::vec3> normals;    ///< [V'] unit.
  std::span<const float> bindFronts;     ///< [T n^2] triangleFronts of the bind pose.
};

/// [T n^2] The front of each refined triangle of a patch: twice its area projected along the mean of its three normals,
/// over the sum of its squared edges. 0.29 for an equilateral triangle across its normals, less for thin ones, negative
/// where the patch folds back.
[[nodiscard]] std::vector<float> triangleFronts(const Refinement& refinement, std::span<const glm::vec3> positions,
                                                std::span<const glm::vec3> normals);

/// A lifted triangle compared with its patch.
struct Fold {
  float area = 1.0f;    ///< q: its area over the patch's, along the patch's face normal; negative: turned over.
  float weight = 0.0f;  ///< 0..1, trust in q: less than 1 where the pose has squeezed the patch itself below 5 % of its
                        ///< front in the bind pose, since q jumps where the patch folds back.
};

/// A refined triangle's face vector: twice the area, along the normal.
[[nodiscard]] inline glm::vec3 faceOf(const std::array<int, 3>& t, std::span<const glm::vec3> positions) {
  const glm::vec3& a = at(positions, t[0]);
  return glm::cross(at(positions, t[1]) - a, at(positions, t[2]) - a);
}

/// One of triangleFronts().  @param face  of the triangle in the patch.
[[nodiscard]] inline float frontOf(const std::array<int, 3>& t, const glm::vec3& face, const PatchView& patch) {
  const glm::vec3& a = at(patch.positions, t[0]);
  const glm::vec3 normals = at(patch.normals, t[0]) + at(patch.normals, t[1]) + at(patch.normals, t[2]);
  return in_float::frontOf(face, normals, at(patch.positions, t[1]) - a, at(patch.positions, t[2]) - a);
}

/// Fold::weight.  @param face  of the triangle in the patch.
[[nodiscard]] float trustIn(const Refinement& refinement, std::size_t triangle, const PatchView& patch,
                            const glm::vec3& face);

/// A search for triangles whose area has shrunk.
struct ShrunkSearch {
  std::span<const int> asked;                     ///< Refined triangles.
  const std::array<int, 3>* triangles = nullptr;  ///< [T n^2] corners.
  const VertexPair* vertices = nullptr;           ///< [V'] read at the corners.
  float least = 0.0f;                             ///< q
  int* shrunk = nullptr;                          ///< Out: triangles with q < least, in order; room for all and 4 more.
};

using FoldKernel = std::size_t (*)(const ShrunkSearch& search);  ///< Returns the number of shrunk triangles.

[[nodiscard]] FoldKernel foldKernel(InstructionSet set);

struct FoldTriangle {
  int index = 0;
  std::array<int, 3> corners{};
  glm::vec3 face{0.0f};  ///< Face vector of its patch.
  float whole = 0.0f;    ///< Squared length of `face`.
  float trust = -1.0f;   ///< trustIn(); negative: not computed yet.
};

/// The refined triangles of all control triangles with a fold, and of those that share a control vertex with them.
/// Grows as more triangles fold. Reused from pose to pose for its memory.
class FoldRegion {
 public:
  /// Finds the folds. All arguments must outlive the use of the region.  @param moved  only its triangles can fold.
  /// @param rings  of the refinement.  @param pairs  vertices of moved.refined in the patch and in positions.
  /// @param least  q below which a triangle folds.
  void find(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
            const MovedTriangles& moved, const PatchView& patch, const VertexPairs& pairs,
            std::span<const glm::vec3> positions, float least);

  [[nodiscard]] std::span<FoldTriangle> triangles() { return triangles_; }

  /// Fold::weight of one of triangles().
  [[nodiscard]] float trustOf(FoldTriangle& triangle) const {
    if (triangle.trust < 0.0f) {
      triangle.trust = trustIn(*refinement_, static_cast<std::size_t>(triangle.index), patch_, triangle.face);
    }
    return triangle.trust;
  }

  /// Adds a fold: the next grow() extends the region around its control triangle.
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
  std::vector<int> first_;               ///< [T] first of a control triangle's in triangles_; -1: outside.
  std::vector<std::uint8_t> isFolding_;  ///< [T] the control triangle has a fold.
  std::vector<std::uint8_t> isNear_;     ///< [V] corner of a control triangle with a fold.
  std::vector<int> folding_;             ///< Control triangles that have folded since the last grow().
  std::vector<int> near_;                ///< Scratch.
  std::vector<int> shrunk_;              ///< Refined triangles with q below the bound.
};

}  // namespace sinew
