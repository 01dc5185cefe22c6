// core/bodies/sculpt_heights.cpp: lines from the skin to a sculpt, both ways.
#include "core/bodies/sculpt_heights.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/geometry/triangle_tree.h"
#include "core/surface/patches/patch.h"

namespace sinew {
namespace {

// Fractions of H.
constexpr float kFarthestSculpt = 0.1f;
constexpr float kMostMean = 0.05f;
constexpr float kApartFromRing = 0.015f;
constexpr float kLeastCovered = 0.5f;
constexpr float kSameSize = 1.25f;     ///< Largest ratio of extents.
constexpr float kSameWay = 0.3f;       ///< Least cosine of the normals.
constexpr int kMostRounded = 250'000;  ///< Triangles after rounding.
constexpr int kRingRounds = 2;

/// Triangles of a sculpt, rounded as the skin is.
struct RoundedSculpt {
  std::vector<TriangleCorners> triangles;
  std::vector<glm::vec3> normals;  ///< [triangles] not of unit length.
};

RoundedSculpt roundedSculpt(const ControlMesh& sculpt) {
  int depth = 1;
  while (depth < 4 && (depth + 1) * (depth + 1) * static_cast<int>(sculpt.triangles.size()) <= kMostRounded) ++depth;
  const Refinement refinement = refine(sculpt, depth);
  std::vector<glm::vec3> positions(toIndex(refinement.vertexCount));
  std::vector<glm::vec3> normals(positions.size());
  evaluatePatches(PatchKind::kPn, sculpt, refinement, sculpt.positions, sculpt.normals, positions, normals);
  RoundedSculpt out;
  double volume = 0.0;
  const glm::vec3 middle = boundsOf(sculpt.positions).center();
  for (const auto& [a, b, c] : refinement.triangles) {
    const TriangleCorners corners{at(positions, a), at(positions, b), at(positions, c)};
    out.triangles.push_back(corners);
    out.normals.push_back(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    volume += static_cast<double>(glm::dot(corners[0] - middle, out.normals.back()));
  }
  if (volume < 0.0) {  // Its faces look inwards.
    for (glm::vec3& normal : out.normals) normal = -normal;
  }
  return out;
}

float largest(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }

Result<void> checkPlace(const SkinPoints& points, const ControlMesh& sculpt, float height) {
  const Bounds own = boundsOf(points.positions);
  const Bounds theirs = boundsOf(sculpt.positions);
  const float ratio = largest(theirs.extent()) / largest(own.extent());
  char text[160];
  if (!(ratio <= kSameSize && ratio >= 1.0f / kSameSize)) {
    std::snprintf(text, sizeof text, "the sculpt is %.3g times as large as the character: scale it to the same size",
                  static_cast<double>(ratio));
    return errorAt("", text);
  }
  const float apart = glm::distance(own.center(), theirs.center()) / height;
  if (apart <= 0.25f) return {};
  std::snprintf(text, sizeof text,
                "the sculpt's middle is %.0f %% of the height away from the character's: move it to the same place",
                100.0 * static_cast<double>(apart));
  return errorAt("", text);
}

/// Points with few known neighbors stay.
void dropOutliers(const SkinPoints& points, float most, SculptHeights& out) {
  std::vector<std::vector<int>> ring(points.size());
  for (const auto& [a, b] : points.edges) {
    at(ring, a).push_back(b);
    at(ring, b).push_back(a);
  }
  for (int round = 0; round < kRingRounds; ++round) {
    const std::vector<std::uint8_t> before = out.known;
    for (std::size_t v = 0; v < points.size(); ++v) {
      if (before[v] == 0) continue;
      std::vector<float> around;
      for (const int u : ring[v]) {
        if (at(before, u) != 0) around.push_back(at(out.heights, u));
      }
      if (around.size() < 3) continue;
      const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
      std::nth_element(around.begin(), middle, around.end());
      if (std::abs(out.heights[v] - *middle) > most) out.known[v] = 0;
    }
  }
}

Result<void> checkCover(const SkinPoints& points, float height, SculptHeights& out) {
  double all = 0.0;
  double known = 0.0;
  double away = 0.0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (points.movable[v] == 0) continue;
    const auto area = static_cast<double>(points.areas[v]);
    all += area;
    if (out.known[v] == 0) continue;
    known += area;
    away += area * static_cast<double>(std::abs(out.heights[v]));
  }
  out.covered = all > 0.0 ? static_cast<float>(known / all) : 0.0f;
  char text[160];
  if (out.covered < kLeastCovered) {
    std::snprintf(text, sizeof text,
                  "the sculpt lies over %.0f %% of the skin that muscles can move: is it in the character's bind pose?",
                  100.0 * static_cast<double>(out.covered));
    return errorAt("", text);
  }
  if (away <= known * static_cast<double>(kMostMean * height)) return {};
  std::snprintf(text, sizeof text,
                "the sculpt is %.1f %% of the height away from the skin on average: is it of this body?",
                100.0 * away / known / static_cast<double>(height));
  return errorAt("", text);
}

}  // namespace

Result<SculptHeights> sculptHeights(const SkinPoints& points, const ControlMesh& sculpt, float height) {
  if (sculpt.triangles.empty()) return errorAt("", "the sculpt has no triangles");
  if (Result<void> placed = checkPlace(points, sculpt, height); !placed) return placed.error();
  const RoundedSculpt rounded = roundedSculpt(sculpt);
  std::vector<int> numbers(rounded.triangles.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const TriangleTree tree(rounded.triangles, numbers);
  SculptHeights out;
  out.heights.assign(points.size(), 0.0f);
  out.known.assign(points.size(), 0);
  forRanges(points.size(), 256, [&](std::size_t begin, std::size_t end) {
    std::vector<LineMeeting> meetings;
    for (std::size_t v = begin; v < end; ++v) {
      const float far = kFarthestSculpt * height;
      tree.meetings(points.positions[v], points.directions[v], -far, far, meetings);
      const LineMeeting* best = nullptr;
      for (const LineMeeting& meeting : meetings) {
        const glm::vec3 normal = normalizeOr(at(rounded.normals, meeting.triangle), glm::vec3(0.0f));
        if (glm::dot(normal, points.normals[v]) < kSameWay) continue;
        if (!best || std::abs(meeting.along) < std::abs(best->along)) best = &meeting;
      }
      if (!best) continue;
      out.heights[v] = best->along;
      out.known[v] = 1;
    }
  });
  dropOutliers(points, kApartFromRing * height, out);
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (out.known[v] == 0) out.heights[v] = 0.0f;
  }
  if (Result<void> covers = checkCover(points, height, out); !covers) return covers.error();
  return out;
}

}  // namespace sinew
