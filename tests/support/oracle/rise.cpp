// tests/support/oracle/rise.cpp: rounds over all edges, each based on the previous round only.

#include "tests/support/oracle/rise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace sinew::oracle {
namespace {

constexpr int kRounds = 24;

/// A unit vector at most 60 degrees from a unit normal: turned towards it in the plane of the two.
Vec limited(const Vec& direction, const Vec& normal) {
  const double cosine = dot(direction, normal);
  if (cosine >= 0.5) return direction;
  const Vec across = unitOr(direction - cosine * normal, normal);
  return unitOr(0.5 * normal + std::sqrt(0.75) * across, normal);
}

using Points = std::vector<std::pair<Vec, Vec>>;  // Position and direction.

/// One point for all of a cell that lean to the same axis: the one nearest to the cell's middle.
Points thinned(const Points& points, double cell) {
  using Place = std::array<long, 5>;
  std::map<Place, std::pair<double, std::size_t>> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [p, d] = points[i];
    const std::array<double, 3> at{p.x, p.y, p.z};
    const std::array<double, 3> towards{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    const auto axis = std::ranges::max_element(towards) - towards.begin();
    const double sign = axis == 0 ? d.x : axis == 1 ? d.y : d.z;
    Place place{0, 0, 0, axis, sign < 0.0 ? 1 : 0};
    double distance = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      place[k] = static_cast<long>(std::floor(at[k] / cell));
      const double off = at[k] / cell - static_cast<double>(place[k]) - 0.5;
      distance += off * off;
    }
    const auto [where, isNew] = kept.try_emplace(place, distance, i);
    if (!isNew && distance < where->second.first) where->second = {distance, i};
  }
  Points out;
  for (const auto& [place, one] : kept) out.push_back(points[one.second]);
  return out;
}

}  // namespace

std::vector<Vec> relaxedDirections(const ControlMesh& mesh, double rise) {
  std::vector<Vec> normals;
  for (const glm::vec3& normal : mesh.normals) normals.push_back(vec(normal));
  std::vector<Vec> directions = normals;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vec> sums = directions;
    for (const Edge& edge : mesh.edges) {
      const auto a = static_cast<std::size_t>(edge.vertices[0]);
      const auto b = static_cast<std::size_t>(edge.vertices[1]);
      const Vec along = vec(mesh.positions[b]) - vec(mesh.positions[a]);
      const double squared = dot(along, along);
      if (squared == 0.0) continue;
      const double weight = std::max(0.0, -rise * dot(directions[b] - directions[a], along) / squared);
      sums[a] = sums[a] + weight * (directions[a] + directions[b]);
      sums[b] = sums[b] + weight * (directions[b] + directions[a]);
    }
    for (std::size_t v = 0; v < sums.size(); ++v) directions[v] = limited(unitOr(sums[v], normals[v]), normals[v]);
  }
  return directions;
}

std::vector<double> inverseLimits(const ControlMesh& mesh, const std::vector<Vec>& directions, double most) {
  std::vector<Vec> at;
  for (const glm::vec3& position : mesh.positions) at.push_back(vec(position));
  Points points;
  for (std::size_t v = 0; v < at.size(); ++v) points.emplace_back(at[v], directions[v]);
  for (const ControlTriangle& triangle : mesh.triangles) {
    std::array<std::size_t, 3> c{};
    for (std::size_t i = 0; i < 3; ++i) c[i] = static_cast<std::size_t>(triangle.vertices[i]);
    const double longest =
        std::max({length(at[c[1]] - at[c[0]]), length(at[c[2]] - at[c[1]]), length(at[c[0]] - at[c[2]])});
    const int n = std::min(8, static_cast<int>(std::ceil(longest / (0.15 * most))));
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n && i + j <= n; ++j) {
        if (i + j == 0) continue;
        const double u = static_cast<double>(i) / n;
        const double w = static_cast<double>(j) / n;
        const auto mix = [&](const std::vector<Vec>& of) {
          return (1.0 - u - w) * of[c[0]] + u * of[c[1]] + w * of[c[2]];
        };
        points.emplace_back(mix(at), unitOr(mix(directions), directions[c[0]]));
      }
    }
  }
  points = thinned(points, 0.15 * most);
  std::vector<double> out;
  for (std::size_t v = 0; v < at.size(); ++v) {
    double largest = 0.0;
    for (const auto& [q, d] : points) {
      const Vec apart = q - at[v];
      const double squared = dot(apart, apart);
      if (squared > 0.0) largest = std::max(largest, dot(directions[v] - d, apart) / squared);
    }
    const double t = std::clamp((largest * most - 2.0 / 3.0) * 3.0, 0.0, 1.0);
    out.push_back(largest * t * t * (3.0 - 2.0 * t));
  }
  return out;
}

double heightBelowOverhangs(double root, double sigma, double part, const Function& psi, const Function& slope) {
  const Function sum = [&](double s) { return s + psi(s) / sigma; };
  const Function sumSlope = [&](double s) { return 1.0 + slope(s) / sigma; };
  double height = std::min(root, sum(0.0));
  for (int i = 0; i < 32 && i * part < root; ++i) {
    std::array<double, 2> ends{i * part, std::min((i + 1) * part, root)};
    if (ends[1] < root) height = std::min(height, sum(ends[1]));
    for (int step = 0; step < 6 && sumSlope(ends[0]) < 0.0 && sumSlope(ends[1]) > 0.0; ++step) {
      const std::array<double, 2> slopes{sumSlope(ends[0]), sumSlope(ends[1])};
      const double zero = (ends[0] * slopes[1] - ends[1] * slopes[0]) / (slopes[1] - slopes[0]);
      // Two tangents y = sum(end) + slope (s - end).
      const double meeting =
          (sum(ends[0]) - slopes[0] * ends[0] - sum(ends[1]) + slopes[1] * ends[1]) / (slopes[1] - slopes[0]);
      const double middle = 0.5 * (ends[0] + ends[1]);
      const double lowest = std::clamp(step == 5 ? zero : step % 2 == 0 ? meeting : middle, ends[0], ends[1]);
      height = std::min(height, sum(lowest));
      ends.at(sumSlope(lowest) < 0.0 ? 0 : 1) = lowest;
    }
  }
  return height;
}

double heightWithin(double height, double inverseLimit) {
  if (height * inverseLimit <= 0.5) return height;
  return (1.0 - 0.25 / (inverseLimit * height)) / inverseLimit;
}

}  // namespace sinew::oracle
