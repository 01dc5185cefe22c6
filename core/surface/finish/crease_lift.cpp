// core/surface/finish/crease_lift.cpp: least fronts at control vertices, interpolated, and heights lowered by them.
#include "core/surface/finish/crease_lift.h"

#include <algorithm>
#include <atomic>

#include "core/geometry/formulas.h"
#include "core/geometry/parallel.h"
#include "core/surface/finish/fold.h"

namespace sinew {
namespace {

constexpr float kLeastFront = 0.05f;       ///< In the bind pose.
constexpr std::size_t kFewCreased = 2048;  ///< Triangles, edges or vertices for one thread.

float ratioOf(const std::array<int, 3>& t, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
  return frontOf(t, faceOf(t, positions), {positions, normals, {}});
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
  isNear_.assign(c.mesh.positions.size(), 0);
  const std::span<std::uint8_t> isNear = isNear_;
  forEachIndex(moved.isControl.size(), kFewCreased, [&](std::size_t t) {
    if (moved.isControl[t] == 0) return;
    for (const int v : c.mesh.triangles[t].vertices) {
      std::atomic_ref(at(isNear, v)).store(1, std::memory_order_relaxed);  // Several threads may write it.
    }
  });
  fronts_.resize(c.mesh.triangles.size());
  forEachIndex(fronts_.size(), kFewCreased, [&](std::size_t t) {
    const std::array<int, 3>& corners = c.mesh.triangles[t].vertices;
    if ((at(isNear, corners[0]) | at(isNear, corners[1]) | at(isNear, corners[2])) == 0) return;
    const float perBind = c.perBindFront[t];
    fronts_[t] = perBind == 0.0f ? 1.0f : std::clamp(perBind * ratioOf(corners, c.positions, c.normals), -1.0f, 1.0f);
  });
  rho_.resize(isNear_.size());
  forEachIndex(rho_.size(), kFewCreased, [&](std::size_t v) {
    float least = 1.0f;
    if (isNear[v] != 0) {
      for (const int corner : c.rings.cornersOf(static_cast<int>(v))) {
        least = std::min(least, at(fronts_, at(c.refinement.controlOf, corner / 3)));
      }
    }
    rho_[v] = least;
  });
}

void CreaseLift::lowerInside(const CarryingMesh& c, const MovedTriangles& moved, std::span<float> heights) {
  isLowered_.resize(c.mesh.edges.size(), 0);
  const std::span<std::uint8_t> isLowered = isLowered_;
  forEachIndex(moved.isControl.size(), kFewCreased, [&](std::size_t t) {
    if (moved.isControl[t] == 0) return;
    const ControlTriangle& triangle = c.mesh.triangles[t];
    const auto& [a, b, d] = triangle.vertices;
    const std::array rho{at(rho_, a), at(rho_, b), at(rho_, d)};
    if (*std::ranges::min_element(rho) >= in_float::kLevel) return;
    for (const int edge : triangle.edges) std::atomic_ref(at(isLowered, edge)).store(1, std::memory_order_relaxed);
    for (int v = c.refinement.insideBegin[t]; v < c.refinement.insideBegin[t + 1]; ++v) {
      const glm::vec2 place = c.refinement.insideAt(v);
      at(heights, v) *= in_float::leftOfHeight(rho[0] + place.x * (rho[1] - rho[0]) + place.y * (rho[2] - rho[0]));
    }
  });
}

void CreaseLift::lowerEdges(const CarryingMesh& c, std::span<float> heights) {
  forEachIndex(isLowered_.size(), kFewCreased, [&](std::size_t e) {
    if (isLowered_[e] == 0) return;
    isLowered_[e] = 0;
    const auto edge = static_cast<int>(e);
    const auto& [begin, end] = c.mesh.edges[e].vertices;
    const int level = c.refinement.edgeLevel(edge);
    for (int step = 1; step < level; ++step) {
      const auto share = static_cast<float>(c.refinement.shareAt(edge, step));
      const float rho = at(rho_, begin) + share * (at(rho_, end) - at(rho_, begin));
      at(heights, c.refinement.edgeVertex(edge, step)) *= in_float::leftOfHeight(rho);
    }
  });
}

void CreaseLift::lower(const CarryingMesh& c, const MovedTriangles& moved, std::span<float> heights) {
  findRho(c, moved);
  lowerInside(c, moved, heights);
  lowerEdges(c, heights);
  forEachIndex(rho_.size(), kFewCreased, [&](std::size_t v) {
    if (rho_[v] < in_float::kLevel) heights[v] *= in_float::leftOfHeight(rho_[v]);
  });
}

}  // namespace sinew
