// core/surface/projection/replace_kernel.cpp: `replace` on tiles of 16 lanes, compiled once per instruction set.
#include "core/surface/projection/tile_projection.h"

#include <algorithm>

#include "core/geometry/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/projection/replace_kernel.cpp"
#include "hwy/foreach_target.h"
//
#include "core/surface/projection/tile_field.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Roots composited front to back (replace.h).
struct CompositeLanes {
  V3 position;
  V3 normal;
  V weight;
  V residual;
  M found;

  [[nodiscard]] V left() const { return all(1.0f) - weight; }
};

struct LineLanes {
  V3 p;
  V3 inwards;  ///< Unit.
  V3 n;        ///< Normal for a root without a gradient.
  V length;    ///< Inwards, to the anchor.
};

HWY_INLINE V3 zero3() { return {zero(), zero(), zero()}; }

/// A change of sign along a line.
struct FoundLanes {
  V t;
  M found;
};

class TileReplacer : TileField {
 public:
  explicit TileReplacer(ReplaceInputs& inputs)
      : TileField(*inputs.tiles, inputs.field, *inputs.scratch),
        inputs_(inputs),
        toAnchors_(inputs.wraps && !inputs.settings.alongNormals),
        tolerance_(static_cast<float>(inputs.settings.tolerance)),
        skin_{{zero(), zero(), zero(), zero(), zero()}, false, zero()},
        asked_(none()),
        open_(none()),
        fallback_(none()) {}

  void move(const VertexTile& tile) {
    if (isSkipped(tile)) return;
    start(tile, inputs_.flat.positions);
    if (!gatherNear()) return;
    for (first_ = 0; first_ < kLanes; first_ += width()) moveLanes();
  }

 private:
  /// Finds the tile's muscles that its vertices' lines can meet. False if there are none.
  bool gatherNear() {
    float reach = inputs_.settings.searchLength;
    for (int lane = 0; toAnchors_ && lane < tile_->used; ++lane) {
      const auto v = static_cast<std::size_t>(tile_->vertices[static_cast<std::size_t>(lane)]);
      reach = std::max(reach, glm::distance(inputs_.flat.positions[v], inputs_.flat.anchors[v]));
    }
    const Bounds box = boundsOfTile();
    nearCount_ = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(tile_->candidateCount); ++i) {
      const UnitBallMap& ball = influence(candidate(i).primitive);
      if (ball.boundingRadius == 0.0f) continue;
      const glm::vec3 apart = ball.center - glm::clamp(ball.center, box.low, box.high);
      const float within = reach + ball.boundingRadius;
      if (glm::dot(apart, apart) < within * within) scratch_.near[nearCount_++] = static_cast<int>(i);
    }
    return nearCount_ > 0;
  }

  void moveLanes() {
    LaneFloats omega;
    LanePoints anchors;
    for (std::size_t lane = first_; lane < first_ + width(); ++lane) {
      const auto v = static_cast<std::size_t>(tile_->vertices[lane]);
      omega.lane[lane] = inputs_.omega[v];
      anchors.set(lane, inputs_.flat.anchors[v]);
      normals_.set(lane, inputs_.flat.normals[v]);
    }
    open_ = withMuscles(both(asked(), hn::Gt(hn::Load(kTag, omega.at(first_)), zero())));
    if (!any(open_)) return;
    const V3 p = points_.load(first_);
    const V3 n = normals_.load(first_);
    const V3 back = zero3() - n;
    const V search = all(inputs_.settings.searchLength);
    LineLanes line{p, back, n, search};
    if (toAnchors_) {
      const V3 way = anchors.load(first_) - p;
      line.length = hn::Sqrt(dot(way, way));
      line.inwards = unitOr(way, back);
    }
    fillLines(line);
    const M inside = both(open_, hn::Gt(raysOf(kOn, kFall).sample(zero()).value, zero()));
    if (!inputs_.wraps) open_ = inside;
    asked_ = open_;
    CompositeLanes composite{zero3(), zero3(), zero(), zero(), none()};
    compositeLine(line, inside, composite);
    if (toAnchors_) {
      // The anchor is not always inside.
      const M again = both(andNot(open_, inside), hn::Gt(composite.left(), zero()));
      fallback_ = again;
      if (any(again)) {
        const LineLanes along{p, back, n, search};
        const M others = andNot(open_, again);
        open_ = again;
        fillLines(along);
        compositeIntervals(along, zero(), composite);
        open_ = hn::Or(open_, others);
      }
    } else {
      fallback_ = none();
    }
    finish(composite, omega);
  }

  /// Lanes where some muscle has weight.
  M withMuscles(M lanes) const {
    M seen = none();
    for (std::size_t i = 0; i < static_cast<std::size_t>(tile_->candidateCount) && any(andNot(lanes, seen)); ++i) {
      const LaneFloats& weights = tiles_.weights[static_cast<std::size_t>(tile_->firstCandidate) + i];
      seen = hn::Or(seen, hn::Gt(hn::Load(kTag, weights.at(first_)), zero()));
    }
    return both(lanes, seen);
  }

  /// Muscles along the lines, in both directions.
  void fillLines(const LineLanes& line) {
    lineCount_ = 0;
    clearTerms();
    for (std::size_t k = 0; k < nearCount_; ++k) {
      const std::size_t i = static_cast<std::size_t>(scratch_.near[k]);
      const V factor = weightedStrength(i, primitive(candidate(i).primitive));
      const M seen = both(open_, hn::Ne(factor, zero()));
      if (addTerm(i, line.p, line.inwards, factor, seen, false, scratch_.lines[lineCount_])) ++lineCount_;
    }
    lineLevels_ = levelsOf(std::span(scratch_.lines).first(lineCount_));
  }

  static constexpr float kOn = 1.0f;     ///< Direction along a line: inwards
  static constexpr float kBack = -1.0f;  ///< or outwards.
  static constexpr float kFall = 1.0f;   ///< Change to find: F falls to T,
  static constexpr float kRise = -1.0f;  ///< or rises to T.

  /// psi = sense (F - T) at s = way t on the lines.
  RayLanes raysOf(float way, float sense) {
    LaneScratch& lanes = scratch_.lanes;
    lanes.termCount = lineCount_;
    for (std::size_t i = 0; i < lineCount_; ++i) {
      const LaneTerm& line = scratch_.lines[i];
      LaneTerm& term = lanes.terms[i];
      const auto copy = [&](const LaneFloats& from, LaneFloats& to, float times)
                            HWY_ATTR { hn::Store(all(times) * hn::Load(kTag, from.at(first_)), kTag, to.at(first_)); };
      copy(line.a, term.a, 1.0f);
      copy(line.middle, term.middle, way);
      copy(line.peak, term.peak, 1.0f);
      copy(line.factor, term.factor, sense);
      term.primitive = line.primitive;
      term.slot = line.slot;
      term.groove = line.groove;
    }
    for (LaneShape& shape : std::span(lanes.shapes).first(lanes.shapeCount)) {
      shape.way = way;
      shape.sense = sense;
    }
    const float iso = inputs_.settings.iso;
    skin_ = {{all(sense), zero(), zero(), zero(), zero()}, false, all(-sense * iso)};
    return RayLanes(lanes, lineLevels_, skin_, first_);
  }

  /// First change of sign. Removes uncertified lanes from open_.
  FoundLanes findChange(const RayLanes& rays, V begin, V end, M active) {
    const LaneSearch search = rays.bracketBetween(begin, end, active);
    const LaneRoots roots = rootsIn(rays, search, tolerance_);
    open_ = andNot(open_, andNot(active, hn::Or(roots.solved, search.rootless)));
    return {roots.t, both(both(active, roots.solved), open_)};
  }

  /// Largest sampled F - T of an interval, or enough for full weight.
  /// @param rays  that search for falls.  @param largest  known so far.
  V prominence(const RayLanes& rays, V begin, V end, M active, V largest) const {
    const V whole = all(kFullProminence * inputs_.settings.iso);
    for (const int tenths : kProminenceSamples) {
      if (!any(both(active, hn::Lt(largest, whole)))) break;
      const V t = begin + (end - begin) * all(0.1f * static_cast<float>(tenths));
      largest = hn::Max(largest, rays.sample(t).value);
    }
    return largest;
  }

  void compositeLine(const LineLanes& line, M inside, CompositeLanes& composite) {
    V ownEnd = zero();
    if (any(inside)) {
      const RayLanes out = raysOf(kBack, kFall);
      const FoundLanes root = findChange(out, zero(), all(inputs_.settings.searchLength), inside);
      const V outside = prominence(out, zero(), root.t, root.found, zero());
      const V residual = hn::Abs(out.sample(root.t).value);
      const RayLanes on = raysOf(kOn, kFall);
      const FoundLanes own = findChange(on, zero(), line.length, both(inside, open_));
      ownEnd = select(own.found, own.t, select(inside, line.length, zero()));
      const V atSkin = hn::Max(outside, on.sample(zero()).value);
      const V largest = prominence(on, zero(), ownEnd, root.found, atSkin);
      compositeRoot(line, zero() - root.t, {largest, residual}, both(root.found, open_), composite);
    }
    if (inputs_.wraps) compositeIntervals(line, ownEnd, composite);
  }

  /// From `begin` inwards while there is weight left.
  void compositeIntervals(const LineLanes& line, V begin, CompositeLanes& composite) {
    const V reachable = hn::Min(line.length, all(inputs_.settings.searchLength));
    const V nudge = all(4.0f * tolerance_);  // Off a root, where rounding decides the sign.
    V t = select(hn::Gt(begin, zero()), begin + nudge, zero());
    M goesOn = open_;
    for (int i = 0; i < kMostIntervals; ++i) {
      goesOn = both(both(goesOn, open_), both(hn::Lt(t, reachable), hn::Gt(composite.left(), zero())));
      if (!any(goesOn)) return;
      const FoundLanes in = findChange(raysOf(kOn, kRise), t, reachable, goesOn);
      goesOn = in.found;
      if (!any(goesOn)) return;
      const RayLanes falls = raysOf(kOn, kFall);
      const FoundLanes out = findChange(falls, in.t + nudge, line.length, goesOn);
      const V end = select(out.found, out.t, line.length);
      const V residual = hn::Abs(falls.sample(in.t).value);
      compositeRoot(line, in.t, {prominence(falls, in.t, end, goesOn, zero()), residual}, both(goesOn, open_),
                    composite);
      t = end + nudge;
    }
  }

  struct RootLanes {
    V prominence;
    V residual;
  };

  /// Adds a root at t inwards. Expects the rays that search inwards for falls.
  void compositeRoot(const LineLanes& line, V t, const RootLanes& root, M mask, CompositeLanes& composite) {
    if (!any(mask)) return;
    const V far = (hn::Abs(t) / all(inputs_.settings.searchLength) - all(kFadeBegin)) / all(1.0f - kFadeBegin);
    const V share = root.prominence / all(kFullProminence * inputs_.settings.iso);
    const V own = smoothstep(zero(), all(1.0f), share) * (all(1.0f) - smoothstep(zero(), all(1.0f), far));
    const M whole = hn::Ge(own, all(1.0f));
    const V weight = select(whole, composite.left(), own * composite.left());
    composite.found = hn::Or(composite.found, mask);
    composite.residual = select(mask, hn::Max(composite.residual, root.residual), composite.residual);
    const M counts = both(mask, hn::Gt(weight, zero()));
    if (!any(counts)) return;
    const V3 x = line.p + t * line.inwards;
    const RayLanes rays(scratch_.lanes, lineLevels_, skin_, first_);
    V value;
    const V3 gradient = gradientAt(x, rays, t, value);
    const V3 normal = unitOr(zero3() - gradient, line.n);
    composite.position = select(counts, composite.position + weight * x, composite.position);
    composite.normal = select(counts, composite.normal + weight * normal, composite.normal);
    composite.weight = select(counts, select(whole, all(1.0f), composite.weight + weight), composite.weight);
  }

  void finish(const CompositeLanes& composite, const LaneFloats& omega) {
    giveUp(andNot(asked_, open_));
    const M done = both(asked_, open_);
    scratch_.counts.projected += static_cast<int>(hn::CountTrue(kTag, done));
    scratch_.counts.unresolved += static_cast<int>(hn::CountTrue(kTag, andNot(done, composite.found)));
    scratch_.counts.anchorFallbacks += static_cast<int>(hn::CountTrue(kTag, both(done, fallback_)));
    countResidual(select(both(done, composite.found), composite.residual, zero()));
    LanePoints positions;
    LaneFloats weights;
    positions.store(composite.position, first_);
    normals_.store(composite.normal, first_);
    hn::Store(composite.weight, kTag, weights.at(first_));
    forEach(both(done, hn::Gt(composite.weight, zero())), first_, [&](std::size_t lane) {
      const auto v = static_cast<std::size_t>(tile_->vertices[lane]);
      const float limit = inputs_.wraps || inputs_.flat.inverseLimits.empty() ? 0.0f : inputs_.flat.inverseLimits[v];
      placeReplaced({positions.at(lane), normals_.at(lane), weights.lane[lane]}, omega.lane[lane], limit, v,
                    *inputs_.surface);
    });
  }

  ReplaceInputs& inputs_;
  bool toAnchors_;             ///< Lines go to the anchors; otherwise along the normals.
  float tolerance_;            ///< For roots, world units.
  std::size_t lineCount_ = 0;  ///< Used part of scratch_.lines.
  LaneLevels lineLevels_;      ///< Of their terms.
  LaneSkin skin_;
  M asked_;
  M open_;  ///< Lanes of asked_ that are still certified.
  M fallback_;
  LanePoints normals_;
};

void replaceTiles(ReplaceInputs& inputs) {
  TileReplacer replacer(inputs);
  for (const VertexTile& tile : inputs.asked) replacer.move(tile);
}

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace sinew {

ReplaceKernel replaceKernel(InstructionSet set) { SINEW_RETURN_BY_SET(set, replaceTiles) }

}  // namespace sinew
#endif
