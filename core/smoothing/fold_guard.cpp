// core/smoothing/fold_guard.cpp: vertices of turned triangles step back towards the patch.
#include "core/smoothing/fold_guard.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr int kRounds = 32;
constexpr float kSafeArea = 0.25f;  ///< Share of its area, as seen along the patch, above which a triangle is let be.

/// Twice the area, along the face normal.
glm::vec3 faceOf(std::span<const glm::vec3> positions, const std::array<int, 3>& t) {
  const glm::vec3& a = positions[static_cast<std::size_t>(t[0])];
  return glm::cross(positions[static_cast<std::size_t>(t[1])] - a, positions[static_cast<std::size_t>(t[2])] - a);
}

/// The share of their lift that a triangle lets its corners keep, 0..1.
float shareOf(const std::array<int, 3>& t, std::span<const glm::vec3> patch, std::span<const glm::vec3> positions) {
  const glm::vec3 flat = faceOf(patch, t);
  const float whole = glm::dot(flat, flat);
  const float left = glm::dot(faceOf(positions, t), flat);
  if (!(left < kSafeArea * whole)) return 1.0f;
  return (1.0f - kSafeArea) * whole / (whole - left);
}

}  // namespace

bool FoldGuard::gather(const Refinement& refinement, std::span<const int> control, bool onlyLowered,
                       std::span<const glm::vec3> patch, std::span<const glm::vec3> positions) {
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

void FoldGuard::lower(std::span<const glm::vec3> patch, std::span<glm::vec3> positions) {
  for (const int vertex : lowered_) isLowered_[static_cast<std::size_t>(vertex)] = 0;
  std::swap(lowered_, asking_);
  for (const int vertex : lowered_) {
    const auto v = static_cast<std::size_t>(vertex);
    positions[v] = patch[v] + asked_[v] * (positions[v] - patch[v]);
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
                                        std::span<const int> control, std::span<const glm::vec3> patch,
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
