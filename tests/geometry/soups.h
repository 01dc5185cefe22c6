// tests/geometry/soups.h: triangle soups to weld.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/geometry/weld.h"

namespace sinew {

/// Appends a vertex, bound to binding 0 by default.
inline void addVertex(TriangleSoup& soup, const glm::vec3& p, const glm::vec2& uv = {},
                      std::vector<Influence> influences = {{0, 1.0f}}) {
  if (soup.influenceBegin.empty()) soup.influenceBegin.push_back(0);
  soup.positions.push_back(p);
  soup.uvs.push_back(uv);
  soup.influences.insert(soup.influences.end(), influences.begin(), influences.end());
  soup.influenceBegin.push_back(static_cast<int>(soup.influences.size()));
}

inline void addTriangle(TriangleSoup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  soup.triangles.push_back({a, b, c});
  soup.materials.push_back(0);
}

/// Closed torus, indexed, one vertex per point; weights vary over three bindings.
inline TriangleSoup torus(std::uint32_t around, std::uint32_t along) {
  TriangleSoup soup;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < along; ++j) {
      const float u = 6.2831853f * static_cast<float>(i) / static_cast<float>(around);
      const float v = 6.2831853f * static_cast<float>(j) / static_cast<float>(along);
      const float r = 1.0f + 0.3f * std::cos(v);
      const float w = static_cast<float>(i) / static_cast<float>(around);
      addVertex(soup, {r * std::cos(u), r * std::sin(u), 0.3f * std::sin(v)}, {u, v},
                {{0, 0.5f * (1.0f - w)}, {1, 0.5f * w}, {2, 0.5f}});
    }
  }
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return i % around * along + j % along; };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < along; ++j) {
      addTriangle(soup, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      addTriangle(soup, vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return soup;
}

inline std::vector<Influence> influencesOf(const TriangleSoup& soup, std::size_t v) {
  return {soup.influences.begin() + soup.influenceBegin[v], soup.influences.begin() + soup.influenceBegin[v + 1]};
}

/// Two triangles that meet in two corners.
inline TriangleSoup hinge(const std::vector<Influence>& left, const std::vector<Influence>& right,
                          const glm::vec2& uvRight = {}) {
  TriangleSoup soup;
  addVertex(soup, {0, 0, 0}, {}, left);
  addVertex(soup, {1, 0, 0}, {}, left);
  addVertex(soup, {0, 1, 0}, {}, left);
  addVertex(soup, {1, 0, 0}, uvRight, right);
  addVertex(soup, {0, 1, 0}, uvRight, right);
  addVertex(soup, {1, 1, 0}, uvRight, right);
  addTriangle(soup, 0, 1, 2);
  addTriangle(soup, 3, 5, 4);
  return soup;
}

}  // namespace sinew
