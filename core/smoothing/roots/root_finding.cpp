// core/smoothing/roots/root_finding.cpp: marches over the stretches between breakpoints until phi changes sign.
#include "core/smoothing/roots/root_finding.h"

#include <algorithm>
#include <cmath>

#include "core/base/at.h"
#include "core/smoothing/roots/quartic.h"

namespace sinew {
namespace {

Quartic quarticOf(const RayTerm& term, double begin, double end) {
  // Blossom of 1 - r^2 at (begin, begin), (begin, end), (end, end).
  const double w0 = 1.0 - term.rSquared(begin);
  const double w1 = 1.0 - (term.a * begin * end + term.b * (begin + end) + term.c);
  const double w2 = 1.0 - term.rSquared(end);
  return squareOfQuadratic(w0, w1, w2);
}

/// phi on one stretch as quartics, one per clique, all multiplied by the sign phi has at the ray's start: scratch.sums.
void fillSums(const RayField& field, double begin, double end, double sign, RayScratch& scratch) {
  std::vector<Quartic>& ofSlot = scratch.quarticOfSlot;
  const double middle = 0.5 * (begin + end);
  Quartic everywhere;
  everywhere.addConstant(-field.iso());
  const bool oneSum = field.cliques().empty();
  ofSlot.clear();
  for (const RayTerm& term : field.terms()) {
    if (middle <= term.enter || middle >= term.leave) continue;
    const Quartic part = quarticOf(term, begin, end);
    if (oneSum || term.slot == RayTerm::kEverySum) {
      everywhere.addScaled(part, term.factor);
      continue;
    }
    const auto slot = static_cast<std::size_t>(term.slot);
    if (ofSlot.size() <= slot) ofSlot.resize(slot + 1);
    ofSlot[slot].addScaled(part, term.factor);
  }
  scratch.sums.clear();
  for (const std::vector<int>& clique : field.cliques()) {
    Quartic sum = everywhere;
    for (const int slot : clique) {
      if (static_cast<std::size_t>(slot) < ofSlot.size()) {
        sum.addScaled(at(ofSlot, slot), 1.0);
      }
    }
    scratch.sums.push_back(sum);
  }
  if (oneSum) scratch.sums.push_back(everywhere);
  for (Quartic& sum : scratch.sums) {
    for (double& coefficient : sum.b) coefficient *= sign;
  }
}

/// How a root is to be found.
struct Search {
  ProjectionKind method;
  double tolerance;
  std::int64_t* evaluations;
};

std::optional<double> firstFall(const Quartic& q, double from, const Search& search) {
  switch (search.method) {
    case ProjectionKind::kAnalytic:
      return firstFallClosedForm(q, from, search.tolerance, search.evaluations);
    case ProjectionKind::kBisection:
      return firstFallIsolated(q, from, search.tolerance, BracketSolver::kBisection, search.evaluations);
    case ProjectionKind::kNewton:
      break;
  }
  return firstFallIsolated(q, from, search.tolerance, BracketSolver::kNewton, search.evaluations);
}

/// Where the largest of the sums falls to 0: follows one clique until it falls, then whichever still stands.
std::optional<double> firstFallOfMaximum(const std::vector<Quartic>& sums, const Search& search) {
  double u = 0.0;
  const std::size_t mostChanges = 4 * sums.size() + 1;
  for (std::size_t change = 0; change < mostChanges; ++change) {
    const auto highest = std::ranges::max_element(sums, {}, [u](const Quartic& q) { return q.at(u); });
    if (highest->at(u) <= 1e-15) return u;
    const std::optional<double> fall = firstFall(*highest, u, search);
    if (!fall) return std::nullopt;
    u = std::max(*fall, u);
    const bool anotherStands =
        std::ranges::any_of(sums, [&](const Quartic& q) { return &q != &*highest && q.at(u) > 1e-12; });
    if (!anotherStands) return u;
  }
  return u;
}

/// phi < 0 at the start: the first of the sums that reaches 0 (they were negated).
std::optional<double> firstFallOfAny(const std::vector<Quartic>& sums, const Search& search) {
  std::optional<double> first;
  for (const Quartic& q : sums) {
    const std::optional<double> fall = firstFall(q, 0.0, search);
    if (fall && (!first || *fall < *first)) first = fall;
  }
  return first;
}

}  // namespace

std::optional<double> firstChange(const RayField& field, double begin, double end, bool fromPositive,
                                  ProjectionKind method, double tolerance, RayScratch& scratch) {
  const std::span<const double> breaks = field.breakpoints(begin, end, scratch);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double length = breaks[i + 1] - breaks[i];
    if (!(length > 0.0)) continue;
    fillSums(field, breaks[i], breaks[i + 1], fromPositive ? 1.0 : -1.0, scratch);
    ++scratch.evaluations.field;
    const Search search{method, tolerance / length, &scratch.evaluations.quartic};
    const auto root = fromPositive ? firstFallOfMaximum(scratch.sums, search) : firstFallOfAny(scratch.sums, search);
    if (root) return breaks[i] + *root * length;
  }
  return std::nullopt;
}

}  // namespace sinew
