// core/smoothing/adaptive_levels.cpp: sample the surface finely, in some poses, and fit flat pieces to the samples.
#include "core/smoothing/adaptive_levels.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/base/parallel.h"
#include "core/smoothing/cloth_levels.h"
#include "core/smoothing/detail_moments.h"
#include "core/smoothing/patches/lattice.h"
#include "core/smoothing/patches/level_fit.h"
#include "core/smoothing/patches/sample_points.h"
#include "core/smoothing/sampling.h"
#include "core/smoothing/split_check.h"

namespace sinew {
namespace {

// Samples along an edge: each number divides the next, so that a triangle finds its own among its edges'.
constexpr int kFewSamples = 2;
constexpr int kSamples = 6;
constexpr int kManySamples = 12;
constexpr float kLongEdge = 0.015f;        ///< Fraction of H: longer ones can hide more than a few samples show.
constexpr std::size_t kSmallMesh = 8'000;  ///< Triangles up to which long edges are sampled finely at once.
constexpr float kNormalCosine = 0.99027f;  ///< 8 degrees.
constexpr float kWorthALook = 0.3f;        ///< Of the tolerance: few samples that are off by more call for many.
constexpr float kWorthCosine = 0.99863f;   ///< 3 degrees.
constexpr float kMargin = 0.7f;            ///< Of the tolerance: inner points do not lie exactly where samples did.
constexpr float kBend = 2.0f;              ///< Tolerances that a height may differ from the mean around it.
constexpr float kCheckMargin = 0.9f;       ///< Of the tolerance: there is more between samples.

/// Which of a rig's primitives an edit has changed; nullopt: all may have.
std::optional<std::vector<bool>> changedPrimitives(const Rig& before, const Rig& after) {
  // Other candidates: skin that a muscle may no longer move is to be looked at, too.
  const bool same = sameCandidates(before, after) && before.surface == after.surface &&
                    before.channels == after.channels && before.smoothing.patch == after.smoothing.patch &&
                    before.smoothing.projection == after.smoothing.projection;
  if (!same) return std::nullopt;
  std::vector<bool> changed(after.primitives.size());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    const Primitive& primitive = after.primitives[i];
    changed[i] = before.primitives[i] != primitive;
    for (std::size_t l = 0; l < after.lines.size(); ++l) {
      if (after.lines[l].name == primitive.line && before.lines[l] != after.lines[l]) changed[i] = true;
    }
  }
  return changed;
}

/// Which edges and triangles are looked at, and how finely. What a piece shows follows from itself alone, whatever is
/// looked at beside it.
struct Look {
  bool first = true;            ///< With few samples, to see what is worth many.
  std::vector<bool> edges;      ///< [E]
  std::vector<bool> triangles;  ///< [T]
};

class LevelSearch {
 public:
  LevelSearch(const Preparation& next, const AdaptiveLevels& asked, RefinementLevels& needed)
      : next_(next), asked_(asked), mesh_(next.mesh()), needed_(needed) {
    const float height = next.character().height;
    tolerance_ = {kMargin * asked.tolerance * height, kNormalCosine};
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

  void run(std::vector<bool> edges, std::vector<bool> triangles) {
    flaggedEdges_.assign(edges.size(), 0);
    flaggedTriangles_.assign(triangles.size(), 0);
    take({true, std::move(edges), std::move(triangles)});
    const auto list = [](const std::vector<std::uint8_t>& flags) {
      return std::vector<bool>(flags.begin(), flags.end());
    };
    take({false, list(flaggedEdges_), list(flaggedTriangles_)});
  }

 private:
  [[nodiscard]] int samples(bool isLong, bool first) const {
    if (!first) return isLong ? kManySamples : kSamples;
    if (!isLong) return kFewSamples;
    return mesh_.triangles.size() <= kSmallMesh ? kManySamples : kSamples;
  }

  /// In all poses.
  void take(const Look& look) {
    RefinementLevels sampling{std::vector<std::uint8_t>(mesh_.edges.size()),
                              std::vector<std::uint8_t>(mesh_.triangles.size())};
    std::vector<std::uint8_t> skipped(mesh_.positions.size() + mesh_.edges.size() + mesh_.triangles.size(), 1);
    const std::size_t firstEdge = mesh_.positions.size();
    const auto sampleEdge = [&](std::size_t e) {
      skipped[firstEdge + e] = 0;
      for (const int end : mesh_.edges[e].vertices) at(skipped, end) = 0;
      sampling.edges[e] = static_cast<std::uint8_t>(samples(isLongEdge_[e], look.first));
    };
    bool any = false;
    for (std::size_t e = 0; e < look.edges.size(); ++e) {
      if (look.edges[e]) sampleEdge(e);
      any |= look.edges[e];
    }
    for (std::size_t t = 0; t < look.triangles.size(); ++t) {
      if (!look.triangles[t]) continue;
      any = true;
      skipped[firstEdge + mesh_.edges.size() + t] = 0;
      sampling.triangles[t] = static_cast<std::uint8_t>(samples(isLongTriangle_[t], look.first));
      for (const int e : mesh_.triangles[t].edges) sampleEdge(toIndex(e));
    }
    if (!any) return;
    SurfaceSampler sampler(next_, samplePoints(mesh_, sampling), std::move(skipped));
    for (const Pose& pose : asked_.poses) {
      const Surface& surface = sampler.sample(pose);
      forRanges(mesh_.edges.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
          if (look.edges[e]) fitEdge(static_cast<int>(e), look.first, surface);
        }
      });
      forRanges(mesh_.triangles.size(), 64, [&](std::size_t begin, std::size_t end) {
        Gathered samples;
        for (std::size_t t = begin; t < end; ++t) {
          if (look.triangles[t]) fitTriangle(static_cast<int>(t), look.first, surface, samples);
        }
      });
    }
  }

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

  void fitEdge(int e, bool first, const Surface& surface) {
    const bool isLong = isLongEdge_[toIndex(e)];
    const int fine = samples(isLong, first);
    Gathered own;
    own.add(surface, at(mesh_.edges, e).vertices[0]);
    for (int step = 1; step < fine; ++step) own.add(surface, surface.refinement->edgeVertex(e, step));
    own.add(surface, at(mesh_.edges, e).vertices[1]);
    const FineSamples view{own.positions, own.normals};
    if (fine != samples(isLong, false)) {
      if (edgeLevel(view, 1, look_) > 1) at(flaggedEdges_, e) = 1;
      return;
    }
    std::uint8_t& needed = at(needed_.edges, e);
    if (needed < fine) needed = static_cast<std::uint8_t>(edgeLevel(view, divisorFrom(fine, needed), tolerance_));
  }

  /// The least divisor of `fine` from `level` on.
  static int divisorFrom(int fine, int level) {
    while (fine % level != 0) ++level;
    return level;
  }

  void fitTriangle(int t, bool first, const Surface& surface, Gathered& own) {
    const bool isLong = isLongTriangle_[toIndex(t)];
    const int fine = samples(isLong, first);
    gather(t, fine, surface, own);
    const FineSamples view{own.positions, own.normals};
    if (fine != samples(isLong, false)) {
      if (triangleLevel(view, fine, 1, look_) > 1) at(flaggedTriangles_, t) = 1;
      return;
    }
    std::uint8_t& needed = at(needed_.triangles, t);
    if (needed < fine) {
      needed = static_cast<std::uint8_t>(triangleLevel(view, fine, divisorFrom(fine, needed), tolerance_));
    }
  }

  /// A triangle's samples, row after row.
  void gather(int t, int fine, const Surface& surface, Gathered& samples) const {
    samples.clear();
    forEachSample(mesh_, *surface.refinement, t, fine, [&](int, int, int vertex) { samples.add(surface, vertex); });
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

/// [V+E+T] carriers that see a changed muscle; all where `former` does not serve.
std::vector<bool> carriersToLookAt(const Preparation& next, const AdaptiveLevels& asked, const AdaptiveLevels* former) {
  const std::size_t carriers = next.mesh().positions.size() + next.mesh().edges.size() + next.mesh().triangles.size();
  const bool same =
      former && former->tolerance == asked.tolerance && former->hidden == asked.hidden && former->poses == asked.poses;
  const auto changed = same ? changedPrimitives(*former->rig, *asked.rig) : std::nullopt;
  std::vector<bool> out(carriers, !changed.has_value());
  if (!changed) return out;
  const std::vector<int>& rigIndex = next.attached->attachment.rigIndex;
  for (std::size_t c = 0; c < carriers; ++c) {
    out[c] = std::ranges::any_of(next.attached->candidates.of(static_cast<int>(c)), [&](const CarrierCandidate& seen) {
      return at(*changed, at(rigIndex, seen.primitive));
    });
  }
  return out;
}

/// Whether anything of a triangle is looked at. @param asked [V+E+T]
bool looksAnew(const ControlMesh& mesh, const std::vector<bool>& asked, std::size_t t) {
  const ControlTriangle& triangle = mesh.triangles[t];
  const std::size_t firstEdge = mesh.positions.size();
  if (asked[firstEdge + mesh.edges.size() + t]) return true;
  return std::ranges::any_of(triangle.vertices, [&](int v) { return asked[toIndex(v)]; }) ||
         std::ranges::any_of(triangle.edges, [&](int e) { return asked[firstEdge + toIndex(e)]; });
}

}  // namespace

float followedBend(const Preparation& preparation) {
  if (!preparation.detail) return 0.0f;
  return kBend * preparation.detail->tolerance * preparation.character().height;
}

std::shared_ptr<const AdaptiveLevels> findLevels(const Preparation& next, std::shared_ptr<const Rig> rig,
                                                 float tolerance, const AdaptiveLevels* former) {
  const ControlMesh& mesh = next.mesh();
  auto out = std::make_shared<AdaptiveLevels>();
  out->rig = std::move(rig);
  out->hidden = next.hidden;
  out->tolerance = tolerance;
  out->moments = former ? former->moments : std::make_shared<const std::vector<Pose>>(detailMoments(next.character()));
  out->poses = detailPoses(next.character(), *out->rig, *next.poser, *out->moments);
  const std::vector<bool> asked = carriersToLookAt(next, *out, former);
  const auto firstEdge = asked.begin() + static_cast<std::ptrdiff_t>(mesh.positions.size());
  const auto firstTriangle = firstEdge + static_cast<std::ptrdiff_t>(mesh.edges.size());
  std::vector<bool> edges(firstEdge, firstTriangle);
  std::vector<bool> triangles(firstTriangle, asked.end());
  if (former) out->needed = former->needed;
  out->needed.edges.resize(edges.size());
  out->needed.triangles.resize(triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) out->needed.edges[e] = edges[e] ? 1 : out->needed.edges[e];
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    out->needed.triangles[t] = triangles[t] ? 1 : out->needed.triangles[t];
  }
  LevelSearch(next, *out, out->needed).run(std::move(edges), std::move(triangles));
  if (former) out->checked = former->checked;
  out->checked.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (looksAnew(mesh, asked, t)) out->checked[t].clear();
  }
  const float within = kCheckMargin * tolerance * next.character().height;
  out->levels =
      levelsThatFit(next, out->poses, within, withClothLevels(next, withSides(mesh, out->needed)), out->checked);
  return out;
}

}  // namespace sinew
