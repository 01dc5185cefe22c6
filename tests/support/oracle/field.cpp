// tests/support/oracle/field.cpp: all primitives at every point, and cliques from all subsets of the groups.

#include "tests/support/oracle/field.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>

#include "tests/support/oracle/triangles.h"

namespace sinew::oracle {
namespace {

/// Tries all 2^groups subsets; keeps those whose members are pairwise linked and that nothing can join.
std::vector<Clique> allMaximalCliques(const std::vector<std::vector<bool>>& linked) {
  const std::size_t groups = linked.size();
  assert(groups <= kMostGroups);
  std::vector<Clique> out;
  for (Clique bits = 1; bits < (1u << groups); ++bits) {
    bool clique = true;
    bool maximal = true;
    for (std::size_t i = 0; i < groups; ++i) {
      bool linkedToAll = true;
      for (std::size_t j = 0; j < groups; ++j) {
        if (i != j && holds(bits, j) && !linked[i][j]) linkedToAll = false;
      }
      if (holds(bits, i) && !linkedToAll) clique = false;
      if (!holds(bits, i) && linkedToAll) maximal = false;
    }
    if (clique && maximal) out.push_back(bits);
  }
  return out;
}

/// The largest sum of a clique.
double largestSum(const std::vector<Clique>& cliques, const PerGroup& sums) {
  double out = 0.0;
  for (const Clique clique : cliques) out = std::max(out, sumOver(clique, sums));
  return out;
}

std::vector<double> cliqueSums(const std::vector<Clique>& cliques, const PerGroup& sums) {
  std::vector<double> out;
  for (const Clique clique : cliques) out.push_back(sumOver(clique, sums));
  return out;
}

PerGroup wholly(Clique clique) {
  PerGroup out{};
  for (std::size_t group = 0; group < kMostGroups; ++group) out[group] = holds(clique, group) ? 1.0 : 0.0;
  return out;
}

std::vector<bool> territoryOf(const Primitive& primitive, int bone, const Skeleton& skeleton) {
  std::vector<bool> in(skeleton.bones.size(), false);
  const auto add = [&](int index) {
    if (index >= 0) in[static_cast<std::size_t>(index)] = true;
  };
  if (primitive.territory) {
    for (const std::string& name : *primitive.territory) add(boneNamed(skeleton, name));
    return in;
  }
  add(bone);
  add(skeleton.bones[static_cast<std::size_t>(bone)].parent);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    if (skeleton.bones[b].parent == bone) add(static_cast<int>(b));
  }
  return in;
}

/// r of a point of unit space, where the reach is 1.
double radiusInUnit(const Shape& shape, double reach, const Vec& inUnit) {
  return shape.isPlain() ? length(inUnit) : rho(shape, reach * inUnit) / reach;
}

/// d g(r) of a shape, by differences.
Vec slopeInUnit(const Shape& shape, double reach, const Vec& inUnit) {
  const auto along = [&](const Vec& axis) {
    constexpr double kStep = 1e-6;
    return (g(radiusInUnit(shape, reach, inUnit + kStep * axis)) -
            g(radiusInUnit(shape, reach, inUnit - kStep * axis))) /
           (2.0 * kStep);
  };
  return {along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
}

/// Radius of a ball around the middle of unit space that contains a shape's influence.
double ballInUnit(const Shape& shape, double reach) {
  const auto kappa = static_cast<double>(shape.core);
  const double end = kappa + reach * (1.0 - kappa);
  const double bow =
      std::max(1.0, end * end - 1.0) * std::hypot(static_cast<double>(shape.bend.x), static_cast<double>(shape.bend.y));
  return 1.001 * std::hypot(end, widest(shape, reach) + bow) / reach;
}

/// The last t in [from, to] where a shape's influence holds start + t along; `from` if none does.
double lastInside(const Shape& shape, double reach, const Vec& start, const Vec& along, double from, double to) {
  constexpr int kSteps = 400;
  const auto inside = [&](double t) { return radiusInUnit(shape, reach, start + t * along) < 1.0; };
  for (int i = kSteps - 1; i >= 0; --i) {
    double low = from + (to - from) * i / kSteps;
    if (!inside(low)) continue;
    double high = from + (to - from) * (i + 1) / kSteps;
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = 0.5 * (low + high);
      (inside(middle) ? low : high) = middle;
    }
    return high;
  }
  return from;
}

}  // namespace

double g(double r) { return r < 1.0 ? (1.0 - r * r) * (1.0 - r * r) : 0.0; }
double gSlope(double r) { return r < 1.0 ? -4.0 * r * (1.0 - r * r) : 0.0; }

int boneNamed(const Skeleton& skeleton, const std::string& name) {
  int found = -1;
  int hits = 0;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    if (skeleton.bones[b].path == name) return static_cast<int>(b);
    if (skeleton.bones[b].name == name) {
      found = static_cast<int>(b);
      ++hits;
    }
  }
  return hits == 1 ? found : -1;
}

Field::Field(const Character& character, const Rig& rig)
    : character_(character),
      iso_(static_cast<double>(rig.surface.iso)),
      grooves_(static_cast<double>(rig.surface.grooves) * static_cast<double>(character.height)) {
  const auto groupNamed = [&](const std::string& name) {
    const auto at = std::find_if(rig.groups.begin(), rig.groups.end(), [&](const Group& x) { return x.name == name; });
    return at - rig.groups.begin();
  };
  std::set<double> cuts{0.0, 1.0};
  for (const Link& link : rig.links) cuts.insert(static_cast<double>(link.amount));
  for (auto low = cuts.begin(); std::next(low) != cuts.end(); ++low) {
    const double high = *std::next(low);
    std::vector<std::vector<bool>> linked(rig.groups.size(), std::vector<bool>(rig.groups.size(), false));
    for (const Link& link : rig.links) {
      if (static_cast<double>(link.amount) < 0.5 * (*low + high)) continue;
      const auto a = static_cast<std::size_t>(groupNamed(link.groups[0]));
      const auto b = static_cast<std::size_t>(groupNamed(link.groups[1]));
      linked[a][b] = linked[b][a] = true;
    }
    levels_.push_back({high - *low, allMaximalCliques(linked)});
  }

  for (const Primitive& primitive : rig.primitives) {
    Item item;
    item.bone = boneNamed(character.skeleton, primitive.bone);
    if (item.bone < 0) continue;
    item.group = static_cast<std::size_t>(groupNamed(primitive.group));
    const double reach = static_cast<double>(primitive.reach);
    item.reach = reach;
    item.shape = primitive.placement.shape;
    item.strength = static_cast<double>(primitive.amount) * iso_ / g(1.0 / reach);
    item.sign = primitive.sign;
    item.centerInBone = vec(primitive.placement.center);
    const Vec radii = vec(primitive.placement.radii);
    const Mat scale{{{{reach * radii.x, 0, 0}, {0, reach * radii.y, 0}, {0, 0, reach * radii.z}}}};
    item.unitToBone = rotation(primitive.placement.rotation) * scale;
    item.territory = territoryOf(primitive, item.bone, character.skeleton);
    primitives_.push_back(item);
  }
}

void Field::pose(const Pose& pose) {
  for (Item& item : primitives_) {
    const Affine bone = affine(pose.boneInWorld[static_cast<std::size_t>(item.bone)]);
    item.center = apply(bone, item.centerInBone);
    const Mat toWorld = bone.linear * item.unitToBone;
    item.flat = determinant(toWorld) == 0.0;
    if (!item.flat) item.toUnit = inverse(toWorld);
    item.meanRadius = std::cbrt(std::abs(determinant(toWorld)) * volume(item.shape)) / item.reach;
    // A thin muscle's field falls steeply, so the same width of groove takes more of it.
    const double steepness = item.meanRadius * (item.reach * item.reach - 1.0);
    if (grooves_ > 0.0) item.kappa = grooves_ < steepness ? 2.0 * grooves_ / steepness : 2.0;
  }
}

std::vector<double> Field::territoryWeights(int vertex) const {
  std::vector<double> out;
  for (const Item& item : primitives_) {
    double share = 0.0;
    for (const Influence& influence : character_.mesh.influencesOf(vertex)) {
      const int bone = character_.skeleton.bindings[static_cast<std::size_t>(influence.binding)].bone;
      if (item.territory[static_cast<std::size_t>(bone)]) share += static_cast<double>(influence.weight);
    }
    out.push_back(smoothstep(0.0, 0.5, share));
  }
  return out;
}

double Field::radius(const Item& item, const Vec& point) const {
  return item.flat ? 2.0 : radiusInUnit(item.shape, item.reach, item.toUnit * (point - item.center));
}

Field::Sums Field::sumsAt(const Vec& point, std::span<const double> weights) const {
  Sums out;
  for (std::size_t i = 0; i < primitives_.size(); ++i) {
    const Item& item = primitives_[i];
    if (weights[i] > 0.0)
      out.add(item.sign * weights[i] * item.strength * g(radius(item, point)), item.group, item.kappa);
  }
  return out;
}

void Field::Sums::add(double amount, std::size_t group, double kappa) {
  if (amount < 0.0) {
    carved += amount;
  } else {
    x[group] += amount;
    y[group] += kappa * amount;
  }
}

double Field::value(const Vec& point, std::span<const double> weights) const { return valueOf(sumsAt(point, weights)); }

double Field::valueOf(const Sums& sums) const {
  double out = sums.carved;
  for (const Level& level : levels_) {
    out += level.width *
           (grooves_ > 0.0 ? blended(level.cliques, sums.x, sums.y).value : largestSum(level.cliques, sums.x));
  }
  return out;
}

Vec Field::gradientOf(const PerGroup& shares, const Vec& point, std::span<const double> weights) const {
  Vec out;
  for (std::size_t i = 0; i < primitives_.size(); ++i) {
    const Item& item = primitives_[i];
    const double m = item.sign < 0 ? 1.0 : shares[item.group];
    if (weights[i] <= 0.0 || m <= 0.0 || item.flat) continue;
    // Of m x + m (1 - m) y / 2 with the share held.
    const double factor = m + 0.5 * m * (1.0 - m) * item.kappa;
    const double strength = item.sign * weights[i] * item.strength * factor;
    const Vec inUnit = item.toUnit * (point - item.center);
    if (!item.shape.isPlain()) {
      const Vec slope = slopeInUnit(item.shape, item.reach, inUnit);
      out = out + strength * (transpose(item.toUnit) * slope);
      continue;
    }
    const double r = length(inUnit);
    if (r >= 1.0 || r == 0.0) continue;
    // grad r = A^T (A d) / r.
    out = out + (strength * gSlope(r) / r) * (transpose(item.toUnit) * inUnit);
  }
  return out;
}

Vec Field::gradient(const Vec& point, std::span<const double> weights) const {
  Vec out;
  const Sums here = sumsAt(point, weights);
  for (const Level& level : levels_) {
    if (!level.cliques.empty()) out = out + level.width * gradientOf(level, here, point, weights);
  }
  return out;
}

Vec Field::gradientOf(const Level& level, const Sums& here, const Vec& point, std::span<const double> weights) const {
  if (grooves_ > 0.0) return gradientOf(blended(level.cliques, here.x, here.y).shares, point, weights);
  const std::vector<double> sums = cliqueSums(level.cliques, here.x);
  const auto winner = static_cast<std::size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
  const Vec best = gradientOf(wholly(level.cliques[winner]), point, weights);
  // Of the clique that turns the gradient most: 1 where it ties, 0 from 1e-4 below on, and where it is empty.
  double share = 0.0;
  Vec other;
  double most = 0.0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const double own = std::min(1.0 - (sums[winner] - sums[k]) / 1e-4, sums[k] / 1e-4);
    if (own <= 0.0) continue;
    const Vec gradient = gradientOf(wholly(level.cliques[k]), point, weights);
    const double pull = own * length(gradient - best);
    if (pull <= most) continue;
    most = pull;
    share = own;
    other = gradient;
  }
  return (1.0 / (1.0 + share)) * (best + share * other);
}

double Field::lead(const Vec& point, std::span<const double> weights) const {
  double out = 1e300;
  if (grooves_ > 0.0) return out;
  const Sums here = sumsAt(point, weights);
  for (const Level& level : levels_) {
    std::vector<double> sums = cliqueSums(level.cliques, here.x);
    std::sort(sums.begin(), sums.end(), std::greater<>());
    // Cliques whose other groups add nothing here tie exactly and have the same gradient: skip those.
    for (const double sum : sums) {
      if (sum >= sums.front() * (1.0 - 1e-12)) continue;
      out = std::min(out, sums.front() - sum);
      break;
    }
  }
  return out;
}

int Field::groupsInPart(const Vec& point, std::span<const double> weights) const {
  std::ptrdiff_t most = 0;
  if (grooves_ == 0.0) return 0;
  const Sums sums = sumsAt(point, weights);
  for (const Level& level : levels_) {
    const PerGroup shares = blended(level.cliques, sums.x, sums.y).shares;
    most = std::max(most, std::ranges::count_if(shares, [](double m) { return m > 1e-6 && m < 1.0 - 1e-6; }));
  }
  return static_cast<int>(most);
}

double Field::nearest(const Vec& point, std::span<const double> weights) const {
  double out = 1e300;
  for (std::size_t i = 0; i < primitives_.size(); ++i) {
    if (weights[i] > 0.0 && !primitives_[i].flat) out = std::min(out, radius(primitives_[i], point));
  }
  return out;
}

double Field::blendWidth(const Vec& point, std::span<const double> weights, double most) const {
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < primitives_.size(); ++i) {
    const Item& item = primitives_[i];
    if (weights[i] <= 0.0) continue;
    const double share = weights[i] * item.strength * g(radius(item, point));
    sum += share * std::min(most, item.meanRadius);
    total += share;
  }
  return total > 0.0 ? sum / total : most;
}

bool Field::inRegion(const Vec& point, std::span<const double> weights) const { return nearest(point, weights) < 1.0; }

Field::Ray Field::along(const Vec& origin, const Vec& direction, std::span<const double> weights) const {
  Ray out;
  out.field_ = this;
  for (std::size_t i = 0; i < primitives_.size(); ++i) {
    const Item& item = primitives_[i];
    if (weights[i] <= 0.0 || item.flat) continue;
    const Vec start = item.toUnit * (origin - item.center);
    const Vec along = item.toUnit * direction;
    const double a = dot(along, along);
    const double b = dot(start, along);
    const double ball = item.shape.isPlain() ? 1.0 : ballInUnit(item.shape, item.reach);
    const double discriminant = b * b - a * (dot(start, start) - ball * ball);
    if (discriminant <= 0.0) continue;
    double end = (-b + std::sqrt(discriminant)) / a;
    if (!item.shape.isPlain() && end > 0.0) end = lastInside(item.shape, item.reach, start, along, 0.0, end);
    out.end_ = std::max(out.end_, end);
    out.terms_.push_back(
        {start, along, item.sign * weights[i] * item.strength, item.group, item.kappa, item.shape, item.reach});
  }
  return out;
}

double Field::Ray::value(double t) const {
  Sums sums;
  for (const Term& term : terms_) {
    const double r = radiusInUnit(term.shape, term.reach, term.start + t * term.along);
    sums.add(term.strength * g(r), term.group, term.kappa);
  }
  return field_->valueOf(sums);
}

}  // namespace sinew::oracle
