// core/check/skin_track.cpp: the nearest triangle by its distance in space.
#include "core/check/skin_track.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/character/bindings.h"
#include "core/mesh/nearest_on_triangle.h"

namespace sinew {
namespace {

constexpr float kFaces = 0.2f;        ///< Cosine from which a triangle faces outwards.
constexpr float kLeastWeight = 0.1f;  ///< Less carries no skin to speak of.
constexpr std::size_t kMostBones = 4;

using Corners = TriangleCorners;

Corners cornersOf(const ControlMesh& mesh, int triangle) {
  const auto& vertices = at(mesh.triangles, triangle).vertices;
  const auto corner = [&](std::size_t i) { return at(mesh.positions, vertices[i]); };
  return {corner(0), corner(1), corner(2)};
}

/// The triangle is no nearer, squared: the distance from its box, less what rounding may add.
float leastFrom(const glm::vec3& p, const Corners& c) {
  const glm::vec3 low = glm::min(c[0], glm::min(c[1], c[2]));
  const glm::vec3 high = glm::max(c[0], glm::max(c[1], c[2]));
  const glm::vec3 off = glm::max(glm::max(low - p, p - high), glm::vec3(0.0f));
  return 0.999f * glm::dot(off, off);
}

}  // namespace

std::optional<SkinSpot> spotOver(const ControlMesh& mesh, const glm::vec3& point, const glm::vec3& outwards) {
  std::optional<SkinSpot> best;
  std::optional<SkinSpot> facing;
  float least = std::numeric_limits<float>::max();
  float leastFacing = least;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Corners corners = cornersOf(mesh, t);
    if (leastFrom(point, corners) > leastFacing) continue;
    const glm::vec3 face = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float area = glm::length(face);
    if (!(area > 0.0f)) continue;
    const glm::vec3 shares = nearestOnTriangle(point, corners);
    const glm::vec3 off = point - mixed(corners, shares);
    const float squared = glm::dot(off, off);
    if (squared < least) {
      least = squared;
      best = SkinSpot{t, shares};
    }
    if (squared < leastFacing && glm::dot(face, outwards) > kFaces * area) {
      leastFacing = squared;
      facing = SkinSpot{t, shares};
    }
  }
  return facing ? facing : best;
}

glm::vec3 skinnedVertex(const Character& character, int vertex, const Pose& pose) {
  return glm::vec3(skinMatrix(character, pose, vertex) * glm::vec4(at(character.mesh.positions, vertex), 1.0f));
}

std::optional<SkinFrame> frameAt(const Character& character, const SkinSpot& spot, const Pose& pose) {
  Corners corners;
  for (std::size_t c = 0; c < 3; ++c) {
    corners[c] = skinnedVertex(character, at(character.mesh.triangles, spot.triangle).vertices[c], pose);
  }
  const glm::vec3 along = corners[1] - corners[0];
  const glm::vec3 face = glm::cross(along, corners[2] - corners[0]);
  const float length = glm::length(along);
  const float area = glm::length(face);
  if (!(length > 0.0f) || !(area > 0.0f)) return std::nullopt;
  const glm::vec3 x = along / length;
  const glm::vec3 normal = face / area;
  return SkinFrame{mixed(corners, spot.shares), glm::mat3(x, glm::cross(normal, x), normal)};
}

std::vector<int> bonesAt(const Character& character, const SkinSpot& spot) {
  std::map<int, float> weights;
  const auto& vertices = at(character.mesh.triangles, spot.triangle).vertices;
  for (int c = 0; c < 3; ++c) {
    for (const WeightedBinding& follows : bindingsOf(character, at(vertices, c))) {
      weights[follows.bone()] += spot.shares[c] * follows.weight;
    }
  }
  std::vector<std::pair<int, float>> sorted(weights.begin(), weights.end());
  std::ranges::stable_sort(sorted, std::ranges::greater(), &std::pair<int, float>::second);
  std::vector<int> bones;
  for (const auto& [bone, weight] : sorted) {
    if (weight >= kLeastWeight && bones.size() < kMostBones) bones.push_back(bone);
  }
  return bones;
}

}  // namespace sinew
