// core/smoothing/finish/crease_lift.cpp: fronts of control triangles, the least of them at each control vertex, and
// heights lowered by what lies in between.
#include "core/smoothing/finish/crease_lift.h"

#include <algorithm>

#include "core/base/smoothstep.h"
#include "core/smoothing/finish/fold.h"

namespace sinew {
namespace {

constexpr float kFolded = -0.3f;      ///< rho up to which heights fall the most.
constexpr float kLevel = 0.4f;        ///< rho from which on they stay.
constexpr float kLeft = 0.4f;         ///< What is left of them.
constexpr float kLeastFront = 0.05f;  ///< In the bind pose.

/// How much of its height is left to a vertex.
float leftOf(float rho) { return kLeft + (1.0f - kLeft) * smoothstep(kFolded, kLevel, rho); }

float ratioOf(const std::array<int, 3>& t, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
  return frontOf(t, faceOf(t, positions), {positions, normals, {}}).ratio();
}

}  // namespace

std::vector<float> bindFrontInverses(const ControlMesh& mesh) {
  std::vector<float> out;
  out.reserve(mesh.triangles.size());
  for (const ControlTriangle& t : mesh.triangles) {
    const float front = ratioOf(t.vertices, mesh.positions, mesh.normals);
    out.push_back(front > kLeastFront ? 1.0f / front : 0.0f);
  }
  return out;
}

void CreaseLift::findRho(const CarryingMesh& c, const MovedTriangles& moved) {
  rho_.assign(c.mesh.positions.size(), 1.0f);
  isNear_.assign(c.mesh.positions.size(), 0);
  for (std::size_t t = 0; t < moved.isControl.size(); ++t) {
    if (moved.isControl[t] == 0) continue;
    for (const int v : c.mesh.triangles[t].vertices) at(isNear_, v) = 1;
  }
  for (std::size_t t = 0; t < c.mesh.triangles.size(); ++t) {
    const std::array<int, 3>& corners = c.mesh.triangles[t].vertices;
    if ((at(isNear_, corners[0]) | at(isNear_, corners[1]) | at(isNear_, corners[2])) == 0) continue;
    const float perBind = c.perBindFront[t];
    if (perBind == 0.0f) continue;
    const float front = std::clamp(perBind * ratioOf(corners, c.positions, c.normals), -1.0f, 1.0f);
    for (const int v : corners) at(rho_, v) = std::min(at(rho_, v), front);
  }
}

void CreaseLift::lowerEdge(const CarryingMesh& c, int edge, std::span<float> heights) {
  if (at(isLowered_, edge) != 0) return;
  at(isLowered_, edge) = 1;
  lowered_.push_back(edge);
  const auto& [begin, end] = at(c.mesh.edges, edge).vertices;
  const int level = c.refinement.edgeLevel(edge);
  for (int step = 1; step < level; ++step) {
    const float share = static_cast<float>(step) / static_cast<float>(level);
    const float rho = at(rho_, begin) + share * (at(rho_, end) - at(rho_, begin));
    at(heights, c.refinement.edgeVertex(edge, step)) *= leftOf(rho);
  }
}

void CreaseLift::lower(const CarryingMesh& c, const MovedTriangles& moved, std::span<float> heights) {
  for (const int edge : lowered_) at(isLowered_, edge) = 0;
  lowered_.clear();
  isLowered_.resize(c.mesh.edges.size(), 0);
  findRho(c, moved);
  for (std::size_t t = 0; t < moved.isControl.size(); ++t) {
    if (moved.isControl[t] == 0) continue;
    const ControlTriangle& triangle = c.mesh.triangles[t];
    const auto& [a, b, d] = triangle.vertices;
    const std::array rho{at(rho_, a), at(rho_, b), at(rho_, d)};
    if (*std::ranges::min_element(rho) >= kLevel) continue;
    for (const int edge : triangle.edges) lowerEdge(c, edge, heights);
    for (int v = c.refinement.insideBegin[t]; v < c.refinement.insideBegin[t + 1]; ++v) {
      const glm::vec2 place = c.refinement.insideAt(v);
      at(heights, v) *= leftOf(rho[0] + place.x * (rho[1] - rho[0]) + place.y * (rho[2] - rho[0]));
    }
  }
  for (std::size_t v = 0; v < isNear_.size(); ++v) {
    if (isNear_[v] != 0 && rho_[v] < kLevel) heights[v] *= leftOf(rho_[v]);
  }
}

}  // namespace sinew
