// app/viewport/render/shadow_mesh.cpp: control triangles between clusters of their vertices.
#include "app/viewport/render/shadow_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/character/bindings.h"

namespace sinew::app {
namespace {

using Corners = std::array<std::uint32_t, 3>;  ///< Drawn vertices.

const ControlTriangle& triangleOf(const Character& character, int control) {
  return character.mesh.triangles[static_cast<std::size_t>(control)];
}

/// Drawn vertices at the corners of a control triangle.
Corners cornersOf(const ControlTriangle& triangle, const Refinement& refinement, int control) {
  const auto first = static_cast<std::size_t>(refinement.triangleBegin[static_cast<std::size_t>(control)]);
  const auto count = static_cast<std::size_t>(refinement.refinedTriangles(control));
  Corners own{};
  for (const Corners& refined : std::span(refinement.drawTriangles).subspan(first, count)) {
    for (const std::uint32_t vertex : refined) {
      const int shared = refinement.drawVertex[vertex];
      if (shared >= refinement.controlVertices) continue;
      own[static_cast<std::size_t>(std::ranges::find(triangle.vertices, shared) - triangle.vertices.begin())] = vertex;
    }
  }
  return own;
}

/// Which cell of the bind pose, and the bone.
std::array<int, 4> clusterOf(const Character& character, int vertex) {
  constexpr float kFar = 1e9f;
  const glm::vec3& at = character.mesh.positions[static_cast<std::size_t>(vertex)];
  const glm::ivec3 cell(glm::clamp(glm::floor(at / (kShadowCell * character.height)), -kFar, kFar));
  return {cell.x, cell.y, cell.z, strongestBone(character, vertex)};
}

/// Leaves out triangles that are degenerate or repeat another one.
void dropNeedless(std::vector<Corners>& triangles) {
  for (Corners& triangle : triangles) std::ranges::sort(triangle);  // Seen from either side they are equal.
  std::erase_if(triangles, [](const Corners& t) { return t[0] == t[1] || t[1] == t[2]; });
  std::ranges::sort(triangles);
  const auto repeated = std::ranges::unique(triangles);
  triangles.erase(repeated.begin(), repeated.end());
}

}  // namespace

std::vector<int> shadowClusters(const Character& character) {
  if (character.mesh.triangles.size() <= kFewShadowTriangles) return {};
  struct Member {
    std::array<int, 4> cluster;
    int vertex;
  };
  std::vector<Member> members;
  for (int v = 0; v < static_cast<int>(character.mesh.positions.size()); ++v) {
    members.push_back({clusterOf(character, v), v});
  }
  std::ranges::sort(members, {}, [](const Member& m) { return std::pair(m.cluster, m.vertex); });
  const auto at = [&](const Member& m) { return character.mesh.positions[static_cast<std::size_t>(m.vertex)]; };
  std::vector<int> stands(members.size());
  for (auto first = members.begin(); first != members.end();) {
    const auto last = std::find_if(first, members.end(), [&](const Member& m) { return m.cluster != first->cluster; });
    glm::vec3 mean(0.0f);
    for (auto member = first; member != last; ++member) mean += at(*member) / static_cast<float>(last - first);
    const auto away = [&](const Member& member) { return glm::distance(at(member), mean); };
    const auto nearest = std::ranges::min_element(first, last, {}, away);
    for (; first != last; ++first) stands[static_cast<std::size_t>(first->vertex)] = nearest->vertex;
  }
  return stands;
}

ShadowMesh makeShadowMesh(const Character& character, std::span<const int> clusters, const Refinement& refinement,
                          std::span<const int> order) {
  std::vector<Corners> corners;                                       // [order]
  std::vector<std::uint32_t> drawn(character.mesh.positions.size());  // One of those that lie at a control vertex.
  for (const int control : order) {
    const ControlTriangle& triangle = triangleOf(character, control);
    corners.push_back(cornersOf(triangle, refinement, control));
    for (std::size_t c = 0; c < 3; ++c) drawn[static_cast<std::size_t>(triangle.vertices[c])] = corners.back()[c];
  }
  const auto standing = [&](int vertex) {
    return drawn[static_cast<std::size_t>(clusters[static_cast<std::size_t>(vertex)])];
  };
  ShadowMesh made;
  for (std::size_t first = 0; first < order.size();) {
    const int material = triangleOf(character, order[first]).material;
    const bool opaque = character.materials[static_cast<std::size_t>(material)].alphaMode == AlphaMode::kOpaque;
    std::vector<Corners> own;
    for (; first < order.size() && triangleOf(character, order[first]).material == material; ++first) {
      own.push_back(corners[first]);
      if (!opaque || clusters.empty()) continue;
      std::ranges::transform(triangleOf(character, order[first]).vertices, own.back().begin(), standing);
    }
    if (opaque && !clusters.empty()) dropNeedless(own);
    made.ranges.push_back({material, static_cast<int>(made.indices.size() / 3), static_cast<int>(own.size())});
    for (const Corners& triangle : own) made.indices.insert(made.indices.end(), triangle.begin(), triangle.end());
  }
  return made;
}

}  // namespace sinew::app
