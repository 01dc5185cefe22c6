// core/include/sinew/geometry/control_mesh.h: the coarse mesh: geometric vertices, edges, wedges.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew {

/// Weight of a binding (skeleton.h) at a vertex. Weights of a vertex sum to 1.
struct Influence {
  int binding = 0;
  float weight = 0.0f;
};

/// A geometric vertex as drawn, with texture coordinate, color and, at creases, normal. Seams, colors and creases split
/// wedges, never vertices.
struct Wedge {
  int vertex = 0;
  glm::vec2 uv{0.0f};
  glm::vec4 color{1.0f};               ///< Vertex color, linear RGBA, 0..1: a factor on the material's base color.
  bool creased = false;                ///< Shaded with `normal`, not with the vertex's (core/geometry/normals.h).
  glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< Bind pose, unit; only if creased.
  int fan = -1;                        ///< Number of the normal, from 0; only if creased.
};

/// Edge between two geometric vertices; vertices[0] < vertices[1].
struct Edge {
  std::array<int, 2> vertices{};
  int triangleCount = 0;  ///< 2 on a closed manifold, 1 on a border, more if non-manifold.
};

/// Counter-clockwise from outside. Corner i is vertices[i]; edges[i] joins corners i and (i+1)%3.
struct ControlTriangle {
  std::array<int, 3> vertices{};
  std::array<int, 3> wedges{};
  std::array<int, 3> edges{};
  int material = 0;
  int part = 0;  ///< Index into Character::parts.
};

/// The control mesh in the bind pose, welded (core/geometry/weld.h). World space, character units.
struct ControlMesh {
  std::vector<glm::vec3> positions;  ///< [V]
  std::vector<glm::vec3> normals;    ///< [V] unit, angle-weighted over the faces (Thuermer & Wuethrich 1998).
  std::vector<int> influenceBegin;   ///< [V+1] offsets into influences.
  std::vector<Influence> influences;
  std::vector<Wedge> wedges;               ///< [W] sorted by first use.
  std::vector<Edge> edges;                 ///< [E] in order of first use by the triangles.
  std::vector<ControlTriangle> triangles;  ///< [T] in file order.
  int trianglesDropped = 0;                ///< Lost a corner by welding, or had an index twice.

  [[nodiscard]] std::span<const Influence> influencesOf(int vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(influences)
        .subspan(static_cast<std::size_t>(influenceBegin[v]),
                 static_cast<std::size_t>(influenceBegin[v + 1] - influenceBegin[v]));
  }
};

[[nodiscard]] bool hasColors(const ControlMesh& mesh);  ///< Whether any wedge has a color other than white.

}  // namespace sinew
