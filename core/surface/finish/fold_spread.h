// core/surface/finish/fold_spread.h: lifted skin must not turn inside out. docs/design.md, Folds.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/at.h"
#include "core/surface/finish/fold.h"

namespace sinew {

// The folding part of the surface as a small mesh, while folds are taken out.

/// A vertex that folds have moved, and where it was.
struct FoldMove {
  int vertex = 0;
  glm::vec3 from{0.0f};  ///< World.
};

/// A vertex of the region: one cache line holds all that rounds read of it.
struct FoldVertex {
  glm::vec3 position{0.0f};  ///< World.
  int firstCorner = -1;      ///< Of its list of triangle corners: 3 triangle + corner.
  glm::vec3 from{0.0f};      ///< Before any fold moved it.
  float most = 0.0f;         ///< How far it may move from there; 0: it stays.
  int index = 0;             ///< In the surface.
  bool hasMoved = false;
  float weight = 0.0f;  ///< The stage's own; 0 before and after it.
  glm::vec3 way{0.0f};  ///< Likewise.
};

/// The triangles of a FoldRegion with vertices of their own. Rounds go over them many times: what they read lies
/// together, and the tables of the whole refinement are not looked at. Kept from pose to pose for its memory.
///
/// Every vertex stays as near to where muscles have put it as they have moved it. So one that has only begun to move is
/// not thrown about by a fold beside it. Those on borders, and those that muscles have not moved, stay.
class FoldMesh {
 public:
  /// Everything that is passed must outlive the use of the mesh.
  /// @param region  found.  @param isBorder [V'] borderVertices.  @param patch, positions [V'] world.
  void start(FoldRegion& region, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch,
             std::span<const glm::vec3> positions);

  [[nodiscard]] int triangleCount() const { return static_cast<int>(triangles_.size()); }
  [[nodiscard]] FoldVertex& vertex(int local) { return at(vertices_, local); }
  [[nodiscard]] const std::array<int, 3>& cornersOf(int triangle) const { return at(triangles_, triangle).corners; }
  /// Face vector of the triangle's patch, and its squared length.
  [[nodiscard]] std::pair<const glm::vec3&, float> faceOfPatch(int triangle) const {
    return {at(triangles_, triangle).face, at(triangles_, triangle).whole};
  }

  /// @param least  q from which on the caller does not look: its weight is 0.
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

  /// @param local  a vertex that may move
  void move(int local, const glm::vec3& to);

  /// A triangle folds: what is around its control triangle belongs to the mesh from the next grow() on.
  void add(int triangle) { region_->add(at(region_->triangles(), triangle)); }
  void grow();

  /// Writes what has moved, each vertex once, and ends the use of the mesh. Valid until the next start().
  [[nodiscard]] std::span<const FoldMove> finish(std::span<glm::vec3> positions);

 private:
  struct Triangle {
    std::array<int, 3> corners{};  ///< Local.
    int round = 0;                 ///< The last visit that came by.
    glm::vec3 face{0.0f};
    float whole = 0.0f;
  };

  void gather();
  [[nodiscard]] int gathered(int vertex);

  FoldRegion* region_ = nullptr;
  std::span<const std::uint8_t> isBorder_;
  std::span<const glm::vec3> patch_;
  std::span<const glm::vec3> positions_;
  std::vector<int> localOf_;  ///< [V'] -1: outside of the region.
  std::vector<FoldVertex> vertices_;
  std::vector<Triangle> triangles_;  ///< As the region has them.
  std::vector<int> next_;            ///< [3 triangles] the next corner at the same vertex; -1: none.
  std::vector<FoldMove> moved_;
  int round_ = 0;
};

/// Moves the corners of folded triangles apart, along their patch.
///
/// A triangle with q below 0.3 (fold.h) asks its corners for the least moves that would give it q = 0.3: along the
/// gradients of its area as seen along the patch's face normal. They lie in the patch's plane, so heights stay, and no
/// pit opens. A corner follows the mean of what it is asked for, weighted by how far each q can be trusted and, from q
/// = 0.2 up or where the moves are below 1 % of the edges, by how much is missing; over-relaxed by 1/2. Up to 8
/// rounds, each of which reads the one before alone: the order of triangles does not matter, and what a vertex does is
/// a continuous function of all positions. Vertices that have not moved stay, as do borders.
class FoldSpread {
 public:
  static constexpr float kLeastArea = 0.3f;  ///< q below which a triangle asks.
  static constexpr int kMostRounds = 8;

  /// @param mesh  its region found with kLeastArea.
  void apply(FoldMesh& mesh);

 private:
  void findFolded(FoldMesh& mesh);
  void ask(int triangle, FoldMesh& mesh);
  void moveAsked(FoldMesh& mesh);

  std::vector<int> folded_;  ///< Triangles, before the first round.
  std::vector<int> asked_;   ///< Of the mesh's vertices.
  std::vector<int> moved_;   ///< Those of the last round.
};

}  // namespace sinew
