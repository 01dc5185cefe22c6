// core/surface/finish/skin_walls.cpp: a box tree refitted to each pose; sides by normals of faces, edges, vertices.
#include "core/surface/finish/skin_walls.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/parallel.h"
#include "core/geometry/potential.h"

namespace sinew {
namespace {

constexpr std::size_t kMostWallDepth = 64;
constexpr float kWallSeenWhole = 0.05f;  ///< Cosine to a wall's normal from which it counts as it is.

/// Walls::below: infinite for skin seen from the side. @param along  height along the skin's normal, negative
float asSeen(float distance, float along) {
  const float share = smoothstep(0.0f, kWallSeenWhole, -along / distance);
  return share > 0.0f ? distance / share : std::numeric_limits<float>::infinity();
}

float squaredBoxDistance(const Bounds& box, const glm::vec3& p) {
  const glm::vec3 way = glm::max(glm::max(box.low - p, p - box.high), glm::vec3(0.0f));
  return glm::dot(way, way);
}

/// Halves nodes along the longest side of the box of their triangles' centers.
class WallSplitter {
 public:
  WallSplitter(const Refinement& refinement, std::span<const glm::vec3> positions, WallTree& tree) : tree_(tree) {
    for (const int t : tree.triangles) {
      const TriangleCorners c = refinedCorners(refinement, t, positions);
      middles_.push_back((c[0] + c[1] + c[2]) / 3.0f);
    }
    order_.resize(middles_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
  }

  void run() {
    tree_.nodes.push_back({0, static_cast<int>(order_.size())});
    // The loop reaches added nodes too.
    for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {
      const WallTree::Node node = tree_.nodes[n];
      if (node.count <= kMostInWallLeaf) continue;
      const int half = divide(node);
      tree_.nodes[n] = {static_cast<int>(tree_.nodes.size()), 0};
      tree_.nodes.push_back({node.first, half - node.first});
      tree_.nodes.push_back({half, node.first + node.count - half});
    }
    std::vector<int> sorted;
    for (const int i : order_) sorted.push_back(at(tree_.triangles, i));
    tree_.triangles = std::move(sorted);
  }

 private:
  int divide(const WallTree::Node& node) {
    Bounds box;
    const auto first = order_.begin() + node.first;
    std::for_each_n(first, node.count, [&](int i) { box.add(at(middles_, i)); });
    const glm::length_t axis = longestAxis(box.extent());
    const int half = node.count / 2;
    std::nth_element(first, first + half, first + node.count, [&](int a, int b) {
      const float x = at(middles_, a)[axis];
      const float y = at(middles_, b)[axis];
      return x != y ? x < y : a < b;
    });
    return node.first + half;
  }

  WallTree& tree_;
  std::vector<glm::vec3> middles_;  ///< [triangles]
  std::vector<int> order_;
};

}  // namespace

WallTree wallTree(const Refinement& refinement, std::span<const int> triangles, std::span<const glm::vec3> positions) {
  WallTree tree;
  tree.triangles.assign(triangles.begin(), triangles.end());
  if (triangles.empty()) return tree;
  WallSplitter(refinement, positions, tree).run();
  tree.placeOf.assign(refinement.triangles.size(), -1);
  for (std::size_t i = 0; i < tree.triangles.size(); ++i) at(tree.placeOf, tree.triangles[i]) = static_cast<int>(i);
  for (const int t : tree.triangles) {
    const TriangleCorners c = refinedCorners(refinement, t, positions);
    tree.bindPlaces.push_back(c[0]);
    tree.bindFaces.push_back(faceOf(c));
  }
  return tree;
}

SkinWalls::SkinWalls(const WallTree& tree, const Refinement& refinement, const VertexRings& rings,
                     std::span<const SkinLayer> layers, std::span<const glm::vec3> positions, float reach,
                     std::vector<WallNode>& nodes)
    : tree_(tree),
      refinement_(refinement),
      rings_(rings),
      layers_(layers),
      positions_(positions),
      reach_(reach),
      nodes_(nodes) {
  nodes.resize(tree.nodes.size());
  forEachIndex(nodes.size(), 256, [&](std::size_t n) {
    if (tree.nodes[n].count > 0) fitLeaf(tree.nodes[n], nodes[n]);
  });
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const WallTree::Node& node = tree.nodes[n];
    if (node.count > 0) continue;
    const Bounds& left = at(nodes, node.first).box;
    const Bounds& right = at(nodes, node.first + 1).box;
    nodes[n].box = {glm::min(left.low, right.low), glm::max(left.high, right.high)};
  }
}

void SkinWalls::fitLeaf(const WallTree::Node& leaf, WallNode& out) const {
  out = {};
  for (int i = 0; i < leaf.count; ++i) {
    const TriangleCorners c = cornersOf(at(tree_.triangles, leaf.first + i));
    for (const glm::vec3& corner : c) out.box.add(corner);
    const glm::vec3 face = faceOf(c);
    out.axis += face;
    at(out.planes, i) = glm::vec4(face, glm::dot(face, c[0]));
  }
  out.axis = normalizeOr(out.axis, glm::vec3(0.0f));
  out.center = out.box.center();
  out.radius = 0.5f * glm::length(out.box.extent());
  out.cosine = 1.0f;
  out.most = -std::numeric_limits<float>::infinity();
  for (int i = 0; i < leaf.count; ++i) {
    const glm::vec3 face(at(out.planes, i));
    out.cosine = std::min(out.cosine, glm::dot(face, out.axis));
    out.most = std::max(out.most, at(out.planes, i).w - glm::dot(face, out.center));
  }
  out.sine = std::sqrt(std::max(1.0f - out.cosine * out.cosine, 0.0f));
}

bool WallNode::mayBeBehind(const glm::vec3& p, float within) const {
  const glm::vec3 way = p - center;
  const float squared = glm::dot(way, way);
  if (squared > (within + radius) * (within + radius)) return false;
  const float along = glm::dot(way, axis);
  const float across = std::sqrt(std::max(squared - along * along, 0.0f));
  return cosine <= 0.0f || cosine * along - sine * across <= most;
}

TriangleCorners SkinWalls::cornersOf(int triangle) const { return refinedCorners(refinement_, triangle, positions_); }

bool SkinWalls::isSkin(int triangle) const {
  return at(layers_, at(refinement_.controlOf, triangle)) == SkinLayer::kSkin;
}

/// Sum of face normals weighted by angles, to decide between inside and outside (Baerentzen and Aanaes 2005).
glm::vec3 SkinWalls::normalAtVertex(int vertex) const {
  glm::vec3 sum(0.0f);
  for (const int corner : rings_.cornersOf(vertex)) {
    const int triangle = corner / 3;
    if (!isSkin(triangle)) continue;
    const TriangleCorners c = cornersOf(triangle);
    const auto k = static_cast<std::size_t>(corner % 3);
    const glm::vec3 face = faceOf(c);
    const glm::vec3 a = normalizeOr(c[(k + 1) % 3] - c[k], face);
    const glm::vec3 b = normalizeOr(c[(k + 2) % 3] - c[k], face);
    sum += std::acos(std::clamp(glm::dot(a, b), -1.0f, 1.0f)) * face;
  }
  return sum;
}

glm::vec3 SkinWalls::normalAtEdge(int from, int to) const {
  glm::vec3 sum(0.0f);
  for (const int corner : rings_.cornersOf(from)) {
    const int triangle = corner / 3;
    if (std::ranges::find(at(refinement_.triangles, triangle), to) == at(refinement_.triangles, triangle).end()) {
      continue;
    }
    if (isSkin(triangle)) sum += faceOf(cornersOf(triangle));
  }
  return sum;
}

glm::vec3 SkinWalls::normalAt(int triangle, const glm::vec3& shares) const {
  const std::array<int, 3>& t = at(refinement_.triangles, triangle);
  std::array<int, 3> needed{};
  std::size_t count = 0;
  for (int k = 0; k < 3; ++k) {
    if (shares[k] != 0.0f) needed[count++] = t[toIndex(k)];
  }
  const glm::vec3 face = faceOf(cornersOf(triangle));
  if (count == 3) return face;
  return normalizeOr(count == 1 ? normalAtVertex(needed[0]) : normalAtEdge(needed[0], needed[1]), face);
}

bool SkinWalls::isUnder(int place, const WallsUnder& under) const {
  const glm::vec3 apart = at(tree_.bindPlaces, place) - under.bindPlace;
  return glm::dot(apart, apart) <= reach_ * reach_ && glm::dot(at(tree_.bindFaces, place), under.bindFace) > 0.0f;
}

bool SkinWalls::isAnyUnderAround(int triangle, const WallsUnder& under) const {
  return std::ranges::any_of(at(refinement_.triangles, triangle), [&](int vertex) {
    return std::ranges::any_of(rings_.cornersOf(vertex), [&](int corner) {
      const int place = at(tree_.placeOf, corner / 3);
      return place >= 0 && isUnder(place, under);
    });
  });
}

void SkinWalls::look(int place, const glm::vec3& p, const WallsUnder& under, Walls& out, float& within) const {
  if (!isUnder(place, under)) return;
  const int triangle = at(tree_.triangles, place);
  const TriangleCorners c = cornersOf(triangle);
  const bool isBehind = glm::dot(glm::cross(c[1] - c[0], c[2] - c[0]), p - c[0]) < 0.0f;
  const glm::vec3 shares = nearestOnTriangle(p, c);
  const glm::vec3 way = p - mixed(c, shares);
  const float squared = glm::dot(way, way);
  const float most = isBehind ? std::min(within, std::max(out.above, out.below)) : std::min(within, out.above);
  if (!(squared < most * most)) return;
  const float distance = std::sqrt(squared);
  const glm::vec3 normal = normalAt(triangle, shares);
  const float along = glm::dot(way, normal);
  if (along >= 0.0f) {
    out.above = std::min(out.above, distance);
    within = std::min(within, kWallsApart * distance);
    return;
  }
  const float seen = asSeen(distance, along);
  if (!(seen < out.below)) return;
  out = {out.above, seen, distance, triangle, shares, normal};
  within = std::min(within, kWallsApart * seen);
}

template <class Visit>
void SkinWalls::forEachNear(int root, const glm::vec3& p, float& within, Visit visit) const {
  std::array<int, kMostWallDepth> open{};
  std::size_t count = 0;
  if (!tree_.nodes.empty()) open[count++] = root;
  while (count > 0) {
    const int n = open[--count];
    if (!(squaredBoxDistance(at(nodes_, n).box, p) <= within * within)) continue;
    const WallTree::Node& node = at(tree_.nodes, n);
    if (node.count == 0) {
      const bool leftFirst =
          squaredBoxDistance(at(nodes_, node.first).box, p) <= squaredBoxDistance(at(nodes_, node.first + 1).box, p);
      open[count++] = leftFirst ? node.first + 1 : node.first;
      open[count++] = leftFirst ? node.first : node.first + 1;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) visit(i);
  }
}

Walls SkinWalls::around(const glm::vec3& p, const WallsUnder& under, float within) const {
  Walls out;
  forEachNear(0, p, within, [&](int place) { look(place, p, under, out, within); });
  return out;
}

std::span<const int> SkinWalls::nearTo(const Bounds& box, float within, NearNodes& out) const {
  std::array<int, kMostWallDepth> open{};
  std::size_t count = 0;
  std::size_t found = 0;
  if (!tree_.nodes.empty()) open[count++] = 0;
  while (count > 0) {
    const int n = open[--count];
    const Bounds& own = at(nodes_, n).box;
    const glm::vec3 apart = glm::max(glm::max(own.low - box.high, box.low - own.high), glm::vec3(0.0f));
    if (!(glm::dot(apart, apart) <= within * within)) continue;
    const WallTree::Node& node = at(tree_.nodes, n);
    if (node.count > 0 || found + count + 2 > out.size()) {
      out[found++] = n;
    } else {
      open[count++] = node.first + 1;
      open[count++] = node.first;
    }
  }
  return std::span(out).first(found);
}

bool SkinWalls::isBelowAny(const glm::vec3& p, const WallsUnder& under, float within,
                           std::span<const int> among) const {
  const auto isBelow = [&](int place) {
    const int triangle = at(tree_.triangles, place);
    const TriangleCorners c = cornersOf(triangle);
    const glm::vec3 shares = nearestOnTriangle(p, c);
    const glm::vec3 way = p - mixed(c, shares);
    const float squared = glm::dot(way, way);
    if (!(squared < within * within)) return false;
    // Other skin may end at a wall: a place can then be below the wall and behind only that skin.
    if (!isUnder(place, under)) return isAnyUnderAround(triangle, under);
    const float along = glm::dot(way, normalAt(triangle, shares));
    return along < 0.0f && asSeen(std::sqrt(squared), along) < within;
  };
  return std::ranges::any_of(among, [&](int n) {
    // nearTo() may have run out of memory above the leaves.
    if (at(tree_.nodes, n).count == 0) {
      bool found = false;
      forEachNear(n, p, within, [&](int place) { found = found || isBelow(place); });
      return found;
    }
    const WallNode& own = at(nodes_, n);
    if (!own.mayBeBehind(p, within)) return false;
    const WallTree::Node& leaf = at(tree_.nodes, n);
    for (int i = 0; i < leaf.count; ++i) {
      const glm::vec4& plane = at(own.planes, i);
      // A place below a wall is behind one of the faces that meet at the wall's nearest point.
      const float behind = plane.w - glm::dot(glm::vec3(plane), p);
      if (behind > 0.0f && behind < within && isBelow(leaf.first + i)) return true;
    }
    return false;
  });
}

int SkinWalls::nearest(const glm::vec3& p, float within) const {
  int triangle = -1;
  forEachNear(0, p, within, [&](int place) {
    const TriangleCorners c = cornersOf(at(tree_.triangles, place));
    const float distance = glm::distance(p, mixed(c, nearestOnTriangle(p, c)));
    const int here = at(tree_.triangles, place);
    if (distance > within || (distance == within && triangle >= 0 && triangle < here)) return;
    within = distance;
    triangle = here;
  });
  return triangle;
}

}  // namespace sinew
