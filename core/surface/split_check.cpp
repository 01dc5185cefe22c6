// core/surface/split_check.cpp: splits of triangles checked against samples, pose by pose, and raised where they fail.
#include "core/surface/adaptive_levels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/patches/levels.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/patches/triangulation.h"
#include "core/surface/sampling.h"

namespace sinew {
namespace {

constexpr std::size_t kFewSplits = 4096;  ///< For one thread.
constexpr int kSplitCheckRounds = 6;
constexpr int kSplitCheckSamples = 12;  ///< Along each side.
constexpr std::size_t kMany = 8'000;    ///< Meshes with more triangles, which are small, need fewer samples.
constexpr int kSplitCheckFewSamples = 6;

/// Where a sample lies in a triangle's split.
struct Located {
  int vertex = 0;                 ///< Sample.
  std::array<int, 3> corners{};   ///< Vertices of the split.
  std::array<float, 3> shares{};  ///< Barycentric.
};

class SplitMeter {
 public:
  SplitMeter(const Preparation& next, const RefinementLevels& levels, const SampledPiece& piece)
      : part_(sampledPart(next, piece)),
        mesh_(part_.mesh()),
        asked_(placesIn(part_.triangles, piece.triangles)),
        fine_(next.mesh().triangles.size() > kMany ? kSplitCheckFewSamples : kSplitCheckSamples),
        samples_(part_, samplePoints(mesh_, only(
                                                0, [&](int) { return fine_; }, [&](int) { return fine_; }))),
        split_(part_, refine(mesh_, only(
                                        1, [&](int e) { return at(levels.edges, at(part_.edges, e)); },
                                        [&](int t) { return at(levels.triangles, at(part_.triangles, t)); }))),
        located_(asked_.size()),
        worst_(asked_.size(), 0.0f) {}

  /// [triangles of the piece] the largest distance of a sample from its flat triangle, over all poses.
  const std::vector<float>& measure(const std::vector<Pose>& poses) {
    for (const Pose& pose : poses) {
      const Surface& samples = samples_.sample(pose);
      const Surface& split = split_.sample(pose);
      for (std::size_t i = 0; i < asked_.size(); ++i) {
        if (located_[i].empty()) locate(i, *samples.refinement, *split.refinement);
        for (const Located& one : located_[i]) {
          worst_[i] = std::max(worst_[i], distance(one, samples.positions, split.positions));
        }
      }
    }
    return worst_;
  }

 private:
  /// Levels of the part: `other` except for the asked triangles and their sides.
  RefinementLevels only(std::uint8_t other, const auto& edgeLevel, const auto& insideLevel) const {
    RefinementLevels out{std::vector<std::uint8_t>(mesh_.edges.size(), other),
                         std::vector<std::uint8_t>(mesh_.triangles.size(), other)};
    for (const int t : asked_) {
      at(out.triangles, t) = static_cast<std::uint8_t>(insideLevel(t));
      for (const int e : at(mesh_.triangles, t).edges) at(out.edges, e) = static_cast<std::uint8_t>(edgeLevel(e));
    }
    return out;
  }

  void locate(std::size_t i, const Refinement& samples, const Refinement& split) {
    const int t = asked_[i];
    struct Piece {
      std::array<int, 3> corners;
      std::array<glm::dvec2, 3> at;
    };
    std::vector<Piece> pieces;
    for (int k = at(split.triangleBegin, t); k < at(split.triangleBegin, t + 1); ++k) {
      Piece piece{at(split.triangles, k), {}};
      for (std::size_t c = 0; c < 3; ++c) {
        const glm::dvec3 share = controlCoordinates(mesh_, split, t, piece.corners[c]);
        piece.at[c] = {share.y, share.z};
      }
      pieces.push_back(piece);
    }
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
    forEachSample(mesh_, samples, t, fine_, [&](int j, int k, int vertex) {
      const glm::dvec2 p(static_cast<double>(j) / fine_, static_cast<double>(k) / fine_);
      Located best{vertex, {}, {}};
      double most = -1e30;
      for (const Piece& piece : pieces) {
        const glm::dvec2 u = piece.at[1] - piece.at[0];
        const glm::dvec2 w = piece.at[2] - piece.at[0];
        const double area = cross(u, w);
        if (!(area > 0.0)) continue;
        const double y = cross(p - piece.at[0], w) / area;
        const double z = cross(u, p - piece.at[0]) / area;
        const double least = std::min({1.0 - y - z, y, z});
        if (least <= most) continue;
        most = least;
        best.corners = piece.corners;
        best.shares = {static_cast<float>(1.0 - y - z), static_cast<float>(y), static_cast<float>(z)};
      }
      if (most > -1e30) located_[i].push_back(best);
    });
  }

  static float distance(const Located& one, const std::vector<glm::vec3>& samples,
                        const std::vector<glm::vec3>& split) {
    const auto corner = [&](std::size_t i) { return at(split, one.corners[i]); };
    return distanceFromPiece(at(samples, one.vertex), {corner(0), corner(1), corner(2)}, one.shares);
  }

  SampledPart part_;
  const ControlMesh& mesh_;
  std::vector<int> asked_;  ///< Triangles of the part.
  int fine_;
  SurfaceSampler samples_;
  SurfaceSampler split_;
  std::vector<std::vector<Located>> located_;
  std::vector<float> worst_;
};

const CheckedSplit* find(const std::vector<CheckedSplit>& known, const SplitLevels& levels) {
  const auto found = std::ranges::find(known, levels, &CheckedSplit::levels);
  return found == known.end() ? nullptr : &*found;
}

std::uint8_t finer(int level) {
  const auto next = std::ranges::upper_bound(kGradedLevels, level);
  return static_cast<std::uint8_t>(next == kGradedLevels.end() ? kGradedLevels.back() : *next);
}

void raise(const ControlMesh& mesh, const SplitLevels& split, int t, RefinementLevels& needed) {
  const auto inside = static_cast<std::uint8_t>(split.inside);
  const bool isCoarser = std::ranges::min(split.sides) < split.inside;
  if (isCoarser) {
    for (const int e : at(mesh.triangles, t).edges) at(needed.edges, e) = std::max(at(needed.edges, e), inside);
  }
  at(needed.triangles, t) = std::max(at(needed.triangles, t), isCoarser ? inside : finer(inside));
}

}  // namespace

RefinementLevels levelsThatFit(const Preparation& next, const std::vector<Pose>& poses, float tolerance,
                               RefinementLevels needed, CheckedSplits& known) {
  const ControlMesh& mesh = next.mesh();
  known.resize(mesh.triangles.size());
  const LevelGrader grader(mesh);
  RefinementLevels levels = grader.graded(needed);
  for (int round = 0; round < kSplitCheckRounds; ++round) {
    std::vector<std::uint8_t> unknown(mesh.triangles.size(), 0);
    forEachIndex(unknown.size(), kFewSplits, [&](std::size_t t) {
      const SplitLevels split = splitOf(mesh, levels, static_cast<int>(t));
      if (!split.isUniform() && !find(known[t], split)) unknown[t] = 1;  // The fit has covered n^2 splits.
    });
    const std::vector<SampledPiece> pieces =
        sampledPieces(next, std::vector<std::uint8_t>(mesh.edges.size(), 0), unknown);
    forEachIndex(pieces.size(), 1, [&](std::size_t p) {
      const std::vector<int>& triangles = pieces[p].triangles;
      SplitMeter meter(next, levels, pieces[p]);
      const std::vector<float>& worst = meter.measure(poses);
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        at(known, triangles[i]).push_back({splitOf(mesh, levels, triangles[i]), worst[i] <= tolerance});
      }
    });
    bool raised = false;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      if (at(known, t).empty()) continue;
      const SplitLevels split = splitOf(mesh, levels, t);
      const CheckedSplit* checked = find(at(known, t), split);
      if (!checked || checked->fits) continue;
      raise(mesh, split, t, needed);
      raised = true;
    }
    if (!raised) break;
    levels = grader.graded(needed);
  }
  return levels;
}

}  // namespace sinew
