// core/geometry/triangle_tree.h: triangles in a tree of boxes: which is nearest, how far they wind around a point, and
// whether a ray meets any.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/geometry/nearest_on_triangle.h"
#include "sinew/geometry/geometry.h"

namespace sinew {

/// The nearest point of a tree's triangles.
struct NearestPoint {
  int triangle = -1;       ///< As in the list that the tree was made of; -1: none within the distance.
  glm::vec3 shares{0.0f};  ///< Barycentric.
  float distance = 0.0f;
};

/// Triangles that do not move. The same triangles in the same order give the same answers.
class TriangleTree {
 public:
  /// @param numbers  what the triangles are called in answers; as many
  TriangleTree(std::span<const TriangleCorners> triangles, std::span<const int> numbers);

  /// The triangle with the least distance + cost(triangle); the first of equal ones.
  /// @param within  farther ones do not count  @param cost  at least 0
  template <class Cost>
  [[nodiscard]] NearestPoint nearest(const glm::vec3& p, float within, Cost cost) const {
    NearestPoint best;
    float least = within;
    std::array<int, kMostDepth> open{};
    std::size_t count = 0;
    if (!nodes_.empty()) open[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[static_cast<std::size_t>(open[--count])];
      if (!(distanceTo(node.box, p) <= least)) continue;
      if (node.count == 0) {
        const auto left = static_cast<std::size_t>(node.first);
        const bool leftFirst = distanceTo(nodes_[left].box, p) <= distanceTo(nodes_[left + 1].box, p);
        open[count++] = leftFirst ? node.first + 1 : node.first;
        open[count++] = leftFirst ? node.first : node.first + 1;
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        const glm::vec3 shares = nearestOnTriangle(p, corners_[index]);
        const float distance = glm::distance(p, mixed(corners_[index], shares));
        if (distance > least) continue;
        const float whole = distance + cost(numbers_[index]);
        if (whole > least || (whole == least && best.triangle >= 0 && best.triangle < numbers_[index])) continue;
        least = whole;
        best = {numbers_[index], shares, distance};
      }
    }
    return best;
  }
  [[nodiscard]] NearestPoint nearest(const glm::vec3& p, float within) const {
    return nearest(p, within, [](int) { return 0.0f; });
  }

  /// Generalized winding number (Jacobson et al. 2013): 1 inside of a closed surface, 0 outside; near that where it has
  /// holes. Triangles far away count as one (Barill et al. 2018).
  [[nodiscard]] float windingAt(const glm::vec3& p) const;

  /// Whether a ray meets any triangle, from either side.  @param direction  any length but 0
  [[nodiscard]] bool isMetBy(const glm::vec3& from, const glm::vec3& direction) const;

 private:
  static constexpr std::size_t kMostDepth = 64;

  struct Node {
    Bounds box;
    int first = 0;  ///< Of its triangles, or its first child, with the other after it.
    int count = 0;  ///< Of triangles; 0: it has children.
    glm::vec3 center{0.0f};
    glm::vec3 area{0.0f};  ///< Sum of the triangles' area vectors.
    float radius = 0.0f;   ///< Around the center.
  };

  static float distanceTo(const Bounds& box, const glm::vec3& p) {
    return glm::length(glm::max(glm::max(box.low - p, p - box.high), glm::vec3(0.0f)));
  }
  void split(int node, int first, int end, std::vector<int>& order, std::span<const glm::vec3> middles);
  void sum(Node& node, int first, int end);

  std::vector<Node> nodes_;
  std::vector<TriangleCorners> corners_;
  std::vector<int> numbers_;
};

}  // namespace sinew
