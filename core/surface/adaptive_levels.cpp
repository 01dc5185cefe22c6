// core/surface/adaptive_levels.cpp: sample the surface finely, in some poses, and fit flat pieces to the samples.
#include "core/surface/adaptive_levels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/cloth_levels.h"
#include "core/surface/detail_moments.h"
#include "core/surface/patches/lattice.h"
#include "core/surface/patches/level_fit.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/sampling.h"
#include "core/surface/split_check.h"

namespace sinew {
namespace {

// Samples along an edge: each number divides the next, so that a triangle finds its own among its edges'.
constexpr int kFewSamples = 2;
constexpr int kAdaptiveLevelsSamples = 6;
constexpr int kManySamples = 12;
constexpr float kLongEdge = 0.015f;            ///< Fraction of H: longer ones can hide more than a few samples show.
constexpr std::size_t kSmallMesh = 8'000;      ///< Triangles up to which long edges are sampled finely at once.
constexpr float kNormalCosine = 0.99027f;      ///< 8 degrees.
constexpr float kWorthALook = 0.3f;            ///< Of the tolerance: few samples that are off by more call for many.
constexpr float kWorthCosine = 0.99863f;       ///< 3 degrees.
constexpr float kAdaptiveLevelsMargin = 0.7f;  ///< Of the tolerance: inner points do not lie exactly where samples did.
constexpr float kCheckMargin = 0.9f;           ///< Of the tolerance: there is more between samples.

/// Which edges and triangles are looked at, and how finely. What a piece shows follows from itself alone, whatever is
/// looked at beside it.
struct Look {
  bool first = true;                    ///< With few samples, to see what is worth many.
  std::vector<std::uint8_t> edges;      ///< [E]
  std::vector<std::uint8_t> triangles;  ///< [T]
};

class LevelSearch {
 public:
  LevelSearch(const Preparation& next, const AdaptiveLevels& asked, RefinementLevels& needed)
      : next_(next), asked_(asked), mesh_(next.mesh()), needed_(needed) {
    const float height = next.character().height;
    tolerance_ = {kAdaptiveLevelsMargin * asked.from.tolerance * height, kNormalCosine};
    look_ = {kWorthALook * tolerance_.distance, kWorthCosine};
    isLongEdge_.resize(mesh_.edges.size(), false);
    for (const ControlTriangle& triangle : mesh_.triangles) {
      const bool isLong = std::ranges::any_of(triangle.edges, [&](int e) {
        const auto& ends = at(mesh_.edges, e).vertices;
        return glm::distance(at(mesh_.positions, ends[0]), at(mesh_.positions, ends[1])) > kLongEdge * height;
      });
      isLongTriangle_.push_back(isLong);
      for (const int e : triangle.edges) isLongEdge_[toIndex(e)] = isLongEdge_[toIndex(e)] || isLong;
    }
  }

  void run(std::vector<std::uint8_t> edges, std::vector<std::uint8_t> triangles) {
    flaggedEdges_.assign(edges.size(), 0);
    flaggedTriangles_.assign(triangles.size(), 0);
    take({true, std::move(edges), std::move(triangles)});
    take({false, flaggedEdges_, flaggedTriangles_});
  }

 private:
  [[nodiscard]] int samples(bool isLong, bool first) const {
    if (!first) return isLong ? kManySamples : kAdaptiveLevelsSamples;
    if (!isLong) return kFewSamples;
    return mesh_.triangles.size() <= kSmallMesh ? kManySamples : kAdaptiveLevelsSamples;
  }

  /// In all poses.
  void take(const Look& look) {
    const std::vector<SampledPiece> pieces = sampledPieces(next_, look.edges, look.triangles);
    forEachIndex(pieces.size(), 1, [&](std::size_t i) { takePiece(pieces[i], look.first); });
  }

  void takePiece(const SampledPiece& piece, bool first) {
    const SampledPart part = sampledPart(next_, piece);
    const std::vector<int> edges = placesIn(part.edges, piece.edges);
    const std::vector<int> triangles = placesIn(part.triangles, piece.triangles);
    SurfaceSampler sampler(part, samplePoints(part.mesh(), samplingOf(part, edges, triangles, first)));
    Gathered samples;
    for (const Pose& pose : asked_.from.poses) {
      const View view{part, sampler.sample(pose), first};
      for (const int e : edges) fitEdge(e, view, samples);
      for (const int t : triangles) fitTriangle(t, view, samples);
    }
  }

  [[nodiscard]] RefinementLevels samplingOf(const SampledPart& part, const std::vector<int>& edges,
                                            const std::vector<int>& triangles, bool first) const {
    RefinementLevels out{std::vector<std::uint8_t>(part.edges.size()),
                         std::vector<std::uint8_t>(part.triangles.size())};
    const auto sampleEdge = [&](int e) {
      at(out.edges, e) = static_cast<std::uint8_t>(samples(isLongEdge_[toIndex(at(part.edges, e))], first));
    };
    for (const int e : edges) sampleEdge(e);
    for (const int t : triangles) {
      at(out.triangles, t) = static_cast<std::uint8_t>(samples(isLongTriangle_[toIndex(at(part.triangles, t))], first));
      for (const int e : at(part.mesh().triangles, t).edges) sampleEdge(e);
    }
    return out;
  }

  /// What is looked at in one pose.
  struct View {
    const SampledPart& part;
    const Surface& surface;
    bool first = true;
  };

  struct Gathered {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    void add(const Surface& surface, int vertex) {
      positions.push_back(at(surface.positions, vertex));
      normals.push_back(at(surface.normals, vertex));
    }
    void clear() {
      positions.clear();
      normals.clear();
    }
  };

  /// @param edge  of the part
  void fitEdge(int edge, const View& view, Gathered& own) {
    const int e = at(view.part.edges, edge);
    const bool isLong = isLongEdge_[toIndex(e)];
    const int fine = samples(isLong, view.first);
    const auto& ends = at(view.part.mesh().edges, edge).vertices;
    own.clear();
    own.add(view.surface, ends[0]);
    for (int step = 1; step < fine; ++step) own.add(view.surface, view.surface.refinement->edgeVertex(edge, step));
    own.add(view.surface, ends[1]);
    const FineSamples fineSamples{own.positions, own.normals};
    if (fine != samples(isLong, false)) {
      if (edgeLevel(fineSamples, 1, look_) > 1) at(flaggedEdges_, e) = 1;
      return;
    }
    std::uint8_t& needed = at(needed_.edges, e);
    if (needed < fine)
      needed = static_cast<std::uint8_t>(edgeLevel(fineSamples, divisorFrom(fine, needed), tolerance_));
  }

  /// The least divisor of `fine` from `level` on.
  static int divisorFrom(int fine, int level) {
    while (fine % level != 0) ++level;
    return level;
  }

  /// @param triangle  of the part
  void fitTriangle(int triangle, const View& view, Gathered& own) {
    const int t = at(view.part.triangles, triangle);
    const bool isLong = isLongTriangle_[toIndex(t)];
    const int fine = samples(isLong, view.first);
    own.clear();
    forEachSample(view.part.mesh(), *view.surface.refinement, triangle, fine,
                  [&](int, int, int vertex) { own.add(view.surface, vertex); });
    const FineSamples fineSamples{own.positions, own.normals};
    if (fine != samples(isLong, false)) {
      if (triangleLevel(fineSamples, fine, 1, look_) > 1) at(flaggedTriangles_, t) = 1;
      return;
    }
    std::uint8_t& needed = at(needed_.triangles, t);
    if (needed < fine) {
      needed = static_cast<std::uint8_t>(triangleLevel(fineSamples, fine, divisorFrom(fine, needed), tolerance_));
    }
  }

  const Preparation& next_;
  const AdaptiveLevels& asked_;
  const ControlMesh& mesh_;
  RefinementLevels& needed_;
  LevelTolerance tolerance_;
  LevelTolerance look_;
  std::vector<bool> isLongTriangle_;  ///< [T]
  std::vector<bool> isLongEdge_;      ///< [E] of such a triangle.
  std::vector<std::uint8_t> flaggedEdges_;
  std::vector<std::uint8_t> flaggedTriangles_;
};

/// Sides are split at least half as finely as what they enclose: its triangles end there.
RefinementLevels withSides(const ControlMesh& mesh, RefinementLevels levels) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto half = static_cast<std::uint8_t>(levels.triangles[t] / 2);
    for (const int e : mesh.triangles[t].edges) at(levels.edges, e) = std::max(at(levels.edges, e), half);
  }
  return levels;
}

}  // namespace

std::shared_ptr<const AdaptiveLevels> findLevels(const Preparation& next, std::shared_ptr<const Rig> rig,
                                                 float tolerance, const AdaptiveLevels* former) {
  const ControlMesh& mesh = next.mesh();
  auto out = std::make_shared<AdaptiveLevels>();
  out->moments = former ? former->moments : std::make_shared<const std::vector<Pose>>(detailMoments(next.character()));
  std::vector<Pose> poses = detailPoses(next.character(), *rig, *next.poser, *out->moments);
  out->from = levelSources(next, std::move(rig), tolerance, std::move(poses));
  const std::vector<bool> asked = carriersToLookAt(next, out->from, former ? &former->from : nullptr);
  const auto firstEdge = asked.begin() + static_cast<std::ptrdiff_t>(mesh.positions.size());
  const auto firstTriangle = firstEdge + static_cast<std::ptrdiff_t>(mesh.edges.size());
  std::vector<std::uint8_t> edges(firstEdge, firstTriangle);
  std::vector<std::uint8_t> triangles(firstTriangle, asked.end());
  if (former) out->needed = former->needed;
  out->needed.edges.resize(edges.size());
  out->needed.triangles.resize(triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) out->needed.edges[e] = edges[e] != 0 ? 1 : out->needed.edges[e];
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    out->needed.triangles[t] = triangles[t] != 0 ? 1 : out->needed.triangles[t];
  }
  LevelSearch(next, *out, out->needed).run(std::move(edges), std::move(triangles));
  if (former) out->checked = former->checked;
  out->checked.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (*(firstTriangle + static_cast<std::ptrdiff_t>(t))) out->checked[t].clear();
  }
  const float within = kCheckMargin * tolerance * next.character().height;
  out->levels =
      levelsThatFit(next, out->from.poses, within, withClothLevels(next, withSides(mesh, out->needed)), out->checked);
  return out;
}

}  // namespace sinew
