// core/smoothing/finish/cloth_lift.cpp: feet found by walks, then room for what lies between the vertices.
#include "core/smoothing/finish/cloth_lift.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/parallel.h"
#include "core/base/smoothstep.h"
#include "core/mesh/nearest_on_triangle.h"

namespace sinew {
namespace {

constexpr float kLeastGap = 0.001f;       ///< Fraction of H, where the skin has moved.
constexpr std::size_t kClothBlock = 256;  ///< Vertices that one thread looks at.
constexpr float kClothOverFrom = 0.2f;   ///< Cosine between the skin's normal and the way to the cloth: less is beside,
constexpr float kClothOverWhole = 0.5f;  ///< more is over it.
constexpr float kLeastRaiseCosine = 0.5f;  ///< A raise along another direction grows by no more than this says.

TriangleCorners refinedCorners(const Refinement& refinement, int triangle, std::span<const glm::vec3> of) {
  const std::array<int, 3>& t = at(refinement.triangles, triangle);
  return {at(of, t[0]), at(of, t[1]), at(of, t[2])};
}

bool footHasMoved(const Refinement& refinement, int triangle, const ClothView& view, const Surface& surface) {
  return std::ranges::any_of(at(refinement.triangles, triangle),
                             [&](int v) { return at(surface.positions, v) != at(view.patchPositions, v); });
}

/// How a vertex of cloth moves. @param way  of its foot.  @param gap, height  along the normal there.
struct ClothMove {
  float share = 0.0f;  ///< Of the foot's way.
  float more = 0.0f;   ///< Along the normal.
};

ClothMove clothMove(float share, float gap, float height, float way, float least) {
  ClothMove move{share, 0.0f};
  // As much as leaves the gap. What the file has below the skin is left there.
  if (height > 0.0f)
    move.share = std::max(share, std::clamp(1.0f - (gap - least) / height, 0.0f, 1.0f) * smoothstep(-least, 0.0f, gap));
  if (gap < least) move.more = (least - gap) * smoothstep(-least, 0.0f, gap) * smoothstep(0.0f, least, way);
  return move;
}

}  // namespace

bool ClothLift::apply(const ClothView& view, Surface& surface) {
  if (std::ranges::equal(surface.positions, view.patchPositions)) return false;
  up_.resize(view.binding.cloth.size());
  raise_.assign(view.binding.cloth.size(), 0.0f);
  lack_.resize(view.binding.under.size());
  over_.resize(view.binding.under.size());
  follow(view, surface);
  makeRoom(view, surface);
  return true;
}

void ClothLift::follow(const ClothView& view, Surface& surface) {
  const Refinement& refinement = *surface.refinement;
  const SurfaceWalk walk(refinement, view.rings, triangleLayers(refinement, view.layers), SkinLayer::kSkin,
                         view.patchPositions);
  const float least = kLeastGap * view.height;
  forEachIndex(view.binding.cloth.size(), kClothBlock, [&](std::size_t i) {
    const BoundVertex& one = view.binding.cloth[i];
    const auto v = toIndex(one.vertex);
    const glm::vec3 p = view.patchPositions[v];
    const SurfacePlace foot = walk.nearest(p, one.start);
    const glm::vec3 n0 = mixed(refinedCorners(refinement, foot.triangle, view.patchNormals), foot.shares);
    up_[i] = normalizeOr(n0, view.patchNormals[v]);
    if (!footHasMoved(refinement, foot.triangle, view, surface)) return;
    const glm::vec3 from = mixed(refinedCorners(refinement, foot.triangle, view.patchPositions), foot.shares);
    const glm::vec3 way = mixed(refinedCorners(refinement, foot.triangle, surface.positions), foot.shares) - from;
    const float height = glm::dot(way, up_[i]);
    const ClothMove move = clothMove(one.share, glm::dot(p - from, up_[i]), height, glm::length(way), least);
    surface.positions[v] = p + move.share * way + move.more * up_[i];
    surface.displacement[v] = move.share * height + move.more;
    const glm::vec3 turn = mixed(refinedCorners(refinement, foot.triangle, surface.normals), foot.shares) - n0;
    surface.normals[v] = normalizeOr(view.patchNormals[v] + move.share * turn, view.patchNormals[v]);
  });
}

void ClothLift::makeRoom(const ClothView& view, Surface& surface) {
  const Refinement& refinement = *surface.refinement;
  const SurfaceWalk walk(refinement, view.rings, triangleLayers(refinement, view.layers), SkinLayer::kCloth,
                         view.patchPositions);
  const float least = kLeastGap * view.height;
  forEachIndex(view.binding.under.size(), kClothBlock, [&](std::size_t i) {
    const BoundVertex& one = view.binding.under[i];
    const glm::vec3& p = at(view.patchPositions, one.vertex);
    const glm::vec3& now = at(surface.positions, one.vertex);
    lack_[i] = 0.0f;
    if (now == p) return;
    const SurfacePlace over = walk.nearest(p, one.start);
    const glm::vec3& n = at(view.patchNormals, one.vertex);
    const glm::vec3 way = mixed(refinedCorners(refinement, over.triangle, view.patchPositions), over.shares) - p;
    const float before = glm::dot(way, n);
    const float after =
        glm::dot(mixed(refinedCorners(refinement, over.triangle, surface.positions), over.shares) - now, n);
    const float wanted = std::min(before, least);
    if (!(after < wanted)) return;
    const float length = glm::length(way);
    const float isOver = length > 0.0f ? smoothstep(kClothOverFrom, kClothOverWhole, before / length) : 1.0f;
    lack_[i] = isOver * (wanted - after);
    over_[i] = over.triangle;
  });
  for (std::size_t i = 0; i < lack_.size(); ++i) {
    if (!(lack_[i] > 0.0f)) continue;
    const glm::vec3& n = at(view.patchNormals, view.binding.under[i].vertex);
    for (const int v : at(refinement.triangles, over_[i])) {
      const int slot = at(view.binding.slot, v);
      if (slot < 0) continue;
      at(raise_, slot) = std::max(at(raise_, slot), lack_[i] / std::max(kLeastRaiseCosine, glm::dot(n, at(up_, slot))));
    }
  }
  for (std::size_t i = 0; i < raise_.size(); ++i) {
    if (raise_[i] == 0.0f) continue;
    const auto v = toIndex(view.binding.cloth[i].vertex);
    surface.positions[v] += raise_[i] * up_[i];
    surface.displacement[v] += raise_[i];
  }
}

}  // namespace sinew
