// core/files/usd/meshes.h: the triangles of a glTF file, primitive by primitive, as USD keeps meshes.
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

/// A morph target of one primitive. Only the points that it moves or turns.
struct BlendShape {
  std::vector<int> points;               ///< Ascending.
  std::vector<glm::vec3> offsets;        ///< [points]
  std::vector<glm::vec3> normalOffsets;  ///< [points], or none.
};

/// One primitive of a mesh, for one node that shows it. Vertices in the file's order.
struct Mesh {
  std::string name;
  int material = -1;  ///< Index in the file; -1: none.
  glm::dmat4 meshToBind{1.0};
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> normals;  ///< Or none.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<glm::vec2>> uvs;  ///< [sets], v upwards.
  std::vector<glm::vec4> colors;            ///< Linear, or none.
  int influences = 0;                       ///< Per vertex, those of weight 0 too.
  std::vector<int> bindings;                ///< [vertices * influences] of the skeleton.
  std::vector<float> weights;               ///< Likewise; the sum is 1.
  int node = 0;                             ///< The file's node that shows it.
  std::vector<BlendShape> shapes;           ///< Morph targets, in the file's order.
};

/// All triangles of the scene, node by node. Throws gltf::Refusal where attributes cannot be read.
/// @param root  the same file's JSON  @param left  what .usda does not hold is added
[[nodiscard]] std::vector<Mesh> meshesOf(const gltf::File& file, const Json& root, const gltf::NodeTree& tree,
                                         const gltf::BoundSkeleton& bound, gltf::Accessors& accessors,
                                         std::set<std::string>& left);

/// "primvars:st" for TEXCOORD_0, "primvars:st1" ...
[[nodiscard]] std::string uvName(std::size_t set);

/// What does not change over time, of a mesh prim that is open: faces, texture coordinates, colors.
/// @param factor  the material's color, which vertex colors are multiplied with
void writeTopology(const Mesh& mesh, const glm::vec4& factor, bool doubleSided, Text& text);

/// Their box, as `extent` holds it.
[[nodiscard]] std::string extentText(const std::vector<glm::vec3>& points);

/// Metadata of arrays that have a value for every vertex.
[[nodiscard]] inline std::vector<std::string> perVertex() { return {"interpolation = \"vertex\""}; }

}  // namespace sinew::usd
