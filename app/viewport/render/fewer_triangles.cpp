// app/viewport/render/fewer_triangles.cpp: clusters of vertices for shadows; triangles that cover pixels.
#include "app/viewport/render/fewer_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include "core/character/bindings.h"
#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {
namespace {

using Corners = std::array<std::uint32_t, 3>;  ///< Drawn vertices.

const ControlTriangle& triangleOf(const Character& character, int control) {
  return character.mesh.triangles[static_cast<std::size_t>(control)];
}

/// Drawn vertices at the corners of a control triangle.
Corners cornersOfTriangle(const ControlTriangle& triangle, const Refinement& refinement, int control) {
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

/// Cell of the bind pose, and the bone.
std::array<int, 4> clusterOf(const Character& character, int vertex) {
  constexpr float kFarthest = 1e9f;
  const glm::vec3& at = character.mesh.positions[static_cast<std::size_t>(vertex)];
  const glm::ivec3 cell(glm::clamp(glm::floor(at / (kShadowCell * character.height)), -kFarthest, kFarthest));
  return {cell.x, cell.y, cell.z, strongestBone(character, vertex)};
}

/// Removes degenerate and repeated triangles.
void dropNeedless(std::vector<Corners>& triangles) {
  for (Corners& triangle : triangles) std::ranges::sort(triangle);  // Either side casts the same shadow.
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
  std::vector<std::uint32_t> drawn(character.mesh.positions.size());  // One at each control vertex.
  for (const int control : order) {
    const ControlTriangle& triangle = triangleOf(character, control);
    corners.push_back(cornersOfTriangle(triangle, refinement, control));
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

// Vertices in pixels, then triangles, listed by several threads.

namespace {

constexpr std::size_t kBlock = 4096;
constexpr float kPixelMargin = 1.0f / 16.0f;  ///< Pixels by which OpenGL may place a corner elsewhere: half for its
                                              ///< grid of at least 1/16, half for rounding.

/// Largest difference of two sums of the same terms, at w = 1.
float roundingOf(std::span<const glm::vec3> positions, const glm::mat4& clipFromWorld) {
  glm::vec3 farthest(0.0f);
  const Bounds bounds = boundsOf(positions);
  if (!bounds.isEmpty()) farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
  float largest = 0.0f;
  for (const glm::length_t row : {0, 1, 3}) {
    largest = std::max(largest, glm::dot(glm::abs(glm::row(clipFromWorld, row)), glm::vec4(farthest, 1.0f)));
  }
  return 4.0f * std::numeric_limits<float>::epsilon() * largest;
}

/// Whether the range of three coordinates contains a pixel's center.
bool holdsCenter(float a, float b, float c, float size) {
  const float least = std::clamp(std::min({a, b, c}) - kPixelMargin, -0.5f, size + 0.5f);
  const float most = std::clamp(std::max({a, b, c}) + kPixelMargin, -0.5f, size + 0.5f);
  return static_cast<int>(least + 0.5f) < static_cast<int>(most + 0.5f);
}

bool mayFace(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const glm::vec2 u = b - a;
  const glm::vec2 v = c - a;
  const float lengths = std::abs(u.x) + std::abs(u.y) + std::abs(v.x) + std::abs(v.y);
  return !(u.x * v.y - u.y * v.x < -kPixelMargin * (2.0f * lengths + 1.0f));
}

}  // namespace

void SeenTriangles::place(std::span<const glm::vec3> positions, const glm::mat4& clipFromWorld, const glm::vec2& size) {
  pixels_.resize(positions.size());
  const glm::vec2 half = 0.5f * size;
  const float rounding = std::max(half.x, half.y) * roundingOf(positions, clipFromWorld);
  forEachIndex(positions.size(), kBlock, [&](std::size_t i) {
    const glm::vec4 clip = clipFromWorld * glm::vec4(positions[i], 1.0f);
    const float per = 1.0f / clip.w;
    const glm::vec2 device = per * glm::vec2(clip);
    const float off = rounding * per * (1.0f + std::abs(device.x) + std::abs(device.y));
    const bool isSure = clip.w > 0.0f && clip.z > -clip.w && off < 0.5f * kPixelMargin;
    pixels_[i] = isSure ? half + half * device : glm::vec2(std::numeric_limits<float>::quiet_NaN());
  });
}

bool SeenTriangles::leavesTrace(const std::array<int, 3>& triangle, const glm::vec2& size, bool keepsBack) const {
  const glm::vec2& a = at(pixels_, triangle[0]);
  const glm::vec2& b = at(pixels_, triangle[1]);
  const glm::vec2& c = at(pixels_, triangle[2]);
  if (std::isnan(a.x + b.x + c.x)) return true;
  return (keepsBack || mayFace(a, b, c)) && holdsCenter(a.x, b.x, c.x, size.x) && holdsCenter(a.y, b.y, c.y, size.y);
}

void SeenTriangles::find(const Input& input, const glm::mat4& clipFromWorld, const glm::ivec2& size) {
  place(input.positions, clipFromWorld, glm::vec2(size));
  triangles_.resize(input.order.size());
  ranges_.assign(input.ranges.begin(), input.ranges.end());
  std::size_t listed = 0;
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    Range& range = ranges_[r];
    const auto own = input.order.subspan(toIndex(range.firstTriangle), toIndex(range.triangles));
    const auto list = [&](std::size_t begin, std::size_t end, Corners* out) {
      std::size_t count = 0;
      for (const int triangle : own.subspan(begin, end - begin)) {
        if (!leavesTrace(at(input.refinement.triangles, triangle), glm::vec2(size), input.keepsBacks[r] != 0)) continue;
        out[count++] = at(input.refinement.drawTriangles, triangle);
      }
      return count;
    };
    range.firstTriangle = static_cast<int>(listed);
    range.triangles = static_cast<int>(listInBlocks(own.size(), kBlock, triangles_.data() + listed, list));
    listed += toIndex(range.triangles);
  }
  triangles_.resize(listed);
}

}  // namespace sinew::app
