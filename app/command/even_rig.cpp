// app/command/even_rig.cpp: low-discrepancy points over the skin's area, a ball under each.
#include "app/command/even_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {
namespace {

constexpr float kReach = 1.5f;

/// Areas of the triangles, each with all before it.
std::vector<float> runningAreas(const ControlMesh& mesh) {
  std::vector<float> sums;
  float sum = 0.0f;
  for (const ControlTriangle& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return at(mesh.positions, triangle.vertices[i]); };
    sum += 0.5f * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    sums.push_back(sum);
  }
  return sums;
}

/// Barycentric, even over a triangle, from the plastic number's multiples.
glm::vec3 barycentric(int number) {
  float u = std::fmod(0.5f + 0.7548776662f * static_cast<float>(number % 4096), 1.0f);
  float v = std::fmod(0.5f + 0.5698402910f * static_cast<float>(number % 4096), 1.0f);
  if (u + v > 1.0f) {
    u = 1.0f - u;
    v = 1.0f - v;
  }
  return {1.0f - u - v, u, v};
}

}  // namespace

Rig evenRig(const Character& character, int muscles) {
  const ControlMesh& mesh = character.mesh;
  const std::vector<float> areas = runningAreas(mesh);
  // muscles * pi (reach radius)^2 = overlap * area
  const float share = kEvenOverlap * areas.back() / (static_cast<float>(muscles) * std::numbers::pi_v<float>);
  const float radius = std::sqrt(share) / kReach;
  Rig rig;
  rig.groups.push_back({"even", {}});
  for (int i = 0; i < muscles; ++i) {
    const float wanted = areas.back() * (static_cast<float>(i) + 0.5f) / static_cast<float>(muscles);
    const auto found = std::ranges::lower_bound(areas, wanted) - areas.begin();
    const ControlTriangle& triangle = mesh.triangles[std::min(static_cast<std::size_t>(found), areas.size() - 1)];
    const glm::vec3 weights = barycentric(i);
    glm::vec3 point(0.0f), out(0.0f);
    std::size_t nearest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float weight = weights[static_cast<int>(c)];
      point += weight * at(mesh.positions, triangle.vertices[c]);
      out += weight * at(mesh.normals, triangle.vertices[c]);
      if (weight > weights[static_cast<int>(nearest)]) nearest = c;
    }
    const int boneIndex = strongestBone(character, triangle.vertices[nearest]);
    const Bone& bone = at(character.skeleton.bones, boneIndex);
    const float scale = std::cbrt(std::abs(glm::determinant(glm::mat3(bone.bindInWorld))));
    Primitive primitive;
    primitive.name = "muscle " + std::to_string(i + 1);
    primitive.bone = character.skeleton.fileName(boneIndex);
    primitive.group = rig.groups.front().name;
    primitive.reach = kReach;
    const glm::vec3 center = point - 0.5f * radius * normalizeOr(out, {0.0f, 1.0f, 0.0f});
    primitive.placement.center = glm::vec3(bone.inverseBindInWorld * glm::vec4(center, 1.0f));
    primitive.placement.radii = glm::vec3(radius / (scale > 0.0f ? scale : 1.0f));
    rig.primitives.push_back(std::move(primitive));
  }
  return rig;
}

}  // namespace sinew::app
