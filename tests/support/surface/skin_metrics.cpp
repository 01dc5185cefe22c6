// tests/support/surface/skin_metrics.cpp: shading normals against the faces they are drawn on.

#include "tests/support/surface/skin_metrics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::test {
namespace {

constexpr float kAllowed = 10.0f;  ///< Degrees.

float degreesBetween(const glm::vec3& a, const glm::vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180.0f / std::numbers::pi_v<float>;
}

glm::vec3 faceOf(const std::vector<glm::vec3>& positions, const std::array<int, 3>& t) {
  const glm::vec3& a = positions[static_cast<std::size_t>(t[0])];
  return glm::cross(positions[static_cast<std::size_t>(t[1])] - a, positions[static_cast<std::size_t>(t[2])] - a);
}

/// [V'] face normals weighted by the corners' angles, unit; 0 where they cancel.
std::vector<glm::vec3> faceNormals(const Surface& surface) {
  std::vector<glm::vec3> sums(surface.positions.size(), glm::vec3(0.0f));
  for (const auto& t : surface.refinement->triangles) {
    const glm::vec3 face = faceOf(surface.positions, t);
    const float area = glm::length(face);
    if (!(area > 0.0f)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3& corner = surface.positions[static_cast<std::size_t>(t[i])];
      const float angle = degreesBetween(surface.positions[static_cast<std::size_t>(t[(i + 1) % 3])] - corner,
                                         surface.positions[static_cast<std::size_t>(t[(i + 2) % 3])] - corner);
      sums[static_cast<std::size_t>(t[i])] += angle / area * face;
    }
  }
  for (glm::vec3& sum : sums) sum = normalizeOr(sum, glm::vec3(0.0f));
  return sums;
}

/// One surface with its patch, as the eye sees them: normals against faces.
struct Judge {
  const Surface& surface;
  const Surface& patch;
  std::vector<glm::vec3> faces = faceNormals(surface);
  std::vector<glm::vec3> patchFaces = faceNormals(patch);

  [[nodiscard]] bool moved(std::size_t v) const { return surface.displacement[v] != 0.0f; }

  [[nodiscard]] bool isOff(std::size_t v, const std::vector<glm::vec3>& normals) const {
    const float own = degreesBetween(patch.normals[v], patchFaces[v]);
    return degreesBetween(normals[v], faces[v]) > kAllowed + own;
  }

  /// @param least  degrees that are granted whatever the faces do.
  [[nodiscard]] bool swings(std::size_t a, std::size_t b, const std::vector<glm::vec3>& normals, float least) const {
    const float granted = std::max(degreesBetween(faces[a], faces[b]), least);
    return degreesBetween(normals[a], normals[b]) > kAllowed + granted;
  }
};

void countVertices(const Judge& judge, const Surface& exact, SkinMetrics& out) {
  const Surface& surface = judge.surface;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    if (!judge.moved(v)) continue;
    ++out.vertices;
    out.off += judge.isOff(v, surface.normals) ? 1 : 0;
    out.exactOff += judge.isOff(v, exact.normals) ? 1 : 0;
    if (surface.displacement[v] != exact.displacement[v]) continue;
    const glm::vec3& own = judge.patch.normals[v];
    out.definition += static_cast<double>(degreesBetween(surface.normals[v], own));
    out.exactDefinition += static_cast<double>(degreesBetween(exact.normals[v], own));
  }
}

void countEdges(const Judge& judge, const Surface& exact, SkinMetrics& out) {
  const std::vector<glm::vec3>& own = judge.patch.normals;
  for (const auto& t : judge.surface.refinement->triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(t[i]);
      const auto b = static_cast<std::size_t>(t[(i + 1) % 3]);
      if (a > b || (!judge.moved(a) && !judge.moved(b))) continue;  // Each edge from the triangle that runs it upwards.
      ++out.edges;
      const float patchTurn = degreesBetween(own[a], own[b]);
      out.swinging += judge.swings(a, b, judge.surface.normals, patchTurn) ? 1 : 0;
      out.exactSwinging += judge.swings(a, b, exact.normals, patchTurn) ? 1 : 0;
      out.swingingAtAll += judge.swings(a, b, judge.surface.normals, 0.0f) ? 1 : 0;
    }
  }
}

void countTriangles(const Judge& judge, SkinMetrics& out) {
  for (const auto& t : judge.surface.refinement->triangles) {
    ++out.triangles;
    const glm::vec3 face = faceOf(judge.patch.positions, t);
    if (glm::dot(faceOf(judge.surface.positions, t), face) >= 0.0f) continue;
    glm::vec3 normal(0.0f);
    for (const int corner : t) normal += judge.patch.normals[static_cast<std::size_t>(corner)];
    (glm::dot(face, normal) > 0.0f ? out.turned : out.turnedInFolds) += 1;
  }
}

}  // namespace

void SkinMetrics::add(const SkinMetrics& other) {
  refined = other.refined;
  vertices += other.vertices;
  off += other.off;
  exactOff += other.exactOff;
  edges += other.edges;
  swinging += other.swinging;
  exactSwinging += other.exactSwinging;
  swingingAtAll += other.swingingAtAll;
  triangles += other.triangles;
  turned += other.turned;
  turnedInFolds += other.turnedInFolds;
  definition += other.definition;
  exactDefinition += other.exactDefinition;
}

SkinMetrics skinMetrics(const Surface& surface, const Surface& patch, const Surface& exact) {
  SkinMetrics out;
  out.refined = static_cast<int>(surface.positions.size());
  const Judge judge{surface, patch};
  countVertices(judge, exact, out);
  countEdges(judge, exact, out);
  countTriangles(judge, out);
  return out;
}

}  // namespace sinew::test
