// core/surface/patches/levels.cpp: levels graded by a work list; samples compared with chords and planes.
#include "core/surface/patches/levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/triangle_sides.h"

namespace sinew {

namespace {

constexpr float kMostRatio = 3.0f;

/// The lowest graded level whose pieces are at most that long.
int levelFor(float length, float most) {
  const auto fits = [&](int level) { return length <= most * static_cast<float>(level); };
  const auto found = std::ranges::find_if(kGradedLevels, fits);
  return found == kGradedLevels.end() ? kGradedLevels.back() : *found;
}

/// The shortest piece of a triangle's sides and inside, and its level.
struct Finest {
  float piece = 0.0f;
  int level = 1;
};

class WorkList {
 public:
  explicit WorkList(std::size_t triangles) : waits_(triangles, true), list_(triangles) {
    std::iota(list_.begin(), list_.end(), 0);
  }

  [[nodiscard]] bool empty() const { return list_.empty(); }

  [[nodiscard]] int take() {
    const int t = list_.back();
    list_.pop_back();
    at(waits_, t) = false;
    return t;
  }

  void add(int t) {
    if (!at(waits_, t)) list_.push_back(t);
    at(waits_, t) = true;
  }

 private:
  std::vector<bool> waits_;  ///< [T]
  std::vector<int> list_;
};

}  // namespace

RefinementLevels LevelGrader::graded(RefinementLevels levels) const {
  WorkList waiting(mesh_.triangles.size());
  while (!waiting.empty()) {
    const int t = waiting.take();
    const std::array<int, 3>& edges = at(mesh_.triangles, t).edges;
    std::uint8_t& inside = at(levels.triangles, t);
    const auto isWhole = [&](int edge) { return at(levels.edges, edge) == 1; };
    if (inside == 1 && std::ranges::all_of(edges, isWhole)) continue;  // Most of a fine mesh.
    const std::array<float, 3> lengths = sideLengths(cornersOf(mesh_, at(mesh_.triangles, t)));
    const float longest = std::ranges::max(lengths);
    Finest finest{longest / static_cast<float>(inside), inside};
    for (std::size_t side = 0; side < 3; ++side) {
      const int level = at(levels.edges, edges[side]);
      const Finest own{lengths[side] / static_cast<float>(level), level};
      if (level > 1 && own.piece < finest.piece) finest = own;
    }
    const auto needed = [&](float length) {
      return std::min(levelFor(length, kMostRatio * finest.piece), finest.level);
    };
    inside = static_cast<std::uint8_t>(std::max<int>(inside, needed(longest)));
    for (std::size_t side = 0; side < 3; ++side) {
      const int level = needed(lengths[side]);
      if (level <= at(levels.edges, edges[side])) continue;
      at(levels.edges, edges[side]) = static_cast<std::uint8_t>(level);
      for (const EdgeSide& beside : sides_.of(edges[side])) waiting.add(beside.triangle);
    }
  }
  return levels;
}

namespace {

/// Neighboring samples whose normals differ by more have a crease between them, which no level makes smooth.
constexpr float kCreaseCosine = 0.94f;  ///< 20 degrees.

/// How many times as far normals may be off on a piece of that length.
float allowanceOf(float piece, const LevelTolerance& tolerance) {
  return tolerance.seenPiece > piece ? tolerance.seenPiece / piece : 1.0f;
}

/// Whether the normal interpolated at a sample is too far off for a piece of that length.
bool turnsTooFar(const glm::vec3& interpolated, const glm::vec3& normal, float piece, const LevelTolerance& tolerance) {
  const float times = allowanceOf(piece, tolerance);
  const float cosine = 1.0f - times * times * (1.0f - tolerance.normalCosine);  // Of angles that many times as large.
  return !(glm::dot(interpolated, normal) >= cosine * glm::length(interpolated));
}

/// The angle of two normals, in tolerances.
float turnInTolerances(const glm::vec3& interpolated, const glm::vec3& normal, const LevelTolerance& tolerance) {
  const float length = glm::length(interpolated);
  if (!(length > 0.0f)) return 1e30f;
  const float cosine = glm::dot(interpolated, normal) / length;
  return std::sqrt(std::max(0.0f, 1.0f - cosine) / (1.0f - tolerance.normalCosine));
}

float distanceToChord(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 along = b - a;
  const float squared = glm::dot(along, along);
  const float t = squared > 0.0f ? std::clamp(glm::dot(p - a, along) / squared, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, a + t * along);
}

bool isSmoothAt(const FineSamples& s, std::size_t at) {
  return glm::dot(s.normals[at - 1], s.normals[at]) > kCreaseCosine &&
         glm::dot(s.normals[at], s.normals[at + 1]) > kCreaseCosine;
}

bool edgeFits(const FineSamples& s, int fine, int level, const LevelTolerance& tolerance) {
  const int step = fine / level;
  for (int i = 0; i < fine; ++i) {
    const int from = i / step * step;
    if (i == from) continue;
    const std::size_t a = toIndex(from);
    const std::size_t b = toIndex(from + step);
    const std::size_t at = toIndex(i);
    if (distanceToChord(s.positions[at], s.positions[a], s.positions[b]) > tolerance.distance) return false;
    const float share = static_cast<float>(i - from) / static_cast<float>(step);
    const glm::vec3 between = (1.0f - share) * s.normals[a] + share * s.normals[b];
    if (!turnsTooFar(between, s.normals[at], glm::distance(s.positions[a], s.positions[b]), tolerance)) continue;
    if (isSmoothAt(s, at)) return false;
  }
  return true;
}

/// Whether distanceFromPiece() is at most `most`. The first of its two measures usually decides.
bool isWithin(float most, const glm::vec3& sample, const std::array<glm::vec3, 3>& corners,
              const std::array<float, 3>& shares) {
  const glm::vec3 own = shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
  return !(glm::distance(sample, own) > most) || !(distanceFromPiece(sample, corners, shares) > most);
}

/// Number of the sample at place k of row j of a triangle.
std::size_t indexOf(int fine, int j, int k) { return toIndex(j * (fine + 1) - j * (j - 1) / 2 + k); }

/// A sample in its small triangle of a level's split.
struct Place {
  int j = 0;
  int k = 0;
  std::size_t at = 0;
  std::array<std::size_t, 3> corners{};
  std::array<float, 3> shares{};  ///< Barycentric.
};

Place placeIn(int fine, int step, int j, int k) {
  const int row = std::min(j / step, (fine / step) - 1) * step;
  const int place = std::min(k / step, (fine - row) / step - 1) * step;
  const int fj = j - row;
  const int fk = k - place;
  const bool up = fj + fk <= step;
  const auto index = [&](int down, int right) { return indexOf(fine, row + down, place + right); };
  const auto s = static_cast<float>(step);
  const float x = static_cast<float>(up ? fj : step - fj) / s;
  const float y = static_cast<float>(up ? fk : step - fk) / s;
  return {j,
          k,
          indexOf(fine, j, k),
          up ? std::array{index(0, 0), index(step, 0), index(0, step)}
             : std::array{index(step, step), index(0, step), index(step, 0)},
          {1.0f - x - y, x, y}};
}

/// All samples but the corners of the split.
std::vector<Place> placesOf(int fine, int level) {
  const int step = fine / level;
  std::vector<Place> out;
  for (int j = 0; j <= fine; ++j) {
    for (int k = 0; k <= fine - j; ++k) {
      if (j % step != 0 || k % step != 0) out.push_back(placeIn(fine, step, j, k));
    }
  }
  return out;
}

/// Computed once, because every pose looks them up for tens of thousands of triangles.
const std::vector<Place>& knownPlaces(int fine, int level) {
  static const auto kKnown = [] {
    std::array<std::array<std::vector<Place>, kMaxDepth + 1>, kMaxDepth + 1> known;
    for (int n = 1; n <= kMaxDepth; ++n) {
      for (int divisor = 1; divisor < n; ++divisor) {
        if (n % divisor == 0) known[toIndex(n)][toIndex(divisor)] = placesOf(n, divisor);
      }
    }
    return known;
  }();
  return kKnown[toIndex(fine)][toIndex(level)];
}

bool isSmoothAt(const FineSamples& samples, int fine, int j, int k) {
  const glm::vec3& own = samples.normals[indexOf(fine, j, k)];
  constexpr std::array<std::array<int, 2>, 6> kAround{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};
  return std::ranges::all_of(kAround, [&](const std::array<int, 2>& way) {
    const int row = j + way[0];
    const int place = k + way[1];
    if (row < 0 || place < 0 || row + place > fine) return true;
    return glm::dot(own, samples.normals[indexOf(fine, row, place)]) > kCreaseCosine;
  });
}

bool triangleFits(const FineSamples& s, int fine, int level, const LevelTolerance& tolerance) {
  return std::ranges::all_of(knownPlaces(fine, level), [&](const Place& own) {
    const auto& [a, b, c] = own.corners;
    if (!isWithin(tolerance.distance, s.positions[own.at], {s.positions[a], s.positions[b], s.positions[c]},
                  own.shares)) {
      return false;
    }
    const glm::vec3 between =
        own.shares[0] * s.normals[a] + own.shares[1] * s.normals[b] + own.shares[2] * s.normals[c];
    const float piece = longestSide({s.positions[a], s.positions[b], s.positions[c]});
    return !turnsTooFar(between, s.normals[own.at], piece, tolerance) || !isSmoothAt(s, fine, own.j, own.k);
  });
}

/// The least divisor >= `from` of `fine` that fits; `fine` itself always does.
template <class Fits>
int leastDivisor(int fine, int from, Fits fits) {
  for (int level = from; level < fine; ++level) {
    if (fine % level == 0 && fits(level)) return level;
  }
  return fine;
}

}  // namespace

float distanceFromPiece(const glm::vec3& sample, const std::array<glm::vec3, 3>& corners,
                        const std::array<float, 3>& shares) {
  const auto& [a, b, c] = corners;
  const float apart = glm::distance(sample, shares[0] * a + shares[1] * b + shares[2] * c);
  const glm::vec3 face = glm::cross(b - a, c - a);
  const float area = glm::length(face);
  return area > 0.0f ? std::min(apart, std::abs(glm::dot(sample - a, face)) / area) : apart;
}

int edgeLevel(const FineSamples& samples, int from, const LevelTolerance& tolerance) {
  const int fine = static_cast<int>(samples.positions.size()) - 1;
  return leastDivisor(fine, from, [&](int level) { return edgeFits(samples, fine, level, tolerance); });
}

int triangleLevel(const FineSamples& samples, int fine, int from, const LevelTolerance& tolerance) {
  return leastDivisor(fine, from, [&](int level) { return triangleFits(samples, fine, level, tolerance); });
}

float edgeMisfit(const FineSamples& s, const LevelTolerance& tolerance) {
  const std::size_t last = s.positions.size() - 1;
  const float allowance = allowanceOf(glm::distance(s.positions[0], s.positions[last]), tolerance);
  float most = 0.0f;
  for (std::size_t i = 1; i < last; ++i) {
    most = std::max(most, distanceToChord(s.positions[i], s.positions[0], s.positions[last]) / tolerance.distance);
    if (!isSmoothAt(s, i)) continue;
    const float share = static_cast<float>(i) / static_cast<float>(last);
    const glm::vec3 between = (1.0f - share) * s.normals[0] + share * s.normals[last];
    most = std::max(most, turnInTolerances(between, s.normals[i], tolerance) / allowance);
  }
  return most;
}

float triangleMisfit(const FineSamples& s, int fine, const LevelTolerance& tolerance) {
  const std::array<std::size_t, 3> at{0, indexOf(fine, fine, 0), indexOf(fine, 0, fine)};
  const std::array corners{s.positions[at[0]], s.positions[at[1]], s.positions[at[2]]};
  const float allowance = allowanceOf(longestSide(corners), tolerance);
  float most = 0.0f;
  for (const Place& own : knownPlaces(fine, 1)) {
    most = std::max(most, distanceFromPiece(s.positions[own.at], corners, own.shares) / tolerance.distance);
    if (!isSmoothAt(s, fine, own.j, own.k)) continue;
    const glm::vec3 between =
        own.shares[0] * s.normals[at[0]] + own.shares[1] * s.normals[at[1]] + own.shares[2] * s.normals[at[2]];
    most = std::max(most, turnInTolerances(between, s.normals[own.at], tolerance) / allowance);
  }
  return most;
}

SideSamples::SideSamples(const FineSamples& ofTriangle, int fine, std::size_t side) : count_(toIndex(fine) + 1) {
  for (int i = 0; i <= fine; ++i) {
    const std::array places{indexOf(fine, i, 0), indexOf(fine, fine - i, i), indexOf(fine, 0, fine - i)};
    at(positions_, i) = ofTriangle.positions[places[side]];
    at(normals_, i) = ofTriangle.normals[places[side]];
  }
}

}  // namespace sinew
