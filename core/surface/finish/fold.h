// core/surface/finish/fold.h: how far a lifted triangle has turned over against its patch.
// docs/design.md, Folds.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/instruction_set.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

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

/// A lifted triangle against its patch.
struct Fold {
  float area = 1.0f;    ///< q: its area over the patch's, signed along the patch's face normal; below 0: turned over.
  float weight = 0.0f;  ///< 0..1, how far q can be trusted: less where the pose has squeezed the patch itself below
                        ///< 5 % of its front in the bind pose. q jumps where that folds back.
};

/// A refined triangle's face: twice the area, along the normal.
[[nodiscard]] inline glm::vec3 faceOf(const std::array<int, 3>& t, std::span<const glm::vec3> positions) {
  const glm::vec3& a = at(positions, t[0]);
  return glm::cross(at(positions, t[1]) - a, at(positions, t[2]) - a);
}

/// How much a triangle of the patch faces along its normals, as triangleFronts() has it.
struct Front {
  float along = 0.0f;  ///< Twice the area, along the sum of the three normals.
  float edges = 0.0f;  ///< Three times the sum of the squared edges.

  [[nodiscard]] float ratio() const { return edges > 0.0f ? along / edges : 0.0f; }
};

/// @param face  of the triangle in the patch.
[[nodiscard]] inline Front frontOf(const std::array<int, 3>& t, const glm::vec3& face, const PatchView& patch) {
  const glm::vec3& a = at(patch.positions, t[0]);
  const glm::vec3 u = at(patch.positions, t[1]) - a;
  const glm::vec3 v = at(patch.positions, t[2]) - a;
  const glm::vec3 normals = at(patch.normals, t[0]) + at(patch.normals, t[1]) + at(patch.normals, t[2]);
  return {glm::dot(face, normals), 3.0f * (glm::dot(u, u) + glm::dot(v, v) + glm::dot(v - u, v - u))};
}

/// How far q can be trusted. @param face  of the triangle in the patch.
[[nodiscard]] float trustIn(const Refinement& refinement, std::size_t triangle, const PatchView& patch,
                            const glm::vec3& face);

// The triangles in and around folds, where their removal has to look.

// The triangles whose area has shrunk, by instruction set.

struct ShrunkSearch {
  std::span<const int> asked;                     ///< Refined triangles.
  const std::array<int, 3>* triangles = nullptr;  ///< [T n^2] their corners.
  const VertexPair* vertices = nullptr;           ///< [V'] read at those.
  float least = 0.0f;                             ///< Area over the patch's, signed along it (q of fold.h).
  int* shrunk = nullptr;                          ///< Out: those with q < least, in order; room for all and 4 more.
};

/// Returns how many have shrunk.
using FoldKernel = std::size_t (*)(const ShrunkSearch& search);

/// All give the same bits.
[[nodiscard]] FoldKernel foldKernel(InstructionSet set);

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
