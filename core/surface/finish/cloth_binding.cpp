// core/surface/finish/cloth_binding.cpp: nearest places found by walking from the control triangle of a corner.
#include "core/surface/finish/cloth_binding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/potential.h"
#include "core/geometry/triangle_tree.h"

namespace sinew {
namespace {

constexpr int kMostWalkSteps = 256;         ///< From triangle to triangle; a guard, hardly ever reached.
constexpr float kClothWholeWithin = 0.03f;  ///< Fraction of H up to which cloth follows the skin's full height.
constexpr float kSkinUnderWithin = 0.05f;   ///< Fraction of H within which cloth makes room for skin under it.
constexpr float kSkinUnderAlong = 0.2f;     ///< Least cosine between the skin's normal and the direction to cloth.

float squaredLength(const glm::vec3& v) { return glm::dot(v, v); }

/// Corners of a refined vertex's carrier, the one with the largest weight first.
struct CarrierCorners {
  std::array<int, 3> corners{};
  std::size_t count = 1;
};

/// Calls visit(vertex, corners) for every refined vertex of a layer.
template <class Visit>
void forEachOn(SkinLayer layer, const ControlMesh& mesh, const Refinement& refinement, const MeshLayers& layers,
               Visit visit) {
  const int vertices = refinement.controlVertices;
  for (int v = 0; v < vertices; ++v) {
    if (at(layers.carriers, v) == layer) visit(v, CarrierCorners{{v, v, v}, 1});
  }
  for (int e = 0; e < refinement.controlEdges; ++e) {
    if (at(layers.carriers, vertices + e) != layer) continue;
    const auto& ends = at(mesh.edges, e).vertices;
    const int level = refinement.edgeLevel(e);
    for (int step = 1; step < level; ++step) {
      const bool first = refinement.shareAt(e, step) <= 0.5;
      visit(refinement.edgeVertex(e, step), CarrierCorners{{ends[first ? 0 : 1], ends[first ? 1 : 0], 0}, 2});
    }
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    if (at(layers.carriers, vertices + refinement.controlEdges + t) != layer) continue;
    const auto& corners = at(mesh.triangles, t).vertices;
    for (int v = at(refinement.insideBegin, t); v < at(refinement.insideBegin, t + 1); ++v) {
      const glm::dvec2& place = refinement.insideAt(v);
      const double a = 1.0 - place.x - place.y;
      const std::size_t largest = a >= place.x && a >= place.y ? 0 : place.x >= place.y ? 1 : 2;
      visit(v, CarrierCorners{{corners[largest], corners[(largest + 1) % 3], corners[(largest + 2) % 3]}, 3});
    }
  }
}

/// The refined triangle to start a walk from; -1: no corner is bound.
int startOf(const CarrierCorners& of, const std::vector<int>& bound, const Refinement& refinement) {
  for (std::size_t i = 0; i < of.count; ++i) {
    if (const int t = at(bound, of.corners[i]); t >= 0) return at(refinement.triangleBegin, t);
  }
  return -1;
}

/// Finds nearest places on the refined triangles of one layer by walking from triangle to triangle.
class SurfaceWalk {
 public:
  /// All must outlive the walk. @param layers [T] of the control triangles.  @param positions [V']
  SurfaceWalk(const Refinement& refinement, const VertexRings& rings, std::span<const SkinLayer> layers, SkinLayer on,
              std::span<const glm::vec3> positions)
      : refinement_(refinement), rings_(rings), layers_(layers), on_(on), positions_(positions) {}

  /// The nearest place reached from a triangle by steps that each come nearer.
  [[nodiscard]] SurfacePlace nearest(const glm::vec3& p, int start) const {
    const auto cornersOf = [&](int triangle) { return refinedCorners(refinement_, triangle, positions_); };
    const auto isOn = [&](int triangle) { return at(layers_, at(refinement_.controlOf, triangle)) == on_; };
    SurfacePlace best{start, {}};
    const TriangleCorners first = cornersOf(start);
    best.shares = nearestOnTriangle(p, first);
    float least = squaredLength(p - mixed(first, best.shares));
    for (int step = 0; step < kMostWalkSteps; ++step) {
      const SurfacePlace here = best;
      if (here.shares.x > 0.0f && here.shares.y > 0.0f && here.shares.z > 0.0f) break;
      for (int c = 0; c < 3; ++c) {
        if (!(here.shares[c] > 0.0f)) continue;
        for (const int corner : rings_.cornersOf(at(at(refinement_.triangles, here.triangle), c))) {
          const int triangle = corner / 3;
          if (triangle == here.triangle || !isOn(triangle)) continue;
          const TriangleCorners corners = cornersOf(triangle);
          const glm::vec3 shares = nearestOnTriangle(p, corners);
          const float distance = squaredLength(p - mixed(corners, shares));
          if (!(distance < least)) continue;
          least = distance;
          best = {triangle, shares};
        }
      }
      if (best.triangle == here.triangle) break;
    }
    return best;
  }

 private:
  const Refinement& refinement_;
  const VertexRings& rings_;
  std::span<const SkinLayer> layers_;
  SkinLayer on_;
  std::span<const glm::vec3> positions_;
};

/// Refined triangles of skin near cloth.
std::vector<int> skinNearCloth(const ControlMesh& mesh, const Refinement& refinement, const MeshLayers& layers) {
  std::vector<bool> isUnder(mesh.triangles.size());
  for (const int t : layers.skinUnder) {
    if (t >= 0) isUnder[toIndex(t)] = true;
  }
  const std::span<const SkinLayer> ofTriangles = triangleLayers(refinement, layers);
  std::vector<int> out;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    if (at(ofTriangles, t) != SkinLayer::kSkin) continue;
    const auto isNear = [&](int v) { return at(layers.clothOver, v) >= 0; };
    if (!isUnder[toIndex(t)] && std::ranges::none_of(at(mesh.triangles, t).vertices, isNear)) continue;
    for (int r = at(refinement.triangleBegin, t); r < at(refinement.triangleBegin, t + 1); ++r) out.push_back(r);
  }
  return out;
}

/// Halves along the longest side, down to groups.
void sortInSpace(std::span<int> order, std::span<const WallsUnder> places) {
  if (order.size() <= kClothGroup) return;
  Bounds box;
  for (const int i : order) box.add(at(places, i).bindPlace);
  const glm::length_t axis = longestAxis(box.extent());
  const std::size_t half = (order.size() / 2 + kClothGroup - 1) / kClothGroup * kClothGroup;
  std::ranges::nth_element(order, order.begin() + static_cast<std::ptrdiff_t>(half), {},
                           [&](int i) { return std::pair(at(places, i).bindPlace[axis], i); });
  sortInSpace(order.first(half), places);
  sortInSpace(order.subspan(half), places);
}

void findWalls(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
               const MeshLayers& layers, std::span<const glm::vec3> positions, float height, ClothBinding& out) {
  out.walls = wallTree(refinement, skinNearCloth(mesh, refinement, layers), positions);
  const float reach = kClothReach * height;
  std::vector<WallNode> nodes;
  const SkinWalls walls(out.walls, refinement, rings, triangleLayers(refinement, layers), positions, reach, nodes);
  out.wallsUnder.resize(out.cloth.size());
  forEachIndex(out.cloth.size(), 256, [&](std::size_t i) {
    const glm::vec3& p = at(positions, out.cloth[i].vertex);
    const int nearest = walls.nearest(p, reach);
    out.wallsUnder[i] = {p, nearest < 0 ? glm::vec3(0.0f) : faceOf(refinedCorners(refinement, nearest, positions))};
  });
  out.inSpace.resize(out.cloth.size());
  for (std::size_t i = 0; i < out.inSpace.size(); ++i) out.inSpace[i] = static_cast<int>(i);
  sortInSpace(out.inSpace, out.wallsUnder);
}

}  // namespace

ClothBinding bindCloth(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
                       const MeshLayers& layers, std::span<const glm::vec3> positions,
                       std::span<const glm::vec3> normals, float height) {
  ClothBinding out;
  const auto placeOf = [&](const SurfacePlace& place) {
    return mixed(refinedCorners(refinement, place.triangle, positions), place.shares);
  };
  const auto walkAll = [&](std::vector<BoundVertex>& bound, SkinLayer to, auto shareOf) {
    const SurfaceWalk walk(refinement, rings, triangleLayers(refinement, layers), to, positions);
    forEachIndex(bound.size(), 256, [&](std::size_t i) {
      BoundVertex& one = bound[i];
      one.place = walk.nearest(at(positions, one.vertex), one.place.triangle);
      one.share = shareOf(one.vertex, placeOf(one.place) - at(positions, one.vertex));
    });
    std::erase_if(bound, [](const BoundVertex& one) { return one.share == 0.0f; });
  };
  const auto bindAll = [&](SkinLayer layer, const std::vector<int>& to, std::vector<BoundVertex>& bound) {
    forEachOn(layer, mesh, refinement, layers, [&](int v, const CarrierCorners& of) {
      if (const int start = startOf(of, to, refinement); start >= 0) bound.push_back({v, {start, {}}, 1.0f});
    });
  };
  bindAll(SkinLayer::kCloth, layers.skinUnder, out.cloth);
  walkAll(out.cloth, SkinLayer::kSkin, [&](int, const glm::vec3& apart) {
    return 1.0f - smoothstep(kClothWholeWithin, kClothReach, glm::length(apart) / height);
  });
  bindAll(SkinLayer::kSkin, layers.clothOver, out.under);
  walkAll(out.under, SkinLayer::kCloth, [&](int v, const glm::vec3& apart) {
    const float length = glm::length(apart);
    const bool isOver =
        length <= kSkinUnderWithin * height && glm::dot(apart, at(normals, v)) >= kSkinUnderAlong * length;
    return isOver ? 1.0f : 0.0f;
  });
  findWalls(mesh, refinement, rings, layers, positions, height, out);
  out.slot.assign(toIndex(refinement.vertexCount), -1);
  for (std::size_t i = 0; i < out.cloth.size(); ++i) at(out.slot, out.cloth[i].vertex) = static_cast<int>(i);
  return out;
}

}  // namespace sinew
