// core/surface/triangle_samples.cpp: samples pieces of the mesh pose by pose, without the triangles that skip the pose.
#include "core/surface/triangle_samples.h"

#include <algorithm>
#include <utility>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "core/surface/patches/sample_points.h"
#include "core/surface/sampling.h"

namespace sinew {
namespace {

Refinement pointsOf(const SampledPart& part, const std::vector<std::uint8_t>& fine) {
  const ControlMesh& mesh = part.mesh();
  RefinementLevels out{std::vector<std::uint8_t>(mesh.edges.size()), std::vector<std::uint8_t>(mesh.triangles.size())};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    out.triangles[t] = at(fine, part.triangles[t]);
    for (const int e : mesh.triangles[t].edges) at(out.edges, e) = std::max(at(out.edges, e), out.triangles[t]);
  }
  return samplePoints(mesh, out);
}

/// Each number of pieces of a side divides the larger ones.
void samplePiece(const Preparation& next, const std::vector<Pose>& poses, const SamplesAsked& asked,
                 const SampledPiece& piece, const std::function<void(int, std::size_t, const FineSamples&)>& take) {
  const SampledPart part = sampledPart(next, piece);
  SurfaceSampler sampler(part, pointsOf(part, asked.fine));
  std::vector<int> own;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    own.clear();
    for (const int place : part.asked) {
      if (contains(at(asked.poses, at(part.triangles, place)), pose)) own.push_back(place);
    }
    if (own.empty()) continue;
    const Surface& surface = sampler.sample(poses[pose], own);
    for (const int place : own) {
      const int t = at(part.triangles, place);
      positions.clear();
      normals.clear();
      forEachSample(part.mesh(), *surface.refinement, place, at(asked.fine, t), [&](int, int, int vertex) {
        positions.push_back(at(surface.positions, vertex));
        normals.push_back(at(surface.normals, vertex));
      });
      take(t, pose, {positions, normals});
    }
  }
}

}  // namespace

void sampleTriangles(const Preparation& next, const std::vector<Pose>& poses, const SamplesAsked& asked,
                     const std::function<void(int, std::size_t, const FineSamples&)>& take) {
  const std::vector<SampledPiece> pieces = sampledPieces(next, asked.fine);
  forEachIndex(pieces.size(), 1, [&](std::size_t i) { samplePiece(next, poses, asked, pieces[i], take); });
}

FineSamples TriangleSamples::of(std::size_t nth) const {
  const auto count = toIndex((fine + 1) * (fine + 2) / 2);
  return {std::span(positions).subspan(nth * count, count), std::span(normals).subspan(nth * count, count)};
}

void SampledSurface::sample(const std::vector<std::uint8_t>& fine) {
  std::vector<std::uint8_t> missing = fine;
  for (std::size_t t = 0; t < fine.size(); ++t) {
    if (fine[t] == 0) continue;
    if (samples_[t].hold(fine[t])) missing[t] = 0;
    else samples_[t] = {};
  }
  sampleTriangles(next_, poses_, {missing, posesOf_},
                  [&](int t, std::size_t, const FineSamples& samples) { keep(t, at(missing, t), samples); });
}

void SampledSurface::keep(int triangle, int fine, const FineSamples& samples) {
  TriangleSamples& own = at(samples_, triangle);
  own.fine = fine;
  own.positions.insert(own.positions.end(), samples.positions.begin(), samples.positions.end());
  own.normals.insert(own.normals.end(), samples.normals.begin(), samples.normals.end());
}

const TriangleSamples& SampledSurface::of(int triangle) const { return at(samples_, triangle); }

}  // namespace sinew
