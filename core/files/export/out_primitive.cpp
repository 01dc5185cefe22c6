// core/files/export/out_primitive.cpp: positions, normals, tangents, weights and indices as accessors.
#include "core/files/export/out_primitive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/geometry/at.h"
#include "core/geometry/index_table.h"

namespace sinew::exporting {

// Refined primitives.

namespace {

/// Attributes that can be interpolated.
bool isInterpolated(const std::string& name) {
  return name.starts_with("TEXCOORD_") || name.starts_with("COLOR_") || name == "TANGENT";
}

class AttributeReader {
 public:
  AttributeReader(Source& source, const gltf::SoupPart& part) : source_(source), part_(part) {
    place_ = gltf::placeOfPrimitive(toIndex(part.mesh), toIndex(part.primitive));
  }

  /// Values of the part's soup vertices.
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
    int low = 0;  ///< First twins of the corners around it; equal at a corner, -1 inside a triangle.
    int high = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };

  /// Finds the first vertex with the same attributes: the file also splits at normals and weights.
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
      if (corner < 3) {  // the file's exact value
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

// Accessors of refined primitives.

const char* vectorType(int components) {
  static constexpr std::array kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
  return kTypes[toIndex(components - 1)];
}

/// Joints as one byte each if possible, else two.
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

/// Makes tangents unit and perpendicular to the normals; keeps the fourth number.
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

RefinedPrimitive refinedPrimitive(Source& source, const gltf::SoupPart& part, const ControlMesh& mesh,
                                  const Surface& surface) {
  return PrimitiveRefiner(source, part, mesh, surface).run();
}

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

// The file's own vertices, moved by muscles at rest, with new weights.

namespace {

std::string notFinite(const std::string& attribute) {
  return attribute + ": values that are not finite, which glTF does not allow; others stand for them";
}
constexpr float kSameNormal = 1e-4f;  ///< Smaller changes of normals are rounding: the file's normal stays exactly.

std::vector<glm::vec3> pointsOf(const std::vector<float>& values) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) points.emplace_back(values[i], values[i + 1], values[i + 2]);
  return points;
}

bool isFinite(const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z); }

/// Replaces a value that is not finite: white as in the import, a unit tangent, or 0.
float replacement(const std::string& attribute, int component) {
  if (attribute == "TANGENT") return component == 0 || component == 3 ? 1.0f : 0.0f;
  return attribute.starts_with("COLOR_") ? 1.0f : 0.0f;
}

/// All values of an attribute with those replaced that are not finite; nullopt if all are finite.
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

/// Replaces only values that are not finite, which glTF forbids.
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

/// [file vertices] control vertex, or -1 if unused.
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

/// The file's normals, or empty.
std::vector<glm::vec3> OutPrimitives::fileNormals(const gltf::SoupPart& part, const Json& attributes,
                                                  std::size_t count) const {
  const Json* normal = attributes.find("NORMAL");
  if (!normal) return {};
  const std::string place = gltf::placeOf("meshes", toIndex(part.mesh)) + ".primitives.attributes.NORMAL";
  const gltf::Accessor& accessor = source_.accessors.open(*normal, place, TINYGLTF_TYPE_VEC3);
  if (accessor.count() != count) gltf::refuse(place, "not as many values as positions");
  return gltf::vectorsOf<glm::vec3>(accessor);
}

/// Weights of an unused vertex.
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
  const std::string place = gltf::placeOfPrimitive(toIndex(part.mesh), toIndex(part.primitive));
  repair(place + ".attributes", rewrite, attributes, left);
  if (Json* targets = memberOf(primitive, "targets")) {
    for (Json& target : targets->children) repair(place + ".targets", rewrite, target, left);
  }
  return {positions.size(), part.endTriangle - part.firstTriangle};
}

}  // namespace sinew::exporting
