// core/export/original_primitive.cpp: the file's own vertices, moved by muscles at rest, with other weights.
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/at.h"
#include "core/export/out_primitive.h"

namespace sinew::exporting {
namespace {

/// Turns of normals smaller than this are rounding: the file's normal stays, bit for bit.
constexpr float kSameNormal = 1e-4f;

std::vector<glm::vec3> readVectors(const gltf::Accessor& accessor) {
  std::vector<glm::vec3> values(accessor.count());
  for (std::size_t v = 0; v < values.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) values[v][axis] = static_cast<float>(accessor.number(v, axis));
  }
  return values;
}

std::string_view bytesOf(const std::vector<glm::vec3>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(glm::vec3)};
}

}  // namespace

/// [file vertices] control vertex, or -1 for what no triangle of the mesh uses.
std::vector<int> OutPrimitives::controlVertices(const gltf::SoupPart& part, std::size_t count) const {
  std::vector<int> result(count, -1);
  for (std::size_t t = part.firstTriangle; t < part.endTriangle; ++t) {
    if (source_.controlTriangle[t] < 0) continue;
    const auto& corners = at(mesh_.triangles, source_.controlTriangle[t]).vertices;
    for (std::size_t i = 0; i < 3; ++i) {
      result[source_.origin.fileVertex[source_.soup.triangles[t][i]]] = corners[i];
    }
  }
  return result;
}

/// The file's normals; empty where it has none.
std::vector<glm::vec3> OutPrimitives::fileNormals(const gltf::SoupPart& part, const Json& attributes,
                                                  std::size_t count) const {
  const Json* normal = attributes.find("NORMAL");
  if (!normal) return {};
  const std::string place = gltf::placeOf("meshes", toIndex(part.mesh)) + ".primitives.attributes.NORMAL";
  const double index = normal->number(-1.0);
  if (!(index >= 0.0 && index < static_cast<double>(source_.file.model().accessors.size()))) {
    gltf::refuse(place, "there is no such accessor");
  }
  const gltf::Accessor& accessor = source_.accessors.open(static_cast<int>(index), place, TINYGLTF_TYPE_VEC3);
  if (accessor.count() != count) gltf::refuse(place, "not as many values as positions");
  return readVectors(accessor);
}

/// What a vertex follows that no triangle uses.
FourWeights OutPrimitives::anyWeights(int node) const {
  const gltf::MeshBinding& binding = *at(source_.bound.meshes, node);
  const int first = binding.skin < 0 ? binding.rigid : at(source_.bound.jointBindings, binding.skin).front();
  return {{first, -1, -1, -1}, {1.0f}};
}

WrittenPrimitive OutPrimitives::writeOriginal(const gltf::SoupPart& part, GltfRewrite& rewrite, Json& primitive) {
  const auto& from = at(at(source_.file.model().meshes, part.mesh).primitives, part.primitive).attributes;
  std::vector<glm::vec3> positions =
      readVectors(source_.accessors.open(from.at("POSITION"), "meshes", TINYGLTF_TYPE_VEC3));
  Json& attributes = *memberOf(primitive, "attributes");
  std::vector<glm::vec3> normals = fileNormals(part, attributes, positions.size());
  const std::vector<int> control = controlVertices(part, positions.size());
  const glm::dmat3 toBind(skins_.meshToBind(part.node));
  const glm::dmat3 intoMesh = glm::inverse(toBind);
  std::vector<FourWeights> weights;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (control[v] < 0) {
      weights.push_back(anyWeights(part.node));
      continue;
    }
    const std::size_t c = toIndex(control[v]);
    weights.push_back(weights_[c]);
    if (bind_.displacement[c] != 0.0f) {
      positions[v] += glm::vec3(intoMesh * glm::dvec3(bind_.positions[c] - mesh_.positions[c]));
    }
    const glm::vec3 turn = bind_.normals[c] - mesh_.normals[c];
    if (normals.empty() || glm::length(turn) <= kSameNormal) continue;
    const glm::dvec3 world = glm::normalize(glm::transpose(intoMesh) * glm::dvec3(normals[v]));
    normals[v] =
        normalizeOr(glm::vec3(glm::normalize(glm::transpose(toBind) * (world + glm::dvec3(turn)))), normals[v]);
  }
  const auto add = [&](const std::vector<glm::vec3>& values, std::optional<Bounds> bounds) {
    return rewrite.addAccessor({bytesOf(values), TINYGLTF_COMPONENT_TYPE_FLOAT, "VEC3", values.size(),
                                TINYGLTF_TARGET_ARRAY_BUFFER, std::move(bounds)});
  };
  attributes.set("POSITION", add(positions, boundsOf(positions)));
  if (!normals.empty()) attributes.set("NORMAL", add(normals, {}));
  std::erase_if(attributes.children, [](const Json& attribute) {
    return attribute.key.starts_with("JOINTS_") || attribute.key.starts_with("WEIGHTS_");
  });
  setWeights(part.node, weights, rewrite, attributes);
  return {positions.size(), part.endTriangle - part.firstTriangle};
}

}  // namespace sinew::exporting
