// core/files/export/original_primitive.cpp: the file's own vertices, moved by muscles at rest, with other weights.
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/files/export/into_mesh.h"
#include "core/files/export/out_primitive.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

std::string notFinite(const std::string& attribute) {
  return attribute + ": values that are not finite, which glTF does not allow; others stand for them";
}
/// Turns of normals smaller than this are rounding: the file's normal stays, bit for bit.
constexpr float kSameNormal = 1e-4f;

std::vector<glm::vec3> pointsOf(const std::vector<float>& values) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) points.emplace_back(values[i], values[i + 1], values[i + 2]);
  return points;
}

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z); }

/// What stands for an element that is not finite: white, as the import shows it, some unit tangent, or 0.
float replacement(const std::string& attribute, int component) {
  if (attribute == "TANGENT") return component == 0 || component == 3 ? 1.0f : 0.0f;
  return attribute.starts_with("COLOR_") ? 1.0f : 0.0f;
}

/// All values of an attribute, those replaced that are not finite; nothing where none is.
std::optional<std::vector<float>> replaceNonFinite(const gltf::Accessor& accessor, const std::string& attribute) {
  std::vector<float> values;
  bool isSound = true;
  for (std::size_t v = 0; v < accessor.count(); ++v) {
    bool isWhole = true;
    for (int c = 0; c < accessor.components(); ++c) {
      values.push_back(static_cast<float>(accessor.number(v, c)));
      isWhole = isWhole && std::isfinite(values.back());
    }
    isSound = isSound && isWhole;
    for (int c = 0; !isWhole && c < accessor.components(); ++c) {
      values[values.size() - toIndex(accessor.components() - c)] = replacement(attribute, c);
    }
  }
  return isSound ? std::nullopt : std::optional(std::move(values));
}

}  // namespace

/// Attributes that are still the file's stay what they are there, but for values that are not finite: glTF allows none.
void OutPrimitives::repair(const std::string& place, GltfRewrite& rewrite, Json& attributes,
                           std::set<std::string>& left) {
  const std::vector<tinygltf::Accessor>& accessors = source_.file.model().accessors;
  for (const Json& attribute : std::vector<Json>(attributes.children)) {
    const double index = attribute.number(-1.0);
    if (!(index >= 0.0 && index < static_cast<double>(accessors.size()))) continue;
    const tinygltf::Accessor& from = at(accessors, static_cast<int>(index));
    if (from.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) continue;
    const std::string own = place + '.' + attribute.key;
    const std::optional<std::vector<float>> values =
        replaceNonFinite(source_.accessors.open(static_cast<int>(index), own, from.type), attribute.key);
    if (!values) continue;
    std::optional<Bounds> bounds;
    if (attribute.key == "POSITION") bounds = boundsOf(pointsOf(*values));  // A morph target's.
    const std::string type = at(source_.root.at("accessors").items(), static_cast<int>(index)).at("type").text("");
    const int added = rewrite.addAccessor(
        {bytesOf(*values), TINYGLTF_COMPONENT_TYPE_FLOAT, type, from.count, TINYGLTF_TARGET_ARRAY_BUFFER, bounds});
    attributes.set(attribute.key, added);
    left.insert(notFinite(attribute.key));
  }
}

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
  const gltf::Accessor& accessor = source_.accessors.open(*normal, place, TINYGLTF_TYPE_VEC3);
  if (accessor.count() != count) gltf::refuse(place, "not as many values as positions");
  return gltf::vectorsOf<glm::vec3>(accessor);
}

/// What a vertex follows that no triangle uses.
FourWeights OutPrimitives::anyWeights(int node) const {
  const gltf::MeshBinding& binding = *at(source_.bound.meshes, node);
  const int first = binding.skin < 0 ? binding.rigid : at(source_.bound.jointBindings, binding.skin).front();
  return {{first, -1, -1, -1}, {1.0f}};
}

WrittenPrimitive OutPrimitives::writeOriginal(const gltf::SoupPart& part, GltfRewrite& rewrite, Json& primitive,
                                              std::set<std::string>& left) {
  const auto& from = at(at(source_.file.model().meshes, part.mesh).primitives, part.primitive).attributes;
  std::vector<glm::vec3> positions =
      gltf::vectorsOf<glm::vec3>(source_.accessors.open(from.at("POSITION"), "meshes", TINYGLTF_TYPE_VEC3));
  Json& attributes = *memberOf(primitive, "attributes");
  std::vector<glm::vec3> normals = fileNormals(part, attributes, positions.size());
  const std::vector<int> control = controlVertices(part, positions.size());
  const IntoMesh into(skins_.meshToBind(part.node));
  const glm::dmat3 toBind(skins_.meshToBind(part.node));
  const glm::dmat3 intoMesh = glm::inverse(toBind);
  std::vector<FourWeights> weights;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!normals.empty() && !isFinite(normals[v])) {
      normals[v] = control[v] < 0 ? glm::vec3(0.0f, 0.0f, 1.0f) : into.normal(at(mesh_.normals, control[v]));
      left.insert(notFinite("NORMAL"));
    }
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
  attributes.set("POSITION", rewrite.addAttribute(positions, "VEC3", boundsOf(positions)));
  if (!normals.empty()) attributes.set("NORMAL", rewrite.addAttribute(normals, "VEC3"));
  std::erase_if(attributes.children, [](const Json& attribute) {
    return attribute.key.starts_with("JOINTS_") || attribute.key.starts_with("WEIGHTS_");
  });
  setWeights(part.node, weights, rewrite, attributes);
  const std::string place =
      gltf::placeOf(gltf::placeOf("meshes", toIndex(part.mesh)) + ".primitives", toIndex(part.primitive));
  repair(place + ".attributes", rewrite, attributes, left);
  if (Json* targets = memberOf(primitive, "targets")) {
    for (Json& target : targets->children) repair(place + ".targets", rewrite, target, left);
  }
  return {positions.size(), part.endTriangle - part.firstTriangle};
}

}  // namespace sinew::exporting
