// tests/support/lifted_sheet.cpp: a flat patch under a bump whose sides lean together.

#include "tests/support/lifted_sheet.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

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

}  // namespace sinew::test
