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
constexpr float kUnknown = 2.0f;

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

void CreaseLift::start(const CarryingMesh& c) {
  for (const int triangle : triangles_) at(fronts_, triangle) = kUnknown;
  for (const int vertex : vertices_) at(rho_, vertex) = kUnknown;
  for (const int edge : lowered_) at(isLowered_, edge) = 0;
  triangles_.clear();
  vertices_.clear();
  lowered_.clear();
  fronts_.resize(c.mesh.triangles.size(), kUnknown);
  rho_.resize(c.mesh.positions.size(), kUnknown);
  isLowered_.resize(c.mesh.edges.size(), 0);
}

float CreaseLift::frontOfTriangle(const CarryingMesh& c, int triangle) {
  float& front = at(fronts_, triangle);
  if (front != kUnknown) return front;
  triangles_.push_back(triangle);
  const float perBind = at(c.perBindFront, triangle);
  if (perBind == 0.0f) return front = 1.0f;
  const std::array<int, 3>& t = at(c.mesh.triangles, triangle).vertices;
  front = std::clamp(perBind * ratioOf(t, c.positions, c.normals), -1.0f, 1.0f);
  return front;
}

float CreaseLift::rhoAt(const CarryingMesh& c, int vertex) {
  float& rho = at(rho_, vertex);
  if (rho != kUnknown) return rho;
  vertices_.push_back(vertex);
  rho = 1.0f;
  for (const int corner : c.rings.cornersOf(vertex)) {
    rho = std::min(rho, frontOfTriangle(c, at(c.refinement.controlOf, corner / 3)));
  }
  return rho;
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
  start(c);
  for (std::size_t t = 0; t < moved.isControl.size(); ++t) {
    if (moved.isControl[t] == 0) continue;
    const ControlTriangle& triangle = c.mesh.triangles[t];
    const std::array rho{rhoAt(c, triangle.vertices[0]), rhoAt(c, triangle.vertices[1]),
                         rhoAt(c, triangle.vertices[2])};
    if (*std::ranges::min_element(rho) >= kLevel) continue;
    for (const int edge : triangle.edges) lowerEdge(c, edge, heights);
    for (int v = c.refinement.insideBegin[t]; v < c.refinement.insideBegin[t + 1]; ++v) {
      const glm::vec2 place = c.refinement.insideAt(v);
      at(heights, v) *= leftOf(rho[0] + place.x * (rho[1] - rho[0]) + place.y * (rho[2] - rho[0]));
    }
  }
  for (const int vertex : vertices_) at(heights, vertex) *= leftOf(at(rho_, vertex));
}

}  // namespace sinew
