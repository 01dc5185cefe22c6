// core/files/export/out_primitive.h: the primitives of the exported file: accessors made, JSON pointed at them.
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
#include "core/files/fit/four_weights.h"
#include "core/files/gltf/node_tree.h"
#include "sinew/geometry/geometry.h"
#include "sinew/surface/surface.h"

namespace sinew::exporting {

// From the bind pose into the space that a file's vertices are in.

/// World in the bind pose -> a skin's mesh space.
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

// One primitive of the file as refined: vertices split where the file splits
// them.

/// Floats per vertex that are interpolated over the file's triangles.
struct VertexAttribute {
  std::string name;  ///< TEXCOORD_n, COLOR_n or TANGENT.
  int components = 0;
  std::vector<float> values;  ///< [vertices * components]
};

struct RefinedPrimitive {
  std::vector<int> refined;  ///< [n] refined vertex that each vertex shows.
  std::vector<int> drawn;    ///< [n] drawn vertex whose shading normal it has.
  std::vector<VertexAttribute> attributes;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< As the soup winds them.
};

/// The part's triangles, split as the surface's refinement says. Two vertices are one where they show the same drawn
/// vertex and the file's texture coordinates, colors and tangents agree at the corners they lie between. Throws
/// gltf::Refusal where an attribute cannot be read.
[[nodiscard]] RefinedPrimitive refinedPrimitive(Source& source, const gltf::SoupPart& part, const ControlMesh& mesh,
                                                const Surface& surface);

struct WrittenPrimitive {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::vector<int> refined{};  ///< As RefinedPrimitive has them; empty for the file's own vertices.
  std::vector<int> drawn{};
};

class OutPrimitives {
 public:
  /// @param weights  [V'], or [V] where only writeOriginal is asked for
  OutPrimitives(Source& source, const ControlMesh& mesh, const Surface& bind, const std::vector<FourWeights>& weights,
                OutSkins& skins);

  /// Exchanges all attributes and indices of a copy of the part's JSON. Without vertices where no triangle is left.
  WrittenPrimitive writeRefined(const gltf::SoupPart& part, GltfRewrite& rewrite, Json& primitive,
                                std::set<std::string>& left);
  /// Exchanges positions, normals, weights, and what is not finite; all else stays the accessors it is.
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
