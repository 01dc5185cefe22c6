// core/smoothing/finish/crease_lift.cpp: the least ratio of fronts around each vertex.
#include "core/smoothing/finish/crease_lift.h"

#include <algorithm>

#include "core/base/smoothstep.h"

namespace sinew {
namespace {

constexpr float kFolded = -0.3f;      ///< rho up to which heights fall the most.
constexpr float kLevel = 0.4f;        ///< rho from which on they stay.
constexpr float kLeft = 0.4f;         ///< What is left of them.
constexpr float kLeastFront = 0.05f;  ///< In the bind pose.

}  // namespace

void CreaseLift::lower(const Refinement& refinement, const MovedTriangles& moved, const PatchView& patch,
                       std::span<float> heights) {
  if (fronts_.size() != heights.size()) fronts_.assign(heights.size(), kLevel);
  folded_.clear();
  for (const int triangle : moved.refined) {
    const float bindFront = at(patch.bindFronts, triangle);
    if (!(bindFront > kLeastFront)) continue;
    const std::array<int, 3>& t = at(refinement.triangles, triangle);
    const Front front = frontOf(t, faceOf(t, patch.positions), patch);
    if (!(front.along < kLevel * bindFront * front.edges)) continue;
    const float ratio = front.along / (bindFront * front.edges);
    for (const int v : t) {
      float& least = at(fronts_, v);
      if (least == kLevel) folded_.push_back(v);
      least = std::min(least, ratio);
    }
  }
  for (const int v : folded_) {
    at(heights, v) *= kLeft + (1.0f - kLeft) * smoothstep(kFolded, kLevel, at(fronts_, v));
    at(fronts_, v) = kLevel;
  }
}

}  // namespace sinew
