// core/files/export/out_primitive.h: the primitives of the exported file.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/out_skins.h"
#include "core/files/export/source.h"
#include "core/files/fit/weight_fit.h"
#include "core/files/gltf/node_tree.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/surface.h"

namespace sinew::exporting {

/// World in the bind pose -> mesh space of a skin.
struct IntoMesh {
  explicit IntoMesh(const glm::dmat4& meshToBind)
      : inverse(gltf::affineInverse(meshToBind).value_or(glm::dmat4(1.0))), linear(glm::dmat3(meshToBind)) {}

  [[nodiscard]] glm::vec3 point(const glm::vec3& p) const {
    return glm::vec3(inverse * glm::dvec4(glm::dvec3(p), 1.0));
  }
  [[nodiscard]] glm::dvec3 way(const glm::dvec3& d) const { return glm::dmat3(inverse) * d; }
  [[nodiscard]] glm::vec3 normal(const glm::vec3& n) const {
    return normalizeOr(glm::vec3(glm::normalize(glm::transpose(linear) * glm::dvec3(n))), n);
  }
  [[nodiscard]] bool mirrors() const { return glm::determinant(linear) < 0.0; }

  glm::dmat4 inverse;
  glm::dmat3 linear;
};

/// An interpolated vertex attribute.
struct VertexAttribute {
  std::string name;  ///< TEXCOORD_n, COLOR_n or TANGENT.
  int components = 0;
  std::vector<float> values;  ///< [vertices * components]
};

/// A refined primitive, with vertices split as in the file.
struct RefinedPrimitive {
  std::vector<int> refined;  ///< [n] refined vertex of each vertex.
  std::vector<int> drawn;    ///< [n] drawn vertex with its shading normal.
  std::vector<VertexAttribute> attributes;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Winding as in the soup.
};

/// Refines the part's triangles. Vertices are joined if they have the same drawn vertex, and the file's texture
/// coordinates, colors and tangents agree at the corners around them. Throws gltf::Refusal for unreadable attributes.
[[nodiscard]] RefinedPrimitive refinedPrimitive(Source& source, const gltf::SoupPart& part, const ControlMesh& mesh,
                                                const Surface& surface);

struct WrittenPrimitive {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::vector<int> refined{};  ///< [vertices] refined vertex of each; empty for the file's own vertices.
  std::vector<int> drawn{};    ///< [vertices] drawn vertex with its shading normal.
};

class OutPrimitives {
 public:
  /// @param weights  [V'], or [V] for writeOriginal only
  OutPrimitives(Source& source, const ControlMesh& mesh, const Surface& bind, const std::vector<FourWeights>& weights,
                OutSkins& skins);

  /// Replaces all attributes and indices in a copy of the part's JSON. No vertices if no triangle is left.
  WrittenPrimitive writeRefined(const gltf::SoupPart& part, GltfRewrite& rewrite, Json& primitive,
                                std::set<std::string>& left);
  /// Replaces positions, normals, weights and values that are not finite; keeps the other accessors.
  WrittenPrimitive writeOriginal(const gltf::SoupPart& part, GltfRewrite& rewrite, Json& primitive,
                                 std::set<std::string>& left);

 private:
  void setWeights(int node, const std::vector<FourWeights>& weights, GltfRewrite& rewrite, Json& attributes);
  void repair(const std::string& place, GltfRewrite& rewrite, Json& attributes, std::set<std::string>& left);
  [[nodiscard]] std::vector<glm::vec3> fileNormals(const gltf::SoupPart& part, const Json& attributes,
                                                   std::size_t count) const;
  [[nodiscard]] FourWeights anyWeights(int node) const;
  [[nodiscard]] std::vector<int> controlVertices(const gltf::SoupPart& part, std::size_t count) const;

  Source& source_;
  const ControlMesh& mesh_;
  const Surface& bind_;
  const std::vector<FourWeights>& weights_;
  OutSkins& skins_;
};

}  // namespace sinew::exporting
