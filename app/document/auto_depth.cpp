// app/document/auto_depth.cpp: one division and a dead band.
#include "app/document/auto_depth.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "sinew/rig/rig.h"

namespace sinew {
namespace {

constexpr float kDeadBand = 0.75f;  ///< Steps; more than 0.5, or there would be none.

}  // namespace

float meanEdgeFraction(const ControlMesh& mesh, float height) {
  if (mesh.edges.empty()) return 1.0f;
  double sum = 0.0;
  for (const Edge& edge : mesh.edges) {
    sum +=
        static_cast<double>(glm::distance(at(mesh.positions, edge.vertices[0]), at(mesh.positions, edge.vertices[1])));
  }
  return static_cast<float>(sum / static_cast<double>(mesh.edges.size())) / height;
}

int autoDepth(float meanEdgeFraction, float heightPixels, int current) {
  const float ideal =
      std::clamp(meanEdgeFraction * heightPixels / kAutoEdgePixels, 1.0f, static_cast<float>(kMaxAutoDepth));
  if (!std::isfinite(ideal)) return current > 0 ? current : 1;
  const bool settled =
      current >= 1 && current <= kMaxAutoDepth && std::abs(ideal - static_cast<float>(current)) <= kDeadBand;
  return settled ? current : static_cast<int>(std::lround(ideal));
}

float autoTolerance(float heightPixels, float current) {
  const float ideal = std::clamp(kAutoErrorPixels / heightPixels, kLeastTolerance, kMostTolerance);
  if (!std::isfinite(ideal)) return current > 0.0f ? current : kDefaultTolerance;
  const float step = 2.0f * std::log2(ideal);
  if (current > 0.0f && std::abs(step - 2.0f * std::log2(current)) <= kDeadBand) return current;
  return std::clamp(std::exp2(0.5f * std::round(step)), kLeastTolerance, kMostTolerance);
}

}  // namespace sinew
