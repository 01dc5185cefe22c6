// core/surface/projection/rise.cpp: normals relaxed over converging edges; nearest points that meet, found in a grid.
#include "core/surface/projection/rise.h"

#include <tuple>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/triangle_sides.h"
#include "core/geometry/triangle_tree.h"

namespace sinew {

namespace {

constexpr int kRounds = 24;
constexpr float kLeastCosine = 0.5f;  ///< Between a direction and its normal.

/// Weight of an edge: rise over the height at which its lifted ends would meet. 0 if the directions diverge.
float convergence(const glm::vec3& edge, const glm::vec3& a, const glm::vec3& b, float rise) {
  const float squared = glm::dot(edge, edge);
  if (!(squared > 0.0f)) return 0.0f;
  return std::max(0.0f, -rise * glm::dot(b - a, edge) / squared);
}

/// The direction nearest to `wanted` within the widest angle of the normal.
glm::vec3 nearNormal(const glm::vec3& wanted, const glm::vec3& normal) {
  const float along = glm::dot(wanted, normal);
  if (along >= kLeastCosine) return wanted;
  const glm::vec3 sideways = normalizeOr(wanted - along * normal, glm::vec3(0.0f));
  return normalizeOr(kLeastCosine * normal + std::sqrt(1.0f - kLeastCosine * kLeastCosine) * sideways, normal);
}

}  // namespace

std::vector<glm::vec3> riseDirections(const ControlMesh& mesh, float rise) {
  std::vector<glm::vec3> directions = mesh.normals;
  std::vector<glm::vec3> sums(directions.size());
  std::vector<float> weights(directions.size());
  for (int round = 0; round < kRounds; ++round) {
    std::ranges::fill(sums, glm::vec3(0.0f));
    std::ranges::fill(weights, 0.0f);
    for (const Edge& edge : mesh.edges) {
      const auto a = static_cast<std::size_t>(edge.vertices[0]);
      const auto b = static_cast<std::size_t>(edge.vertices[1]);
      const float weight = convergence(mesh.positions[b] - mesh.positions[a], directions[a], directions[b], rise);
      sums[a] += weight * directions[b];
      sums[b] += weight * directions[a];
      weights[a] += weight;
      weights[b] += weight;
    }
    for (std::size_t v = 0; v < directions.size(); ++v) {
      if (weights[v] == 0.0f) continue;
      // A direction keeps at least half of itself: on dense meshes neighbors weigh so much that they would swap in
      // every round.
      directions[v] =
          nearNormal(normalizeOr((1.0f + weights[v]) * directions[v] + sums[v], mesh.normals[v]), mesh.normals[v]);
    }
  }
  return directions;
}

namespace {

constexpr float kFarthest = 1.5f;  ///< Times `most`: there is no limit from here on.
constexpr double kSpacing = 0.15;  ///< Spacing of points, times `most`.
constexpr int kMostSteps = 8;      ///< Along an edge of a large triangle.

struct Point {
  glm::vec3 position;
  glm::vec3 direction;
  glm::ivec3 cell{0};
  int side = 0;             ///< The one of six axes nearest to its direction.
  double fromCenter = 0.0;  ///< Squared distance from the middle of its cell.
};

int sideOf(const glm::vec3& direction) {
  const glm::length_t axis = longestAxis(glm::abs(direction));
  return 2 * axis + (direction[axis] < 0.0f ? 1 : 0);
}

/// Points of the mesh sorted by cells of a grid, so that the neighborhood of a point is a few ranges. Dense points are
/// thinned: in a cell of `spacing`, of those with directions nearest to one axis, the one nearest to the middle stays.
class PointGrid {
 public:
  PointGrid(const ControlMesh& mesh, std::span<const glm::vec3> directions, double spacing, double cellSize)
      : cellSize_(cellSize) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) add(mesh.positions[v], directions[v]);
    for (const ControlTriangle& triangle : mesh.triangles) addInside(mesh, directions, triangle, spacing);
    thin(spacing);
    for (Point& point : points_) point.cell = cellOf(point.position, cellSize_);
    std::ranges::sort(points_, {}, [](const Point& point) { return key(point.cell); });
  }

  /// Calls visit for every point of the cells that a ball touches.
  template <typename Visit>
  void around(const glm::vec3& center, float radius, Visit&& visit) const {
    const glm::ivec3 low = cellOf(center - radius, cellSize_);
    const glm::ivec3 high = cellOf(center + radius, cellSize_);
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        const auto before = [](const Point& point, const glm::ivec3& cell) { return key(point.cell) < key(cell); };
        auto at = std::lower_bound(points_.begin(), points_.end(), glm::ivec3(x, y, low.z), before);
        for (; at != points_.end() && at->cell.x == x && at->cell.y == y && at->cell.z <= high.z; ++at) visit(*at);
      }
    }
  }

 private:
  static std::tuple<int, int, int> key(const glm::ivec3& cell) { return {cell.x, cell.y, cell.z}; }

  static glm::ivec3 cellOf(const glm::dvec3& p, double size) { return glm::ivec3(glm::floor(p / size)); }

  void add(const glm::vec3& position, const glm::vec3& direction) { points_.push_back({position, direction}); }

  void thin(double spacing) {
    for (Point& point : points_) {
      point.cell = cellOf(point.position, spacing);
      point.side = sideOf(point.direction);
      const glm::dvec3 off = glm::dvec3(point.position) - spacing * (glm::dvec3(point.cell) + 0.5);
      point.fromCenter = glm::dot(off, off);
    }
    const auto place = [](const Point& point) { return std::tuple(key(point.cell), point.side); };
    std::ranges::sort(points_, {}, [&](const Point& point) {
      const glm::vec3& p = point.position;
      return std::tuple(place(point), point.fromCenter, p.x, p.y, p.z);
    });
    const auto samePlace = [&](const Point& a, const Point& b) { return place(a) == place(b); };
    points_.erase(std::unique(points_.begin(), points_.end(), samePlace), points_.end());
  }

  void addInside(const ControlMesh& mesh, std::span<const glm::vec3> directions, const ControlTriangle& triangle,
                 double spacing) {
    const std::array<glm::vec3, 3> p = cornersOf(mesh, triangle);
    std::array<glm::vec3, 3> d;
    for (std::size_t i = 0; i < 3; ++i) d[i] = at(directions, triangle.vertices[i]);
    const double wanted = std::ceil(static_cast<double>(longestSide(p)) / spacing);
    const int steps = static_cast<int>(std::min(wanted, static_cast<double>(kMostSteps)));
    for (int j = 0; j <= steps && steps > 1; ++j) {
      for (int k = 0; j + k <= steps; ++k) {
        if (std::max({j, k, steps - j - k}) == steps) continue;  // A corner.
        const float b = static_cast<float>(j) / static_cast<float>(steps);
        const float c = static_cast<float>(k) / static_cast<float>(steps);
        const float a = 1.0f - b - c;
        add(a * p[0] + b * p[1] + c * p[2], normalizeOr(a * d[0] + b * d[1] + c * d[2], d[0]));
      }
    }
  }

  double cellSize_;
  std::vector<Point> points_;
};

}  // namespace

/// Unit directions differ by 2 at most, so points that meet below 3/2 `most` lie within 3 `most` of each other, and a
/// grid finds them without looking at all pairs.
std::vector<float> inverseRiseLimits(const ControlMesh& mesh, std::span<const glm::vec3> directions, float most) {
  const float radius = 2.0f * kFarthest * most;  // Unit vectors differ by 2 at most.
  const PointGrid grid(mesh, directions, kSpacing * static_cast<double>(most), 0.5 * static_cast<double>(radius));
  std::vector<float> out(mesh.positions.size(), 0.0f);
  for (std::size_t v = 0; v < out.size(); ++v) {
    const glm::vec3& p = mesh.positions[v];
    float nearest = 0.0f;
    grid.around(p, radius, [&](const Point& q) {
      const glm::vec3 apart = q.position - p;
      const float squared = glm::dot(apart, apart);
      const float converging = glm::dot(directions[v] - q.direction, apart);
      if (squared > 0.0f && converging > nearest * squared) nearest = converging / squared;
    });
    out[v] = nearest * smoothstep(1.0f / kFarthest, 1.0f, nearest * most);
  }
  return out;
}

}  // namespace sinew
