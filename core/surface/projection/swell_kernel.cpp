// core/surface/projection/swell_kernel.cpp: `swell` on tiles of 16 lanes, compiled once per instruction set.
#include "core/surface/projection/tile_projection.h"

#include <cmath>

#include "core/geometry/potential.h"
#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/projection/swell_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/surface/projection/tile_field.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

#define formula HWY_INLINE
#include "core/geometry/formulas/rise.h"
using Rays = const RayLanes&;
HWY_INLINE Sample psiAt(const RayLanes& rays, V s) { return rays.sample(s); }
#include "core/geometry/formulas/overhang.h"
#undef formula

/// F on the skin, the blend width and the muscles' mean radius there.
struct OnSkin {
  V field;
  V blendWidth;
  V radius;
};

/// Ends of the rays.
struct Found {
  V t;
  M rootless;
  M known;
  V risesFrom;  ///< F only falls before this.
  V radius;     ///< Mean of the muscles' radii.
};

class TileSweller : TileField {
 public:
  explicit TileSweller(SwellInputs& inputs)
      : TileField(*inputs.tiles, inputs.field, *inputs.scratch),
        inputs_(inputs),
        tolerance_(static_cast<float>(inputs.settings.tolerance)),
        isoRoot_(isoRoot(inputs.settings.iso)),
        isoRadius_(static_cast<float>(isoRadius(static_cast<double>(inputs.settings.iso)))) {}

  void move(const VertexTile& tile) {
    if (isSkipped(tile)) return;
    start(tile, inputs_.surface->positions);
    if (!gatherNear()) return;
    for (first_ = 0; first_ < kLanes; first_ += width()) moveLanes();
  }

 private:
  /// Finds the tile's primitives that its rays can meet, as in forEachReachable(). False if there are none.
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

  void moveLanes() {
    const V3 p = points_.load(first_);
    const OnSkin onSkin = sampleSkin(p);
    const M active = both(hn::Ne(onSkin.field, zero()), asked());
    if (!any(active)) return;
    directions_.gather(inputs_.rise.directions, tile_->vertices, first_);
    const V3 d = directions_.load(first_);
    const LaneSkin skin = skinOf(onSkin);
    fillTerms(p, skin.sense * d, skin, active);
    const LaneLevels levels = levelsOf(std::span(scratch_.lanes.terms).first(scratch_.lanes.termCount));
    const RayLanes rays(scratch_.lanes, levels, skin, first_);
    const LaneRise rise = riseOf(rays, onSkin);
    const LaneSearch search = rays.bracketFromSkin(rise, active);
    const LaneRoots roots = rootsIn(rays, search, tolerance_);
    const M known = both(active, hn::Or(roots.solved, search.rootless));
    scratch_.counts.projected += static_cast<int>(hn::CountTrue(kTag, known));
    giveUp(andNot(active, known));
    const V inverseLimit =
        inverseTouchLimit(onSkin.field, all(inputs_.settings.iso), skin.isoRoot, skin.isoRadius, skin.inverseWidth);
    if (any(known)) {
      place(p, d, rays, inverseLimit,
            {select(search.rootless, rise.end, roots.t), search.rootless, known, rise.from, onSkin.radius});
    }
  }

  /// Cliques for sums on the skin.
  LaneLevels levelsOnSkin() {
    if (!blends()) return levels_;
    PresentCliques& present = startPresent();
    for (std::size_t n = 0; n < nearCount_; ++n) {
      const std::size_t i = static_cast<std::size_t>(scratch_.near[n]);
      const PosedPrimitive& muscle = primitive(candidate(i).primitive);
      if (scratch_.spans[i].gap < 0.0f && muscle.strength >= 0.0f) present.add(candidate(i).slot, muscle.groove);
    }
    return present.finish();
  }

  /// F without carves, of the groups' sums.
  static V ofGroups(const LaneBlend& sums, const LaneCliques& cliques) {
    if (cliques.soft) {
      sums.share(0, 1);
      return sums.partOf(0, 1);
    }
    V most = zero();
    for (std::size_t k = 0; k < cliques.count(); ++k) most = hn::Max(most, sums.sumOf(k, 0));
    return most;
  }

  OnSkin sampleSkin(const V3& p) {
    V carved = zero();
    V together = zero();
    V shares = zero();
    V widths = zero();
    V radii = zero();
    const LaneLevels levels = levelsOnSkin();
    const LaneCliques& cliques = levels.first;
    const LaneBlend sums(scratch_.lanes, cliques, all(1.0f), first_);
    sums.clearSums(2);
    for (std::size_t n = 0; n < nearCount_; ++n) {
      const std::size_t i = static_cast<std::size_t>(scratch_.near[n]);
      if (!(scratch_.spans[i].gap < 0.0f)) continue;
      const PosedPrimitive& muscle = primitive(candidate(i).primitive);
      const UnitBallMap& ball = muscle.influence;
      if (ball.boundingRadius == 0.0f) continue;
      const V here = hn::Max(zero(), all(1.0f) - rSquared(ball, p - all(ball.center)));
      if (!any(hn::Gt(here, zero()))) continue;
      const V value = potential(weightedStrength(i, muscle), here);
      shares = shares + hn::Abs(value);
      radii = radii + hn::Abs(value) * all(muscle.meanRadius);
      widths = widths + hn::Abs(value) * all(std::min(inputs_.settings.blendWidth, muscle.meanRadius));
      if (muscle.strength < 0.0f) {
        carved = carved + value;
        continue;
      }
      const int slot = blends() ? scratch_.lanes.present.numberOf(candidate(i).slot) : candidate(i).slot;
      if (sums.isEverywhere(slot)) {
        together = together + value;
        continue;
      }
      sums.add(slot, 0, value);
      if (cliques.mixed) sums.add(slot, 1, all(muscle.groove) * value);
    }
    if (HWY_LIKELY(levels.several.empty())) {
      if (!cliques.empty()) together = together + ofGroups(sums, cliques);
    } else {
      for (const LaneLevel& level : levels.several) {
        const LaneBlend ofLevel(scratch_.lanes, level.cliques, all(1.0f), first_);
        together = together + all(level.weight) * ofGroups(ofLevel, level.cliques);
      }
    }
    const M seen = hn::Gt(shares, zero());
    const V most = all(inputs_.settings.blendWidth);
    return {together + carved, select(seen, widths / shares, most), select(seen, radii / shares, most)};
  }

  /// Terms, in the search's direction and sign, that some active lane's ray meets ahead. A term adds 0 to the rays that
  /// do not meet it, so that no lane depends on its neighbors.
  void fillTerms(const V3& p, const V3& along, const LaneSkin& skin, M active) {
    LaneScratch& lanes = scratch_.lanes;
    clearTerms();
    for (std::size_t n = 0; n < nearCount_; ++n) {
      const std::size_t i = static_cast<std::size_t>(scratch_.near[n]);
      const PosedPrimitive& muscle = primitive(candidate(i).primitive);
      if (muscle.influence.boundingRadius == 0.0f) continue;
      const V factor = skin.sense * weightedStrength(i, muscle);
      const M seen = both(active, hn::Ne(factor, zero()));
      if (addTerm(i, p, along, factor, seen, true, lanes.terms[lanes.termCount])) ++lanes.termCount;
    }
  }

  LaneSkin skinOf(const OnSkin& onSkin) const {
    const M outward = hn::Gt(onSkin.field, zero());
    return {{select(outward, all(1.0f), all(-1.0f)), all(1.0f - isoRadius_) / onSkin.blendWidth, all(isoRadius_),
             all(isoRoot_), select(outward, all(isoRoot_), all(1e30f))},
            true,
            zero()};
  }

  /// Where terms may rise: a positive one before its middle, a negative one after it; a shape anywhere in its box.
  LaneRise riseOf(const RayLanes& rays, const OnSkin& onSkin) const {
    const LaneSkin& skin = rays.skin();
    const M outward = hn::Gt(skin.sense, zero());
    LaneRise rise{all(1e30f), zero(), select(outward, onSkin.blendWidth, all(isoRadius_) / skin.inverseWidth)};
    const auto include = [&](M met, const Range& rising, V leave) HWY_ATTR {
      rise.end = select(both(met, outward), hn::Max(rise.end, leave), rise.end);
      const M rises = both(met, hn::Gt(rising.high, zero()));
      rise.from = select(rises, hn::Min(rise.from, hn::Max(zero(), rising.low)), rise.from);
      rise.to = select(rises, hn::Max(rise.to, rising.high), rise.to);
    };
    for (const LaneTerm& term : rays.terms()) {
      const V factor = rays.load(term.factor);
      const V middle = rays.load(term.middle);
      const Range extent = rays.extentOf(term);
      const M met = both(hn::Ne(factor, zero()), liesAhead(rays.load(term.a), middle, rays.load(term.peak)));
      const M adds = hn::Gt(factor, zero());
      include(met, {select(adds, extent.low, middle), select(adds, middle, extent.high)}, extent.high);
    }
    for (const LaneShape& shape : rays.shapes()) {
      const ShapeOnRays ray = rays.onRays(shape);
      const Range box = ray.box();
      include(both(hn::Ne(ray.factor(), zero()), hn::Gt(box.high, zero())), box, box.high);
    }
    return rise;
  }

  /// The root, or less if psi falls slowly before it. Outwards, the skin's own field is steep enough up to h/2 while F
  /// does not rise; bounds of the derivative usually prove the rest.
  V belowOverhangs(const RayLanes& rays, const Found& found, M moved) const {
    const LaneSkin& skin = rays.skin();
    const V blendWidth = all(1.0f - isoRadius_) / skin.inverseWidth;
    const V sigma = overhangSlope(skin, blendWidth, found.radius);
    const V steep = select(hn::Gt(skin.sense, zero()), hn::Min(all(0.5f) * blendWidth, found.risesFrom), zero());
    M asked = both(moved, hn::Lt(steep, found.t));
    if (!any(asked)) return found.t;
    asked = both(asked, hn::Gt(rays.bounds(steep, found.t).maxSlope, zero() - sigma));
    if (!any(asked)) return found.t;
    return heightBelowOverhangs(rays, found.t, sigma, blendWidth, asked);
  }

  /// @param inverseLimit  1/L, in addition to that of other skin.
  void place(const V3& p, const V3& d, const RayLanes& rays, V inverseLimit, const Found& found) {
    const LaneSkin& skin = rays.skin();
    const V t = found.t;
    const M moved = both(found.known, hn::Ne(t, zero()));
    if (!any(moved)) return;
    const V s = skin.sense * t;
    normals_.gather(inputs_.surface->normals, tile_->vertices, first_);
    const V3 n = normals_.load(first_);
    V field;
    const V3 gradient = gradientAt(p + s * d, rays, t, field);
    countResidual(select(andNot(moved, found.rootless), hn::Abs(skin.value(t) + field), zero()));
    // s grows by 1 along d and not at all along the skin: its gradient is n / (n.d).
    const V slope = skin.slope(t) / hn::Max(dot(n, d), all(kLeastAlong));
    const V below = belowOverhangs(rays, found, moved);
    LaneFloats limits;
    for (std::size_t lane = first_; lane < first_ + width(); ++lane) {
      limits.lane[lane] = inputs_.rise.inverseLimits[static_cast<std::size_t>(tile_->vertices[lane])];
    }
    const V ofSkin = select(hn::Gt(s, zero()), hn::Load(kTag, limits.at(first_)), zero());
    const V inverse = hn::Max(inverseLimit, ofSkin);
    const V size = limitedRise(below, inverse);
    const M lowered = hn::Lt(size, t);
    const V height = skin.sense * size;
    const V3 ofField = unitOr(V3{zero(), zero(), zero()} - (slope * n + gradient), n);
    const V3 normal = select(lowered, unitOr(n + (height / s) * (ofField - n), n), ofField);
    write(p + height * d, normal, height, moved);
  }

  void write(const V3& position, const V3& normal, V height, M moved) {
    LanePoints positions;
    LaneFloats heights;
    positions.store(position, first_);
    normals_.store(normal, first_);
    hn::Store(height, kTag, heights.at(first_));
    forEach(moved, first_, [&](std::size_t lane) {
      const auto v = static_cast<std::size_t>(tile_->vertices[lane]);
      inputs_.surface->positions[v] = positions.at(lane);
      inputs_.surface->normals[v] = normals_.at(lane);
      inputs_.surface->displacement[v] = heights.lane[lane];
    });
  }

  SwellInputs& inputs_;
  float tolerance_;  ///< For roots, world units.
  float isoRoot_;
  float isoRadius_;
  LanePoints directions_;
  LanePoints normals_;
};

void swellTiles(SwellInputs& inputs) {
  TileSweller sweller(inputs);
  for (const VertexTile& tile : inputs.asked) sweller.move(tile);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

SwellKernel swellKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, swellTiles) }

}  // namespace sinew
#endif
