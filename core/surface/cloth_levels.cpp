// core/surface/cloth_levels.cpp: the length of skin's pieces, handed on to what lies over it.
#include "core/surface/cloth_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kNoPiece = std::numeric_limits<float>::max();

class ClothSplitter {
 public:
  ClothSplitter(const Preparation& next, RefinementLevels& levels)
      : next_(next), layers_(*next.layers()), mesh_(next.mesh()), levels_(levels) {
    pieces_.assign(mesh_.positions.size(), kNoPiece);
    for (std::size_t v = 0; v < pieces_.size(); ++v) {
      if (layers_.carriers[v] == SkinLayer::kCloth) pieces_[v] = pieceUnder(layers_.skinUnder[v]);
    }
  }

  void run() {
    const std::size_t firstEdge = mesh_.positions.size();
    const std::size_t firstTriangle = firstEdge + mesh_.edges.size();
    for (std::size_t e = 0; e < mesh_.edges.size(); ++e) {
      if (layers_.carriers[firstEdge + e] == SkinLayer::kCloth) raise(mesh_.edges[e].vertices, levels_.edges[e]);
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (layers_.carriers[firstTriangle + t] != SkinLayer::kCloth) continue;
      raise(mesh_.triangles[t].vertices, levels_.triangles[t]);
    }
  }

 private:
  [[nodiscard]] float lengthOf(int a, int b) const {
    return glm::distance(at(mesh_.positions, a), at(mesh_.positions, b));
  }

  /// Of the longest side.
  [[nodiscard]] float longest(std::span<const int> corners) const {
    float length = 0.0f;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      length = std::max(length, lengthOf(corners[i], corners[(i + 1) % corners.size()]));
    }
    return length;
  }

  [[nodiscard]] float pieceUnder(int triangle) const {
    if (triangle < 0) return kNoPiece;
    const int carrier = static_cast<int>(mesh_.positions.size() + mesh_.edges.size()) + triangle;
    if (next_.seen->of(carrier).empty()) return kNoPiece;
    const ControlTriangle& skin = at(mesh_.triangles, triangle);
    int level = at(levels_.triangles, triangle);
    for (const int e : skin.edges) level = std::max<int>(level, at(levels_.edges, e));
    return longest(skin.vertices) / static_cast<float>(level);
  }

  void raise(std::span<const int> corners, std::uint8_t& level) const {
    float piece = kNoPiece;
    for (const int v : corners) piece = std::min(piece, at(pieces_, v));
    if (!(piece > 0.0f) || piece == kNoPiece) return;
    const float wanted = std::min(std::ceil(longest(corners) / piece), static_cast<float>(kMaxDepth));
    level = std::max(level, static_cast<std::uint8_t>(wanted));
  }

  const Preparation& next_;
  const MeshLayers& layers_;
  const ControlMesh& mesh_;
  RefinementLevels& levels_;
  std::vector<float> pieces_;  ///< [V] of cloth: how long the skin's pieces are under it.
};

}  // namespace

RefinementLevels withClothLevels(const Preparation& next, RefinementLevels levels) {
  if (next.layers() && next.layers()->hasCloth()) ClothSplitter(next, levels).run();
  return levels;
}

}  // namespace sinew
