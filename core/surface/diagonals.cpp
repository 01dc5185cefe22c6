// core/surface/diagonals.cpp: samples the surface on a grid in each control triangle and swaps diagonals, pose by pose.
#include "core/surface/diagonals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/sampling.h"

namespace sinew {
namespace {

constexpr int kDiagonalFewSamples = 6;  ///< Along a side, up to this level:
constexpr int kDiagonalFewLevels = 3;
constexpr int kDiagonalSamples = 12;
constexpr double kDiagonalLeastAngle = 0.2618;  ///< 15 degrees in the bind pose, unless the former triangles have less.
constexpr float kDiagonalGain = 0.9f;           ///< A diagonal is swapped if its error becomes less than this fraction.
constexpr float kDiagonalLeastError = 1e-5f;    ///< Squared, a pose: 0.2 degrees.
constexpr int kDiagonalPasses = 8;

double crossOf(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

struct PlaceSample {
  glm::vec3 position;
  glm::vec3 normal;
};

/// Samples of one control triangle in one pose, in the order of forEachSample().
struct SampleGrid {
  int fine = 0;
  std::vector<PlaceSample> samples;

  /// Linear between samples.  @param place  barycentric (1-x-y, x, y)
  [[nodiscard]] PlaceSample at(const glm::dvec2& place) const {
    const auto [j, x] = cellOf(place.x);
    const auto [k, y] = cellOf(place.y);
    const auto cornerAt = [&](int row, int column) -> const PlaceSample& {
      return sinew::at(samples, row * (fine + 1) - row * (row - 1) / 2 + column);
    };
    if (x + y <= 1.0f || j + k >= fine - 1) {
      if (j + k >= fine) return cornerAt(j, std::min(k, fine - j));
      return mean(cornerAt(j, k), 1.0f - x - y, cornerAt(j + 1, k), x, cornerAt(j, k + 1), y);
    }
    return mean(cornerAt(j + 1, k + 1), x + y - 1.0f, cornerAt(j, k + 1), 1.0f - x, cornerAt(j + 1, k), 1.0f - y);
  }

 private:
  [[nodiscard]] std::pair<int, float> cellOf(double coordinate) const {
    const double scaled = std::clamp(coordinate, 0.0, 1.0) * fine;
    const double nearest = std::round(scaled);
    const double place = std::abs(scaled - nearest) < 1e-9 ? nearest : scaled;
    const int cell = static_cast<int>(place);
    return {cell, static_cast<float>(place - cell)};
  }
  static PlaceSample mean(const PlaceSample& a, float u, const PlaceSample& b, float v, const PlaceSample& c, float w) {
    return {u * a.position + v * b.position + w * c.position, u * a.normal + v * b.normal + w * c.normal};
  }
};

/// The split of one control triangle, whose diagonals are swapped.
class DiagonalSwapper {
 public:
  /// @param corners  bind pose.  @param poses  samples of the triangle in each pose
  DiagonalSwapper(const SplitLevels& levels, const std::array<glm::vec3, 3>& corners, std::span<const SampleGrid> poses,
                  float tolerance)
      : levels_(levels), poses_(poses), tolerance_(tolerance) {
    split_.split(levels, corners);
    triangles_.assign(split_.triangles().begin(), split_.triangles().end());
    flatten(corners);
    takePoints();
  }

  [[nodiscard]] Triangulation run() {
    bool swappedAny = false;
    for (int pass = 0; pass < kDiagonalPasses; ++pass) {
      bool swapped = false;
      for (std::size_t one = 0; one < triangles_.size(); ++one) {
        for (std::size_t side = 0; side < 3; ++side) swapped = swapIfBetter(one, side) || swapped;
      }
      if (!swapped) break;
      swappedAny = true;
    }
    Triangulation out{levels_, {}};
    if (!swappedAny) return out;
    for (const std::array<int, 3>& t : triangles_) {
      out.triangles.push_back(
          {static_cast<std::uint8_t>(t[0]), static_cast<std::uint8_t>(t[1]), static_cast<std::uint8_t>(t[2])});
    }
    return out;
  }

 private:
  void flatten(const std::array<glm::vec3, 3>& corners) {
    const glm::dvec3 u = glm::dvec3(corners[1]) - glm::dvec3(corners[0]);
    const glm::dvec3 v = glm::dvec3(corners[2]) - glm::dvec3(corners[0]);
    const double length = glm::length(u);
    const double area = glm::length(glm::cross(u, v));
    plane_ = {glm::dvec2(1.0, 0.0), glm::dvec2(0.5, 0.866)};
    if (length > 0.0 && area > 0.0) plane_ = {glm::dvec2(length, 0.0), glm::dvec2(glm::dot(u, v), area) / length};
  }

  void takePoints() {
    places_ = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
    for (std::size_t side = 0; side < 3; ++side) {
      const glm::dvec2 from = places_[side];
      const glm::dvec2 to = places_[(side + 1) % 3];
      for (int step = 1; step < levels_.sides[side]; ++step) {
        places_.push_back(from + (to - from) * (static_cast<double>(step) / levels_.sides[side]));
      }
    }
    places_.insert(places_.end(), split_.inside().begin(), split_.inside().end());
    for (const SampleGrid& pose : poses_) {
      std::vector<PlaceSample>& points = points_.emplace_back();
      for (const glm::dvec2& place : places_) points.push_back(pose.at(place));
    }
  }

  [[nodiscard]] double leastAngle(const std::array<int, 3>& t) const {
    double least = 4.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec2 u = inPlane(t[(i + 1) % 3]) - inPlane(t[i]);
      const glm::dvec2 v = inPlane(t[(i + 2) % 3]) - inPlane(t[i]);
      least = std::min(least, std::atan2(crossOf(u, v), glm::dot(u, v)));
    }
    return least;
  }
  [[nodiscard]] glm::dvec2 inPlane(int point) const {
    const glm::dvec2& place = at(places_, point);
    return place.x * plane_[0] + place.y * plane_[1];
  }

  /// The triangle beyond the side from a to b; none: npos.
  [[nodiscard]] std::size_t beyond(std::size_t from, int a, int b) const {
    for (std::size_t i = from; i < triangles_.size(); ++i) {
      const auto& [p, q, r] = triangles_[i];
      if ((p == b && q == a) || (q == b && r == a) || (r == b && p == a)) return i;
    }
    return npos;
  }

  bool swapIfBetter(std::size_t one, std::size_t side) {
    const int a = triangles_[one][side];
    const int b = triangles_[one][(side + 1) % 3];
    const int c = triangles_[one][(side + 2) % 3];
    const std::size_t two = beyond(one + 1, a, b);
    if (two == npos) return false;
    int d = triangles_[two][0];
    for (const int point : triangles_[two]) d = point != a && point != b ? point : d;
    const std::array<int, 3> first{c, a, d};
    const std::array<int, 3> second{c, d, b};
    const double angle = std::min(leastAngle(first), leastAngle(second));
    if (angle < std::min(kDiagonalLeastAngle, std::min(leastAngle(triangles_[one]), leastAngle(triangles_[two]))))
      return false;
    if (!isBetter(a, b, c, d)) return false;
    triangles_[one] = first;
    triangles_[two] = second;
    return true;
  }

  /// Whether c-d comes closer to the surface than a-b where they cross.
  [[nodiscard]] bool isBetter(int a, int b, int c, int d) const {
    const glm::dvec2 along = at(places_, b) - at(places_, a);
    const glm::dvec2 across = at(places_, d) - at(places_, c);
    const double area = crossOf(along, across);
    if (area == 0.0) return false;
    const glm::dvec2 between = at(places_, c) - at(places_, a);
    const double onSide = crossOf(between, across) / area;
    const double onOther = crossOf(between, along) / area;
    const glm::dvec2 place = at(places_, a) + onSide * along;
    float former = 0.0f;
    float swapped = 0.0f;
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
      const PlaceSample own = poses_[pose].at(place);
      const PlaceSample onFormer = meanOf(pose, a, b, static_cast<float>(onSide));
      const PlaceSample onSwapped = meanOf(pose, c, d, static_cast<float>(onOther));
      const float off = glm::distance(onSwapped.position, own.position);
      if (off > tolerance_ && off > glm::distance(onFormer.position, own.position)) return false;
      former += turn(onFormer.normal, own.normal);
      swapped += turn(onSwapped.normal, own.normal);
    }
    return swapped < kDiagonalGain * former - kDiagonalLeastError * static_cast<float>(poses_.size());
  }

  [[nodiscard]] PlaceSample meanOf(std::size_t pose, int from, int to, float share) const {
    const PlaceSample& a = at(points_[pose], from);
    const PlaceSample& b = at(points_[pose], to);
    return {(1.0f - share) * a.position + share * b.position, (1.0f - share) * a.normal + share * b.normal};
  }

  /// Squared distance of unit vectors.
  static float turn(const glm::vec3& a, const glm::vec3& b) {
    const float lengths = glm::length(a) * glm::length(b);
    return lengths > 0.0f ? 2.0f - 2.0f * glm::dot(a, b) / lengths : 4.0f;
  }

  static constexpr std::size_t npos = static_cast<std::size_t>(-1);
  SplitLevels levels_;
  std::span<const SampleGrid> poses_;
  float tolerance_;
  SplitTriangle split_;
  std::vector<std::array<int, 3>> triangles_;
  std::array<glm::dvec2, 2> plane_{};             ///< Sides from corner 0.
  std::vector<glm::dvec2> places_;                ///< Barycentric, of all points.
  std::vector<std::vector<PlaceSample>> points_;  ///< [poses][points]
};

/// Whether there is a diagonal to swap.
bool hasDiagonals(const SplitLevels& split) {
  return split.inside > 1 || std::ranges::any_of(split.sides, [](int level) { return level > 1; });
}

int samplesOf(const SplitLevels& split) {
  return std::max(std::ranges::max(split.sides), split.inside) <= kDiagonalFewLevels ? kDiagonalFewSamples
                                                                                     : kDiagonalSamples;
}

void alignPiece(const Preparation& next, const std::vector<Pose>& poses, float tolerance,
                const RefinementLevels& levels, const SampledPiece& piece, std::vector<Triangulation>& out) {
  const SampledPart part = sampledPart(next, piece);
  const ControlMesh& mesh = part.mesh();
  const std::vector<int> asked = placesIn(part.triangles, piece.triangles);
  const auto splitAt = [&](std::size_t i) { return splitOf(next.mesh(), levels, piece.triangles[i]); };
  RefinementLevels points{std::vector<std::uint8_t>(mesh.edges.size(), 1),
                          std::vector<std::uint8_t>(mesh.triangles.size(), 1)};
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const auto fine = static_cast<std::uint8_t>(samplesOf(splitAt(i)));
    at(points.triangles, asked[i]) = fine;
    for (const int e : at(mesh.triangles, asked[i]).edges) at(points.edges, e) = std::max(at(points.edges, e), fine);
  }
  SurfaceSampler sampler(part, samplePoints(mesh, points));
  std::vector<std::vector<SampleGrid>> grids(asked.size(), std::vector<SampleGrid>(poses.size()));
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    const Surface& surface = sampler.sample(poses[pose]);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      SampleGrid& grid = grids[i][pose];
      grid.fine = samplesOf(splitAt(i));
      forEachSample(mesh, *surface.refinement, asked[i], grid.fine, [&](int, int, int vertex) {
        grid.samples.push_back({at(surface.positions, vertex), at(surface.normals, vertex)});
      });
    }
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::array<int, 3>& corners = at(mesh.triangles, asked[i]).vertices;
    const auto corner = [&](std::size_t c) { return at(mesh.positions, corners[c]); };
    at(out, piece.triangles[i]) =
        DiagonalSwapper(splitAt(i), {corner(0), corner(1), corner(2)}, grids[i], tolerance).run();
  }
}

}  // namespace

std::vector<Triangulation> alignedDiagonals(const Preparation& next, const std::vector<Pose>& poses, float tolerance,
                                            const RefinementLevels& levels, std::vector<Triangulation> known) {
  const ControlMesh& mesh = next.mesh();
  std::vector<std::uint8_t> asked(mesh.triangles.size(), 0);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const SplitLevels split = splitOf(mesh, levels, t);
    if (at(known, t).levels == split) continue;
    at(known, t) = {split, {}};
    at(asked, t) = hasDiagonals(split) ? 1 : 0;
  }
  const std::vector<SampledPiece> pieces = sampledPieces(next, std::vector<std::uint8_t>(mesh.edges.size(), 0), asked);
  forEachIndex(pieces.size(), 1, [&](std::size_t p) { alignPiece(next, poses, tolerance, levels, pieces[p], known); });
  return known;
}

}  // namespace sinew
