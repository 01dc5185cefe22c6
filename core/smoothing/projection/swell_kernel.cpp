// core/smoothing/projection/swell_kernel.cpp: `swell` on tiles of 16 lanes, compiled once per instruction set.
#include "core/smoothing/projection/swell_kernel.h"

#include <cmath>

#include "core/lanes/targets.h"
#include "core/primitives/potential.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/smoothing/projection/swell_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/smoothing/projection/tile_field.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// F on the skin and the blend width there.
struct OnSkin {
  V field;
  V blendWidth;
};

/// Where the rays end.
struct Found {
  V t;
  M rootless;
  M known;
};

class TileSweller : TileField {
 public:
  explicit TileSweller(SwellFrame& frame)
      : TileField(*frame.tiles, frame.field, *frame.scratch),
        frame_(frame),
        isoRoot_(isoRoot(frame.settings.iso)),
        isoRadius_(static_cast<float>(isoRadius(static_cast<double>(frame.settings.iso)))) {}

  void move(const VertexTile& tile) {
    start(tile, frame_.surface->positions);
    if (!gatherNear()) return;
    if (nearIsShaped()) {
      leaveToScalar();
      return;
    }
    for (std::size_t first = 0; first < kLanes; first += width()) moveLanes(first);
  }

 private:
  /// The tile's primitives that its rays can meet, as in forEachReachable(). False if there are none.
  bool gatherNear() {
    const Bounds box = boundsOfTile();
    const std::size_t count = static_cast<std::size_t>(tile_->candidateCount);
    std::vector<carrier_walk::Span>& spans = scratch_.spans;
    bool overlaps = false;
    for (std::size_t i = 0; i < count && !overlaps; ++i) {
      const UnitBallMap& ball = influence(candidate(i).primitive);
      const glm::vec3 apart = ball.center - glm::clamp(ball.center, box.low, box.high);
      overlaps = glm::dot(apart, apart) < ball.boundingRadius * ball.boundingRadius;
    }
    nearCount_ = 0;
    if (!overlaps) return false;
    for (std::size_t i = 0; i < count; ++i) spans[i] = carrier_walk::spanTo(influence(candidate(i).primitive), box);
    const float extent = carrier_walk::extentOf(std::span(spans).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      if (spans[i].gap < extent) scratch_.near[nearCount_++] = static_cast<int>(i);
    }
    return nearCount_ > 0;
  }

  void moveLanes(std::size_t first) {
    const V3 p = points_.load(first);
    const OnSkin onSkin = sampleSkin(p, first);
    const M active = both(hn::Ne(onSkin.field, zero()), asked(first));
    if (!any(active)) return;
    scratch_.counts.projected += static_cast<int>(hn::CountTrue(kTag, active));
    directions_.gather(frame_.rise.directions, tile_->vertices, first);
    const V3 d = directions_.load(first);
    const LaneSkin skin = skinOf(onSkin);
    fillTerms(p, d, skin, active, first);
    const RayLanes rays(scratch_.lanes, cliques_, skin, first);
    const LaneRise rise = riseOf(rays, skin, onSkin);
    const LaneSearch search = rays.bracket(rise, active);
    V t;
    const float tolerance = static_cast<float>(frame_.settings.tolerance);
    const M solved = rays.solve(search, tolerance, 5e-8f / tolerance, t);
    const M known = both(active, hn::Or(solved, search.rootless));
    t = choose(search.rootless, rise.end, t);
    giveUp(butNot(active, known), first);
    if (any(known)) place(p, d, skin, {t, search.rootless, known}, first);
  }

  OnSkin sampleSkin(const V3& p, std::size_t first) const {
    LaneScratch& lanes = scratch_.lanes;
    V carved = zero();
    V together = zero();
    V shares = zero();
    V widths = zero();
    for (std::size_t slot = 0; slot < cliques_.slotCount; ++slot) {
      hn::Store(zero(), kTag, lanes.sums[slot].of[0].at(first));
    }
    for (std::size_t n = 0; n < nearCount_; ++n) {
      const std::size_t i = static_cast<std::size_t>(scratch_.near[n]);
      if (!(scratch_.spans[i].gap < 0.0f)) continue;
      const PosedPrimitive& muscle = primitive(candidate(i).primitive);
      const UnitBallMap& ball = muscle.influence;
      if (ball.boundingRadius == 0.0f) continue;
      const V3 y = inBall(ball, p - all(ball.center));
      const V here = hn::Max(zero(), all(1.0f) - scaleOf(ball) * dot(y, y));
      if (!any(hn::Gt(here, zero()))) continue;
      const V value = weightedStrength(i, muscle, first) * here * here;
      shares = shares + hn::Abs(value);
      widths = widths + hn::Abs(value) * all(std::min(frame_.settings.blendWidth, muscle.meanRadius));
      if (muscle.strength < 0.0f) {
        carved = carved + value;
      } else if (cliques_.empty()) {
        together = together + value;
      } else {
        LaneFloats& sum = lanes.sums[static_cast<std::size_t>(candidate(i).slot)].of[0];
        hn::Store(hn::Load(kTag, sum.at(first)) + value, kTag, sum.at(first));
      }
    }
    for (std::size_t k = 0; k + 1 < cliques_.begin.size(); ++k) together = hn::Max(together, slotSum(k, 0, first));
    const V width = choose(hn::Gt(shares, zero()), widths / shares, all(frame_.settings.blendWidth));
    return {together + carved, width};
  }

  /// Terms in the search's direction and sign: those that some active lane's ray meets ahead. A term that a ray does
  /// not meet adds 0 to it, so that no lane depends on what its neighbours meet.
  void fillTerms(const V3& p, const V3& d, const LaneSkin& skin, M active, std::size_t first) {
    LaneScratch& lanes = scratch_.lanes;
    lanes.termCount = 0;
    for (std::size_t n = 0; n < nearCount_; ++n) {
      const std::size_t i = static_cast<std::size_t>(scratch_.near[n]);
      const PosedPrimitive& muscle = primitive(candidate(i).primitive);
      const UnitBallMap& ball = muscle.influence;
      if (ball.boundingRadius == 0.0f) continue;
      const V factor = skin.sign * weightedStrength(i, muscle, first);
      const M seen = both(active, hn::Ne(factor, zero()));
      const V3 fromCenter = p - all(ball.center);
      if (!any(both(seen, mayMeet(fromCenter, skin.sign * d, ball.boundingRadius)))) continue;
      const V3 y = inBall(ball, fromCenter);
      const V3 yd = inBall(ball, d);
      const V scale = scaleOf(ball);
      const V squared = dot(yd, yd);
      const V middle = zero() - dot(y, yd) / squared;
      const V3 nearest = y + middle * yd;
      const V peak = all(1.0f) - scale * dot(nearest, nearest);
      const V a = scale * squared;
      const V ahead = skin.sign * middle;
      if (!any(both(seen, liesAhead(a, ahead, peak)))) continue;
      LaneTerm& term = lanes.terms[lanes.termCount++];
      hn::Store(a, kTag, term.a.at(first));
      hn::Store(ahead, kTag, term.middle.at(first));
      hn::Store(peak, kTag, term.peak.at(first));
      hn::Store(factor, kTag, term.factor.at(first));
      term.primitive = candidate(i).primitive;
      term.slot = muscle.strength < 0.0f ? LaneTerm::kEverySum : candidate(i).slot;
    }
  }

  LaneSkin skinOf(const OnSkin& onSkin) const {
    const M outward = hn::Gt(onSkin.field, zero());
    return {choose(outward, all(1.0f), all(-1.0f)),
            all(1.0f - isoRadius_) / onSkin.blendWidth,
            all(isoRadius_),
            all(isoRoot_),
            choose(outward, all(isoRoot_), all(1e30f)),
            zero()};
  }

  /// Where terms may rise: before its middle one that adds, after it one that takes away.
  LaneRise riseOf(const RayLanes& rays, const LaneSkin& skin, const OnSkin& onSkin) const {
    const M outward = hn::Gt(skin.sign, zero());
    LaneRise rise{all(1e30f), zero(), choose(outward, onSkin.blendWidth, all(isoRadius_) / skin.inverseWidth)};
    for (const LaneTerm& term : rays.terms()) {
      const V factor = rays.load(term.factor);
      const V middle = rays.load(term.middle);
      const V peak = rays.load(term.peak);
      const V a = rays.load(term.a);
      const V half = hn::Sqrt(hn::Max(zero(), peak) / a);
      const V leave = middle + half;
      const M met = both(hn::Ne(factor, zero()), liesAhead(a, middle, peak));
      rise.end = choose(both(met, outward), hn::Max(rise.end, leave), rise.end);
      const M adds = hn::Gt(factor, zero());
      const V from = hn::Max(zero(), choose(adds, middle - half, middle));
      const V to = choose(adds, middle, leave);
      const M rises = both(met, hn::Gt(to, zero()));
      rise.from = choose(rises, hn::Min(rise.from, from), rise.from);
      rise.to = choose(rises, hn::Max(rise.to, to), rise.to);
    }
    return rise;
  }

  void place(const V3& p, const V3& d, const LaneSkin& skin, const Found& found, std::size_t first) {
    const V t = found.t;
    const M moved = both(found.known, hn::Ne(t, zero()));
    if (!any(moved)) return;
    const RayLanes rays(scratch_.lanes, cliques_, skin, first);
    const V s = skin.sign * t;
    normals_.gather(frame_.surface->normals, tile_->vertices, first);
    const V3 n = normals_.load(first);
    V field;
    const V3 gradient = gradientAt(p + s * d, rays, skin, t, field, first);
    const V residual = choose(butNot(moved, found.rootless), hn::Abs(skin.value(t) + field), zero());
    scratch_.counts.residualMax =
        std::max(scratch_.counts.residualMax, static_cast<double>(hn::GetLane(hn::MaxOfLanes(kTag, residual))));
    // s grows by 1 along d and not at all along the skin: its gradient is n / (n.d).
    const V slope = skin.slope(t) / hn::Max(dot(n, d), all(kLeastAlong));
    LaneFloats limits;
    for (std::size_t lane = first; lane < first + width(); ++lane) {
      limits.lane[lane] = frame_.rise.inverseLimits[static_cast<std::size_t>(tile_->vertices[lane])];
    }
    const V inverse = hn::Load(kTag, limits.at(first));
    const V limit = all(1.0f) / inverse;
    const M limited = hn::Gt(s * inverse, all(0.5f));
    const V height = choose(limited, limit - all(0.25f) * limit * limit / s, s);
    const V3 ofField = unitOr(V3{zero(), zero(), zero()} - (slope * n + gradient), n);
    const V3 normal = choose(limited, unitOr(n + (height / s) * (ofField - n), n), ofField);
    write(p + height * d, normal, height, moved, first);
  }

  void write(const V3& position, const V3& normal, V height, M moved, std::size_t first) {
    LanePoints positions;
    LaneFloats heights;
    positions.store(position, first);
    normals_.store(normal, first);
    hn::Store(height, kTag, heights.at(first));
    forEach(moved, first, [&](std::size_t lane) {
      const auto v = static_cast<std::size_t>(tile_->vertices[lane]);
      frame_.surface->positions[v] = positions.at(lane);
      frame_.surface->normals[v] = normals_.at(lane);
      frame_.surface->displacement[v] = heights.lane[lane];
    });
  }

  SwellFrame& frame_;
  float isoRoot_;
  float isoRadius_;
  LanePoints directions_;
  LanePoints normals_;
};

void swellTiles(SwellFrame& frame) {
  TileSweller sweller(frame);
  for (const VertexTile& tile : frame.asked) sweller.move(tile);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "core/lanes/dispatch.h"

namespace sinew {

SwellKernel swellKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, swellTiles) }

}  // namespace sinew
#endif
