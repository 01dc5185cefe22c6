// core/surface/finish/cloth_lift.cpp: cloth follows its feet, makes room for skin, and leaves other walls of folds.
#include "core/surface/finish/cloth_lift.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/potential.h"
#include "core/surface/finish/skin_walls.h"

namespace sinew {
namespace {

constexpr float kLeastGap = 0.001f;       ///< Fraction of H, where the skin has moved.
constexpr std::size_t kClothBlock = 256;  ///< Vertices for one thread.
constexpr float kClothOverFrom = 0.2f;  ///< Cosine between the skin's normal and the direction to cloth: less is beside
constexpr float kClothOverWhole = 0.5f;    ///< the skin, more is over it.
constexpr float kClothDeepest = 0.05f;     ///< Fraction of H: deeper cloth is not searched for.
constexpr float kClear = -1.0f;            ///< In place of a gap: below no skin.
constexpr float kClearMotion = 2e-4f;      ///< Motion of a wall or the cloth from which walls count, fraction of H.
constexpr float kClearBeyond = 0.25f;      ///< Height above the wall that a vertex is moved to, fraction of its depth.
constexpr int kClearRounds = 12;           ///< Moving out of one wall may lead into the next.
constexpr float kLeastRaiseCosine = 0.5f;  ///< Divides raises along another direction, at the least.

bool footHasMoved(const Refinement& refinement, int triangle, const ClothView& view, const Surface& surface) {
  return std::ranges::any_of(at(refinement.triangles, triangle),
                             [&](int v) { return at(surface.positions, v) != at(view.patchPositions, v); });
}

struct ClothMove {
  float share = 0.0f;  ///< Fraction of the foot's motion.
  float more = 0.0f;   ///< Along the normal.
};

/// Weight of the skin that a place is below: 1 where it is the nearest by far.
float weightOf(const Walls& walls, float wholeUpTo, float noneFrom) {
  return walls.triangle < 0 ? 0.0f : 1.0f - smoothstep(wholeUpTo, noneFrom, walls.below / walls.above);
}

ClothMove clothMove(float share, float gap, float height, float way, float least) {
  ClothMove move{share, 0.0f};
  // Enough to leave the gap. Cloth below the skin in the file stays there.
  if (height > 0.0f)
    move.share = std::max(share, std::clamp(1.0f - (gap - least) / height, 0.0f, 1.0f) * smoothstep(-least, 0.0f, gap));
  if (gap < least) move.more = (least - gap) * smoothstep(-least, 0.0f, gap) * smoothstep(0.0f, least, way);
  return move;
}

}  // namespace

bool ClothLift::apply(const ClothView& view, Surface& surface) {
  if (std::ranges::equal(surface.positions, view.patchPositions)) return false;
  up_.resize(view.binding.cloth.size());
  gap_.resize(view.binding.cloth.size());
  raise_.assign(view.binding.cloth.size(), 0.0f);
  lack_.resize(view.binding.under.size());
  over_.resize(view.binding.under.size());
  follow(view, surface);
  makeRoom(view, surface);
  clearWalls(view, surface);
  return true;
}

void ClothLift::follow(const ClothView& view, Surface& surface) {
  const Refinement& refinement = *surface.refinement;
  const float least = kLeastGap * view.height;
  forEachIndex(view.binding.cloth.size(), kClothBlock, [&](std::size_t i) {
    const BoundVertex& one = view.binding.cloth[i];
    const auto v = toIndex(one.vertex);
    const glm::vec3 p = view.patchPositions[v];
    const SurfacePlace& foot = one.place;
    const glm::vec3 n0 = mixed(refinedCorners(refinement, foot.triangle, view.patchNormals), foot.shares);
    up_[i] = normalizeOr(n0, view.patchNormals[v]);
    const glm::vec3 from = mixed(refinedCorners(refinement, foot.triangle, view.patchPositions), foot.shares);
    gap_[i] = glm::dot(p - from, up_[i]) > 0.0f ? glm::distance(p, from) : 0.0f;
    if (!footHasMoved(refinement, foot.triangle, view, surface)) return;
    const glm::vec3 way = mixed(refinedCorners(refinement, foot.triangle, surface.positions), foot.shares) - from;
    const float height = glm::dot(way, up_[i]);
    const ClothMove move = clothMove(one.share, glm::dot(p - from, up_[i]), height, glm::length(way), least);
    surface.positions[v] = p + move.share * way + move.more * up_[i];
    if (gap_[i] > 0.0f) gap_[i] = glm::distance(surface.positions[v], from + way);
    surface.displacement[v] = move.share * height + move.more;
    const glm::vec3 turn = mixed(refinedCorners(refinement, foot.triangle, surface.normals), foot.shares) - n0;
    surface.normals[v] = normalizeOr(view.patchNormals[v] + move.share * turn, view.patchNormals[v]);
  });
}

void ClothLift::makeRoom(const ClothView& view, Surface& surface) {
  const Refinement& refinement = *surface.refinement;
  const float least = kLeastGap * view.height;
  forEachIndex(view.binding.under.size(), kClothBlock, [&](std::size_t i) {
    const BoundVertex& one = view.binding.under[i];
    const glm::vec3& p = at(view.patchPositions, one.vertex);
    const glm::vec3& now = at(surface.positions, one.vertex);
    lack_[i] = 0.0f;
    if (now == p) return;
    const SurfacePlace& over = one.place;
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

/// Sets the gap of vertices that are not below any skin near them to kClear. @return whether there are others
bool ClothLift::findBelow(const ClothView& view, const SkinWalls& walls, const Surface& surface) {
  const ClothBinding& binding = view.binding;
  const float deepest = kClothDeepest * view.height;
  forEachIndex((binding.cloth.size() + kClothGroup - 1) / kClothGroup, 8, [&](std::size_t g) {
    const std::size_t first = g * kClothGroup;
    const auto group = std::span(binding.inSpace).subspan(first, std::min(kClothGroup, binding.inSpace.size() - first));
    Bounds box;
    float most = 0.0f;
    for (const int i : group) {
      float& gap = at(gap_, i);
      if (!(gap > 0.0f)) continue;  // Below its own wall at least.
      gap = std::min(SkinWalls::kWallsApart * (gap + at(raise_, i)), deepest);
      most = std::max(most, gap);
      box.add(at(surface.positions, at(binding.cloth, i).vertex));
    }
    SkinWalls::NearNodes memory;
    const std::span<const int> among = walls.nearTo(box, most, memory);
    for (const int i : group) {
      const glm::vec3& p = at(surface.positions, at(binding.cloth, i).vertex);
      if (at(gap_, i) > 0.0f && !walls.isBelowAny(p, at(binding.wallsUnder, i), at(gap_, i), among))
        at(gap_, i) = kClear;
    }
  });
  return std::ranges::any_of(gap_, [](float gap) { return gap != kClear; });
}

/// Moves vertices out of walls, but no farther than the file has them.
void ClothLift::clearWalls(const ClothView& view, Surface& surface) {
  const ClothBinding& binding = view.binding;
  const Refinement& refinement = *surface.refinement;
  const std::span<const SkinLayer> layers = triangleLayers(refinement, view.layers);
  const float reach = kClothReach * view.height;
  const float deepest = kClothDeepest * view.height;
  const float least = kLeastGap * view.height;
  const SkinWalls walls(binding.walls, refinement, view.rings, layers, surface.positions, reach, walls_);
  if (!findBelow(view, walls, surface)) return;
  const SkinWalls before(binding.walls, refinement, view.rings, layers, view.patchPositions, reach, patchWalls_);
  forEachIndex(binding.cloth.size(), kClothBlock, [&](std::size_t i) {
    if (gap_[i] == kClear) return;
    const auto v = toIndex(binding.cloth[i].vertex);
    const glm::vec3 followed = surface.positions[v];
    const Walls onPatch = before.around(view.patchPositions[v], binding.wallsUnder[i], deepest);
    const float allowed = onPatch.depth * weightOf(onPatch, 1.0f / SkinWalls::kWallsApart, 1.0f);
    // Steps are found with every wall at full weight; each is then weighted by its wall and all before it.
    glm::vec3 way(0.0f);
    float weight = 1.0f;
    for (int round = 0; round < kClearRounds; ++round) {
      const glm::vec3 p = followed + way;
      const Walls now = walls.around(p, binding.wallsUnder[i], deepest);
      const float excess = now.depth - allowed;
      const float counts = weightOf(now, 1.0f, SkinWalls::kWallsApart);
      if (!(excess > 0.0f) || !(counts > 0.0f)) break;
      const glm::vec3 place = mixed(refinedCorners(refinement, now.triangle, surface.positions), now.shares);
      const glm::vec3 still = mixed(refinedCorners(refinement, now.triangle, view.patchPositions), now.shares);
      const float motion = std::max(glm::distance(place, still), glm::distance(followed, view.patchPositions[v]));
      weight *= counts * smoothstep(0.0f, kClearMotion * view.height, motion);
      const float length = excess + std::min(kClearBeyond * excess, least);
      const glm::vec3 step = length * normalizeOr(place - p, now.normal);
      way += step;
      surface.positions[v] += weight * step;
    }
    surface.displacement[v] += glm::dot(surface.positions[v] - followed, up_[i]);
  });
}

}  // namespace sinew
