// core/files/usd/meshes.cpp: accessors -> meshes -> text.
#include "core/files/usd/meshes.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "core/files/gltf/mesh.h"
#include "core/geometry/at.h"

namespace sinew::usd {
namespace {

constexpr std::size_t kMeshesMostVertices = 200'000'000;  ///< Limit of vertices of a primitive.
constexpr std::size_t kFour = 4;

class MeshReader {
 public:
  MeshReader(const gltf::BoundSkeleton& bound, gltf::Accessors& accessors) : bound_(bound), accessors_(accessors) {}

  /// May have no triangles. @param attributes  in the file's JSON, since the import reads no normals
  Mesh read(const tinygltf::Primitive& primitive, const Json& attributes, const std::string& place,
            const gltf::MeshBinding& binding) {
    Mesh mesh;
    mesh.material = primitive.material;
    mesh.meshToBind = binding.meshToBind;
    attributes_ = &attributes;
    if (!has("POSITION")) return mesh;
    place_ = place + ".attributes.";
    mesh.points = gltf::vectorsOf<glm::vec3>(open("POSITION", TINYGLTF_TYPE_VEC3));
    if (has("NORMAL")) mesh.normals = gltf::vectorsOf<glm::vec3>(open("NORMAL", TINYGLTF_TYPE_VEC3));
    for (std::size_t set = 0; has("TEXCOORD_" + std::to_string(set)); ++set) {
      mesh.uvs.push_back(gltf::vectorsOf<glm::vec2>(open("TEXCOORD_" + std::to_string(set), TINYGLTF_TYPE_VEC2)));
      for (glm::vec2& uv : mesh.uvs.back()) uv.y = 1.0f - uv.y;
    }
    if (has("COLOR_0")) readColors(mesh);
    expectAll(mesh.normals.empty(), mesh.normals.size(), mesh);
    for (const auto& uvs : mesh.uvs) expectAll(false, uvs.size(), mesh);
    expectAll(mesh.colors.empty(), mesh.colors.size(), mesh);
    readTriangles(primitive, place, mesh);
    readInfluences(binding, mesh);
    return mesh;
  }

  BlendShape readShape(const Json& target, const std::string& place, const Mesh& mesh) {
    attributes_ = &target;
    place_ = place + '.';
    const auto deltasOf = [&](const char* name) {
      std::vector<glm::vec3> deltas;
      if (has(name)) deltas = gltf::vectorsOf<glm::vec3>(open(name, TINYGLTF_TYPE_VEC3));
      expectAll(deltas.empty(), deltas.size(), mesh);
      return deltas;
    };
    const std::vector<glm::vec3> positions = deltasOf("POSITION");
    const std::vector<glm::vec3> normals = mesh.normals.empty() ? std::vector<glm::vec3>() : deltasOf("NORMAL");
    BlendShape shape;
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const glm::vec3 offset = positions.empty() ? glm::vec3(0.0f) : positions[v];
      const glm::vec3 turn = normals.empty() ? glm::vec3(0.0f) : normals[v];
      if (offset == glm::vec3(0.0f) && turn == glm::vec3(0.0f)) continue;
      shape.points.push_back(static_cast<int>(v));
      shape.offsets.push_back(offset);
      if (!normals.empty()) shape.normalOffsets.push_back(turn);
    }
    return shape;
  }

 private:
  [[nodiscard]] bool has(const std::string& name) const { return attributes_->find(name) != nullptr; }

  const gltf::Accessor& open(const std::string& name, int type, int orType = -1) {
    const gltf::Accessor& accessor = accessors_.open(attributes_->at(name), place_ + name, type, orType);
    if (accessor.count() > kMeshesMostVertices) gltf::refuse(accessor.place(), "too many vertices");
    return accessor;
  }

  void expectAll(bool absent, std::size_t count, const Mesh& mesh) const {
    if (absent || count == mesh.points.size()) return;
    gltf::refuse(place_, std::to_string(count) + " values for " + std::to_string(mesh.points.size()) + " positions");
  }

  void readColors(Mesh& mesh) {
    const gltf::Accessor& from = open("COLOR_0", TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4);
    mesh.colors.assign(from.count(), glm::vec4(1.0f));
    for (std::size_t i = 0; i < mesh.colors.size(); ++i) {
      for (int c = 0; c < from.components(); ++c) mesh.colors[i][c] = static_cast<float>(from.number(i, c));
    }
  }

  void readTriangles(const tinygltf::Primitive& primitive, const std::string& place, Mesh& mesh) {
    const gltf::Accessor* indices =
        primitive.indices < 0 ? nullptr : &accessors_.open(primitive.indices, place + ".indices", TINYGLTF_TYPE_SCALAR);
    // A mirrored skinned mesh would be inside out: USD uses the points in mesh space.
    const bool mirrored = glm::determinant(glm::dmat3(mesh.meshToBind)) < 0.0;
    const std::size_t corners = indices ? indices->count() : mesh.points.size();
    const std::size_t count = gltf::triangleCount(primitive.mode, corners);
    mesh.triangles.reserve(count);
    for (std::size_t t = 0; t < count; ++t) {
      std::array<std::uint32_t, 3> triangle = gltf::triangleCorners(primitive.mode, t);
      for (std::uint32_t& corner : triangle) {
        if (indices) corner = indices->integer(corner, 0);
        if (corner >= mesh.points.size()) gltf::refuse(place + ".indices", "an index beyond the vertices");
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      mesh.triangles.push_back(triangle);
    }
  }

  void readInfluences(const gltf::MeshBinding& binding, Mesh& mesh) {
    std::vector<std::pair<const gltf::Accessor*, const gltf::Accessor*>> sets;
    for (std::size_t set = 0; binding.skin >= 0; ++set) {
      const std::string joints = "JOINTS_" + std::to_string(set);
      const std::string weights = "WEIGHTS_" + std::to_string(set);
      if (!has(joints) || !has(weights)) break;
      sets.emplace_back(&open(joints, TINYGLTF_TYPE_VEC4), &open(weights, TINYGLTF_TYPE_VEC4));
      expectAll(false, sets.back().first->count(), mesh);
      expectAll(false, sets.back().second->count(), mesh);
    }
    const std::size_t width = kFour * std::max<std::size_t>(sets.size(), 1);
    const int first = binding.skin < 0 ? binding.rigid : at(bound_.jointBindings, binding.skin).front();
    mesh.influences = static_cast<int>(width);
    mesh.bindings.assign(mesh.points.size() * width, first);
    mesh.weights.assign(mesh.points.size() * width, 0.0f);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      double sum = 0.0;
      for (std::size_t i = 0; i < kFour * sets.size(); ++i) {
        const auto& [joints, weights] = sets[i / kFour];
        const auto weight = static_cast<float>(weights->number(v, static_cast<int>(i % kFour)));
        if (!(weight > 0.0f)) continue;
        mesh.bindings[v * width + i] = bindingOf(binding, *joints, v, static_cast<int>(i % kFour));
        mesh.weights[v * width + i] = weight;
        sum += static_cast<double>(weight);
      }
      setSum(sum, std::span(mesh.weights).subspan(v * width, width));
    }
  }

  int bindingOf(const gltf::MeshBinding& binding, const gltf::Accessor& joints, std::size_t vertex, int component) {
    const std::vector<int>& bindings = at(bound_.jointBindings, binding.skin);
    const std::uint32_t joint = joints.integer(vertex, component);
    if (joint >= bindings.size()) gltf::refuse(joints.place(), "a joint beyond the skin's");
    return bindings[joint];
  }

  static void setSum(double sum, std::span<float> weights) {
    constexpr double kRounded = 2e-6;  // Rounding of floats.
    if (!(sum > 0.0)) weights.front() = 1.0f;
    else if (std::abs(sum - 1.0) > kRounded) {
      for (float& weight : weights) weight = static_cast<float>(static_cast<double>(weight) / sum);
    }
  }

  const gltf::BoundSkeleton& bound_;
  gltf::Accessors& accessors_;
  const Json* attributes_ = nullptr;
  std::string place_;
};

}  // namespace

std::vector<Mesh> meshesOf(const gltf::File& file, const Json& root, const gltf::NodeTree& tree,
                           const gltf::BoundSkeleton& bound, gltf::Accessors& accessors, std::set<std::string>& left) {
  MeshReader reader(bound, accessors);
  std::vector<Mesh> meshes;
  for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
    if (!bound.meshes[node]) continue;
    const int number = tree.nodes[node].mesh;
    const std::string place = gltf::placeOf("meshes", toIndex(number));
    file.expectSound(place);
    const std::vector<tinygltf::Primitive>& primitives = at(file.model().meshes, number).primitives;
    const std::vector<Json>& list = at(root.at("meshes").items(), number).at("primitives").items();
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const std::string own = gltf::placeOf(place + ".primitives", p);
      file.expectSound(own);
      if (primitives[p].mode < TINYGLTF_MODE_TRIANGLES || primitives[p].mode > TINYGLTF_MODE_TRIANGLE_FAN) {
        left.insert("points and lines: .usda holds triangles alone");
        continue;
      }
      Mesh mesh = reader.read(primitives[p], list[p].at("attributes"), own, *bound.meshes[node]);
      if (mesh.triangles.empty()) continue;
      mesh.name = tree.nodes[node].name;
      mesh.node = static_cast<int>(node);
      const std::vector<Json>& targets = list[p].at("targets").items();
      for (std::size_t k = 0; k < targets.size(); ++k) {
        mesh.shapes.push_back(reader.readShape(targets[k], gltf::placeOf(own + ".targets", k), mesh));
      }
      meshes.push_back(std::move(mesh));
    }
  }
  return meshes;
}

std::string uvName(std::size_t set) { return set == 0 ? "st" : "st" + std::to_string(set); }

void writeTopology(const Mesh& mesh, const glm::vec4& factor, bool doubleSided, Text& text) {
  if (doubleSided) text.line("uniform bool doubleSided = 1");
  std::vector<int> indices;
  indices.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) indices.push_back(static_cast<int>(corner));
  }
  text.attribute("int[] faceVertexCounts", arrayText(std::vector<int>(mesh.triangles.size(), 3)));
  text.attribute("int[] faceVertexIndices", arrayText(indices));
  if (!mesh.colors.empty()) {
    std::vector<glm::vec3> colors;
    std::vector<float> alphas;
    for (const glm::vec4& color : mesh.colors) {
      colors.emplace_back(color * factor);
      alphas.push_back(color.a * factor.a);
    }
    text.attribute("color3f[] primvars:displayColor", arrayText(colors), perVertex());
    const auto isSolid = [](float alpha) { return alpha >= 1.0f; };
    if (!std::ranges::all_of(alphas, isSolid)) {
      text.attribute("float[] primvars:displayOpacity", arrayText(alphas), perVertex());
    }
  }
  for (std::size_t set = 0; set < mesh.uvs.size(); ++set) {
    text.attribute("texCoord2f[] primvars:" + uvName(set), arrayText(mesh.uvs[set]), perVertex());
  }
  text.line("uniform token subdivisionScheme = \"none\"");
}

std::string extentText(const std::vector<glm::vec3>& points) {
  const Bounds bounds = boundsOf(points);
  return arrayText(std::array{bounds.low, bounds.high});
}

}  // namespace sinew::usd
