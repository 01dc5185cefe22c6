// core/files/export/out_primitive.cpp: positions, normals, tangents, weights and indices as accessors.
#include "core/files/export/out_primitive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/files/export/into_mesh.h"
#include "core/geometry/at.h"
#include "core/geometry/index_table.h"

namespace sinew::exporting {

// Corners, edges and insides of the file's triangles become vertices.

namespace {

/// Attributes that mean something between the corners.
bool isInterpolated(const std::string& name) {
  return name.starts_with("TEXCOORD_") || name.starts_with("COLOR_") || name == "TANGENT";
}

class AttributeReader {
 public:
  AttributeReader(Source& source, const gltf::SoupPart& part) : source_(source), part_(part) {
    place_ = gltf::placeOf(gltf::placeOf("meshes", toIndex(part.mesh)) + ".primitives", toIndex(part.primitive));
  }

  /// The values of the part's vertices of the soup.
  std::vector<VertexAttribute> read() {
    const Json& primitive =
        at(at(source_.root.at("meshes").items(), part_.mesh).at("primitives").items(), part_.primitive);
    std::vector<VertexAttribute> result;
    for (const Json& attribute : primitive.at("attributes").children) {
      if (isInterpolated(attribute.key)) result.push_back(readOne(attribute));
    }
    return result;
  }

 private:
  VertexAttribute readOne(const Json& attribute) {
    const std::string place = place_ + ".attributes." + attribute.key;
    const bool uv = attribute.key.starts_with("TEXCOORD_");
    const bool color = attribute.key.starts_with("COLOR_");
    const int type = uv ? TINYGLTF_TYPE_VEC2 : TINYGLTF_TYPE_VEC4;
    const gltf::Accessor& accessor = source_.accessors.open(attribute, place, type, color ? TINYGLTF_TYPE_VEC3 : -1);
    VertexAttribute result{attribute.key, accessor.components(), {}};
    for (std::size_t v = part_.firstVertex; v < part_.endVertex; ++v) {
      const std::uint32_t element = source_.origin.fileVertex[v];
      if (element >= accessor.count()) gltf::refuse(place, "fewer values than positions");
      for (int c = 0; c < result.components; ++c) {
        const auto value = static_cast<float>(accessor.number(element, c));
        const float sound = std::isfinite(value) ? value : 0.0f;
        result.values.push_back(color ? std::clamp(sound, 0.0f, 1.0f) : sound);
      }
    }
    return result;
  }

  Source& source_;
  const gltf::SoupPart& part_;
  std::string place_;
};

class PrimitiveRefiner {
 public:
  PrimitiveRefiner(Source& source, const gltf::SoupPart& part, const ControlMesh& mesh, const Surface& surface)
      : source_(source),
        part_(part),
        refinement_(*surface.refinement),
        mesh_(mesh),
        from_(AttributeReader(source, part).read()),
        keys_(3 * refinement_.triangles.size()) {}

  RefinedPrimitive run() {
    for (const VertexAttribute& attribute : from_)
      out_.attributes.push_back({attribute.name, attribute.components, {}});
    findTwins();
    for (std::size_t t = part_.firstTriangle; t < part_.endTriangle; ++t) {
      if (source_.controlTriangle[t] >= 0) split(t, source_.controlTriangle[t]);
    }
    return std::move(out_);
  }

 private:
  struct Key {
    int drawn = 0;
    int low = 0;  ///< Corners that it lies between, as their first twins; equal at a corner, -1 inside a triangle.
    int high = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };

  /// The first vertex of the part with the same attributes: the file also splits at normals and weights.
  void findTwins() {
    const std::size_t count = part_.endVertex - part_.firstVertex;
    IndexTable table(count);
    twin_.resize(count);
    for (std::size_t v = 0; v < count; ++v) {
      std::uint64_t hash = 0;
      for (const VertexAttribute& attribute : from_) {
        for (const float value : valuesOf(attribute, v)) hash = hashCombine(hash, floatBits(value));
      }
      twin_[v] = table.findOrInsert(hash, static_cast<int>(v), [&](int other) {
        return std::ranges::all_of(from_, [&](const VertexAttribute& attribute) {
          return std::ranges::equal(valuesOf(attribute, v), valuesOf(attribute, toIndex(other)));
        });
      });
    }
  }

  static std::span<const float> valuesOf(const VertexAttribute& attribute, std::size_t vertex) {
    const std::size_t size = toIndex(attribute.components);
    return std::span(attribute.values).subspan(vertex * size, size);
  }

  void split(std::size_t soupTriangle, int control) {
    std::array<std::size_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = source_.soup.triangles[soupTriangle][i] - part_.firstVertex;
    for (int t = at(refinement_.triangleBegin, control); t < at(refinement_.triangleBegin, control + 1); ++t) {
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        const int refined = at(refinement_.triangles, t)[i];
        const int drawn = static_cast<int>(at(refinement_.drawTriangles, t)[i]);
        triangle[i] = vertex(corners, controlCoordinates(mesh_, refinement_, control, refined), refined, drawn);
      }
      out_.triangles.push_back(triangle);
    }
  }

  std::uint32_t vertex(const std::array<std::size_t, 3>& corners, const glm::dvec3& place, int refined, int drawn) {
    Key key{drawn, -1, -1};
    if (refined < refinement_.insideBegin.front()) {
      std::vector<int> ends;
      for (int i = 0; i < 3; ++i) {
        if (place[i] > 0.0) ends.push_back(twin_[at(corners, i)]);
      }
      key.low = std::ranges::min(ends);
      key.high = std::ranges::max(ends);
    }
    const int next = static_cast<int>(keyOf_.size());
    const std::uint64_t hash =
        hashCombine(hashCombine(static_cast<std::uint64_t>(drawn), toIndex(key.low + 1)), toIndex(key.high + 1));
    const int found = keys_.findOrInsert(hash, next, [&](int other) { return at(keyOf_, other) == key; });
    if (found == next) {
      keyOf_.push_back(key);
      out_.refined.push_back(refined);
      out_.drawn.push_back(drawn);
      interpolate(corners, place);
    }
    return static_cast<std::uint32_t>(found);
  }

  void interpolate(const std::array<std::size_t, 3>& corners, const glm::dvec3& place) {
    int corner = 0;
    while (corner < 3 && place[corner] != 1.0) ++corner;
    for (std::size_t a = 0; a < from_.size(); ++a) {
      std::vector<float>& to = out_.attributes[a].values;
      if (corner < 3) {  // The file's value to the last bit.
        const auto values = valuesOf(from_[a], at(corners, corner));
        to.insert(to.end(), values.begin(), values.end());
        continue;
      }
      const std::size_t start = to.size();
      for (std::size_t c = 0; c < toIndex(from_[a].components); ++c) {
        double sum = 0.0;
        for (int i = 0; i < 3; ++i) sum += place[i] * static_cast<double>(valuesOf(from_[a], at(corners, i))[c]);
        to.push_back(static_cast<float>(sum));
      }
      if (from_[a].name == "TANGENT") to[start + 3] = to[start + 3] < 0.0f ? -1.0f : 1.0f;
    }
  }

  Source& source_;
  const gltf::SoupPart& part_;
  const Refinement& refinement_;
  const ControlMesh& mesh_;
  std::vector<VertexAttribute> from_;  // [part's vertices of the soup]
  std::vector<int> twin_;              // [part's vertices of the soup]
  IndexTable keys_;
  std::vector<Key> keyOf_;  // [vertices so far]
  RefinedPrimitive out_;
};

}  // namespace

RefinedPrimitive refinedPrimitive(Source& source, const gltf::SoupPart& part, const ControlMesh& mesh,
                                  const Surface& surface) {
  return PrimitiveRefiner(source, part, mesh, surface).run();
}

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
