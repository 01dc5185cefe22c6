// core/surface/roots/ray_field.cpp: terms along a ray, their sums and breakpoints.
#include "core/surface/roots/ray_field.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/at.h"

namespace sinew {
namespace {

void add(RaySample& sum, const RaySample& part) {
  sum.value += part.value;
  sum.slope += part.slope;
}

}  // namespace

void RayField::reset(double iso, const CliqueLists& cliques) {
  terms_.clear();
  shaped_.clear();
  iso_ = iso;
  cliques_ = &cliques;
}

void RayField::addPrimitive(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                            const glm::vec3& direction) {
  if (!primitive.influence.isPlain()) [[unlikely]]
    return addShaped(primitive, weight, slot, origin, direction);
  RayTerm term;
  const auto [a, b, c] = primitive.influence.alongRay(origin, direction);
  term.a = a;
  term.b = b;
  term.c = c;
  const double discriminant = term.b * term.b - term.a * (term.c - 1.0);
  if (!(term.a > 0.0) || !(discriminant > 0.0)) return;
  const double root = std::sqrt(discriminant);
  term.enter = (-term.b - root) / term.a;
  term.leave = (-term.b + root) / term.a;
  if (term.leave <= 0.0) return;
  term.factor = static_cast<double>(primitive.strength) * static_cast<double>(weight);
  term.slot = primitive.strength < 0.0f ? RayTerm::kEverySum : slot;
  terms_.push_back(term);
}

void RayField::addShaped(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                         const glm::vec3& direction) {
  if (primitive.influence.boundingRadius == 0.0f) return;
  const ShapedRay ray(primitive.influence, origin, direction);
  const bool isQuadratic = ray.isQuadratic();
  const ShapedStretches stretches = ray.stretches();
  for (const ShapedStretch& stretch : stretches.items()) {
    RayTerm term;
    term.factor = static_cast<double>(primitive.strength) * static_cast<double>(weight);
    term.slot = primitive.strength < 0.0f ? RayTerm::kEverySum : slot;
    term.enter = stretch.enter;
    term.leave = stretch.leave;
    term.goesOn = stretch.goesOn;
    if (isQuadratic) {
      const auto [a, b, c] = ray.quadraticAround(0.5 * (stretch.enter + stretch.leave));
      term.a = a;
      term.b = b;
      term.c = c;
    } else {
      term.shaped = static_cast<int>(shaped_.size());
    }
    terms_.push_back(term);
  }
  if (!isQuadratic && !stretches.items().empty()) shaped_.push_back(ray);
}

RaySample RayField::sampleShaped(const RayTerm& term, double t) const {
  const ShapedRay& ray = at(shaped_, term.shaped);
  const glm::dvec3 p = ray.at(t);
  const double w = 1.0 - ray.shape.rSquared(p);
  if (w <= 0.0 || t < term.enter || t > term.leave || (term.goesOn && t == term.leave)) return {};
  return {term.factor * w * w, -2.0 * term.factor * w * glm::dot(ray.shape.rSquaredSlope(p), ray.along)};
}

inline RaySample RayField::sampleTerm(const RayTerm& term, double t) const {
  if (term.shaped >= 0) return sampleShaped(term, t);
  const double w = 1.0 - term.rSquared(t);
  if (w <= 0.0 || t < term.enter || t > term.leave || (t == term.leave && term.goesOn)) return {};
  return {term.factor * w * w, -4.0 * term.factor * w * (term.a * t + term.b)};
}

RaySample RayField::sample(double t, RayScratch& scratch) const {
  RaySample everywhere{-iso_, 0.0};
  if (cliques_->empty()) {
    for (const RayTerm& term : terms_) add(everywhere, sampleTerm(term, t));
    // Without cliques all positive terms form one sum: nothing to take the maximum of.
    return everywhere;
  }
  std::vector<RaySample>& ofSlot = scratch.ofSlot;
  ofSlot.clear();
  for (const RayTerm& term : terms_) {
    if (term.slot == RayTerm::kEverySum) {
      add(everywhere, sampleTerm(term, t));
      continue;
    }
    const auto slot = static_cast<std::size_t>(term.slot);
    if (ofSlot.size() <= slot) ofSlot.resize(slot + 1);
    add(ofSlot[slot], sampleTerm(term, t));
  }
  RaySample best;
  for (const std::vector<int>& clique : *cliques_) {
    RaySample sum;
    for (const int slot : clique) {
      if (static_cast<std::size_t>(slot) < ofSlot.size()) add(sum, at(ofSlot, slot));
    }
    if (sum.value > best.value) best = sum;
  }
  add(best, everywhere);
  return best;
}

std::span<const double> RayField::breakpoints(double begin, double end, RayScratch& scratch) const {
  std::vector<double>& breakpoints = scratch.breakpoints;
  breakpoints.assign(1, begin);
  for (const RayTerm& term : terms_) {
    for (const double t : {term.enter, term.leave}) {
      if (t > begin && t < end) breakpoints.push_back(t);
    }
  }
  std::ranges::sort(breakpoints);
  breakpoints.push_back(end);
  return breakpoints;
}

double RayField::lastLeave() const {
  double last = 0.0;
  for (const RayTerm& term : terms_) last = std::max(last, term.leave);
  return last;
}

}  // namespace sinew
