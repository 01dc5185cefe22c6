// core/smoothing/finish/fold_spread.h: lifted skin must not turn inside out. docs/design.md, Folds.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/finish/fold_moves.h"
#include "core/smoothing/finish/fold_region.h"

namespace sinew {

/// Moves the corners of triangles that are still folded apart, along their patch.
///
/// A triangle with q below 0.3 (fold.h) asks its corners for the least moves that would give it q = 0.3: along the
/// gradients of its area as seen along the patch's face normal. They lie in the patch's plane, so heights stay, and no
/// pit opens. A corner follows the mean of what it is asked for, weighted by how far each q can be trusted and, from q
/// = 0.2 up, by how much is missing; over-relaxed by 1/2. Up to 32 rounds, each of which reads the one before alone:
/// the order of triangles does not matter, and what a vertex does is a continuous function of all positions. Vertices
/// that have not moved stay, as do borders.
class FoldSpread {
 public:
  static constexpr int kMostRounds = 32;

  /// @param region  as FoldRelaxation left it.
  /// @param isBorder [V'] borderVertices.  @param patch, positions [V'] world; positions in and out.
  void apply(std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch, FoldRegion& region,
             FoldMoves& moves, std::span<glm::vec3> positions);

 private:
  /// A vertex of the region, in one cache line with all that rounds read of it.
  struct Vertex {
    glm::vec3 position{0.0f};
    int firstCorner = -1;  ///< Of its list in next_: 3 triangle + corner.
    glm::vec3 way{0.0f};   ///< Weighted sum of the moves asked for in this round.
    float weight = 0.0f;   ///< Sum over triangles.
    glm::vec3 from{0.0f};  ///< Before any fold moved it.
    float most = 0.0f;     ///< How far it may move from there; 0: it stays.
    int index = 0;         ///< In the surface.
    bool hasMoved = false;
  };
  struct Triangle {
    std::array<int, 3> corners{};  ///< In vertices_.
    int round = -1;                ///< The last one that looked at it.
    glm::vec3 face{0.0f};          ///< FoldTriangle's.
    float whole = 0.0f;
  };

  /// Takes in what the region has gained.
  void gather(std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch, FoldRegion& region,
              const FoldMoves& moves, std::span<const glm::vec3> positions);
  [[nodiscard]] int localOf(int vertex, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> patch,
                            const FoldMoves& moves, std::span<const glm::vec3> positions);
  void ask(int triangle, FoldRegion& region);
  void moveAsked();

  std::vector<int> localOf_;         ///< [V'] in vertices_; -1: outside of the region.
  std::vector<Vertex> vertices_;     ///< Of the region.
  std::vector<Triangle> triangles_;  ///< As the region has them.
  std::vector<int> next_;            ///< [3 triangles_] the next corner at the same vertex; -1: none.
  std::vector<int> asked_;           ///< In vertices_.
  std::vector<int> moved_;           ///< In vertices_: those of the last round.
};

}  // namespace sinew
