// core/surface/finish/fold_spread.h: unfolds lifted skin that has turned inside out. docs/design.md, Folds.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/at.h"
#include "core/surface/finish/fold.h"

namespace sinew {

/// A vertex moved by unfolding, and its position before.
struct FoldMove {
  int vertex = 0;
  glm::vec3 from{0.0f};  ///< World.
};

/// A vertex of the region, with all that rounds read of it in one cache line.
struct FoldVertex {
  glm::vec3 position{0.0f};  ///< World.
  int firstCorner = -1;      ///< First in its list of triangle corners: 3 triangle + corner.
  glm::vec3 from{0.0f};      ///< Before any move.
  float most = 0.0f;         ///< Largest distance from `from`; 0: it stays.
  int index = 0;             ///< In the surface.
  bool hasMoved = false;
  float weight = 0.0f;  ///< For the stage; 0 before and after it.
  glm::vec3 way{0.0f};  ///< Likewise.
};

/// The triangles of a FoldRegion with vertices of their own, for the many rounds over them: what these read lies
/// together. Reused from pose to pose for its memory.
///
/// A vertex moves no farther than muscles have moved it, so that a fold does not throw a neighbor about that has just
/// begun to move. Vertices on borders, and those that muscles have not moved, stay.
class FoldMesh {
 public:
  /// All arguments must outlive the use of the mesh.
  /// @param region  after find().  @param isBorder [V'] borderVertices().  @param patch, positions [V'] world.
  void start(FoldRegion& region, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch,
             std::span<const glm::vec3> positions);

  [[nodiscard]] int triangleCount() const { return static_cast<int>(triangles_.size()); }
  [[nodiscard]] FoldVertex& vertex(int local) { return at(vertices_, local); }
  [[nodiscard]] const std::array<int, 3>& cornersOf(int triangle) const { return at(triangles_, triangle).corners; }
  /// Face vector of the triangle's patch, and its squared length.
  [[nodiscard]] std::pair<const glm::vec3&, float> faceOfPatch(int triangle) const {
    return {at(triangles_, triangle).face, at(triangles_, triangle).whole};
  }

  /// @param least  q from which the weight is 0, since the caller does not need it.
  [[nodiscard]] Fold foldOf(int triangle, float least) {
    const Triangle& own = at(triangles_, triangle);
    const glm::vec3& a = at(vertices_, own.corners[0]).position;
    const glm::vec3 face =
        glm::cross(at(vertices_, own.corners[1]).position - a, at(vertices_, own.corners[2]).position - a);
    const float left = glm::dot(face, own.face);
    if (!(left < least * own.whole)) return {};
    return {left / own.whole, region_->trustOf(at(region_->triangles(), triangle))};
  }

  /// Calls visit(triangle) once for each triangle at one of the vertices (local).
  template <class Visit>
  void forEachAt(std::span<const int> vertices, Visit visit) {
    ++round_;
    for (const int v : vertices) {
      for (int corner = at(vertices_, v).firstCorner; corner >= 0; corner = at(next_, corner)) {
        if (std::exchange(at(triangles_, corner / 3).round, round_) != round_) visit(corner / 3);
      }
    }
  }

  void move(int local, const glm::vec3& to);  ///< @param local  a vertex that may move

  /// Adds a fold: the next grow() extends the mesh around its control triangle.
  void add(int triangle) { region_->add(at(region_->triangles(), triangle)); }
  void grow();

  /// Writes moved vertices and lists each once. Ends the use of the mesh. Valid until the next start().
  [[nodiscard]] std::span<const FoldMove> finish(std::span<glm::vec3> positions);

 private:
  struct Triangle {
    std::array<int, 3> corners{};  ///< Local.
    int round = 0;                 ///< Last round that visited it.
    glm::vec3 face{0.0f};
    float whole = 0.0f;
  };

  void gather();
  [[nodiscard]] int gathered(int vertex);

  FoldRegion* region_ = nullptr;
  std::span<const std::uint8_t> isBorder_;
  std::span<const glm::vec3> patch_;
  std::span<const glm::vec3> positions_;
  std::vector<int> localOf_;  ///< [V'] -1: outside the region.
  std::vector<FoldVertex> vertices_;
  std::vector<Triangle> triangles_;  ///< In the region's order.
  std::vector<int> next_;            ///< [3 triangles] the next corner at the same vertex; -1: none.
  std::vector<FoldMove> moved_;
  int round_ = 0;
};

/// Moves the corners of folded triangles apart along their patch.
///
/// Every triangle with q < 0.3 (fold.h) requests of its corners the least moves that would give it q = 0.3, along the
/// gradients of its area projected along the patch's face normal. These lie in the patch's plane, so heights stay and
/// no pit opens. A corner moves by the mean of its requests, over-relaxed by 1/2. Weights are the trust in q, times the
/// missing part from q = 0.2 up or where the moves are below 1 % of the edges. There are up to 8 rounds, each reading
/// only the one before: the order of triangles does not matter, and positions depend continuously on each other.
class FoldSpread {
 public:
  static constexpr float kLeastArea = in_float::kLeastArea;  ///< q
  static constexpr int kMostRounds = 8;

  void apply(FoldMesh& mesh);  ///< @param mesh  of a region found with kLeastArea.

 private:
  void findFolded(FoldMesh& mesh);
  void ask(int triangle, FoldMesh& mesh);
  void moveAsked(FoldMesh& mesh);

  std::vector<int> folded_;  ///< Triangles, before the first round.
  std::vector<int> asked_;   ///< Vertices with requests.
  std::vector<int> moved_;   ///< Vertices moved in the last round.
};

}  // namespace sinew
