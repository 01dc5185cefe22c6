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

PrimitiveCounts OutPrimitives::writeOriginal(const gltf::SoupPart& part, GltfRewrite& rewrite, Json& primitive) {
  const auto& from = at(at(source_.file.model().meshes, part.mesh).primitives, part.primitive).attributes;
  std::vector<glm::vec3> positions =
      readVectors(source_.accessors.open(from.at("POSITION"), "meshes", TINYGLTF_TYPE_VEC3));
  const glm::dmat4 binds = at(source_.bound.meshes, part.node)->meshToBind;
  const glm::dmat4& toBind = skins_.meshToBind(part.node);
  const std::vector<int> control = controlVertices(part, positions.size());
  Json& attributes = *memberOf(primitive, "attributes");
  const Json* normal = attributes.find("NORMAL");
  std::vector<glm::vec3> normals;
  if (normal) {
    normals = readVectors(source_.accessors.open(static_cast<int>(normal->number(-1.0)), "meshes", TINYGLTF_TYPE_VEC3));
    normals.resize(positions.size());
  }
  const bool moves = binds != toBind;  // A mesh that had no skin lies elsewhere in its new one.
  const glm::dmat4 placed = glm::inverse(toBind) * binds;
  const glm::dmat3 intoMesh(glm::inverse(toBind));
  const glm::dmat3 normalIntoMesh = glm::transpose(glm::dmat3(toBind));
  const glm::dmat3 normalPlaced = glm::transpose(glm::inverse(glm::dmat3(placed)));
  std::vector<FourWeights> weights;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (moves) {
      positions[v] = glm::vec3(placed * glm::dvec4(glm::dvec3(positions[v]), 1.0));
      if (normal) normals[v] = normalizeOr(glm::vec3(normalPlaced * glm::dvec3(normals[v])), normals[v]);
    }
    if (control[v] < 0) {
      const int any = at(source_.bound.meshes, part.node)->rigid;
      const auto& joints = source_.bound.jointBindings;
      const int skin = at(source_.bound.meshes, part.node)->skin;
      weights.push_back({{skin < 0 ? any : at(joints, skin).front(), -1, -1, -1}, {1.0f}});
      continue;
    }
    const std::size_t c = toIndex(control[v]);
    weights.push_back(weights_[c]);
    if (bind_.displacement[c] != 0.0f) {
      positions[v] += glm::vec3(intoMesh * glm::dvec3(bind_.positions[c] - mesh_.positions[c]));
    }
    const glm::vec3 turn = bind_.normals[c] - mesh_.normals[c];
    if (normal && glm::length(turn) > kSameNormal) {
      const glm::dvec3 world = glm::normalize(glm::inverse(normalIntoMesh) * glm::dvec3(normals[v]));
      normals[v] = normalizeOr(glm::vec3(glm::normalize(normalIntoMesh * (world + glm::dvec3(turn)))), normals[v]);
    }
  }
  const auto add = [&](const std::vector<glm::vec3>& values, std::optional<Bounds> bounds) {
    return rewrite.addAccessor({bytesOf(values), TINYGLTF_COMPONENT_TYPE_FLOAT, "VEC3", values.size(),
                                TINYGLTF_TARGET_ARRAY_BUFFER, std::move(bounds)});
  };
  attributes.set("POSITION", add(positions, boundsOf(positions)));
  if (normal) attributes.set("NORMAL", add(normals, {}));
  std::erase_if(attributes.children, [](const Json& attribute) {
    return attribute.key.starts_with("JOINTS_") || attribute.key.starts_with("WEIGHTS_");
  });
  setWeights(part.node, weights, rewrite, attributes);
  return {positions.size(), part.endTriangle - part.firstTriangle};
}

}  // namespace sinew::exporting
