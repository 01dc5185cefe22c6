// core/surface/align_splits.cpp: samples the surface, aligns edges, then the triangles between them.
#include "core/surface/align_splits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/patches/aligned_triangle.h"
#include "core/surface/patches/sample_grids.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/sampling.h"

namespace sinew {
namespace {

constexpr int kFewGridSamples = 6;  ///< Along a side, up to this level:
constexpr int kFewGridLevels = 3;
constexpr int kGridSamples = 12;
constexpr std::array kEdgeSteps{0.24, 0.12, 0.06};  ///< Of a segment of the edge: lengths of the moves tried.
constexpr double kMostAlongEdge = 0.36;             ///< Of a segment: what a point may move in all.
constexpr std::size_t kFewAligned = 16;             ///< Edges or triangles for one thread.

/// The points along one edge, and the triangles at it.
class AlignedEdge {
 public:
  AlignedEdge(int level, std::size_t poses, float tolerance) : level_(level), poses_(poses), tolerance_(tolerance) {
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

  [[nodiscard]] PointFit fitAt(int step, double share) {
    PointFit fit;
    for (Side& side : sides_) fit.add(side.triangle.fitAt(side.point(step, level_), side.place(share)));
    return fit;
  }

  bool moveIfBetter(int step, double length) {
    double& own = shares_[toIndex(step - 1)];
    const double home = own;
    PointFit fit = fitAt(step, home);
    for (const double share : {home - length, home + length}) {
      if (std::abs(share - evenShare(step)) * level_ > kMostAlongEdge) continue;
      const PointFit moved = fitAt(step, share);
      if (!isBetterFit(moved, fit, poses_, tolerance_)) continue;
      fit = moved;
      own = share;
    }
    if (own == home) return false;
    for (Side& side : sides_) side.triangle.move(side.point(step, level_), side.place(own));
    return true;
  }

  int level_;
  std::size_t poses_;
  float tolerance_;
  std::vector<double> shares_;
  std::vector<Side> sides_;
};

class SplitAligner {
 public:
  SplitAligner(const Preparation& next, const std::vector<Pose>& poses, float tolerance, const RefinementLevels& levels,
               AlignedSplits splits)
      : next_(next),
        mesh_(next.mesh()),
        poses_(poses),
        tolerance_(tolerance),
        levels_(levels),
        splits_(std::move(splits)),
        trianglesAt_(mesh_.edges.size()),
        asksEdge_(mesh_.edges.size(), 0),
        asksTriangle_(mesh_.triangles.size(), 0),
        grids_(mesh_.triangles.size()) {
    splits_.edges.resize(mesh_.edges.size());
    splits_.triangles.resize(mesh_.triangles.size());
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
      for (const int e : mesh_.triangles[t].edges) at(trianglesAt_, e).push_back(static_cast<int>(t));
      if (splits_.triangles[t].levels == split) continue;
      splits_.triangles[t] = {split, {}, {}};
      asksTriangle_[t] = split.inside > 1 ? 1 : 0;
      for (const int e : mesh_.triangles[t].edges) at(asksEdge_, e) = 1;
    }
    for (std::size_t e = 0; e < asksEdge_.size(); ++e) {
      if (asksEdge_[e] == 0) continue;
      splits_.edges[e].clear();
      if (levels_.edges[e] == 1) asksEdge_[e] = 0;
      else
        for (const int t : trianglesAt_[e]) at(asksTriangle_, t) = 1;
    }
  }

  [[nodiscard]] SplitLevels splitAt(int t) const { return at(splits_.triangles, t).levels; }

  [[nodiscard]] int samplesOf(int t) const {
    const SplitLevels split = splitAt(t);
    return std::max(std::ranges::max(split.sides), split.inside) <= kFewGridLevels ? kFewGridSamples : kGridSamples;
  }

  void sample() {
    const std::vector<SampledPiece> pieces =
        sampledPieces(next_, std::vector<std::uint8_t>(mesh_.edges.size(), 0), asksTriangle_);
    forEachIndex(pieces.size(), 1, [&](std::size_t p) { samplePiece(pieces[p]); });
  }

  void samplePiece(const SampledPiece& piece) {
    const SampledPart part = sampledPart(next_, piece);
    const ControlMesh& mesh = part.mesh();
    const std::vector<int> asked = placesIn(part.triangles, piece.triangles);
    RefinementLevels points{std::vector<std::uint8_t>(mesh.edges.size(), 1),
                            std::vector<std::uint8_t>(mesh.triangles.size(), 1)};
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const auto fine = static_cast<std::uint8_t>(samplesOf(piece.triangles[i]));
      at(points.triangles, asked[i]) = fine;
      for (const int e : at(mesh.triangles, asked[i]).edges) at(points.edges, e) = std::max(at(points.edges, e), fine);
      at(grids_, piece.triangles[i]) = SampleGrids(fine, poses_.size());
    }
    SurfaceSampler sampler(part, samplePoints(mesh, points));
    for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
      const Surface& surface = sampler.sample(poses_[pose]);
      for (std::size_t i = 0; i < asked.size(); ++i) {
        SampleGrids& grids = at(grids_, piece.triangles[i]);
        PlaceSample* next = grids.inPose(pose).data();
        forEachSample(mesh, *surface.refinement, asked[i], grids.fine(), [&](int, int, int vertex) {
          *next++ = {at(surface.positions, vertex), at(surface.normals, vertex)};
        });
      }
    }
  }

  [[nodiscard]] AlignedTriangle triangleOf(int t, const SideShares& sides) const {
    const auto corner = [&](std::size_t c) { return at(mesh_.positions, at(mesh_.triangles, t).vertices[c]); };
    return {splitAt(t), sides, {corner(0), corner(1), corner(2)}, at(grids_, t), tolerance_};
  }

  /// Against triangles whose other sides are evenly spaced, so that no edge depends on another.
  void alignEdge(std::size_t e) {
    AlignedEdge edge(levels_.edges[e], poses_.size(), tolerance_);
    for (const int t : trianglesAt_[e]) {
      const ControlTriangle& triangle = at(mesh_.triangles, t);
      const auto found = std::ranges::find(triangle.edges, static_cast<int>(e));
      const auto side = static_cast<std::size_t>(found - triangle.edges.begin());
      edge.add(triangleOf(t, {}), side, mesh_.edges[e].vertices[0] == triangle.vertices[side]);
    }
    splits_.edges[e] = edge.align();
  }

  void alignTriangle(int t) {
    AlignedTriangle triangle = triangleOf(t, sidesOf(mesh_, levels_, splits_.edges, t));
    triangle.align();
    at(splits_.triangles, t) = triangle.triangulation();
  }

  const Preparation& next_;
  const ControlMesh& mesh_;
  const std::vector<Pose>& poses_;
  float tolerance_;
  const RefinementLevels& levels_;
  AlignedSplits splits_;
  std::vector<std::vector<int>> trianglesAt_;  ///< [E]
  std::vector<std::uint8_t> asksEdge_;         ///< [E]
  std::vector<std::uint8_t> asksTriangle_;     ///< [T]
  std::vector<SampleGrids> grids_;             ///< [T]
};

}  // namespace

AlignedSplits alignSplits(const Preparation& next, const std::vector<Pose>& poses, float tolerance,
                          const RefinementLevels& levels, AlignedSplits known) {
  return SplitAligner(next, poses, tolerance, levels, std::move(known)).run();
}

}  // namespace sinew
