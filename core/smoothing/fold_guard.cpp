// core/smoothing/fold_guard.cpp: vertices of turned triangles step back towards the patch.
#include "core/smoothing/fold_guard.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/base/smoothstep.h"

namespace sinew {
namespace {

constexpr int kRounds = 32;
constexpr float kSafeArea = 0.25f;  ///< Share of its area, as seen along the patch, above which a triangle is let be.
// Of a patch triangle's front over its own in the bind pose: from which it asks for nothing, and for all.
constexpr float kNoFront = 0.02f;
constexpr float kWholeFront = 0.17f;

/// A refined triangle of the patch.
struct Facet {
  glm::vec3 face;     ///< Twice the area, along the face normal.
  float front = 0.0f; ///< As triangleFronts has it.
};

Facet facetOf(const std::array<int, 3>& t, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
  const auto a = static_cast<std::size_t>(t[0]);
  const auto b = static_cast<std::size_t>(t[1]);
  const auto c = static_cast<std::size_t>(t[2]);
  const glm::vec3 u = positions[b] - positions[a];
  const glm::vec3 v = positions[c] - positions[a];
  Facet out{glm::cross(u, v)};
  const float edges = glm::dot(u, u) + glm::dot(v, v) + glm::dot(v - u, v - u);
  if (edges > 0.0f) out.front = glm::dot(out.face, normals[a] + normals[b] + normals[c]) / (3.0f * edges);
  return out;
}

/// The share of their lift that a triangle lets its corners keep, 0..1.
float shareOf(const std::array<int, 3>& t, const PatchView& patch, float bindFront,
              std::span<const glm::vec3> positions) {
  const Facet facet = facetOf(t, patch.positions, patch.normals);
  const glm::vec3& a = positions[static_cast<std::size_t>(t[0])];
  const glm::vec3 lifted =
      glm::cross(positions[static_cast<std::size_t>(t[1])] - a, positions[static_cast<std::size_t>(t[2])] - a);
  const float whole = glm::dot(facet.face, facet.face);
  const float left = glm::dot(lifted, facet.face);
  if (!(left < kSafeArea * whole) || !(bindFront > 0.0f)) return 1.0f;
  const float weight = smoothstep(kNoFront, kWholeFront, facet.front / bindFront);
  return 1.0f - weight * (1.0f - (1.0f - kSafeArea) * whole / (whole - left));
}

}  // namespace

std::vector<float> triangleFronts(const Refinement& refinement, std::span<const glm::vec3> positions,
                                  std::span<const glm::vec3> normals) {
  std::vector<float> fronts;
  fronts.reserve(refinement.triangles.size());
  for (const std::array<int, 3>& t : refinement.triangles) fronts.push_back(facetOf(t, positions, normals).front);
  return fronts;
}

bool FoldGuard::gather(const Refinement& refinement, std::span<const int> control, bool onlyLowered,
                       const PatchView& patch, std::span<const glm::vec3> positions) {
  asking_.clear();
  folding_.clear();
  const auto lowered = [&](int v) { return isLowered_[static_cast<std::size_t>(v)] != 0; };
  for (const int t : control) {
    bool folds = false;
    const int perTriangle = refinement.depth * refinement.depth;
    for (int i = t * perTriangle; i < (t + 1) * perTriangle; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const std::array<int, 3>& small = refinement.triangles[index];
      if (onlyLowered && std::ranges::none_of(small, lowered)) continue;
      const float share = shareOf(small, patch, patch.bindFronts[index], positions);
      if (share == 1.0f) continue;
      folds = true;
      for (const int corner : small) {
        float& asked = asked_[static_cast<std::size_t>(corner)];
        if (asked == 1.0f) asking_.push_back(corner);
        asked = std::min(asked, share);
      }
    }
    if (folds) folding_.push_back(t);
  }
  return !asking_.empty();
}

void FoldGuard::lower(const PatchView& patch, std::span<glm::vec3> positions) {
  for (const int vertex : lowered_) isLowered_[static_cast<std::size_t>(vertex)] = 0;
  std::swap(lowered_, asking_);
  for (const int vertex : lowered_) {
    const auto v = static_cast<std::size_t>(vertex);
    positions[v] = patch.positions[v] + asked_[v] * (positions[v] - patch.positions[v]);
    kept_[v] *= asked_[v];
    asked_[v] = 1.0f;
    isLowered_[v] = 1;
  }
}

void FoldGuard::watchAround(const ControlMesh& mesh, std::span<const int> control) {
  for (const int t : folding_) {
    for (const int corner : mesh.triangles[static_cast<std::size_t>(t)].vertices) {
      nearFolding_[static_cast<std::size_t>(corner)] = 1;
    }
  }
  watched_.clear();
  for (const int t : control) {
    const auto near = [&](int corner) { return nearFolding_[static_cast<std::size_t>(corner)] != 0; };
    if (std::ranges::any_of(mesh.triangles[static_cast<std::size_t>(t)].vertices, near)) watched_.push_back(t);
  }
}

std::span<const float> FoldGuard::apply(const ControlMesh& mesh, const Refinement& refinement,
                                        std::span<const int> control, const PatchView& patch,
                                        std::span<glm::vec3> positions) {
  asked_.assign(positions.size(), 1.0f);
  if (!gather(refinement, control, false, patch, positions)) return {};
  kept_.assign(positions.size(), 1.0f);
  isLowered_.assign(positions.size(), 0);
  lowered_.clear();
  nearFolding_.assign(mesh.positions.size(), 0);
  bool folds = true;
  for (int round = 0; round < kRounds && folds; ++round) {
    lower(patch, positions);
    // Only triangles with a lowered corner can ask for more: they are around those that asked before.
    watchAround(mesh, control);
    folds = gather(refinement, watched_, true, patch, positions);
  }
  return kept_;
}

}  // namespace sinew
