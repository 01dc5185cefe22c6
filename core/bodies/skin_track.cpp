// core/bodies/skin_track.cpp: the nearest triangle by its distance in space.
#include "core/bodies/skin_track.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/triangle_tree.h"

namespace sinew {
namespace {

constexpr float kFaces = 0.2f;        ///< Cosine from which a triangle faces outwards.
constexpr float kLeastWeight = 0.1f;  ///< Less carries no skin to speak of.
constexpr std::size_t kMostBones = 4;
constexpr int kRun = 32;  ///< Triangles.

using Corners = TriangleCorners;

Corners cornersOf(const ControlMesh& mesh, int triangle) {
  const auto& vertices = at(mesh.triangles, triangle).vertices;
  const auto corner = [&](std::size_t i) { return at(mesh.positions, vertices[i]); };
  return {corner(0), corner(1), corner(2)};
}

/// What is in the box is no nearer, squared, less what rounding may add.
float leastFrom(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 off = glm::max(glm::max(low - p, p - high), glm::vec3(0.0f));
  return 0.999f * glm::dot(off, off);
}

glm::vec3 lowOf(const Corners& c) { return glm::min(c[0], glm::min(c[1], c[2])); }
glm::vec3 highOf(const Corners& c) { return glm::max(c[0], glm::max(c[1], c[2])); }

/// The nearest place so far, of all the skin and of that which faces outwards.
struct Nearest {
  std::optional<SkinSpot> any;
  std::optional<SkinSpot> facing;
  float least = std::numeric_limits<float>::max();
  float leastFacing = std::numeric_limits<float>::max();

  void look(const Corners& corners, int triangle, const glm::vec3& point, const glm::vec3& outwards) {
    const glm::vec3 face = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float area = glm::length(face);
    if (!(area > 0.0f)) return;
    const glm::vec3 shares = nearestOnTriangle(point, corners);
    const glm::vec3 off = point - mixed(corners, shares);
    const float squared = glm::dot(off, off);
    if (squared < least) {
      least = squared;
      any = SkinSpot{triangle, shares};
    }
    if (squared < leastFacing && glm::dot(face, outwards) > kFaces * area) {
      leastFacing = squared;
      facing = SkinSpot{triangle, shares};
    }
  }
};

}  // namespace

SkinRuns::SkinRuns(const ControlMesh& mesh) : mesh_(&mesh) {
  const int count = static_cast<int>(mesh.triangles.size());
  for (int begin = 0; begin < count; begin += kRun) {
    const Corners first = cornersOf(mesh, begin);
    Run run{begin, std::min(begin + kRun, count), lowOf(first), highOf(first)};
    for (int t = begin + 1; t < run.end; ++t) {
      const Corners corners = cornersOf(mesh, t);
      run.low = glm::min(run.low, lowOf(corners));
      run.high = glm::max(run.high, highOf(corners));
    }
    runs_.push_back(run);
  }
}

std::optional<SkinSpot> spotOver(const SkinRuns& skin, const glm::vec3& point, const glm::vec3& outwards) {
  Nearest nearest;
  for (const SkinRuns::Run& run : skin.runs()) {
    if (leastFrom(point, run.low, run.high) > nearest.leastFacing) continue;
    for (int t = run.begin; t < run.end; ++t) {
      const Corners corners = cornersOf(skin.mesh(), t);
      if (leastFrom(point, lowOf(corners), highOf(corners)) > nearest.leastFacing) continue;
      nearest.look(corners, t, point, outwards);
    }
  }
  return nearest.facing ? nearest.facing : nearest.any;
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
