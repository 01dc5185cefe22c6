// core/surface/patches/aligned_triangle.cpp: tries places and diagonals and keeps what fits better.
#include "core/surface/patches/aligned_triangle.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr double kAlignedLeastAngle = 0.2618;  ///< 15 degrees in the bind pose, unless the former triangles have less.
constexpr double kWideTangent = 0.27;          ///< Of 15.1 degrees.
constexpr double kPointGain = 0.98;            ///< A point is moved if its error becomes less than this fraction.
constexpr float kDiagonalGain = 0.9f;          ///< Likewise a diagonal.
constexpr float kLeastTurn = 1e-5f;            ///< Squared, a pose, 0.2 degrees: less is not worth a change.
constexpr int kDiagonalPasses = 8;

double crossOf(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

float apartSquared(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 apart = a - b;
  return glm::dot(apart, apart);
}

/// Squared distance of unit vectors.
float turnBetween(const glm::vec3& a, const glm::vec3& b) {
  const float lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0f ? 2.0f - 2.0f * glm::dot(a, b) / lengths : 4.0f;
}

PlaceSample mean(const PlaceSample& a, const PlaceSample& b, float share) {
  return {(1.0f - share) * a.position + share * b.position, (1.0f - share) * a.normal + share * b.normal};
}

bool isAt(int point, const std::array<int, 3>& triangle) {
  return std::ranges::find(triangle, point) != triangle.end();
}

/// What a fit's `turned` must be less than.
double mostTurned(const PointFit& former) {
  return std::min(kPointGain * former.turned, former.turned - static_cast<double>(kLeastTurn) * former.area);
}

}  // namespace

void PointFit::add(const PointFit& other) {
  turned += other.turned;
  area += other.area;
  leastAngle = std::min(leastAngle, other.leastAngle);
  off = std::max(off, other.off);
}

// What follows cannot take much away: triangles that turn over do, but are excluded by their angles, and rounding by
// far less than the least turn.
FitBound boundOf(const PointFit& former) {
  FitBound out{.leastAngle = std::min(kAlignedLeastAngle, former.leastAngle)};
  if (former.leastAngle > 0.0) out.turned = mostTurned(former) + static_cast<double>(kLeastTurn) * former.area;
  return out;
}

bool isBetterFit(const PointFit& moved, const PointFit& former, float tolerance) {
  if (moved.leastAngle < std::min(kAlignedLeastAngle, former.leastAngle)) return false;
  if (moved.off > tolerance && moved.off > former.off) return false;
  return moved.turned < mostTurned(former);
}

AlignedTriangle::AlignedTriangle(const SplitLevels& levels, const SideShares& sides,
                                 const std::array<glm::vec3, 3>& corners, const SampleGrids& grids, float tolerance)
    : levels_(levels), grids_(grids), tolerance_(tolerance), former_(grids.poses()) {
  flatten(corners);
  SplitTriangle split;
  split.split(levels, corners, sides);
  triangles_.assign(split.triangles().begin(), split.triangles().end());
  placePoints(sides);
  places_.insert(places_.end(), split.inside().begin(), split.inside().end());
  samples_.resize(places_.size() * poses());
  for (std::size_t point = 0; point < places_.size(); ++point) read(places_[point], &samples_[point * poses()]);
}

void AlignedTriangle::flatten(const std::array<glm::vec3, 3>& corners) {
  const glm::dvec3 u = glm::dvec3(corners[1]) - glm::dvec3(corners[0]);
  const glm::dvec3 v = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
  const double length = glm::length(u);
  const double area = glm::length(glm::cross(u, v));
  plane_ = {glm::dvec2(1.0, 0.0), glm::dvec2(0.5, 0.866)};
  if (length > 0.0 && area > 0.0) plane_ = {glm::dvec2(length, 0.0), glm::dvec2(glm::dot(u, v), area) / length};
}

glm::dvec2 AlignedTriangle::placeOn(std::size_t side, double share) const {
  constexpr std::array kCorners{glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0)};
  return kCorners[side] + (kCorners[(side + 1) % 3] - kCorners[side]) * share;
}

int AlignedTriangle::pointOn(std::size_t side, int step) const {
  int point = 2 + step;
  for (std::size_t before = 0; before < side; ++before) point += levels_.sides[before] - 1;
  return point;
}

void AlignedTriangle::placePoints(const SideShares& sides) {
  for (std::size_t corner = 0; corner < 3; ++corner) places_.push_back(placeOn(corner, 0.0));
  for (std::size_t side = 0; side < 3; ++side) {
    for (int step = 1; step < levels_.sides[side]; ++step) {
      const double even = static_cast<double>(step) / levels_.sides[side];
      places_.push_back(placeOn(side, sides[side].empty() ? even : sides[side][toIndex(step - 1)]));
    }
  }
}

/// @param out [poses]
void AlignedTriangle::read(const glm::dvec2& place, PlaceSample* out) const {
  const SampleCell cell = grids_.cellOf(place);
  for (std::size_t pose = 0; pose < poses(); ++pose) out[pose] = grids_.at(cell, pose);
}

/// Angles above kAlignedLeastAngle are alike, and may be left out.
double AlignedTriangle::leastAngle(const std::array<int, 3>& t) const {
  double least = kAnyAngle;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec2 from = inPlane(at(places_, t[i]));
    const glm::dvec2 u = inPlane(at(places_, t[(i + 1) % 3])) - from;
    const glm::dvec2 v = inPlane(at(places_, t[(i + 2) % 3])) - from;
    const double sine = crossOf(u, v);
    const double cosine = glm::dot(u, v);
    if (sine > 0.0 && sine > kWideTangent * cosine) continue;
    least = std::min(least, std::atan2(sine, cosine));
  }
  return least;
}

void AlignedTriangle::addFit(const std::array<int, 3>& t, PointFit& fit) {
  PointFit own;
  own.leastAngle = leastAngle(t);
  const std::array<glm::dvec2, 3> places{at(places_, t[0]), at(places_, t[1]), at(places_, t[2])};
  const double inParent = crossOf(places[1] - places[0], places[2] - places[0]);
  own.area = 0.5 * inParent * crossOf(plane_[0], plane_[1]);
  const SampleCell middle = grids_.cellOf((places[0] + places[1] + places[2]) / 3.0);
  std::array<SampleCell, 3> onSides;
  for (std::size_t i = 0; i < 3; ++i) onSides[i] = grids_.cellOf(0.5 * (places[i] + places[(i + 1) % 3]));
  float turned = 0.0f;
  float offSquared = 0.0f;
  for (std::size_t pose = 0; pose < poses(); ++pose) {
    const PlaceSample& a = sampleAt(t[0], pose);
    const PlaceSample& b = sampleAt(t[1], pose);
    const PlaceSample& c = sampleAt(t[2], pose);
    const PlaceSample surface = grids_.at(middle, pose);
    turned += turnBetween(a.normal + b.normal + c.normal, surface.normal);
    offSquared = std::max(offSquared, apartSquared((a.position + b.position + c.position) / 3.0f, surface.position));
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 flat = 0.5f * (sampleAt(t[i], pose).position + sampleAt(t[(i + 1) % 3], pose).position);
      offSquared = std::max(offSquared, apartSquared(flat, grids_.positionAt(onSides[i], pose)));
    }
  }
  own.off = std::sqrt(offSquared);
  own.turned = own.area * static_cast<double>(turned);
  own.area *= static_cast<double>(poses());
  fit.add(own);
}

PointFit AlignedTriangle::fitAt(int point, const glm::dvec2& place, const FitBound& bound) {
  const glm::dvec2 former = at(places_, point);
  std::copy_n(&sampleAt(point, 0), poses(), former_.begin());
  move(point, place);
  PointFit fit;
  for (const std::array<int, 3>& t : triangles_) {
    if (!isAt(point, t)) continue;
    addFit(t, fit);
    if (bound.excludes(fit)) break;
  }
  at(places_, point) = former;
  std::ranges::copy(former_, &sampleAt(point, 0));
  return fit;
}

void AlignedTriangle::move(int point, const glm::dvec2& place) {
  at(places_, point) = place;
  read(place, &sampleAt(point, 0));
}

/// Diagonals first: points that move between triangles across a valley make teeth along it.
void AlignedTriangle::align() {
  swapDiagonals();
  moveInside(0.25);
  moveInside(0.12);
  swapDiagonals();
  moveInside(0.12);
  moveInside(0.06);
  swapDiagonals();
}

void AlignedTriangle::moveInside(double step) {
  for (int point = firstInside(); point < static_cast<int>(places_.size()); ++point) moveIfBetter(point, step);
}

void AlignedTriangle::moveIfBetter(int point, double step) {
  const auto first = std::ranges::find_if(triangles_, [&](const std::array<int, 3>& t) { return isAt(point, t); });
  const glm::dvec2& corner = at(places_, (*first)[0]);
  const double size =
      std::sqrt(std::abs(crossOf(at(places_, (*first)[1]) - corner, at(places_, (*first)[2]) - corner)));
  const glm::dvec2 home = at(places_, point);
  glm::dvec2 best = home;
  PointFit fit = fitAt(point, home);
  for (const glm::dvec2& way : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-1, 0), glm::dvec2(0, -1)}) {
    const glm::dvec2 place = home + step * size * way;
    const PointFit moved = fitAt(point, place, boundOf(fit));
    if (!isBetterFit(moved, fit, tolerance_)) continue;
    fit = moved;
    best = place;
  }
  if (best == home) return;
  move(point, best);
  isChanged_ = true;
}

void AlignedTriangle::swapDiagonals() {
  for (int pass = 0; pass < kDiagonalPasses; ++pass) {
    bool swapped = false;
    for (std::size_t one = 0; one < triangles_.size(); ++one) {
      for (std::size_t side = 0; side < 3; ++side) swapped = swapIfBetter(one, side) || swapped;
    }
    if (!swapped) return;
    isChanged_ = true;
  }
}

/// The triangle beyond the side from a to b.
std::optional<std::size_t> AlignedTriangle::beyond(std::size_t from, int a, int b) const {
  for (std::size_t i = from; i < triangles_.size(); ++i) {
    const auto& [p, q, r] = triangles_[i];
    if ((p == b && q == a) || (q == b && r == a) || (r == b && p == a)) return i;
  }
  return std::nullopt;
}

bool AlignedTriangle::swapIfBetter(std::size_t one, std::size_t side) {
  const int a = triangles_[one][side];
  const int b = triangles_[one][(side + 1) % 3];
  const int c = triangles_[one][(side + 2) % 3];
  const auto two = beyond(one + 1, a, b);
  if (!two) return false;
  int d = triangles_[*two][0];
  for (const int point : triangles_[*two]) d = point != a && point != b ? point : d;
  const std::array<int, 3> first{c, a, d};
  const std::array<int, 3> second{c, d, b};
  const double former = std::min(leastAngle(triangles_[one]), leastAngle(triangles_[*two]));
  if (std::min(leastAngle(first), leastAngle(second)) < std::min(kAlignedLeastAngle, former)) return false;
  if (!isCloser(a, b, c, d)) return false;
  triangles_[one] = first;
  triangles_[*two] = second;
  return true;
}

/// Whether c-d comes closer to the surface than a-b where they cross.
bool AlignedTriangle::isCloser(int a, int b, int c, int d) {
  const glm::dvec2 along = at(places_, b) - at(places_, a);
  const glm::dvec2 across = at(places_, d) - at(places_, c);
  const double area = crossOf(along, across);
  if (area == 0.0) return false;
  const glm::dvec2 between = at(places_, c) - at(places_, a);
  const double onSide = crossOf(between, across) / area;
  const auto onOther = static_cast<float>(crossOf(between, along) / area);
  const SampleCell cell = grids_.cellOf(at(places_, a) + onSide * along);
  float former = 0.0f;
  float swapped = 0.0f;
  for (std::size_t pose = 0; pose < poses(); ++pose) {
    const PlaceSample own = grids_.at(cell, pose);
    const PlaceSample onFormer = mean(sampleAt(a, pose), sampleAt(b, pose), static_cast<float>(onSide));
    const PlaceSample onSwapped = mean(sampleAt(c, pose), sampleAt(d, pose), onOther);
    const float off = glm::distance(onSwapped.position, own.position);
    if (off > tolerance_ && off > glm::distance(onFormer.position, own.position)) return false;
    former += turnBetween(onFormer.normal, own.normal);
    swapped += turnBetween(onSwapped.normal, own.normal);
  }
  return swapped < kDiagonalGain * former - kLeastTurn * static_cast<float>(poses());
}

Triangulation AlignedTriangle::triangulation() const {
  Triangulation out{levels_, {}, {}};
  if (!isChanged_) return out;
  out.inside.assign(places_.begin() + firstInside(), places_.end());
  for (const auto& [a, b, c] : triangles_) {
    out.triangles.push_back({static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(c)});
  }
  return out;
}

}  // namespace sinew
