// core/smoothing/finish/fold_guard.cpp: vertices of turned triangles step back towards the patch.
#include "core/smoothing/finish/fold_guard.h"

#include <algorithm>

#include "core/base/at.h"

namespace sinew {
namespace {

constexpr int kRounds = 64;
constexpr float kSafeArea = 0.25f;  ///< Share of its area, as seen along the patch, above which a triangle is let be.

/// The share of their lift that a triangle lets its corners keep, 0..1.
float shareOf(const Fold& fold) {
  if (fold.weight == 0.0f) return 1.0f;
  return 1.0f - fold.weight * (1.0f - (1.0f - kSafeArea) / (1.0f - fold.area));
}

}  // namespace

bool FoldGuard::gather(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control,
                       bool onlyLowered, const PatchView& patch, std::span<const glm::vec3> positions) {
  asking_.clear();
  const auto lowered = [&](int v) { return at(isLowered_, v) != 0; };
  for (const int t : control) {
    bool folds = false;
    const int perTriangle = refinement.depth * refinement.depth;
    for (int i = t * perTriangle; i < (t + 1) * perTriangle; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const std::array<int, 3>& small = refinement.triangles[index];
      if (onlyLowered && std::ranges::none_of(small, lowered)) continue;
      const float share = shareOf(foldOf(refinement, index, patch, positions, kSafeArea));
      if (share == 1.0f) continue;
      folds = true;
      for (const int corner : small) {
        float& asked = at(asked_, corner);
        if (asked == 1.0f) asking_.push_back(corner);
        asked = std::min(asked, share);
      }
    }
    if (folds) watch_.add(at(mesh.triangles, t));
  }
  return !asking_.empty();
}

void FoldGuard::lower(const PatchView& patch, std::span<glm::vec3> positions) {
  for (const int vertex : lowered_) at(isLowered_, vertex) = 0;
  lowered_ = asking_;  // Not swapped: their memory would go on growing by turns.
  for (const int vertex : lowered_) {
    const auto v = static_cast<std::size_t>(vertex);
    positions[v] = patch.positions[v] + asked_[v] * (positions[v] - patch.positions[v]);
    kept_[v] *= asked_[v];
    asked_[v] = 1.0f;
    isLowered_[v] = 1;
  }
}

std::span<const float> FoldGuard::apply(const ControlMesh& mesh, const Refinement& refinement,
                                        std::span<const int> control, const PatchView& patch,
                                        std::span<glm::vec3> positions) {
  asked_.assign(positions.size(), 1.0f);
  watch_.clear(mesh);
  if (!gather(mesh, refinement, control, false, patch, positions)) return {};
  kept_.assign(positions.size(), 1.0f);
  isLowered_.assign(positions.size(), 0);
  lowered_.clear();
  bool folds = true;
  for (int round = 0; round < kRounds && folds; ++round) {
    lower(patch, positions);
    // Only triangles with a lowered corner can ask for more: they are around those that asked before.
    folds = gather(mesh, refinement, watch_.around(mesh, control), true, patch, positions);
  }
  return kept_;
}

}  // namespace sinew
