// core/smoothing/finish/fold_moves.h: vertices that folds have moved, and where they were.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/base/at.h"

namespace sinew {

/// A vertex that was moved, and where it was.
struct FoldMove {
  int vertex = 0;
  glm::vec3 from{0.0f};  ///< World.
};

/// Keeps every vertex as near to where muscles have put it as they have moved it. So one that has only begun to move is
/// not thrown about by a fold beside it.
class FoldMoves {
 public:
  void start(std::size_t vertices) {
    if (isMoved_.size() != vertices) isMoved_.assign(vertices, 0);
    for (const FoldMove& move : list_) {
      if (static_cast<std::size_t>(move.vertex) < vertices) at(isMoved_, move.vertex) = 0;
    }
    list_.clear();
    from_.resize(vertices);
  }

  /// @param patch, positions [V'] world.
  void move(int vertex, const glm::vec3& to, std::span<const glm::vec3> patch, std::span<glm::vec3> positions) {
    const glm::vec3 from = fromOf(vertex, positions);
    place(vertex, limited(from, glm::distance(from, at(patch, vertex)), to), positions);
  }

  /// Where the vertex was before it was moved.
  [[nodiscard]] glm::vec3 fromOf(int vertex, std::span<const glm::vec3> positions) const {
    return at(isMoved_, vertex) != 0 ? at(from_, vertex) : at(positions, vertex);
  }

  /// @param most  how far muscles have moved it
  [[nodiscard]] static glm::vec3 limited(const glm::vec3& from, float most, const glm::vec3& to) {
    const glm::vec3 way = to - from;
    const float length = std::sqrt(glm::dot(way, way));
    return from + (length > most ? most / length : 1.0f) * way;
  }

  /// @param to  limited()
  void place(int vertex, const glm::vec3& to, std::span<glm::vec3> positions) {
    if (at(isMoved_, vertex) == 0) {
      at(isMoved_, vertex) = 1;
      at(from_, vertex) = at(positions, vertex);
      list_.push_back({vertex, at(positions, vertex)});
    }
    at(positions, vertex) = to;
  }

  /// Each vertex once.
  [[nodiscard]] std::span<const FoldMove> list() const { return list_; }

 private:
  std::vector<std::uint8_t> isMoved_;  ///< [V']
  std::vector<glm::vec3> from_;        ///< [V'] read only where moved.
  std::vector<FoldMove> list_;
};

}  // namespace sinew
