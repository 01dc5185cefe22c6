// core/smoothing/fold_guard.cpp: vertices of turned triangles step back towards the patch.
#include "core/smoothing/fold_guard.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr int kRounds = 32;
constexpr float kSafeArea = 0.25f;  ///< Share of its area, as seen along the patch, above which a triangle is let be.
constexpr float kWholeFront = 0.01f;  ///< Of face . normal / sum of squared edges; an equilateral triangle has 0.29.

/// How much a triangle of the patch has a front, 0..1: none where it folds back or has no area.
float frontOf(const glm::vec3& face, const glm::vec3& normals, const glm::vec3& u, const glm::vec3& v) {
  const float edges = glm::dot(u, u) + glm::dot(v, v) + glm::dot(v - u, v - u);
  const float t = std::clamp(glm::dot(face, normals) / (3.0f * kWholeFront * edges), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// The share of their lift that a triangle lets its corners keep, 0..1.
float shareOf(const std::array<int, 3>& t, const PatchView& patch, std::span<const glm::vec3> positions) {
  const auto a = static_cast<std::size_t>(t[0]);
  const auto b = static_cast<std::size_t>(t[1]);
  const auto c = static_cast<std::size_t>(t[2]);
  const glm::vec3 u = patch.positions[b] - patch.positions[a];
  const glm::vec3 v = patch.positions[c] - patch.positions[a];
  const glm::vec3 face = glm::cross(u, v);
  const float whole = glm::dot(face, face);
  const float left = glm::dot(glm::cross(positions[b] - positions[a], positions[c] - positions[a]), face);
  if (!(left < kSafeArea * whole)) return 1.0f;
  const float front = frontOf(face, patch.normals[a] + patch.normals[b] + patch.normals[c], u, v);
  return 1.0f - front * (1.0f - (1.0f - kSafeArea) * whole / (whole - left));
}

}  // namespace

bool FoldGuard::gather(const Refinement& refinement, std::span<const int> control, bool onlyLowered,
                       const PatchView& patch, std::span<const glm::vec3> positions) {
  asking_.clear();
  folding_.clear();
  const auto lowered = [&](int v) { return isLowered_[static_cast<std::size_t>(v)] != 0; };
  for (const int t : control) {
    bool folds = false;
    for (const std::array<int, 3>& small : refinedTriangles(refinement, t)) {
      if (onlyLowered && std::ranges::none_of(small, lowered)) continue;
      const float share = shareOf(small, patch, positions);
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
