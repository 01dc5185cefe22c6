// tests/support/surface/lifted_sheet.cpp: a flat patch under a bump whose sides lean towards each other.

#include "tests/support/surface/lifted_sheet.h"

#include <algorithm>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace sinew::test {
namespace {

glm::vec3 face(const std::vector<glm::vec3>& at, const std::array<int, 3>& t) {
  const glm::vec3& a = at[static_cast<std::size_t>(t[0])];
  return glm::cross(at[static_cast<std::size_t>(t[1])] - a, at[static_cast<std::size_t>(t[2])] - a);
}

}  // namespace

LiftedSheet::LiftedSheet(const Sheet& sheet)
    : mesh(meshOf(sheet.positions, sheet.triangles)),
      refinement(refine(mesh, 1)),
      rings(vertexRings(refinement)),
      patch(mesh.positions),
      bindFronts(triangleFronts(refinement, mesh.positions, mesh.normals)) {}

float LiftedSheet::leastArea(const std::vector<glm::vec3>& positions) const {
  float least = std::numeric_limits<float>::infinity();
  for (const auto& t : refinement.triangles) {
    const glm::vec3 before = face(patch, t);
    least = std::min(least, glm::dot(face(positions, t), before) / glm::dot(before, before));
  }
  return least;
}

int LiftedSheet::turned(const std::vector<glm::vec3>& positions) const {
  return static_cast<int>(std::ranges::count_if(
      refinement.triangles, [&](const auto& t) { return glm::dot(face(positions, t), face(patch, t)) < 0.0f; }));
}

Sheet flatSheet() {
  return sheetOf(20, [](float, float) { return 0.0f; });
}

std::vector<glm::vec3> converging(const std::vector<glm::vec3>& patch, float lift) {
  std::vector<glm::vec3> out = patch;
  for (glm::vec3& p : out) {
    const float inside = std::max(0.0f, 1.0f - (p.x * p.x + p.y * p.y) / 0.5f);
    const float lean = std::clamp(p.x / 0.2f, -1.0f, 1.0f);
    if (inside > 0.0f) p += lift * inside * inside * glm::normalize(glm::vec3(-lean, 0.1f * lean, 1.0f));
  }
  return out;
}

float largestStep(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  float out = 0.0f;
  for (std::size_t v = 0; v < a.size(); ++v) out = std::max(out, glm::distance(a[v], b[v]));
  return out;
}

float steepestStep(const std::vector<glm::vec3>& patch, float most, int steps,
                   const std::function<std::vector<glm::vec3>(std::vector<glm::vec3>)>& finish) {
  std::vector<glm::vec3> before = patch;
  float worst = 0.0f;
  for (int i = 1; i <= steps; ++i) {
    const float lift = most * static_cast<float>(i) / static_cast<float>(steps);
    std::vector<glm::vec3> now = finish(converging(patch, lift));
    worst = std::max(worst, largestStep(before, now));
    before = std::move(now);
  }
  const float slope = worst * static_cast<float>(steps) / most;
  std::printf("  %d steps: the largest is %.2f times the lift's\n", steps, double{slope});
  return slope;
}

}  // namespace sinew::test
