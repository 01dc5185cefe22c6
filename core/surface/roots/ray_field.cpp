// core/surface/roots/ray_field.cpp: terms along a ray, their sums, and a search from breakpoint to breakpoint.
#include "core/surface/roots/ray_field.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/geometry/at.h"
#include "core/geometry/formulas.h"

namespace sinew {
namespace {

void add(ValueAndSlope& sum, const ValueAndSlope& part) {
  sum.value += part.value;
  sum.slope += part.slope;
}

}  // namespace

void RayField::reset(double iso, CliqueLevelsView levels) {
  terms_.clear();
  shaped_.clear();
  iso_ = iso;
  levels_ = levels;
  isSoft_ = false;
}

namespace {

/// A term without its way along the ray.
RayTerm termOf(const PosedPrimitive& primitive, float weight, int slot) {
  RayTerm term;
  term.factor = static_cast<double>(primitive.strength) * static_cast<double>(weight);
  term.slot = primitive.strength < 0.0f ? RayTerm::kEverySum : slot;
  term.groove = static_cast<double>(primitive.groove);
  return term;
}

}  // namespace

void RayField::addPrimitive(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                            const glm::vec3& direction) {
  if (!primitive.influence.isPlain()) [[unlikely]]
    return addShaped(primitive, weight, slot, origin, direction);
  RayTerm term = termOf(primitive, weight, slot);
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
  addTerm(term);
}

void RayField::addShaped(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                         const glm::vec3& direction) {
  if (primitive.influence.boundingRadius == 0.0f) return;
  const ShapedRay ray(primitive.influence, origin, direction);
  const bool isQuadratic = ray.isQuadratic();
  const ShapedStretches stretches = ray.stretches();
  for (const ShapedStretch& stretch : stretches.items()) {
    RayTerm term = termOf(primitive, weight, slot);
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
    addTerm(term);
  }
  if (!isQuadratic && !stretches.items().empty()) shaped_.push_back(ray);
}

ValueAndSlope RayField::sampleShaped(const RayTerm& term, double t) const {
  const ShapedRay& ray = at(shaped_, term.shaped);
  const glm::dvec3 p = ray.at(t);
  const double w = 1.0 - ray.shape.rSquared(p);
  if (w <= 0.0 || t < term.enter || t > term.leave || (term.goesOn && t == term.leave)) return {};
  return {in_double::potential(term.factor, w),
          -2.0 * term.factor * in_double::potentialRate(w) * glm::dot(ray.shape.rSquaredSlope(p), ray.along)};
}

inline ValueAndSlope RayField::sampleTerm(const RayTerm& term, double t) const {
  if (term.shaped >= 0) return sampleShaped(term, t);
  const double w = 1.0 - term.rSquared(t);
  if (w <= 0.0 || t < term.enter || t > term.leave || (t == term.leave && term.goesOn)) return {};
  return {in_double::potential(term.factor, w),
          -4.0 * term.factor * in_double::potentialRate(w) * (term.a * t + term.b)};
}

ValueAndSlope RayField::sample(double t, RayScratch& scratch) const {
  ValueAndSlope everywhere{-iso_, 0.0};
  if (levels_.empty()) {
    for (const RayTerm& term : terms_) add(everywhere, sampleTerm(term, t));
    return everywhere;
  }
  std::vector<ValueAndSlope>& ofSlot = scratch.ofSlot;
  ofSlot.clear();
  scratch.softness.clear();
  for (const RayTerm& term : terms_) {
    if (term.slot == RayTerm::kEverySum) {
      add(everywhere, sampleTerm(term, t));
      continue;
    }
    const auto slot = static_cast<std::size_t>(term.slot);
    if (ofSlot.size() <= slot) ofSlot.resize(slot + 1);
    const ValueAndSlope part = sampleTerm(term, t);
    add(ofSlot[slot], part);
    if (!isSoft_) continue;
    scratch.softness.resize(ofSlot.size());
    add(scratch.softness[slot], {term.groove * part.value, term.groove * part.slope});
  }
  ValueAndSlope out;
  for (const CliqueLevel& level : levels_) {
    const ValueAndSlope part = isSoft_ ? softest(level.cliques, scratch) : highest(level.cliques, scratch);
    add(out, {level.weight * part.value, level.weight * part.slope});
  }
  add(out, everywhere);
  return out;
}

ValueAndSlope RayField::highest(const CliqueLists& cliques, const RayScratch& scratch) {
  const std::vector<ValueAndSlope>& ofSlot = scratch.ofSlot;
  ValueAndSlope best;
  for (const std::span<const int> clique : cliques) {
    ValueAndSlope sum;
    for (const int slot : clique) {
      if (static_cast<std::size_t>(slot) < ofSlot.size()) add(sum, at(ofSlot, slot));
    }
    if (sum.value > best.value) best = sum;
  }
  return best;
}

ValueAndSlope RayField::softest(const CliqueLists& cliques, RayScratch& scratch) {
  std::vector<BlendedGroup>& groups = scratch.blend.start(cliques);
  for (std::size_t i = 0; i < scratch.ofSlot.size(); ++i) {
    groups[i].sum = scratch.ofSlot[i].value;
    groups[i].softness = scratch.softness[i].value;
  }
  ValueAndSlope out{scratch.blend.settle(), 0.0};
  for (std::size_t i = 0; i < scratch.ofSlot.size(); ++i) {
    out.slope += in_double::softPart(scratch.ofSlot[i].slope, scratch.softness[i].slope, groups[i].share);
  }
  return out;
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

namespace {

Quartic quarticOf(const RayTerm& term, double begin, double end) {
  // Blossom of 1 - r^2 at (begin, begin), (begin, end), (end, end).
  const double w0 = 1.0 - term.rSquared(begin);
  const double w1 = 1.0 - (term.a * begin * end + term.b * (begin + end) + term.c);
  const double w2 = 1.0 - term.rSquared(end);
  return squareOfQuadratic(w0, w1, w2);
}

/// (1 - r^2)^2 of one term on an interval.
template <class Polynomial>
Polynomial polynomialOf(const RayField& field, const RayTerm& term, double begin, double end) {
  if constexpr (std::is_same_v<Polynomial, Bernstein>) {
    if (term.shaped >= 0) {
      const Bernstein w = at(field.shaped(), term.shaped).insideness(begin, end);
      return w * w;
    }
  }
  return Polynomial(quarticOf(term, begin, end));
}

bool isActive(const RayTerm& term, double t) { return t > term.enter && t < term.leave; }

/// out.sums: phi's polynomials on one interval (isMaximum()), all multiplied by the sign of phi at the ray's start.
template <class Polynomial>
void fillSums(const RayField& field, double begin, double end, double sign, PolynomialSums<Polynomial>& out) {
  std::vector<Polynomial>& ofSlot = out.ofSlot;
  const double middle = 0.5 * (begin + end);
  Polynomial everywhere;
  everywhere.addConstant(-field.iso());
  const bool oneSum = field.levels().empty();
  ofSlot.clear();
  for (const RayTerm& term : field.terms()) {
    if (!isActive(term, middle)) continue;
    const Polynomial part = polynomialOf<Polynomial>(field, term, begin, end);
    if (oneSum || term.slot == RayTerm::kEverySum) {
      everywhere.addScaled(part, term.factor);
      continue;
    }
    const auto slot = static_cast<std::size_t>(term.slot);
    if (ofSlot.size() <= slot) ofSlot.resize(slot + 1);
    ofSlot[slot].addScaled(part, term.factor);
  }
  out.sums.clear();
  if (oneSum) {
    out.sums.push_back(everywhere);
  } else {
    for (const std::span<const int> clique : field.levels().front().cliques) {
      Polynomial sum = everywhere;
      for (const int slot : clique) {
        if (static_cast<std::size_t>(slot) < ofSlot.size()) sum.addScaled(at(ofSlot, slot), 1.0);
      }
      out.sums.push_back(sum);
    }
  }
  for (Polynomial& sum : out.sums) {
    for (double& coefficient : sum.b) coefficient *= sign;
  }
}

/// Parts of phi on one interval.
void fillSoftSums(const RayField& field, double begin, double end, SoftFallScratch& scratch) {
  if (scratch.halves.empty()) scratch.halves.emplace_back();
  SoftSums& out = scratch.halves.front();
  const CliqueLevelsView levels = field.levels();
  if (scratch.blends.size() < levels.size()) scratch.blends.resize(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) scratch.blends[i].start(levels[i].cliques);
  out.everywhere = {};
  out.everywhere.addConstant(-field.iso());
  out.parts.clear();
  for (const RayTerm& term : field.terms()) {
    if (!isActive(term, 0.5 * (begin + end))) continue;
    const Bernstein part = polynomialOf<Bernstein>(field, term, begin, end);
    if (term.slot == RayTerm::kEverySum) {
      out.everywhere.addScaled(part, term.factor);
    } else {
      SoftPart& own = out.of(term.slot);
      own.sum.addScaled(part, term.factor);
      own.softness.addScaled(part, term.groove * term.factor);
    }
  }
}

struct Search {
  ProjectionKind method;
  double tolerance;
};

BracketSolver solverOf(ProjectionKind method) {
  return method == ProjectionKind::kBisection ? BracketSolver::kBisection : BracketSolver::kNewton;
}

/// Above degree 4 there is no closed form: `analytic` isolates the root and takes Newton steps.
template <class Polynomial>
std::optional<double> firstFall(const Polynomial& q, double from, const Search& search) {
  if constexpr (std::is_same_v<Polynomial, Quartic>) {
    if (search.method == ProjectionKind::kAnalytic) return firstFallClosedForm(q, from, search.tolerance);
  }
  return firstFallIsolated(q, from, search.tolerance, solverOf(search.method));
}

/// Where the largest of the sums falls to 0: follows one clique until it falls, then one that is still positive.
template <class Polynomial>
std::optional<double> firstFallOfMaximum(const std::vector<Polynomial>& sums, const Search& search) {
  double u = 0.0;
  const std::size_t mostChanges = 4 * sums.size() + 1;
  for (std::size_t change = 0; change < mostChanges; ++change) {
    const auto highest = std::ranges::max_element(sums, {}, [u](const Polynomial& q) { return q.at(u); });
    if (highest->at(u) <= 1e-15) return u;
    const std::optional<double> fall = firstFall(*highest, u, search);
    if (!fall) return std::nullopt;
    u = std::max(*fall, u);
    const bool anotherIsPositive =
        std::ranges::any_of(sums, [&](const Polynomial& q) { return &q != &*highest && q.at(u) > 1e-12; });
    if (!anotherIsPositive) return u;
  }
  return u;
}

/// For phi < 0 at the start: where the first of the negated sums reaches 0.
template <class Polynomial>
std::optional<double> firstFallOfAny(const std::vector<Polynomial>& sums, const Search& search) {
  std::optional<double> first;
  for (const Polynomial& q : sums) {
    const std::optional<double> fall = firstFall(q, 0.0, search);
    if (fall && (!first || *fall < *first)) first = fall;
  }
  return first;
}

/// firstChange() on one interval, mapped to [0, 1].
template <class Polynomial>
std::optional<double> changeWithin(const RayField& field, double begin, double end, bool fromPositive,
                                   const Search& search, PolynomialSums<Polynomial>& memory) {
  fillSums(field, begin, end, fromPositive ? 1.0 : -1.0, memory);
  return fromPositive ? firstFallOfMaximum(memory.sums, search) : firstFallOfAny(memory.sums, search);
}

bool isQuarticOn(const RayField& field, double begin, double end) {
  if (field.shaped().empty()) return true;
  const double middle = 0.5 * (begin + end);
  return std::ranges::none_of(field.terms(),
                              [&](const RayTerm& term) { return term.shaped >= 0 && isActive(term, middle); });
}

}  // namespace

const char* nameOf(ProjectionKind projection) {
  if (projection == ProjectionKind::kNewton) return "newton";
  return projection == ProjectionKind::kBisection ? "bisection" : "analytic";
}

std::optional<ProjectionKind> projectionKindNamed(const std::string& name) {
  for (const auto kind : {ProjectionKind::kNewton, ProjectionKind::kBisection, ProjectionKind::kAnalytic}) {
    if (name == nameOf(kind)) return kind;
  }
  return std::nullopt;
}

std::optional<double> firstChange(const RayField& field, double begin, double end, bool fromPositive,
                                  ProjectionKind method, double tolerance, RayScratch& scratch) {
  const std::span<const double> breaks = field.breakpoints(begin, end, scratch);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double length = breaks[i + 1] - breaks[i];
    if (!(length > 0.0)) continue;
    const Search search{method, tolerance / length};
    const double from = breaks[i];
    const double to = breaks[i + 1];
    if (!field.isMaximum()) {
      fillSoftSums(field, from, to, scratch.soft);
      const auto root =
          firstSoftFall(field.levels(), fromPositive ? 1.0 : -1.0, search.tolerance, solverOf(method), scratch.soft);
      if (root) return from + *root * length;
      continue;
    }
    const auto root = isQuarticOn(field, from, to)
                          ? changeWithin(field, from, to, fromPositive, search, scratch.quartics)
                          : changeWithin(field, from, to, fromPositive, search, scratch.polynomials);
    if (root) return breaks[i] + *root * length;
  }
  return std::nullopt;
}

}  // namespace sinew
