// core/smoothing/projection/tile_field.h: the muscles that a tile's vertices see. Included once per instruction set.
#if defined(SINEW_TILE_FIELD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TILE_FIELD_H
#undef SINEW_TILE_FIELD_H
#else
#define SINEW_TILE_FIELD_H
#endif

#include "core/lanes/lane_points.h"
#include "core/smoothing/projection/projection_scratch.h"
#include "core/smoothing/projection/vertex_tiles.h"
#include "core/smoothing/roots/ray_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// One tile at a time: its vertices' places, the muscles near it and what a mode's kernel reads of them.
class TileField {
 protected:
  TileField(const VertexTiles& tiles, const FieldView& field, TileScratch& scratch)
      : tiles_(tiles), field_(field), scratch_(scratch) {}

  void start(const VertexTile& tile, std::span<const glm::vec3> positions) {
    tile_ = &tile;
    for (std::size_t first = 0; first < kLanes; first += width()) points_.gather(positions, tile.vertices, first);
    const std::size_t set = static_cast<std::size_t>(tile.cliqueSet);
    cliques_ = {tiles_.cliqueBegins[set], tiles_.cliqueSlots[set], tiles_.slotCounts[set]};
  }

  Bounds boundsOfTile() const {
    V3 low = points_.load(0);
    V3 high = low;
    for (std::size_t first = width(); first < kLanes; first += width()) {
      const V3 p = points_.load(first);
      low = {hn::Min(low.x, p.x), hn::Min(low.y, p.y), hn::Min(low.z, p.z)};
      high = {hn::Max(high.x, p.x), hn::Max(high.y, p.y), hn::Max(high.z, p.z)};
    }
    const auto least = [](V v) { return hn::GetLane(hn::MinOfLanes(kTag, v)); };
    const auto most = [](V v) { return hn::GetLane(hn::MaxOfLanes(kTag, v)); };
    return {{least(low.x), least(low.y), least(low.z)}, {most(high.x), most(high.y), most(high.z)}};
  }

  const TileCandidate& candidate(std::size_t i) const {
    return tiles_.candidates[static_cast<std::size_t>(tile_->firstCandidate) + i];
  }
  const PosedPrimitive& primitive(int index) const { return field_.primitives[static_cast<std::size_t>(index)]; }
  const UnitBallMap& influence(int index) const { return primitive(index).influence; }

  bool nearIsShaped() const {
    for (std::size_t n = 0; n < nearCount_; ++n) {
      const std::size_t i = static_cast<std::size_t>(scratch_.near[n]);
      if (!influence(candidate(i).primitive).isPlain()) return true;
    }
    return false;
  }

  /// Lanes know ellipsoids alone.
  void leaveToScalar() {
    for (std::size_t first = 0; first < kLanes; first += width()) {
      forEach(asked(first), first, [&](std::size_t lane) { scratch_.shaped.push_back(tile_->vertices[lane]); });
    }
  }

  /// Lanes that hold a vertex of their own that is to be projected.
  M asked(std::size_t first) const {
    const auto& skipped = field_.skipped;
    const auto isAsked = [&](std::size_t lane) {
      if (lane >= static_cast<std::size_t>(tile_->used)) return false;
      return skipped.empty() || skipped[static_cast<std::size_t>(tile_->carriers[lane])] == 0;
    };
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < width(); ++i) bits |= static_cast<std::uint64_t>(isAsked(first + i)) << i;
    return hn::LoadMaskBits(kTag, reinterpret_cast<const std::uint8_t*>(&bits));
  }

  V weightedStrength(std::size_t i, const PosedPrimitive& muscle, std::size_t first) const {
    const LaneFloats& weights = tiles_.weights[static_cast<std::size_t>(tile_->firstCandidate) + i];
    return all(muscle.strength) * hn::Load(kTag, weights.at(first));
  }

  /// r^2 is scale |y|^2, y = inBall(ball, x - center).
  static HWY_INLINE V scaleOf(const UnitBallMap& ball) {
    return all(ball.inverseRadius > 0.0f ? ball.inverseRadius * ball.inverseRadius : 1.0f);
  }
  static HWY_INLINE V3 inBall(const UnitBallMap& ball, const V3& v) {
    return ball.inverseRadius > 0.0f ? v : times(ball.toUnit, v);
  }

  HWY_INLINE V slotSum(std::size_t clique, std::size_t which, std::size_t first) const {
    V sum = zero();
    for (int i = cliques_.begin[clique]; i < cliques_.begin[clique + 1]; ++i) {
      const int slot = cliques_.slots[static_cast<std::size_t>(i)];
      sum = sum + hn::Load(kTag, scratch_.lanes.sums[static_cast<std::size_t>(slot)].of[which].at(first));
    }
    return sum;
  }

  void giveUp(M mask, std::size_t first) {
    if (!any(mask)) return;
    forEach(mask, first, [&](std::size_t lane) { scratch_.uncertified.push_back(tile_->vertices[lane]); });
  }

  /// F's gradient at s along the directions, and in `value` sign * F.
  V3 gradientAt(const V3& x, const RayLanes& rays, const LaneSkin& skin, V t, V& value, std::size_t first) const {
    V3 gradient{zero(), zero(), zero()};
    value = zero();
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) {
      for (LaneFloats& sum : scratch_.lanes.sums[slot].of) rays.store(zero(), sum);
    }
    for (const LaneTerm& term : rays.terms()) {
      const V along = t - rays.load(term.middle);
      const V w = hn::Max(zero(), rays.load(term.peak) - rays.load(term.a) * along * along);
      if (!any(hn::Gt(w, zero()))) continue;
      const UnitBallMap& ball = influence(term.primitive);
      V3 y = x - all(ball.center);
      if (ball.inverseRadius > 0.0f) {
        y = all(ball.inverseRadius * ball.inverseRadius) * y;
      } else {
        y = transposedTimes(ball.toUnit, times(ball.toUnit, y));
      }
      const V fw = rays.load(term.factor) * w;
      const V3 part = (all(-4.0f) * skin.sign * fw) * y;
      if (cliques_.empty() || term.slot == LaneTerm::kEverySum) {
        value = value + fw * w;
        gradient = gradient + part;
      } else {
        SlotSums& sums = scratch_.lanes.sums[static_cast<std::size_t>(term.slot)];
        rays.store(rays.load(sums.of[0]) + fw * w, sums.of[0]);
        rays.store(rays.load(sums.of[1]) + part.x, sums.of[1]);
        rays.store(rays.load(sums.of[2]) + part.y, sums.of[2]);
        rays.store(rays.load(sums.of[3]) + part.z, sums.of[3]);
      }
    }
    V best = zero();
    V3 bestGradient{zero(), zero(), zero()};
    for (std::size_t k = 0; k + 1 < cliques_.begin.size(); ++k) {
      const V sum = slotSum(k, 0, first);
      const M wins = hn::Gt(skin.sign * sum, skin.sign * best);
      best = choose(wins, sum, best);
      bestGradient = choose(wins, V3{slotSum(k, 1, first), slotSum(k, 2, first), slotSum(k, 3, first)}, bestGradient);
    }
    value = value + best;
    return gradient + bestGradient;
  }

  const VertexTiles& tiles_;
  const FieldView& field_;
  TileScratch& scratch_;
  const VertexTile* tile_ = nullptr;
  std::size_t nearCount_ = 0;  ///< Of scratch_.near: indices of the tile's candidates.
  LaneCliques cliques_;
  LanePoints points_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
