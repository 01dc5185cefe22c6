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
    const auto v = static_cast<std::size_t>(vertex);
    if (isMoved_[v] == 0) {
      isMoved_[v] = 1;
      from_[v] = positions[v];
      list_.push_back({vertex, positions[v]});
    }
    const glm::vec3 way = to - from_[v];
    const float most = glm::distance(from_[v], patch[v]);
    const float length = std::sqrt(glm::dot(way, way));
    positions[v] = from_[v] + (length > most ? most / length : 1.0f) * way;
  }

  /// Each vertex once.
  [[nodiscard]] std::span<const FoldMove> list() const { return list_; }

 private:
  std::vector<std::uint8_t> isMoved_;  ///< [V']
  std::vector<glm::vec3> from_;        ///< [V'] read only where moved.
  std::vector<FoldMove> list_;
};

}  // namespace sinew
