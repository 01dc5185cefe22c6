// core/files/export/out_primitive.cpp: positions, normals, tangents, weights and indices as accessors.
#include "core/files/export/out_primitive.h"

#include <algorithm>
#include <array>
#include <limits>

#include <glm/geometric.hpp>

#include "core/files/export/into_mesh.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

const char* vectorType(int components) {
  static constexpr std::array kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
  return kTypes[toIndex(components - 1)];
}

/// glTF has one byte for a joint where that is enough, else two.
template <class Number>
int addJoints(GltfRewrite& rewrite, const std::vector<std::array<int, kMostWeights>>& joints, int componentType) {
  std::vector<Number> numbers;
  for (const auto& four : joints) {
    for (const int joint : four) numbers.push_back(static_cast<Number>(joint));
  }
  return rewrite.addAccessor({bytesOf(numbers), componentType, "VEC4", joints.size(), TINYGLTF_TARGET_ARRAY_BUFFER});
}

int addIndices(GltfRewrite& rewrite, const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t vertices) {
  const std::size_t count = 3 * triangles.size();
  if (vertices > std::numeric_limits<std::uint16_t>::max()) {
    return rewrite.addAccessor({bytesOf(triangles), TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, "SCALAR", count,
                                TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER});
  }
  std::vector<std::uint16_t> indices;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t corner : triangle) indices.push_back(static_cast<std::uint16_t>(corner));
  }
  return rewrite.addAccessor({bytesOf(indices), TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, "SCALAR", count,
                              TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER});
}

/// Upright on the normals, unit; the fourth number stays.
void straighten(const std::vector<glm::vec3>& normals, std::vector<float>& tangents) {
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const glm::vec3 tangent(tangents[4 * v], tangents[4 * v + 1], tangents[4 * v + 2]);
    const glm::vec3& n = normals[v];
    const glm::vec3 other = std::abs(n.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
    const glm::vec3 upright = normalizeOr(tangent - glm::dot(tangent, n) * n, glm::normalize(glm::cross(n, other)));
    for (int axis = 0; axis < 3; ++axis) tangents[4 * v + toIndex(axis)] = upright[axis];
  }
}

}  // namespace

OutPrimitives::OutPrimitives(Source& source, const ControlMesh& mesh, const Surface& bind,
                             const std::vector<FourWeights>& weights, OutSkins& skins)
    : source_(source), mesh_(mesh), bind_(bind), weights_(weights), skins_(skins) {}

void OutPrimitives::setWeights(int node, const std::vector<FourWeights>& weights, GltfRewrite& rewrite,
                               Json& attributes) {
  std::vector<std::array<int, kMostWeights>> joints;
  std::vector<std::array<float, kMostWeights>> shares;
  int largest = 0;
  for (const FourWeights& own : weights) {
    std::array<int, kMostWeights> four{};
    for (std::size_t i = 0; i < kMostWeights && own.binding[i] >= 0; ++i) {
      four[i] = skins_.jointOf(node, own.binding[i]);
      largest = std::max(largest, four[i]);
    }
    joints.push_back(four);
    shares.push_back(own.weight);
  }
  const bool narrow = largest <= std::numeric_limits<std::uint8_t>::max();
  attributes.set("JOINTS_0", narrow
                                 ? addJoints<std::uint8_t>(rewrite, joints, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
                                 : addJoints<std::uint16_t>(rewrite, joints, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT));
  attributes.set("WEIGHTS_0", rewrite.addAttribute(shares, "VEC4"));
}

WrittenPrimitive OutPrimitives::writeRefined(const gltf::SoupPart& part, GltfRewrite& rewrite, Json& primitive,
                                             std::set<std::string>& left) {
  RefinedPrimitive refined = refinedPrimitive(source_, part, mesh_, bind_);
  if (refined.triangles.empty()) return {};
  const IntoMesh into(skins_.meshToBind(part.node));
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<FourWeights> weights;
  for (std::size_t v = 0; v < refined.refined.size(); ++v) {
    positions.push_back(into.point(at(bind_.positions, refined.refined[v])));
    normals.push_back(into.normal(shadingNormal(bind_, toIndex(refined.drawn[v]))));
    weights.push_back(at(weights_, refined.refined[v]));
  }
  if (into.mirrors()) {
    for (auto& triangle : refined.triangles) std::swap(triangle[1], triangle[2]);
  }
  for (const Json& attribute : primitive.at("attributes").children) {
    if (attribute.key.starts_with('_'))
      left.insert("vertex attribute " + attribute.key + ": it has no meaning between vertices");
  }
  Json attributes = Json::object();
  attributes.set("POSITION", rewrite.addAttribute(positions, "VEC3", boundsOf(positions)));
  attributes.set("NORMAL", rewrite.addAttribute(normals, "VEC3"));
  for (VertexAttribute& attribute : refined.attributes) {
    if (attribute.name == "TANGENT") straighten(normals, attribute.values);
    attributes.set(attribute.name, rewrite.addAccessor({bytesOf(attribute.values), TINYGLTF_COMPONENT_TYPE_FLOAT,
                                                        vectorType(attribute.components), positions.size(),
                                                        TINYGLTF_TARGET_ARRAY_BUFFER}));
  }
  setWeights(part.node, weights, rewrite, attributes);
  primitive.set("attributes", std::move(attributes));
  primitive.set("indices", addIndices(rewrite, refined.triangles, positions.size()));
  for (const char* gone : {"mode", "targets"}) removeMember(primitive, gone);
  return {positions.size(), refined.triangles.size(), std::move(refined.refined), std::move(refined.drawn)};
}

}  // namespace sinew::exporting
