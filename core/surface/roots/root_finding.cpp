// core/surface/roots/root_finding.cpp: marches over the stretches between breakpoints until phi changes sign.
#include "core/surface/roots/root_finding.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/geometry/at.h"
#include "core/surface/roots/quartic.h"

namespace sinew {
namespace {

Quartic quarticOf(const RayTerm& term, double begin, double end) {
  // Blossom of 1 - r^2 at (begin, begin), (begin, end), (end, end).
  const double w0 = 1.0 - term.rSquared(begin);
  const double w1 = 1.0 - (term.a * begin * end + term.b * (begin + end) + term.c);
  const double w2 = 1.0 - term.rSquared(end);
  return squareOfQuadratic(w0, w1, w2);
}

/// (1 - r^2)^2 of one term on a stretch.
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

/// phi on one stretch as polynomials, one per clique, all multiplied by the sign phi has at the ray's start: out.sums.
template <class Polynomial>
void fillSums(const RayField& field, double begin, double end, double sign, PolynomialSums<Polynomial>& out) {
  std::vector<Polynomial>& ofSlot = out.ofSlot;
  const double middle = 0.5 * (begin + end);
  Polynomial everywhere;
  everywhere.addConstant(-field.iso());
  const bool oneSum = field.cliques().empty();
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
  for (const std::vector<int>& clique : field.cliques()) {
    Polynomial sum = everywhere;
    for (const int slot : clique) {
      if (static_cast<std::size_t>(slot) < ofSlot.size()) {
        sum.addScaled(at(ofSlot, slot), 1.0);
      }
    }
    out.sums.push_back(sum);
  }
  if (oneSum) out.sums.push_back(everywhere);
  for (Polynomial& sum : out.sums) {
    for (double& coefficient : sum.b) coefficient *= sign;
  }
}

/// How a root is to be found.
struct Search {
  ProjectionKind method;
  double tolerance;
};

std::optional<double> firstFall(const Quartic& q, double from, const Search& search) {
  switch (search.method) {
    case ProjectionKind::kAnalytic:
      return firstFallClosedForm(q, from, search.tolerance);
    case ProjectionKind::kBisection:
      return firstFallIsolated(q, from, search.tolerance, BracketSolver::kBisection);
    case ProjectionKind::kNewton:
      break;
  }
  return firstFallIsolated(q, from, search.tolerance);
}

/// Above degree 4 there is no closed form: `analytic` isolates and goes on by Newton's steps.
std::optional<double> firstFall(const Bernstein& q, double from, const Search& search) {
  const bool halves = search.method == ProjectionKind::kBisection;
  return firstFallIsolated(q, from, search.tolerance, halves ? BracketSolver::kBisection : BracketSolver::kNewton);
}

/// Where the largest of the sums falls to 0: follows one clique until it falls, then whichever still stands.
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
    const bool anotherStands =
        std::ranges::any_of(sums, [&](const Polynomial& q) { return &q != &*highest && q.at(u) > 1e-12; });
    if (!anotherStands) return u;
  }
  return u;
}

/// phi < 0 at the start: the first of the sums that reaches 0 (they were negated).
template <class Polynomial>
std::optional<double> firstFallOfAny(const std::vector<Polynomial>& sums, const Search& search) {
  std::optional<double> first;
  for (const Polynomial& q : sums) {
    const std::optional<double> fall = firstFall(q, 0.0, search);
    if (fall && (!first || *fall < *first)) first = fall;
  }
  return first;
}

/// As firstChange, on [0, 1] of one stretch.
template <class Polynomial>
std::optional<double> changeOnStretch(const RayField& field, double begin, double end, bool fromPositive,
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
  switch (projection) {
    case ProjectionKind::kNewton:
      return "newton";
    case ProjectionKind::kBisection:
      return "bisection";
    case ProjectionKind::kAnalytic:
      break;
  }
  return "analytic";
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
    const auto root = isQuarticOn(field, from, to)
                          ? changeOnStretch(field, from, to, fromPositive, search, scratch.quartics)
                          : changeOnStretch(field, from, to, fromPositive, search, scratch.polynomials);
    if (root) return breaks[i] + *root * length;
  }
  return std::nullopt;
}

}  // namespace sinew
