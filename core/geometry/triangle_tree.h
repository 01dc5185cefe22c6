// core/geometry/triangle_tree.h: a tree of triangles for nearest points, winding numbers and rays.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/geometry/at.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/geometry/geometry.h"

namespace sinew {

using TriangleCorners = std::array<glm::vec3, 3>;

/// Corners of a control triangle in the bind pose.
[[nodiscard]] inline TriangleCorners controlCorners(const ControlMesh& mesh, int triangle) {
  const auto& v = at(mesh.triangles, triangle).vertices;
  return {at(mesh.positions, v[0]), at(mesh.positions, v[1]), at(mesh.positions, v[2])};
}

/// The point with these barycentric coordinates.
[[nodiscard]] inline glm::vec3 mixed(const TriangleCorners& c, const glm::vec3& shares) {
  return shares.x * c[0] + shares.y * c[1] + shares.z * c[2];
}

/// Barycentric coordinates of the triangle's point nearest to p (Ericson, Real-Time Collision Detection, 5.1.5).
/// Exactly 0 for corners that the point does not need.
[[nodiscard]] inline glm::vec3 nearestOnTriangle(const glm::vec3& p, const TriangleCorners& c) {
  const glm::vec3 ab = c[1] - c[0];
  const glm::vec3 ac = c[2] - c[0];
  const glm::vec3 ap = p - c[0];
  const float a1 = glm::dot(ab, ap);
  const float a2 = glm::dot(ac, ap);
  if (a1 <= 0.0f && a2 <= 0.0f) return {1.0f, 0.0f, 0.0f};
  const glm::vec3 bp = p - c[1];
  const float b1 = glm::dot(ab, bp);
  const float b2 = glm::dot(ac, bp);
  if (b1 >= 0.0f && b2 <= b1) return {0.0f, 1.0f, 0.0f};
  const float vc = a1 * b2 - b1 * a2;
  if (vc <= 0.0f && a1 >= 0.0f && b1 <= 0.0f) {
    const float t = a1 / (a1 - b1);
    return {1.0f - t, t, 0.0f};
  }
  const glm::vec3 cp = p - c[2];
  const float c1 = glm::dot(ab, cp);
  const float c2 = glm::dot(ac, cp);
  if (c2 >= 0.0f && c1 <= c2) return {0.0f, 0.0f, 1.0f};
  const float vb = c1 * a2 - a1 * c2;
  if (vb <= 0.0f && a2 >= 0.0f && c2 <= 0.0f) {
    const float t = a2 / (a2 - c2);
    return {1.0f - t, 0.0f, t};
  }
  const float va = b1 * c2 - c1 * b2;
  if (va <= 0.0f && b2 - b1 >= 0.0f && c1 - c2 >= 0.0f) {
    const float t = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return {0.0f, 1.0f - t, t};
  }
  const float all = va + vb + vc;
  return all > 0.0f ? glm::vec3(va / all, vb / all, vc / all) : glm::vec3(1.0f, 0.0f, 0.0f);
}

// Along which axis something is longest.

/// The first of equals. @param size  not below 0
[[nodiscard]] inline glm::length_t longestAxis(const glm::vec3& size) {
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Where a line meets a triangle.
struct LineMeeting {
  int triangle = 0;    ///< Its number in the tree.
  float along = 0.0f;  ///< From the line's point, in its direction's lengths.
};

struct NearestPoint {
  int triangle = -1;       ///< Its number in the tree; -1: none within the distance.
  glm::vec3 shares{0.0f};  ///< Barycentric.
  float distance = 0.0f;
};

/// Static triangles. The same triangles in the same order give the same results.
class TriangleTree {
 public:
  /// @param numbers  numbers of the triangles in results
  TriangleTree(std::span<const TriangleCorners> triangles, std::span<const int> numbers);

  /// The first triangle of smallest distance + cost(triangle). @param within  largest such sum  @param cost  at least 0
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

  /// Generalized winding number (Jacobson et al. 2013): 1 inside a closed surface, 0 outside, approximately so with
  /// holes. Distant triangles are combined (Barill et al. 2018).
  [[nodiscard]] float windingAt(const glm::vec3& p) const;

  /// Whether a ray hits any triangle from either side.  @param direction  of any length but 0
  [[nodiscard]] bool isMetBy(const glm::vec3& from, const glm::vec3& direction) const;

  /// Where a line meets triangles from either side, low <= along <= high, in no particular but always the same order.
  /// @param direction  of any length but 0  @param out  replaced
  void meetings(const glm::vec3& from, const glm::vec3& direction, float low, float high,
                std::vector<LineMeeting>& out) const;

 private:
  static constexpr std::size_t kMostDepth = 64;

  struct Node {
    Bounds box;
    int first = 0;  ///< First triangle, or first of two consecutive children.
    int count = 0;  ///< Number of triangles; 0: it has children.
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
