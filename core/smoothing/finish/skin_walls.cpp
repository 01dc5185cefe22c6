// core/smoothing/finish/skin_walls.cpp: a tree of boxes, found anew; sides by normals of faces, edges and vertices.
#include "core/smoothing/finish/skin_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/parallel.h"

namespace sinew {
namespace {

constexpr std::size_t kFewInWallLeaf = 6;
constexpr std::size_t kMostWallDepth = 64;

TriangleCorners wallCorners(const Refinement& refinement, int triangle, std::span<const glm::vec3> positions) {
  const std::array<int, 3>& t = at(refinement.triangles, triangle);
  return {at(positions, t[0]), at(positions, t[1]), at(positions, t[2])};
}

glm::vec3 faceOf(const TriangleCorners& c) {
  return normalizeOr(glm::cross(c[1] - c[0], c[2] - c[0]), glm::vec3(0.0f));
}

/// Squared.
float boxDistance(const Bounds& box, const glm::vec3& p) {
  const glm::vec3 way = glm::max(glm::max(box.low - p, p - box.high), glm::vec3(0.0f));
  return glm::dot(way, way);
}

/// Halves along the longest side of the triangles' middles.
class WallSplitter {
 public:
  WallSplitter(const Refinement& refinement, std::span<const glm::vec3> positions, WallTree& tree) : tree_(tree) {
    for (const int t : tree.triangles) {
      const TriangleCorners c = wallCorners(refinement, t, positions);
      middles_.push_back((c[0] + c[1] + c[2]) / 3.0f);
    }
    order_.resize(middles_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
  }

  void run() {
    tree_.nodes.push_back({0, static_cast<int>(order_.size())});
    // Nodes that are added come last, so that all are met.
    for (std::size_t n = 0; n < tree_.nodes.size(); ++n) {
      const WallTree::Node node = tree_.nodes[n];
      if (toIndex(node.count) <= kFewInWallLeaf) continue;
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
    const glm::vec3 size = box.extent();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int half = node.count / 2;
    std::nth_element(first, first + half, first + node.count, [&](int a, int b) {
      const float x = at(middles_, a)[axis];
      const float y = at(middles_, b)[axis];
      return x != y ? x < y : a < b;
    });
    return node.first + half;
  }

  WallTree& tree_;
  std::vector<glm::vec3> middles_;  ///< [triangles] as given.
  std::vector<int> order_;
};

}  // namespace

WallTree wallTree(const Refinement& refinement, std::span<const int> triangles, std::span<const glm::vec3> positions) {
  WallTree tree;
  tree.triangles.assign(triangles.begin(), triangles.end());
  if (triangles.empty()) return tree;
  WallSplitter(refinement, positions, tree).run();
  for (const int t : tree.triangles) {
    const TriangleCorners c = wallCorners(refinement, t, positions);
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
  std::array<glm::vec3, kFewInWallLeaf> faces{};
  out = {};
  for (int i = 0; i < leaf.count; ++i) {
    const TriangleCorners c = cornersOf(at(tree_.triangles, leaf.first + i));
    for (const glm::vec3& corner : c) out.box.add(corner);
    out.axis += at(faces, i) = faceOf(c);
  }
  out.axis = normalizeOr(out.axis, glm::vec3(0.0f));
  const glm::vec3 center = out.box.center();
  out.cosine = 1.0f;
  out.most = -std::numeric_limits<float>::infinity();
  for (int i = 0; i < leaf.count; ++i) {
    const glm::vec3& face = at(faces, i);
    const int corner = at(refinement_.triangles, at(tree_.triangles, leaf.first + i))[0];
    out.cosine = std::min(out.cosine, glm::dot(face, out.axis));
    out.most = std::max(out.most, glm::dot(face, at(positions_, corner) - center));
  }
}

TriangleCorners SkinWalls::cornersOf(int triangle) const { return wallCorners(refinement_, triangle, positions_); }

bool SkinWalls::isSkin(int triangle) const {
  return at(layers_, at(refinement_.controlOf, triangle)) == SkinLayer::kSkin;
}

/// Those that tell inside from outside (Baerentzen and Aanaes 2005): of faces, by the angles there.
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

void SkinWalls::look(int place, const glm::vec3& p, const WallsUnder& under, Walls& out, float& within) const {
  if (!isUnder(place, under)) return;
  const int triangle = at(tree_.triangles, place);
  const TriangleCorners c = cornersOf(triangle);
  // A place is below a wall only if it is behind one of the faces that meet at the wall's nearest point.
  const bool isBehind = glm::dot(glm::cross(c[1] - c[0], c[2] - c[0]), p - c[0]) < 0.0f;
  const glm::vec3 shares = nearestOnTriangle(p, c);
  const glm::vec3 way = p - mixed(c, shares);
  const float squared = glm::dot(way, way);
  const float most = isBehind ? std::min(within, std::max(out.above, out.below)) : std::min(within, out.above);
  if (!(squared < most * most)) return;
  const float distance = std::sqrt(squared);
  const glm::vec3 normal = normalAt(triangle, shares);
  if (glm::dot(way, normal) >= 0.0f) out.above = std::min(out.above, distance);
  else if (distance < out.below) {
    out.below = distance;
    out.triangle = triangle;
    out.shares = shares;
    out.normal = normal;
  }
  within = std::min(within, kWallsApart * distance);
}

template <class Pass, class Visit>
void SkinWalls::forEachNear(int root, const glm::vec3& p, float& within, Pass pass, Visit visit) const {
  std::array<int, kMostWallDepth> open{};
  std::size_t count = 0;
  if (!tree_.nodes.empty()) open[count++] = root;
  while (count > 0) {
    const int n = open[--count];
    if (!(boxDistance(at(nodes_, n).box, p) <= within * within)) continue;
    const WallTree::Node& node = at(tree_.nodes, n);
    if (node.count == 0) {
      const bool leftFirst =
          boxDistance(at(nodes_, node.first).box, p) <= boxDistance(at(nodes_, node.first + 1).box, p);
      open[count++] = leftFirst ? node.first + 1 : node.first;
      open[count++] = leftFirst ? node.first : node.first + 1;
      continue;
    }
    if (!pass(at(nodes_, n))) continue;
    for (int i = node.first; i < node.first + node.count; ++i) visit(i);
  }
}

Walls SkinWalls::around(const glm::vec3& p, const WallsUnder& under, float within) const {
  Walls out;
  forEachNear(
      0, p, within, [](const WallNode&) { return true; }, [&](int place) { look(place, p, under, out, within); });
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
  bool found = false;
  const auto mayBeBehind = [&](const WallNode& leaf) {
    const glm::vec3 way = p - leaf.box.center();
    const float along = glm::dot(way, leaf.axis);
    const float sine = std::sqrt(std::max(1.0f - leaf.cosine * leaf.cosine, 0.0f));
    const float across = std::sqrt(std::max(glm::dot(way, way) - along * along, 0.0f));
    return leaf.cosine <= 0.0f || leaf.cosine * along - sine * across <= leaf.most;
  };
  const auto visit = [&](int place) {
    const int triangle = at(tree_.triangles, place);
    const TriangleCorners c = cornersOf(triangle);
    if (!(glm::dot(glm::cross(c[1] - c[0], c[2] - c[0]), p - c[0]) < 0.0f) || !isUnder(place, under)) return;
    const glm::vec3 shares = nearestOnTriangle(p, c);
    const glm::vec3 way = p - mixed(c, shares);
    if (!(glm::dot(way, way) < within * within) || !(glm::dot(way, normalAt(triangle, shares)) < 0.0f)) return;
    found = true;
    within = 0.0f;
  };
  for (const int root : among) {
    forEachNear(root, p, within, mayBeBehind, visit);
    if (found) break;
  }
  return found;
}

int SkinWalls::nearest(const glm::vec3& p, float within) const {
  int triangle = -1;
  forEachNear(
      0, p, within, [](const WallNode&) { return true; },
      [&](int place) {
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
