// core/surface/align_splits.cpp: samples the surface, aligns edges, then the triangles between them.
#include "core/surface/align_splits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/geometry/at.h"
#include "core/geometry/edge_sides.h"
#include "core/geometry/parallel.h"
#include "core/geometry/triangle_sides.h"
#include "core/surface/adaptive_levels.h"
#include "core/surface/patches/aligned_triangle.h"
#include "core/surface/patches/sample_grids.h"

namespace sinew {
namespace {

constexpr int kFewGridSamples = 6;  ///< Along a side, up to this level:
constexpr int kFewGridLevels = 3;
constexpr int kGridSamples = 12;
constexpr std::array kEdgeSteps{0.24, 0.12, 0.06};  ///< Of a segment of the edge: lengths of the moves tried.
constexpr double kMostAlongEdge = 0.36;             ///< Of a segment: what a point may move in all.
constexpr float kLeastAlignedPiece = 4.5f;          ///< Tolerances, on dense meshes: shorter ones are not seen.
constexpr std::size_t kFewAligned = 16;             ///< Edges or triangles for one thread.

int highestOf(const SplitLevels& split) { return std::max(std::ranges::max(split.sides), split.inside); }

/// The points along one edge, and the triangles at it.
class AlignedEdge {
 public:
  AlignedEdge(int level, float tolerance) : level_(level), tolerance_(tolerance) {
    for (int step = 1; step < level; ++step) shares_.push_back(evenShare(step));
  }

  /// @param isForward  the triangle's side starts at the edge's smaller vertex
  void add(AlignedTriangle triangle, std::size_t side, bool isForward) {
    sides_.push_back({std::move(triangle), side, isForward});
  }

  /// Shares as in AlignedSplits::edges.
  [[nodiscard]] std::vector<double> align() {
    bool isMoved = false;
    for (const double length : kEdgeSteps) {
      for (int step = 1; step < level_; ++step) isMoved = moveIfBetter(step, length / level_) || isMoved;
    }
    return isMoved ? shares_ : std::vector<double>{};
  }

 private:
  struct Side {
    AlignedTriangle triangle;
    std::size_t side;
    bool isForward;

    [[nodiscard]] int point(int step, int level) const {
      return triangle.pointOn(side, isForward ? step : level - step);
    }
    [[nodiscard]] glm::dvec2 place(double share) const {
      return triangle.placeOn(side, isForward ? share : 1.0 - share);
    }
  };

  [[nodiscard]] double evenShare(int step) const { return static_cast<double>(step) / level_; }

  [[nodiscard]] PointFit fitAt(int step, double share, const FitBound& bound = {}) {
    PointFit fit;
    for (Side& side : sides_) {
      fit.add(side.triangle.fitAt(side.point(step, level_), side.place(share), bound));
      if (bound.excludes(fit)) break;
    }
    return fit;
  }

  bool moveIfBetter(int step, double length) {
    double& own = shares_[toIndex(step - 1)];
    const double home = own;
    PointFit fit = fitAt(step, home);
    for (const double share : {home - length, home + length}) {
      if (std::abs(share - evenShare(step)) * level_ > kMostAlongEdge) continue;
      const PointFit moved = fitAt(step, share, boundOf(fit));
      if (!isBetterFit(moved, fit, tolerance_)) continue;
      fit = moved;
      own = share;
    }
    if (own == home) return false;
    for (Side& side : sides_) side.triangle.move(side.point(step, level_), side.place(own));
    return true;
  }

  int level_;
  float tolerance_;
  std::vector<double> shares_;
  std::vector<Side> sides_;
};

class SplitAligner {
 public:
  SplitAligner(const ControlMesh& mesh, SampledSurface& surface, float tolerance, const RefinementLevels& levels,
               AlignedSplits splits)
      : mesh_(mesh),
        surface_(surface),
        tolerance_(tolerance),
        levels_(levels),
        splits_(std::move(splits)),
        sides_(mesh),
        asksEdge_(mesh.edges.size(), 0),
        asksTriangle_(mesh.triangles.size(), 0) {
    splits_.edges.resize(mesh.edges.size());
    splits_.triangles.resize(mesh.triangles.size());
  }

  AlignedSplits run() {
    findUnknown();
    sample();
    forEachIndex(asksEdge_.size(), kFewAligned, [&](std::size_t e) {
      if (asksEdge_[e] != 0) alignEdge(e);
    });
    forEachIndex(asksTriangle_.size(), kFewAligned, [&](std::size_t t) {
      if (asksTriangle_[t] != 0) alignTriangle(static_cast<int>(t));
    });
    return std::move(splits_);
  }

 private:
  /// Triangles that are new or have other levels, their edges, and the triangles beyond these.
  void findUnknown() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const SplitLevels split = splitOf(mesh_, levels_, static_cast<int>(t));
      if (splits_.triangles[t].levels == split) continue;
      splits_.triangles[t] = {split, {}, {}};
      asksTriangle_[t] = 1;
      for (const int e : mesh_.triangles[t].edges) at(asksEdge_, e) = 1;
    }
    for (std::size_t e = 0; e < asksEdge_.size(); ++e) {
      if (asksEdge_[e] == 0) continue;
      splits_.edges[e].clear();
      if (levels_.edges[e] == 1) continue;
      for (const EdgeSide& own : sides_.of(static_cast<int>(e))) at(asksTriangle_, own.triangle) = 1;
    }
    leaveOutUnseen();
  }

  void leaveOutUnseen() {
    const auto isSeen = [&](int t) { return isWorthAligning(t); };
    for (std::size_t e = 0; e < asksEdge_.size(); ++e) {
      const std::span sides = sides_.of(static_cast<int>(e));
      if (levels_.edges[e] == 1 || !std::ranges::all_of(sides, isSeen, &EdgeSide::triangle)) asksEdge_[e] = 0;
    }
    for (std::size_t t = 0; t < asksTriangle_.size(); ++t) {
      if (asksTriangle_[t] == 0) continue;
      splits_.triangles[t] = {splits_.triangles[t].levels, {}, {}};
      if (!isSeen(static_cast<int>(t))) asksTriangle_[t] = 0;
    }
  }

  [[nodiscard]] bool isWorthAligning(int t) const {
    const int highest = highestOf(at(splits_.triangles, t).levels);
    if (highest == 1 || mesh_.triangles.size() <= kDenseMesh) return highest > 1;
    const float longest = longestSide(cornersOf(mesh_, at(mesh_.triangles, t)));
    return longest >= kLeastAlignedPiece * tolerance_ * static_cast<float>(highest);
  }

  [[nodiscard]] int samplesOf(std::size_t t) const {
    return highestOf(splits_.triangles[t].levels) <= kFewGridLevels ? kFewGridSamples : kGridSamples;
  }

  void sample() {
    std::vector<std::uint8_t> fine(asksTriangle_.size(), 0);
    for (std::size_t t = 0; t < fine.size(); ++t) {
      if (asksTriangle_[t] != 0) fine[t] = static_cast<std::uint8_t>(samplesOf(t));
    }
    surface_.sample(fine);
  }

  [[nodiscard]] AlignedTriangle triangleOf(int t, const SideShares& sides) const {
    const TriangleSamples& samples = surface_.of(t);
    const SampleGrids grids(samples.positions, samples.normals, samples.fine, samplesOf(toIndex(t)));
    return {at(splits_.triangles, t).levels, sides, cornersOf(mesh_, at(mesh_.triangles, t)), grids, tolerance_};
  }

  /// Against triangles whose other sides are evenly spaced, so that no edge depends on another.
  void alignEdge(std::size_t e) {
    AlignedEdge edge(levels_.edges[e], tolerance_);
    for (const auto& [t, side] : sides_.of(static_cast<int>(e))) {
      const bool isForward = mesh_.edges[e].vertices[0] == at(at(mesh_.triangles, t).vertices, side);
      edge.add(triangleOf(t, {}), toIndex(side), isForward);
    }
    splits_.edges[e] = edge.align();
  }

  void alignTriangle(int t) {
    AlignedTriangle triangle = triangleOf(t, sidesOf(mesh_, levels_, splits_.edges, t));
    triangle.align();
    at(splits_.triangles, t) = triangle.triangulation();
  }

  const ControlMesh& mesh_;
  SampledSurface& surface_;
  float tolerance_;
  const RefinementLevels& levels_;
  AlignedSplits splits_;
  EdgeSides sides_;
  std::vector<std::uint8_t> asksEdge_;      ///< [E]
  std::vector<std::uint8_t> asksTriangle_;  ///< [T]
};

}  // namespace

AlignedSplits alignSplits(const ControlMesh& mesh, SampledSurface& surface, float tolerance,
                          const RefinementLevels& levels, AlignedSplits known) {
  return SplitAligner(mesh, surface, tolerance, levels, std::move(known)).run();
}

}  // namespace sinew
