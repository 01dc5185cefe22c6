// core/files/usd/meshes.h: the primitives of a glTF file as USD meshes.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "core/files/gltf/skin.h"
#include "core/files/json/json.h"
#include "core/files/usd/text.h"

namespace sinew::usd {

/// A morph target of one primitive, sparse.
struct BlendShape {
  std::vector<int> points;               ///< Ascending.
  std::vector<glm::vec3> offsets;        ///< [points]
  std::vector<glm::vec3> normalOffsets;  ///< [points], or none.
};

/// A primitive of a node's mesh. Vertices are in the file's order.
struct Mesh {
  std::string name;
  int material = -1;  ///< Index in the file; -1: none.
  glm::dmat4 meshToBind{1.0};
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> normals;  ///< Or none.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<glm::vec2>> uvs;  ///< [sets], v upwards.
  std::vector<glm::vec4> colors;            ///< Linear, or none.
  int influences = 0;                       ///< Per vertex, including weights of 0.
  std::vector<int> bindings;                ///< [vertices * influences] of the skeleton.
  std::vector<float> weights;               ///< Likewise; the sum is 1.
  int node = 0;                             ///< Of the file.
  std::vector<BlendShape> shapes;           ///< Morph targets, in the file's order.
};

/// All triangles of the scene by node. Throws gltf::Refusal for bad attributes. @param left  what .usda cannot hold
[[nodiscard]] std::vector<Mesh> meshesOf(const gltf::File& file, const Json& root, const gltf::NodeTree& tree,
                                         const gltf::BoundSkeleton& bound, gltf::Accessors& accessors,
                                         std::set<std::string>& left);

[[nodiscard]] std::string uvName(std::size_t set);  ///< "primvars:st" for TEXCOORD_0, "primvars:st1" ...

/// Constant attributes of an open mesh prim: faces, uvs, colors. @param factor  the material's, times vertex colors
void writeTopology(const Mesh& mesh, const glm::vec4& factor, bool doubleSided, Text& text);

[[nodiscard]] std::string extentText(const std::vector<glm::vec3>& points);  ///< Bounding box for `extent`.

/// Metadata of arrays with a value per vertex.
[[nodiscard]] inline std::vector<std::string> perVertex() { return {"interpolation = \"vertex\""}; }

}  // namespace sinew::usd
