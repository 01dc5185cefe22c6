// core/geometry/triangle_tree.cpp: splits in halves along the longest side, down to a few triangles.
#include "core/geometry/triangle_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr int kFewInLeaf = 4;      ///< Most triangles of a leaf.
constexpr float kFarRadii = 2.0f;  ///< Distance in radii from which a node's triangles are combined.

/// Solid angle of a triangle (Van Oosterom and Strackee 1983).
float solidAngle(const TriangleCorners& corners, const glm::vec3& p) {
  const glm::vec3 a = corners[0] - p;
  const glm::vec3 b = corners[1] - p;
  const glm::vec3 c = corners[2] - p;
  const float la = glm::length(a);
  const float lb = glm::length(b);
  const float lc = glm::length(c);
  const float above = glm::dot(a, glm::cross(b, c));
  const float below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
  return above == 0.0f && below == 0.0f ? 0.0f : 2.0f * std::atan2(above, below);
}

/// 1 / direction, clamped for rays along an axis, to avoid 0 * infinity.
glm::vec3 inverseOf(const glm::vec3& direction) {
  constexpr float kFar = 1e30f;
  glm::vec3 inverse(0.0f);
  for (int k = 0; k < 3; ++k) inverse[k] = std::clamp(1.0f / direction[k], -kFar, kFar);
  return inverse;
}

/// Slab test of a line between two places on it and a box.
bool meetsBox(const Bounds& box, const glm::vec3& from, const glm::vec3& inverse, float low, float high) {
  const glm::vec3 a = (box.low - from) * inverse;
  const glm::vec3 b = (box.high - from) * inverse;
  const glm::vec3 in = glm::min(a, b);
  const glm::vec3 out = glm::max(a, b);
  const float last = std::min({out.x, out.y, out.z, high});
  return last >= low && std::max({in.x, in.y, in.z}) <= last;
}

constexpr float kMissed = std::numeric_limits<float>::infinity();

/// Where the line meets the triangle, or kMissed. Moeller and Trumbore 1997.
float meetingWith(const TriangleCorners& c, const glm::vec3& from, const glm::vec3& direction) {
  const glm::vec3 side = c[1] - c[0];
  const glm::vec3 other = c[2] - c[0];
  const glm::vec3 across = glm::cross(direction, other);
  const float volume = glm::dot(side, across);
  if (volume == 0.0f) return kMissed;
  const glm::vec3 way = from - c[0];
  const float u = glm::dot(way, across) / volume;
  const glm::vec3 turned = glm::cross(way, side);
  const float v = glm::dot(direction, turned) / volume;
  return u >= 0.0f && v >= 0.0f && u + v <= 1.0f ? glm::dot(other, turned) / volume : kMissed;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const TriangleCorners> triangles, std::span<const int> numbers) {
  assert(triangles.size() == numbers.size());
  if (triangles.empty()) return;
  std::vector<int> order(triangles.size());
  std::vector<glm::vec3> middles(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    order[i] = static_cast<int>(i);
    middles[i] = (triangles[i][0] + triangles[i][1] + triangles[i][2]) / 3.0f;
  }
  corners_.assign(triangles.begin(), triangles.end());
  nodes_.reserve(2 * triangles.size() / kFewInLeaf + 2);
  nodes_.emplace_back();
  split(0, 0, static_cast<int>(order.size()), order, middles);
  for (std::size_t i = 0; i < order.size(); ++i) {
    corners_[i] = at(triangles, order[i]);
    numbers_.push_back(at(numbers, order[i]));
  }
  // Children come after their parents, so sums go backwards.
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    if (node.count > 0) {
      sum(node, node.first, node.first + node.count);
      continue;
    }
    const Node& left = at(nodes_, node.first);
    const Node& right = at(nodes_, node.first + 1);
    node.area = left.area + right.area;
    node.center = node.box.center();
    node.radius = 0.5f * glm::length(node.box.extent());
  }
}

/// `corners_` is still in the order of the list.
void TriangleTree::split(int node, int first, int end, std::vector<int>& order, std::span<const glm::vec3> middles) {
  struct Open {
    int node, first, end;
  };
  std::vector<Open> open{{node, first, end}};
  while (!open.empty()) {
    const Open now = open.back();
    open.pop_back();
    Bounds box;
    Bounds inner;
    for (int i = now.first; i < now.end; ++i) {
      for (const glm::vec3& corner : at(corners_, at(order, i))) box.add(corner);
      inner.add(at(middles, at(order, i)));
    }
    at(nodes_, now.node).box = box;
    if (now.end - now.first <= kFewInLeaf) {
      at(nodes_, now.node).first = now.first;
      at(nodes_, now.node).count = now.end - now.first;
      continue;
    }
    const glm::length_t axis = longestAxis(inner.extent());
    const int half = now.first + (now.end - now.first) / 2;
    std::nth_element(order.begin() + now.first, order.begin() + half, order.begin() + now.end, [&](int a, int b) {
      const float x = at(middles, a)[axis];
      const float y = at(middles, b)[axis];
      return x != y ? x < y : a < b;
    });
    const int child = static_cast<int>(nodes_.size());
    at(nodes_, now.node).first = child;
    nodes_.emplace_back();
    nodes_.emplace_back();
    open.push_back({child + 1, half, now.end});
    open.push_back({child, now.first, half});
  }
}

void TriangleTree::sum(Node& node, int first, int end) {
  node.center = node.box.center();
  node.radius = 0.5f * glm::length(node.box.extent());
  for (int i = first; i < end; ++i) {
    const TriangleCorners& c = at(corners_, i);
    node.area += 0.5f * glm::cross(c[1] - c[0], c[2] - c[0]);
  }
}

float TriangleTree::windingAt(const glm::vec3& p) const {
  double angle = 0.0;
  std::array<int, kMostDepth> open{};
  std::size_t count = 0;
  if (!nodes_.empty()) open[count++] = 0;
  while (count > 0) {
    const Node& node = at(nodes_, open[--count]);
    const glm::vec3 way = node.center - p;
    const float distance = glm::length(way);
    if (distance > kFarRadii * node.radius && distance > 0.0f) {
      angle += static_cast<double>(glm::dot(node.area, way) / (distance * distance * distance));
    } else if (node.count == 0) {
      open[count++] = node.first + 1;
      open[count++] = node.first;
    } else {
      for (int i = node.first; i < node.first + node.count; ++i) {
        angle += static_cast<double>(solidAngle(at(corners_, i), p));
      }
    }
  }
  return static_cast<float>(angle / (4.0 * std::numbers::pi));
}

bool TriangleTree::isMetBy(const glm::vec3& from, const glm::vec3& direction) const {
  const glm::vec3 inverse = inverseOf(direction);
  std::array<int, kMostDepth> open{};
  std::size_t count = 0;
  if (!nodes_.empty()) open[count++] = 0;
  while (count > 0) {
    const Node& node = at(nodes_, open[--count]);
    if (!meetsBox(node.box, from, inverse, 0.0f, kMissed)) continue;
    if (node.count == 0) {
      open[count++] = node.first + 1;
      open[count++] = node.first;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const float along = meetingWith(at(corners_, i), from, direction);
      if (along > 0.0f && along < kMissed) return true;
    }
  }
  return false;
}

void TriangleTree::meetings(const glm::vec3& from, const glm::vec3& direction, float low, float high,
                            std::vector<LineMeeting>& out) const {
  out.clear();
  const glm::vec3 inverse = inverseOf(direction);
  std::array<int, kMostDepth> open{};
  std::size_t count = 0;
  if (!nodes_.empty()) open[count++] = 0;
  while (count > 0) {
    const Node& node = at(nodes_, open[--count]);
    if (!meetsBox(node.box, from, inverse, low, high)) continue;
    if (node.count == 0) {
      open[count++] = node.first + 1;
      open[count++] = node.first;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const float along = meetingWith(at(corners_, i), from, direction);
      if (along >= low && along <= high) out.push_back({at(numbers_, i), along});
    }
  }
}

}  // namespace sinew
