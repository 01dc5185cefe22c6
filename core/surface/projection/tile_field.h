// core/surface/projection/tile_field.h: the muscles that a tile's vertices see. Included once per instruction set.
#if defined(SINEW_TILE_FIELD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_TILE_FIELD_H
#undef SINEW_TILE_FIELD_H
#else
#define SINEW_TILE_FIELD_H
#endif

#include <algorithm>
#include <span>

#include "core/geometry/lanes.h"
#include "core/surface/projection/projection_scratch.h"
#include "core/surface/projection/vertex_tiles.h"
#include "core/surface/roots/ray_lanes.h"
#include "core/surface/roots/root_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// One tile at a time: its vertices, the muscles near it, and what the kernels of both modes read of them.
class TileField {
 protected:
  TileField(const VertexTiles& tiles, const FieldView& field, TileScratch& scratch)
      : tiles_(tiles), field_(field), scratch_(scratch) {
    soft_ = haveSoftGrooves(field.primitives);
  }

  void start(const VertexTile& tile, std::span<const glm::vec3> positions) {
    tile_ = &tile;
    for (std::size_t first = 0; first < kLanes; first += width()) points_.gather(positions, tile.vertices, first);
    const CliqueLevelsView all = field_.cliquesIn(tile.cliqueSet);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const CliqueLists& cliques = all[i].cliques;
      scratch_.lanes.levels[i] = {static_cast<float>(all[i].weight),
                                  {cliques.begins(), cliques.slots(), all[i].owners, cliques.slotCount(), soft_}};
    }
    levels_.first = all.empty() ? LaneCliques{.soft = soft_} : scratch_.lanes.levels[0].cliques;
    levels_.several = std::span<const LaneLevel>(scratch_.lanes.levels).first(all.size() > 1 ? all.size() : 0);
  }

  Bounds boundsOfTile() const {
    V3 low = points_.load(0);
    V3 high = low;
    for (std::size_t first = width(); first < kLanes; first += width()) {
      const V3 p = points_.load(first);
      low = {hn::Min(low.x, p.x), hn::Min(low.y, p.y), hn::Min(low.z, p.z)};
      high = {hn::Max(high.x, p.x), hn::Max(high.y, p.y), hn::Max(high.z, p.z)};
    }
    const auto min = [](V v) { return hn::GetLane(hn::MinOfLanes(kTag, v)); };
    const auto max = [](V v) { return hn::GetLane(hn::MaxOfLanes(kTag, v)); };
    return {{min(low.x), min(low.y), min(low.z)}, {max(high.x), max(high.y), max(high.z)}};
  }

  const TileCandidate& candidate(std::size_t i) const {
    return tiles_.candidates[static_cast<std::size_t>(tile_->firstCandidate) + i];
  }
  const PosedPrimitive& primitive(int index) const { return field_.primitives[static_cast<std::size_t>(index)]; }
  const UnitBallMap& influence(int index) const { return primitive(index).influence; }

  bool isSkipped(const VertexTile& tile) const {
    const auto& skipped = field_.skipped;
    const auto carriers = std::span(tile.carriers).first(static_cast<std::size_t>(tile.used));
    return !skipped.empty() &&
           std::ranges::all_of(carriers, [&](int c) { return skipped[static_cast<std::size_t>(c)] != 0; });
  }

  /// Lanes that hold a vertex of their own that is to be projected.
  M asked() const {
    const auto& skipped = field_.skipped;
    const auto isAsked = [&](std::size_t lane) {
      if (lane >= static_cast<std::size_t>(tile_->used)) return false;
      return skipped.empty() || skipped[static_cast<std::size_t>(tile_->carriers[lane])] == 0;
    };
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < width(); ++i) bits |= static_cast<std::uint64_t>(isAsked(first_ + i)) << i;
    return hn::LoadMaskBits(kTag, reinterpret_cast<const std::uint8_t*>(&bits));
  }

  V weightedStrength(std::size_t i, const PosedPrimitive& muscle) const {
    const LaneFloats& weights = tiles_.weights[static_cast<std::size_t>(tile_->firstCandidate) + i];
    return all(muscle.strength) * hn::Load(kTag, weights.at(first_));
  }

  /// y = inBall(ball, x - center) is in unit space up to a scale: r^2 of an ellipsoid is scale |y|^2.
  static HWY_INLINE V scaleOf(const UnitBallMap& ball) {
    return all(ball.inverseRadius > 0.0f ? ball.inverseRadius * ball.inverseRadius : 1.0f);
  }
  static HWY_INLINE V3 inBall(const UnitBallMap& ball, const V3& v) {
    return ball.inverseRadius > 0.0f ? v : times(ball.toUnit, v);
  }

  /// r^2 at v from the center.
  V rSquared(const UnitBallMap& ball, const V3& v) const {
    const V3 y = inBall(ball, v);
    return ball.isPlain() ? scaleOf(ball) * dot(y, y) : shapeRSquared(shapePoint(numbersOf(ball.shape), y));
  }

  void clearTerms() { scratch_.lanes.termCount = scratch_.lanes.shapeCount = 0; }

  /// The candidate's potential along lines p + t d: a shape goes to scratch_.lanes.
  /// @param ahead  only t >= 0 counts.  @return whether `term` was filled: with an ellipsoid that some line that sees
  /// it meets.
  bool addTerm(std::size_t i, const V3& p, const V3& d, V factor, M seen, bool ahead, LaneTerm& term) {
    const TileCandidate& of = candidate(i);
    const PosedPrimitive& muscle = primitive(of.primitive);
    const UnitBallMap& ball = muscle.influence;
    const V3 fromCenter = p - all(ball.center);
    const M near = mayMeet(fromCenter, d, ball.boundingRadius, ahead);
    if (!any(both(seen, near))) return false;
    const V3 y = inBall(ball, fromCenter);
    const V3 yd = inBall(ball, d);
    const int slot = muscle.strength < 0.0f ? LaneTerm::kEverySum : of.slot;
    if (HWY_UNLIKELY(!ball.isPlain())) {
      LaneShape& shape = scratch_.lanes.shapes[scratch_.lanes.shapeCount];
      shape.primitive = of.primitive;
      shape.slot = slot;
      shape.groove = muscle.groove;
      const M met = both(both(seen, near), fillShape(ball.shape, y, yd, first_, shape));
      hn::Store(hn::IfThenElseZero(met, factor), kTag, shape.factor.at(first_));
      if (any(ahead ? both(met, hn::Gt(ShapeOnRays(shape, first_).box().high, zero())) : met)) {
        ++scratch_.lanes.shapeCount;
      }
      return false;
    }
    const V squared = dot(yd, yd);
    const V middle = zero() - dot(y, yd) / squared;
    const V3 nearest = y + middle * yd;
    const V peak = all(1.0f) - scaleOf(ball) * dot(nearest, nearest);
    const V a = scaleOf(ball) * squared;
    if (!any(both(seen, ahead ? liesAhead(a, middle, peak) : hn::Gt(peak, zero())))) return false;
    hn::Store(factor, kTag, term.factor.at(first_));
    hn::Store(a, kTag, term.a.at(first_));
    hn::Store(middle, kTag, term.middle.at(first_));
    hn::Store(peak, kTag, term.peak.at(first_));
    term.primitive = of.primitive;
    term.slot = slot;
    term.groove = muscle.groove;
    return true;
  }

  /// Cliques for sums of `terms` and of the shapes. With soft grooves the slots are numbered anew.
  LaneLevels levelsOf(std::span<LaneTerm> terms) {
    if (!blends()) return levels_;
    PresentCliques& present = startPresent();
    const std::span<LaneShape> shapes = std::span(scratch_.lanes.shapes).first(scratch_.lanes.shapeCount);
    for (const LaneTerm& term : terms) present.add(term.slot, term.groove);
    for (const LaneShape& shape : shapes) present.add(shape.slot, shape.groove);
    const LaneLevels levels = present.finish();
    for (LaneTerm& term : terms) term.slot = present.numberOf(term.slot);
    for (LaneShape& shape : shapes) shape.slot = present.numberOf(shape.slot);
    return levels;
  }

  /// Cliques share F.
  bool blends() const { return soft_ && !levels_.first.empty(); }
  PresentCliques& startPresent() {
    scratch_.lanes.present.start(levels_);
    return scratch_.lanes.present;
  }

  /// Leaves vertices to the scalar path.
  void giveUp(M mask) {
    if (!any(mask)) return;
    forEach(mask, first_, [&](std::size_t lane) { scratch_.uncertified.push_back(tile_->vertices[lane]); });
  }

  /// F's gradient at x, t along the rays, and in `value` sign * F.
  V3 gradientAt(const V3& x, const RayLanes& rays, V t, V& value) const {
    const V sign = rays.skin().sense;
    const LaneCliques& cliques = rays.cliques();
    V3 gradient{zero(), zero(), zero()};
    value = zero();
    const LaneBlend& blend = rays.blend();
    blend.clearSums(cliques.mixed ? 8 : 4);
    const auto addPart = [&](int slot, float groove, V factor, V w, const V3& halfSlope) HWY_ATTR {
      const V ofPart = potential(factor, w);
      const V3 part = (all(-4.0f) * sign * (factor * potentialRate(w))) * halfSlope;
      if (blend.isEverywhere(slot)) {
        value = value + ofPart;
        gradient = gradient + part;
        return;
      }
      blend.add(slot, 0, ofPart);
      blend.add(slot, 1, part.x);
      blend.add(slot, 2, part.y);
      blend.add(slot, 3, part.z);
      if (!cliques.mixed) return;
      const V soft = all(groove);
      blend.add(slot, 4, soft * ofPart);
      blend.add(slot, 5, soft * part.x);
      blend.add(slot, 6, soft * part.y);
      blend.add(slot, 7, soft * part.z);
    };
    for (const LaneTerm& term : rays.terms()) {
      const V along = t - rays.load(term.middle);
      const V w = hn::Max(zero(), rays.load(term.peak) - rays.load(term.a) * along * along);
      if (!any(hn::Gt(w, zero()))) continue;
      const UnitBallMap& ball = influence(term.primitive);
      const V3 y = x - all(ball.center);
      const V3 halfSlope = ball.inverseRadius > 0.0f ? all(ball.inverseRadius * ball.inverseRadius) * y
                                                     : transposedTimes(ball.toUnit, times(ball.toUnit, y));
      addPart(term.slot, term.groove, rays.load(term.factor), w, halfSlope);
    }
    for (const LaneShape& shape : rays.shapes()) {
      const ShapeOnRays ray = rays.onRays(shape);
      const ShapePoint at = ray.at(t);
      const UnitBallMap& ball = influence(shape.primitive);
      addPart(shape.slot, shape.groove, ray.factor(), hn::Max(zero(), all(1.0f) - shapeRSquared(at)),
              transposedTimes(ball.toUnit, shapeHalfSlope(numbersOf(ball.shape), at)));
    }
    if (cliques.empty()) return gradient;
    if (HWY_LIKELY(rays.levels().empty())) return gradient + gradientOfGroups(rays, value);
    for (const LaneLevel& level : rays.levels()) {
      V ofLevel = zero();
      const V3 part = gradientOfGroups(rays.with(level), ofLevel);
      value = value + all(level.weight) * ofLevel;
      gradient = gradient + all(level.weight) * part;
    }
    return gradient;
  }

  /// Of the groups' sums, as gradientAt() has added them. Adds F to `value`.
  V3 gradientOfGroups(const RayLanes& rays, V& value) const {
    const V sign = rays.skin().sense;
    const LaneCliques& cliques = rays.cliques();
    const LaneBlend& blend = rays.blend();
    if (cliques.soft) {
      blend.share(0, 4);
      value = value + blend.partOf(0, 4);
      return V3{blend.partOf(1, 5), blend.partOf(2, 6), blend.partOf(3, 7)};
    }
    V best = zero();
    V3 bestGradient{zero(), zero(), zero()};
    const auto gradientOf = [&](std::size_t k) HWY_ATTR {
      return V3{blend.sumOf(k, 1), blend.sumOf(k, 2), blend.sumOf(k, 3)};
    };
    for (std::size_t k = 0; k < cliques.count(); ++k) {
      const V sum = blend.sumOf(k, 0);
      const M wins = hn::Gt(sign * sum, sign * best);
      best = select(wins, sum, best);
      bestGradient = select(wins, gradientOf(k), bestGradient);
    }
    value = value + best;
    V share = zero();
    V most = zero();
    V3 other{zero(), zero(), zero()};
    for (std::size_t k = 0; k < cliques.count(); ++k) {
      const V sum = sign * blend.sumOf(k, 0);
      const V near = hn::Min(all(kTie) - (sign * best - sum), sum);
      if (!any(hn::Gt(near, zero()))) continue;
      const V3 own = gradientOf(k);
      const V3 apart = own - bestGradient;
      const V pull = near * near * dot(apart, apart);
      const M turns = both(hn::Gt(near, zero()), hn::Gt(pull, most));
      most = select(turns, pull, most);
      share = select(turns, near, share);
      other = select(turns, own, other);
    }
    share = share * all(1.0f / kTie);
    return (all(1.0f) / (all(1.0f) + share)) * (bestGradient + share * other);
  }

  /// The largest of the residuals, by lane.
  void countResidual(V residual) {
    scratch_.counts.residualMax =
        std::max(scratch_.counts.residualMax, static_cast<double>(hn::GetLane(hn::MaxOfLanes(kTag, residual))));
  }

  const VertexTiles& tiles_;
  const FieldView& field_;
  TileScratch& scratch_;
  const VertexTile* tile_ = nullptr;
  std::size_t nearCount_ = 0;  ///< Used part of scratch_.near: indices of the tile's candidates.
  std::size_t first_ = 0;      ///< First of the current lanes.
  bool soft_ = false;          ///< Some muscle has a soft groove.
  LaneLevels levels_;          ///< Of the tile.
  LanePoints points_;

 private:
  /// Never false by rounding.  @param fromCenter  the line's origin minus the ball's center.  @param d  unit.
  static HWY_INLINE M mayMeet(const V3& fromCenter, const V3& d, float radius, bool ahead) {
    const V squared = dot(fromCenter, fromCenter);
    const V along = dot(fromCenter, d);
    const V within = all(1.01f * radius * radius) + all(1e-5f) * squared;
    const M meets = hn::Lt(squared - along * along, within);
    if (!ahead) return meets;
    return both(hn::Or(hn::Lt(along, zero()), hn::Lt(squared, within)), meets);
  }
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
