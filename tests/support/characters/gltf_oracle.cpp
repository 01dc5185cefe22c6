// tests/support/characters/gltf_oracle.cpp: independent double-precision skinning of raw glTF files.

#include "tests/support/characters/gltf_oracle.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <tiny_gltf.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

namespace sinew::test {
namespace {

std::size_t asSize(int index) { return static_cast<std::size_t>(index); }

double component(const unsigned char* from, int type, bool normalized) {
  const auto load = [&]<class T>(T value, double largest) {
    std::memcpy(&value, from, sizeof value);
    return normalized ? std::max(-1.0, static_cast<double>(value) / largest) : static_cast<double>(value);
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return load(std::int8_t{}, 127.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return load(std::uint8_t{}, 255.0);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return load(std::int16_t{}, 32767.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load(std::uint16_t{}, 65535.0);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return load(std::uint32_t{}, 1.0);
    default:
      return load(float{}, 1.0);
  }
}

/// All components of an accessor, sparse entries applied.
std::vector<double> numbers(const tinygltf::Model& model, int index) {
  const tinygltf::Accessor& a = model.accessors.at(asSize(index));
  const auto width = asSize(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type)));
  const auto size = asSize(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a.componentType)));
  std::vector<double> out(a.count * width, 0.0);
  const auto bytesOf = [&](int view, std::size_t offset) {
    const tinygltf::BufferView& v = model.bufferViews.at(asSize(view));
    return model.buffers.at(asSize(v.buffer)).data.data() + v.byteOffset + offset;
  };
  const auto copy = [&](const unsigned char* from, std::size_t element) {
    for (std::size_t c = 0; c < width; ++c) {
      out[element * width + c] = component(from + c * size, a.componentType, a.normalized);
    }
  };
  if (a.bufferView >= 0) {
    const auto stride = asSize(a.ByteStride(model.bufferViews.at(asSize(a.bufferView))));
    for (std::size_t i = 0; i < a.count; ++i) copy(bytesOf(a.bufferView, a.byteOffset) + i * stride, i);
  }
  if (a.sparse.isSparse) {
    const auto& sparse = a.sparse;
    const auto indexSize =
        asSize(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(sparse.indices.componentType)));
    for (std::size_t i = 0; i < asSize(sparse.count); ++i) {
      const unsigned char* where =
          bytesOf(sparse.indices.bufferView, asSize(sparse.indices.byteOffset)) + i * indexSize;
      const auto element = static_cast<std::size_t>(component(where, sparse.indices.componentType, false));
      copy(bytesOf(sparse.values.bufferView, asSize(sparse.values.byteOffset)) + i * width * size, element);
    }
  }
  return out;
}

struct Local {
  glm::dvec3 translation{0.0};
  glm::dvec4 rotation{0.0, 0.0, 0.0, 1.0};
  glm::dvec3 scale{1.0};
  std::optional<glm::dmat4> matrix;

  glm::dmat4 toMatrix() const {
    if (matrix) return *matrix;
    const glm::dvec4 r = rotation / glm::length(rotation);
    return glm::scale(glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(glm::dquat(r.w, r.x, r.y, r.z)),
                      scale);
  }
};

/// Spherical interpolation on the shorter arc.
glm::dvec4 slerp(glm::dvec4 a, glm::dvec4 b, double t) {
  a /= glm::length(a);
  b /= glm::length(b);
  double cosine = glm::dot(a, b);
  if (cosine < 0.0) {
    b = -b;
    cosine = -cosine;
  }
  const double angle = std::acos(std::min(cosine, 1.0));
  if (angle < 1e-9) return a;
  return (std::sin((1.0 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle);
}

/// Morph weights of a node at a time of a clip; of the node or its mesh if they are not animated.
std::vector<double> morphWeights(const tinygltf::Model& model, int node, std::optional<std::size_t> clip, double time) {
  const tinygltf::Node& shown = model.nodes.at(asSize(node));
  const tinygltf::Mesh& mesh = model.meshes.at(asSize(shown.mesh));
  std::vector<double> weights = mesh.weights;
  if (!shown.weights.empty()) weights = shown.weights;
  weights.resize(mesh.primitives.front().targets.size(), 0.0);
  if (!clip || weights.empty()) return weights;
  const tinygltf::Animation& animation = model.animations.at(*clip);
  for (const tinygltf::AnimationChannel& channel : animation.channels) {
    if (channel.target_path != "weights" || channel.target_node != node) continue;
    const tinygltf::AnimationSampler& sampler = animation.samplers.at(asSize(channel.sampler));
    const std::vector<double> times = numbers(model, sampler.input);
    const std::vector<double> values = numbers(model, sampler.output);
    const std::size_t count = weights.size();
    const bool cubic = sampler.interpolation == "CUBICSPLINE";
    EXPECT_EQ(values.size(), times.size() * count * (cubic ? 3 : 1));
    // glTF 2.0, 3.11: of each key all in-tangents, then all values, then all out-tangents.
    const auto part = [&](std::size_t key, std::size_t k, std::size_t which) {
      return cubic ? values.at((3 * key + which) * count + k) : values.at(key * count + k);
    };
    const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
    const std::size_t next = std::min(after, times.size() - 1);
    const std::size_t key = after == 0 ? 0 : after - 1;
    const double span = times[next] - times[key];
    const double t = span > 0.0 && sampler.interpolation != "STEP" ? (time - times[key]) / span : 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const double a = part(key, k, 1);
      const double b = part(next, k, 1);
      weights[k] = a + (b - a) * t;
      if (!cubic) continue;
      const double u = 1.0 - t;  // The same polynomial as appendix C's, by Bernstein.
      const double first = a + span * part(key, k, 2) / 3.0;
      const double second = b - span * part(next, k, 0) / 3.0;
      weights[k] = u * u * u * a + 3 * u * u * t * first + 3 * u * t * t * second + t * t * t * b;
    }
  }
  return weights;
}

/// Value of a sampler at a time (glTF 2.0, appendix C).
glm::dvec4 sample(const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler, bool rotation, double time) {
  const std::vector<double> times = numbers(model, sampler.input);
  const std::vector<double> values = numbers(model, sampler.output);
  const std::size_t width = rotation ? 4 : 3;
  const bool cubic = sampler.interpolation == "CUBICSPLINE";
  const auto value = [&](std::size_t key, std::size_t part) {  // part: 0 in-tangent, 1 value, 2 out-tangent
    glm::dvec4 v(0.0);
    const std::size_t element = cubic ? 3 * key + part : key;
    for (std::size_t c = 0; c < width; ++c) v[static_cast<int>(c)] = values[element * width + c];
    return v;
  };
  if (time <= times.front()) return value(0, 1);
  if (time >= times.back()) return value(times.size() - 1, 1);
  const auto next = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  const std::size_t key = next - 1;
  const double span = times[next] - times[key];
  const double t = (time - times[key]) / span;
  if (sampler.interpolation == "STEP") return value(key, 1);
  if (cubic) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * value(key, 1) + span * (t3 - 2 * t2 + t) * value(key, 2) +
           (3 * t2 - 2 * t3) * value(next, 1) + span * (t3 - t2) * value(next, 0);
  }
  return rotation ? slerp(value(key, 1), value(next, 1), t) : (1.0 - t) * value(key, 1) + t * value(next, 1);
}

}  // namespace

struct GltfOracle::Impl {
  tinygltf::Model model;
  std::vector<int> parents;

  std::vector<glm::dmat4> worlds(std::optional<std::size_t> clip, double time) const {
    std::vector<Local> locals;
    for (const tinygltf::Node& node : model.nodes) {
      Local local;
      for (int i = 0; i < 3 && !node.translation.empty(); ++i) local.translation[i] = node.translation[asSize(i)];
      for (int i = 0; i < 4 && !node.rotation.empty(); ++i) local.rotation[i] = node.rotation[asSize(i)];
      for (int i = 0; i < 3 && !node.scale.empty(); ++i) local.scale[i] = node.scale[asSize(i)];
      if (!node.matrix.empty()) {
        local.matrix.emplace(1.0);
        for (int i = 0; i < 16; ++i) (*local.matrix)[i / 4][i % 4] = node.matrix[asSize(i)];
      }
      locals.push_back(local);
    }
    if (clip) animate(model.animations.at(*clip), time, locals);
    std::vector<glm::dmat4> result;
    for (std::size_t node = 0; node < locals.size(); ++node) {
      glm::dmat4 world = locals[node].toMatrix();
      for (int p = parents[node]; p >= 0; p = parents[asSize(p)]) world = locals[asSize(p)].toMatrix() * world;
      result.push_back(world);
    }
    return result;
  }

  template <class Add>
  std::vector<RawTriangle> collected(std::optional<std::size_t> clip, double time, Add add) const;

  void animate(const tinygltf::Animation& animation, double time, std::vector<Local>& locals) const {
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      if (channel.target_path == "weights") continue;
      const bool rotation = channel.target_path == "rotation";
      const glm::dvec4 v = sample(model, animation.samplers.at(asSize(channel.sampler)), rotation, time);
      Local& local = locals.at(asSize(channel.target_node));
      if (rotation) local.rotation = v;
      else if (channel.target_path == "scale") local.scale = glm::dvec3(v);
      else local.translation = glm::dvec3(v);
    }
  }

  /// Skinning matrices of a node's skin; empty without one.
  std::vector<glm::dmat4> jointMatrices(const tinygltf::Node& node, const std::vector<glm::dmat4>& world) const {
    std::vector<glm::dmat4> result;
    if (node.skin < 0) return result;
    const tinygltf::Skin& skin = model.skins.at(asSize(node.skin));
    const std::vector<double> binds =
        skin.inverseBindMatrices < 0 ? std::vector<double>{} : numbers(model, skin.inverseBindMatrices);
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      glm::dmat4 inverseBind(1.0);
      for (int i = 0; i < 16 && !binds.empty(); ++i) inverseBind[i / 4][i % 4] = binds[16 * j + asSize(i)];
      result.push_back(world[asSize(skin.joints[j])] * inverseBind);
    }
    return result;
  }

  /// glTF: targets move vertices before joints do.
  std::vector<double> morphed(const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                              const std::string& attribute = "POSITION") const {
    std::vector<double> positions = numbers(model, primitive.attributes.at(attribute));
    EXPECT_TRUE(primitive.targets.empty() || primitive.targets.size() == weights.size());
    for (std::size_t k = 0; k < primitive.targets.size(); ++k) {
      const auto target = primitive.targets[k].find(attribute);
      if (target == primitive.targets[k].end()) continue;
      const std::vector<double> deltas = numbers(model, target->second);
      EXPECT_EQ(deltas.size(), positions.size());
      for (std::size_t i = 0; i < positions.size(); ++i) positions[i] += weights.at(k) * deltas.at(i);
    }
    return positions;
  }

  void addPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& world,
                    const std::vector<glm::dmat4>& joints, const std::vector<double>& weights,
                    std::vector<RawTriangle>& out) const {
    const std::vector<double> positions = morphed(primitive, weights);
    const std::vector<glm::dmat4> matrices = blended(primitive, world, joints);
    std::vector<glm::dvec3> vertices;
    for (std::size_t v = 0; v < matrices.size(); ++v) {
      vertices.emplace_back(matrices[v] *
                            glm::dvec4(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2], 1.0));
    }
    addTriangles(primitive, vertices, out);
  }

  void addNormals(const tinygltf::Primitive& primitive, const glm::dmat4& world, const std::vector<glm::dmat4>& joints,
                  const std::vector<double>& weights, bool isMorphed, std::vector<RawTriangle>& out) const {
    const std::vector<double> own =
        isMorphed ? morphed(primitive, weights, "NORMAL") : numbers(model, primitive.attributes.at("NORMAL"));
    const std::vector<glm::dmat4> matrices = blended(primitive, world, joints);
    std::vector<glm::dvec3> normals;
    for (std::size_t v = 0; v < matrices.size(); ++v) {
      const glm::dvec3 normal(own[3 * v], own[3 * v + 1], own[3 * v + 2]);
      normals.push_back(glm::normalize(glm::transpose(glm::inverse(glm::dmat3(matrices[v]))) * normal));
    }
    addTriangles(primitive, normals, out);
  }

  /// One matrix a vertex.
  std::vector<glm::dmat4> blended(const tinygltf::Primitive& primitive, const glm::dmat4& world,
                                  const std::vector<glm::dmat4>& joints) const {
    const std::size_t count = model.accessors.at(asSize(primitive.attributes.at("POSITION"))).count;
    std::vector<glm::dmat4> matrices(count, joints.empty() ? world : glm::dmat4(0.0));
    if (!joints.empty()) blend(primitive, joints, matrices);
    return matrices;
  }

  void addTriangles(const tinygltf::Primitive& primitive, const std::vector<glm::dvec3>& vertices,
                    std::vector<RawTriangle>& out) const {
    std::vector<double> indices;
    if (primitive.indices >= 0) indices = numbers(model, primitive.indices);
    else
      for (std::size_t v = 0; v < vertices.size(); ++v) indices.push_back(static_cast<double>(v));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      RawTriangle triangle;
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = vertices.at(static_cast<std::size_t>(indices[i + k]));
      out.push_back(triangle);
    }
  }

  void blend(const tinygltf::Primitive& primitive, const std::vector<glm::dmat4>& joints,
             std::vector<glm::dmat4>& matrices) const {
    std::vector<double> sums(matrices.size(), 0.0);
    for (int set = 0; primitive.attributes.contains("JOINTS_" + std::to_string(set)); ++set) {
      const std::vector<double> j = numbers(model, primitive.attributes.at("JOINTS_" + std::to_string(set)));
      const std::vector<double> w = numbers(model, primitive.attributes.at("WEIGHTS_" + std::to_string(set)));
      for (std::size_t i = 0; i < j.size(); ++i) {
        matrices[i / 4] += w[i] * joints.at(static_cast<std::size_t>(j[i]));
        sums[i / 4] += w[i];
      }
    }
    for (std::size_t v = 0; v < matrices.size(); ++v) matrices[v] /= sums[v];
  }
};

GltfOracle::GltfOracle(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
  tinygltf::TinyGLTF reader;
  std::string error;
  std::string warning;
  const bool read = file.extension() == ".glb"
                        ? reader.LoadBinaryFromFile(&impl_->model, &error, &warning, file.string())
                        : reader.LoadASCIIFromFile(&impl_->model, &error, &warning, file.string());
  if (!read) ADD_FAILURE() << file << ": " << error;
  impl_->parents.assign(impl_->model.nodes.size(), -1);
  for (std::size_t n = 0; n < impl_->model.nodes.size(); ++n) {
    for (const int child : impl_->model.nodes[n].children) impl_->parents[asSize(child)] = static_cast<int>(n);
  }
}

GltfOracle::~GltfOracle() = default;

std::size_t GltfOracle::clips() const { return impl_->model.animations.size(); }

double GltfOracle::duration(std::size_t clip) const {
  double last = 0.0;
  for (const auto& sampler : impl_->model.animations.at(clip).samplers) {
    last = std::max(last, numbers(impl_->model, sampler.input).back());
  }
  return last;
}

template <class Add>
std::vector<RawTriangle> GltfOracle::Impl::collected(std::optional<std::size_t> clip, double time, Add add) const {
  const std::vector<glm::dmat4> world = worlds(clip, time);
  std::vector<RawTriangle> result;
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const tinygltf::Node& node = model.nodes[n];
    if (node.mesh < 0) continue;
    const std::vector<glm::dmat4> joints = jointMatrices(node, world);
    const std::vector<double> weights = morphWeights(model, static_cast<int>(n), clip, time);
    for (const auto& primitive : model.meshes.at(asSize(node.mesh)).primitives) {
      add(primitive, world[n], joints, weights, result);
    }
  }
  return result;
}

std::vector<glm::dvec3> GltfOracle::morphedPositions(int mesh, int primitive,
                                                     const std::vector<double>& weights) const {
  const auto& primitives = impl_->model.meshes.at(asSize(mesh)).primitives;
  const std::vector<double> all = impl_->morphed(primitives.at(asSize(primitive)), weights);
  std::vector<glm::dvec3> result;
  for (std::size_t i = 0; i + 2 < all.size(); i += 3) result.emplace_back(all[i], all[i + 1], all[i + 2]);
  return result;
}

std::vector<RawTriangle> GltfOracle::triangles(std::optional<std::size_t> clip, double time) const {
  return impl_->collected(
      clip, time,
      [&](const auto& primitive, const auto& world, const auto& joints, const auto& weights,
          std::vector<RawTriangle>& out) { impl_->addPrimitive(primitive, world, joints, weights, out); });
}

std::vector<RawTriangle> GltfOracle::normals(std::optional<std::size_t> clip, double time, bool morphed) const {
  return impl_->collected(
      clip, time,
      [&](const auto& primitive, const auto& world, const auto& joints, const auto& weights,
          std::vector<RawTriangle>& out) { impl_->addNormals(primitive, world, joints, weights, morphed, out); });
}

}  // namespace sinew::test
