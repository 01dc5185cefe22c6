// core/surface/split_check.cpp: splits of triangles checked against samples, pose by pose, and raised where they fail.
#include "core/surface/adaptive_levels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/patches/levels.h"
#include "core/surface/patches/triangulation.h"
#include "core/surface/sampling.h"

namespace sinew {
namespace {

constexpr std::size_t kFewSplits = 4096;  ///< For one thread.
constexpr int kSplitCheckRounds = 6;
constexpr int kSplitCheckSamples = 12;    ///< Along each side.
constexpr int kSplitCheckFewSamples = 6;  ///< Of dense meshes.

/// Where a sample lies in a triangle's split.
struct Located {
  std::size_t sample = 0;
  std::array<int, 3> corners{};   ///< Vertices of the split.
  std::array<float, 3> shares{};  ///< Barycentric.
};

class SplitMeter {
 public:
  SplitMeter(const Preparation& next, const RefinementLevels& levels, const SampledPiece& piece,
             const SampledSurface& surface, int fine)
      : part_(sampledPart(next, piece)),
        mesh_(part_.mesh()),
        surface_(surface),
        fine_(fine),
        split_(part_, refine(mesh_, splitLevels(levels))),
        located_(part_.asked.size()),
        worst_(part_.asked.size(), 0.0f) {}

  /// [triangles of the piece] the largest distance of a sample from its flat triangle, over all poses.
  const std::vector<float>& measure() {
    std::vector<std::size_t> seen(part_.asked.size(), 0);  // Number of poses.
    for (std::size_t pose = 0; pose < surface_.poses().size(); ++pose) {
      std::vector<std::size_t> own;
      std::vector<int> triangles;
      for (std::size_t i = 0; i < part_.asked.size(); ++i) {
        if (!contains(at(surface_.posesOf(), wholeIndex(i)), pose)) continue;
        own.push_back(i);
        triangles.push_back(part_.asked[i]);
      }
      if (own.empty()) continue;
      const Surface& split = split_.sample(surface_.poses()[pose], triangles);
      for (const std::size_t i : own) {
        if (located_[i].empty()) locate(i, *split.refinement);
        const FineSamples samples = surface_.of(wholeIndex(i)).of(seen[i]++);
        for (const Located& one : located_[i]) {
          worst_[i] = std::max(worst_[i], distance(one, samples.positions, split.positions));
        }
      }
    }
    return worst_;
  }

 private:
  [[nodiscard]] int wholeIndex(std::size_t i) const { return at(part_.triangles, part_.asked[i]); }

  /// Levels of the part: 1 except for the asked triangles and their sides.
  [[nodiscard]] RefinementLevels splitLevels(const RefinementLevels& levels) const {
    RefinementLevels out{std::vector<std::uint8_t>(mesh_.edges.size(), 1),
                         std::vector<std::uint8_t>(mesh_.triangles.size(), 1)};
    for (const int t : part_.asked) {
      at(out.triangles, t) = at(levels.triangles, at(part_.triangles, t));
      for (const int e : at(mesh_.triangles, t).edges) at(out.edges, e) = at(levels.edges, at(part_.edges, e));
    }
    return out;
  }

  void locate(std::size_t i, const Refinement& split) {
    const int t = part_.asked[i];
    const TriangleSamples& samples = surface_.of(wholeIndex(i));
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
    const auto locateSample = [&](int j, int k) {
      const glm::dvec2 p(static_cast<double>(j) / fine_, static_cast<double>(k) / fine_);
      Located best{samples.placeOf(fine_, j, k), {}, {}};
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
    };
    for (int j = 0; j <= fine_; ++j) {
      for (int k = 0; k <= fine_ - j; ++k) locateSample(j, k);
    }
  }

  static float distance(const Located& one, std::span<const glm::vec3> samples, const std::vector<glm::vec3>& split) {
    const auto corner = [&](std::size_t i) { return at(split, one.corners[i]); };
    return distanceFromPiece(samples[one.sample], {corner(0), corner(1), corner(2)}, one.shares);
  }

  SampledPart part_;
  const ControlMesh& mesh_;
  const SampledSurface& surface_;
  int fine_;
  SurfaceSampler split_;
  std::vector<std::vector<Located>> located_;  ///< Of each asked triangle, like
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

RefinementLevels levelsThatFit(const Preparation& next, SampledSurface& surface, float tolerance,
                               RefinementLevels needed, CheckedSplits& known) {
  const ControlMesh& mesh = next.mesh();
  known.resize(mesh.triangles.size());
  const LevelGrader grader(mesh);
  RefinementLevels levels = grader.graded(needed);
  const auto fine =
      static_cast<std::uint8_t>(mesh.triangles.size() > kDenseMesh ? kSplitCheckFewSamples : kSplitCheckSamples);
  for (int round = 0; round < kSplitCheckRounds; ++round) {
    std::vector<std::uint8_t> unknown(mesh.triangles.size(), 0);
    forEachIndex(unknown.size(), kFewSplits, [&](std::size_t t) {
      const SplitLevels split = splitOf(mesh, levels, static_cast<int>(t));
      if (!split.isUniform() && !find(known[t], split)) unknown[t] = fine;  // The fit has covered n^2 splits.
    });
    surface.sample(unknown);
    const std::vector<SampledPiece> pieces = sampledPieces(next, unknown);
    forEachIndex(pieces.size(), 1, [&](std::size_t p) {
      const SampledPiece& triangles = pieces[p];
      SplitMeter meter(next, levels, triangles, surface, fine);
      const std::vector<float>& worst = meter.measure();
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
