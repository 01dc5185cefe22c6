// core/surface/patches/split_triangle.cpp: inner points in rows; the boundary is cut into faces, points are inserted,
// and edges flipped until all faces are Delaunay (Lawson 1977).
#include "core/surface/patches/split_triangle.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr double kLeastHeight = 1e-4;  ///< Fraction of the longest side: flatter triangles have no shape to keep.
constexpr double kKeepAway = 0.4;      ///< Fraction of a side's segment, barycentric: nearer points are left out.
constexpr double kRowHeight = 0.866;   ///< sqrt(3) / 2, of equilateral triangles.
constexpr double kInCircle = 1e-12;    ///< Less counts as on the circle, so that flipping ends.

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

void SplitTriangle::split(const SplitLevels& levels, const std::array<glm::vec3, 3>& corners, const SideShares& sides) {
  levels_ = levels;
  inside_.clear();
  triangles_.clear();
  if (levels.isUniform()) placeEvenly();
  const bool isEven = std::ranges::all_of(sides, [](const std::vector<double>& side) { return side.empty(); });
  if (levels.isUniform() && isEven) return joinEvenly();
  flatten(corners);
  if (!levels.isUniform()) placeInside();
  placePoints(sides);
  joinBoundary();
  link();
  makeDelaunay();
  for (int point = firstInside(); point < static_cast<int>(points_.size()); ++point) insert(point);
  for (const Face& face : faces_) triangles_.push_back(face.points);
}

void SplitTriangle::placeEvenly() {
  const int n = levels_.inside;
  for (int j = 1; j <= n - 2; ++j) {
    for (int k = 1; k <= n - 1 - j; ++k) inside_.emplace_back(static_cast<double>(j) / n, static_cast<double>(k) / n);
  }
}

void SplitTriangle::joinEvenly() {
  const int n = levels_.inside;
  // (j, k) -> number: barycentric (n-j-k, j, k) / n.
  const auto numberOf = [&](int j, int k) {
    const int rest = n - j - k;
    if (j == n) return 1;
    if (k == n) return 2;
    if (rest == n) return 0;
    if (k == 0) return 3 + j - 1;
    if (rest == 0) return 3 + (n - 1) + k - 1;
    if (j == 0) return 3 + 2 * (n - 1) + rest - 1;
    int before = 0;
    for (int row = 1; row < j; ++row) before += n - 1 - row;
    return 3 * n + before + k - 1;
  };
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n - j; ++k) {
      triangles_.push_back({numberOf(j, k), numberOf(j + 1, k), numberOf(j, k + 1)});
      if (k < n - j - 1) triangles_.push_back({numberOf(j + 1, k), numberOf(j + 1, k + 1), numberOf(j, k + 1)});
    }
  }
}

/// Puts the corners in a plane, with a longest side of 1.
void SplitTriangle::flatten(const std::array<glm::vec3, 3>& corners) {
  const auto length = [&](std::size_t a, std::size_t b) {
    return glm::distance(glm::dvec3(corners[a]), glm::dvec3(corners[b]));
  };
  const double ab = length(0, 1);
  const double bc = length(1, 2);
  const double ca = length(2, 0);
  const double longest = std::max({ab, bc, ca});
  corners_ = {glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0), glm::dvec2(0.5, kRowHeight)};
  if (!(longest > 0.0) || !(ab > 0.0)) return;
  const double x = (ab * ab + ca * ca - bc * bc) / (2.0 * ab);
  const double height = std::sqrt(std::max(0.0, ca * ca - x * x));
  if (!(height * ab > kLeastHeight * longest * longest)) return;
  corners_ = {glm::dvec2(0.0), glm::dvec2(ab, 0.0) / longest, glm::dvec2(x, height) / longest};
}

glm::dvec2 SplitTriangle::inPlane(const glm::dvec2& at) const {
  return (1.0 - at.x - at.y) * corners_[0] + at.x * corners_[1] + at.y * corners_[2];
}

void SplitTriangle::placeInside() {
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) lengths[i] = glm::distance(corners_[i], corners_[(i + 1) % 3]);
  const auto base = static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
  const double area = cross(corners_[1] - corners_[0], corners_[2] - corners_[0]);
  const int n = levels_.inside;
  const double evenRows = area / lengths[base] / (kRowHeight * lengths[base] / n);
  const int rows = std::clamp(std::max(static_cast<int>(std::lround(evenRows)), std::ranges::min(levels_.sides)), 1, n);
  for (int row = 1; row < rows; ++row) {
    const double up = static_cast<double>(row) / rows;
    const int segments = std::max(1, static_cast<int>(std::lround(n * (1.0 - up))));
    for (int i = 1; i < segments; ++i) {
      const double along = static_cast<double>(i) / segments;
      std::array<double, 3> at{};
      at[base] = (1.0 - up) * (1.0 - along);
      at[(base + 1) % 3] = (1.0 - up) * along;
      at[(base + 2) % 3] = up;
      bool keeps = true;
      for (std::size_t side = 0; side < 3; ++side) keeps &= at[(side + 2) % 3] * levels_.sides[side] >= kKeepAway;
      if (keeps) inside_.emplace_back(at[1], at[2]);
    }
  }
}

void SplitTriangle::placePoints(const SideShares& sides) {
  points_.assign(corners_.begin(), corners_.end());
  sidesOf_.assign({0b101, 0b011, 0b110});
  ring_.clear();
  for (std::size_t side = 0; side < 3; ++side) {
    ring_.push_back(static_cast<int>(side));
    for (int step = 1; step < levels_.sides[side]; ++step) {
      ring_.push_back(static_cast<int>(points_.size()));
      const double even = static_cast<double>(step) / levels_.sides[side];
      const double share = sides[side].empty() ? even : sides[side][toIndex(step - 1)];
      points_.push_back((1.0 - share) * corners_[side] + share * corners_[(side + 1) % 3]);
      sidesOf_.push_back(1 << side);
    }
  }
  for (const glm::dvec2& at : inside_) {
    points_.push_back(inPlane(at));
    sidesOf_.push_back(0);
  }
}

bool SplitTriangle::onOneSide(int a, int b, int c) const {
  return (at(sidesOf_, a) & at(sidesOf_, b) & at(sidesOf_, c)) != 0;
}

/// Twice the area, positive counter-clockwise; exactly 0 for points on one side.
double SplitTriangle::areaOf(int a, int b, int c) const {
  if (onOneSide(a, b, c)) return 0.0;
  return cross(at(points_, b) - at(points_, a), at(points_, c) - at(points_, a));
}

/// Cuts off boundary points one by one; the rest must not all lie on one side.
void SplitTriangle::joinBoundary() {
  faces_.clear();
  while (ring_.size() > 3) {
    const std::size_t count = ring_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const int before = ring_[(i + count - 1) % count];
      const int after = ring_[(i + 1) % count];
      if (onOneSide(before, ring_[i], after)) continue;
      int shared = 0b111;
      for (std::size_t other = 0; other < count; ++other) shared &= other == i ? 0b111 : at(sidesOf_, ring_[other]);
      if (shared != 0) continue;
      faces_.push_back({{before, ring_[i], after}, {-1, -1, -1}});
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
  }
  faces_.push_back({{ring_[0], ring_[1], ring_[2]}, {-1, -1, -1}});
}

/// Finds the face beyond each side.
void SplitTriangle::link() {
  const auto sideOf = [&](const Face& face, int from, int to) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (face.points[(i + 1) % 3] == from && face.points[(i + 2) % 3] == to) return static_cast<int>(i);
    }
    return -1;
  };
  for (std::size_t a = 0; a < faces_.size(); ++a) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t b = 0; b < faces_.size() && faces_[a].across[i] < 0; ++b) {
        if (sideOf(faces_[b], faces_[a].points[(i + 2) % 3], faces_[a].points[(i + 1) % 3]) < 0) continue;
        faces_[a].across[i] = static_cast<int>(b);
      }
    }
  }
  for (std::size_t a = 0; a < faces_.size(); ++a) {
    for (int i = 0; i < 3; ++i) pending_.push_back({static_cast<int>(a), i});
  }
}

bool SplitTriangle::isInCircle(int a, int b, int c, int d) const {
  const glm::dvec2 p = at(points_, a) - at(points_, d);
  const glm::dvec2 q = at(points_, b) - at(points_, d);
  const glm::dvec2 r = at(points_, c) - at(points_, d);
  return glm::dot(p, p) * cross(q, r) - glm::dot(q, q) * cross(p, r) + glm::dot(r, r) * cross(p, q) > kInCircle;
}

void SplitTriangle::relink(int face, int from, int to) {
  if (face < 0) return;
  for (int& across : at(faces_, face).across) across = across == from ? to : across;
}

/// Replaces the common side of two faces by the other diagonal of their four points, if that is better.
void SplitTriangle::flipIfBetter(int face, std::size_t side) {
  const int other = at(faces_, face).across[side];
  if (other < 0) return;
  Face& one = at(faces_, face);
  Face& two = at(faces_, other);
  const int p = one.points[side];
  const int u = one.points[(side + 1) % 3];
  const int v = one.points[(side + 2) % 3];
  std::size_t far = 0;
  while (two.points[far] == u || two.points[far] == v) ++far;
  const int q = two.points[far];
  if (!(areaOf(p, u, q) > 0.0 && areaOf(p, q, v) > 0.0)) return;
  const bool isFlat = !(areaOf(p, u, v) > 0.0) || !(areaOf(q, v, u) > 0.0);
  if (!isFlat && !isInCircle(p, u, v, q)) return;
  // Faces beyond the four outer sides.
  const auto beyond = [](const Face& of, int opposite) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (of.points[i] == opposite) return of.across[i];
    }
    return -1;
  };
  const int pv = beyond(one, u);
  const int pu = beyond(one, v);
  const int qv = beyond(two, u);
  const int qu = beyond(two, v);
  one = {{p, u, q}, {qu, other, pu}};
  two = {{p, q, v}, {qv, pv, face}};
  relink(qu, other, face);
  relink(pv, face, other);
  pending_.push_back({face, 0});
  pending_.push_back({face, 2});
  pending_.push_back({other, 0});
  pending_.push_back({other, 1});
}

void SplitTriangle::makeDelaunay() {
  while (!pending_.empty()) {
    const auto [face, side] = pending_.back();
    pending_.pop_back();
    flipIfBetter(face, static_cast<std::size_t>(side));
  }
}

void SplitTriangle::insert(int point) {
  int within = 0;
  double best = -2.0;
  for (int i = 0; i < static_cast<int>(faces_.size()); ++i) {
    const auto& [a, b, c] = at(faces_, i).points;
    const double least = std::min({areaOf(a, b, point), areaOf(b, c, point), areaOf(c, a, point)});
    if (least > best) {
      best = least;
      within = i;
    }
  }
  const Face old = at(faces_, within);
  const int second = static_cast<int>(faces_.size());
  const int third = second + 1;
  const auto& [a, b, c] = old.points;
  at(faces_, within) = {{a, b, point}, {second, third, old.across[2]}};
  faces_.push_back({{b, c, point}, {third, within, old.across[0]}});
  faces_.push_back({{c, a, point}, {within, second, old.across[1]}});
  relink(old.across[0], within, second);
  relink(old.across[1], within, third);
  for (const int face : {within, second, third}) pending_.push_back({face, 2});
  makeDelaunay();
}

}  // namespace sinew
