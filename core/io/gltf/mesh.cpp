// core/io/gltf/mesh.cpp: reading mesh primitives (glTF 2.0, section 3.7).

#include "core/io/gltf/mesh.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "sinew/io/gltf_import.h"

namespace sinew::gltf {
namespace {

constexpr std::size_t kMostTriangles = static_cast<std::size_t>(kMaxControlTriangles);
/// Vertices one primitive may choose from; twice what the largest mesh could use unindexed.
constexpr std::size_t kMostVertices = 6 * kMostTriangles;
constexpr std::size_t kMostInfluences = 32U << 20;
constexpr std::size_t kMostJointSets = 16;
constexpr double kLargestCoordinate = 1e15;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

enum class Mode { kTriangles = 4, kStrip = 5, kFan = 6 };

/// The accessors of one primitive.
struct Attributes {
  const Accessor* position = nullptr;
  const Accessor* uv = nullptr;
  std::vector<const Accessor*> joints;
  std::vector<const Accessor*> weights;
};

class SoupReader {
 public:
  SoupReader(const Field& root, const BoundSkeleton& bound, Materials& materials, Accessors& accessors, Notes& notes)
      : root_(root), bound_(bound), materials_(materials), accessors_(accessors), notes_(notes) {
    soup_.influenceBegin.push_back(0);
  }

  void readMesh(const TreeNode& node, const MeshBinding& binding) {
    const Field mesh = root_.member("meshes").item(at(*node.mesh));
    const Field primitives = mesh.member("primitives");
    for (std::size_t p = 0; p < primitives.size(); ++p) readPrimitive(primitives.item(p), binding);
  }

  TriangleSoup take() && { return std::move(soup_); }

 private:
  void readPrimitive(const Field& primitive, const MeshBinding& binding) {
    const std::uint64_t mode = primitive.member("mode").count(4);
    if (mode > 6) refuse(primitive.member("mode").place(), "unknown mode " + std::to_string(mode));
    if (mode < 4) {
      notes_.add("mesh primitives made of points or lines");
      return;
    }
    noteUnused(primitive);
    const int material = materialOf(primitive);
    const Field attributes = primitive.member("attributes");
    if (!attributes.member("POSITION").exists()) {
      notes_.add("mesh primitives without positions");
      return;
    }
    const Attributes open = openAttributes(attributes, materials_.uvSources[at(material)].set, binding);
    const Accessor* indices = nullptr;
    if (const Field reference = primitive.member("indices"); reference.exists()) {
      indices = &accessors_.open(reference, {"SCALAR"});
      if (indices->isFloat()) refuse(indices->place(), "indices must be unsigned integers");
    }
    startPrimitive(open.position->count());
    const bool mirrored = glm::determinant(glm::dmat3(binding.meshToBind)) < 0.0;
    const std::size_t corners = indices ? indices->count() : open.position->count();
    const std::size_t triangles = countTriangles(static_cast<Mode>(mode), corners);
    if (triangles > kMostTriangles - soup_.triangles.size()) refuse(primitive.place(), "more than 2 million triangles");
    for (std::size_t t = 0; t < triangles; ++t) {
      std::array<std::uint32_t, 3> triangle = cornersOf(static_cast<Mode>(mode), t);
      for (std::uint32_t& corner : triangle) {
        if (indices) corner = indices->integer(corner, 0);
        if (corner >= open.position->count()) {
          refuse(indices->place(), "index " + std::to_string(corner) + "; the primitive has " +
                                       std::to_string(open.position->count()) + " vertices");
        }
        corner = vertex(corner, open, binding, materials_.uvSources[at(material)]);
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      soup_.triangles.push_back(triangle);
      soup_.materials.push_back(material);
    }
  }

  void noteUnused(const Field& primitive) {
    if (primitive.member("targets").size() > 0) notes_.add("morph targets of mesh primitives");
    if (primitive.member("extensions").member("KHR_draco_mesh_compression").exists()) {
      notes_.add("Draco data of mesh primitives; the uncompressed copy is used");
    }
    for (const std::string& key : primitive.member("attributes").keys()) {
      if (key.starts_with("COLOR_")) notes_.add("vertex colours");
      else if (key == "NORMAL") continue;  // computed from the welded faces (docs/design.md)
      else if (key == "TANGENT") notes_.add("vertex tangents");
    }
  }

  int materialOf(const Field& primitive) {
    const std::size_t inFile = root_.member("materials").size();
    if (const auto index = primitive.member("material").index(inFile, "material")) return *index;
    if (materials_.materials.size() == inFile) {
      materials_.materials.push_back({.name = "default"});
      materials_.uvSources.emplace_back();
    }
    return static_cast<int>(inFile);
  }

  Attributes openAttributes(const Field& attributes, int uvSet, const MeshBinding& binding) {
    Attributes open;
    open.position = &accessors_.open(attributes.member("POSITION"), {"VEC3"});
    const auto openMatching = [&](const std::string& key, const char* shape) {
      const Accessor* accessor = &accessors_.open(attributes.member(key), {shape});
      if (accessor->count() != open.position->count()) {
        refuse(accessor->place(), std::to_string(accessor->count()) + " values of " + key + " for " +
                                      std::to_string(open.position->count()) + " positions");
      }
      return accessor;
    };
    const std::string uv = "TEXCOORD_" + std::to_string(uvSet);
    if (attributes.member(uv).exists()) open.uv = openMatching(uv, "VEC2");
    if (!binding.skin) return open;
    for (std::size_t set = 0;; ++set) {
      const std::string joints = "JOINTS_" + std::to_string(set);
      const std::string weights = "WEIGHTS_" + std::to_string(set);
      if (!attributes.member(joints).exists() || !attributes.member(weights).exists()) break;
      if (set == kMostJointSets) refuse(attributes.place(), "more than 16 sets of joints");
      open.joints.push_back(openMatching(joints, "VEC4"));
      open.weights.push_back(openMatching(weights, "VEC4"));
      if (open.joints.back()->isFloat()) refuse(open.joints.back()->place(), "joints must be unsigned integers");
    }
    if (open.joints.empty())
      notes_.add("skinned meshes without joints and weights; they follow the skin's first joint");
    return open;
  }

  static std::size_t countTriangles(Mode mode, std::size_t corners) {
    if (mode == Mode::kTriangles) return corners / 3;
    return corners < 3 ? 0 : corners - 2;
  }

  /// Corner numbers of a triangle; every second one of a strip is turned so that all face the same way.
  static std::array<std::uint32_t, 3> cornersOf(Mode mode, std::size_t triangle) {
    const auto t = static_cast<std::uint32_t>(triangle);
    if (mode == Mode::kTriangles) return {3 * t, 3 * t + 1, 3 * t + 2};
    if (mode == Mode::kFan) return {t + 1, t + 2, 0};
    return {t, t + 1 + t % 2, t + 2 - t % 2};
  }

  /// Forgets which vertices of the last primitive were taken over, without touching them all.
  void startPrimitive(std::size_t vertices) {
    if (vertices > kMostVertices) refuse("meshes", "a primitive with more than 12 million vertices");
    ++stamp_;
    if (taken_.size() < vertices) taken_.resize(vertices);
  }

  /// Soup vertex for a vertex of the primitive.
  std::uint32_t vertex(std::uint32_t index, const Attributes& open, const MeshBinding& binding,
                       const UvSource& uvSource) {
    Taken& taken = taken_[index];
    if (taken.stamp == stamp_) return taken.soupVertex;
    taken = {.stamp = stamp_, .soupVertex = static_cast<std::uint32_t>(soup_.positions.size())};
    glm::dvec4 position(0.0, 0.0, 0.0, 1.0);
    for (int axis = 0; axis < 3; ++axis) position[axis] = open.position->number(index, axis);
    position = binding.meshToBind * position;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(position[axis]) <= kLargestCoordinate)) {
        refuse(open.position->place(), "position " + std::to_string(index) + " is not finite or too large");
      }
    }
    soup_.positions.emplace_back(position);
    glm::vec2 uv(0.0f);
    if (open.uv) uv = uvSource.apply(open.uv->number(index, 0), open.uv->number(index, 1));
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
      notes_.add("texture coordinates that are not finite; taken as 0");
      uv = glm::vec2(0.0f);
    }
    soup_.uvs.push_back(uv);
    addInfluences(index, open, binding);
    return taken.soupVertex;
  }

  void addInfluences(std::uint32_t index, const Attributes& open, const MeshBinding& binding) {
    scratch_.clear();
    double sum = 0.0;
    for (std::size_t set = 0; set < open.joints.size(); ++set) {
      for (int c = 0; c < 4; ++c) {
        const double weight = open.weights[set]->number(index, c);
        if (!(std::abs(weight) <= kLargestCoordinate)) {
          refuse(open.weights[set]->place(),
                 "weight of vertex " + std::to_string(index) + " is not finite or too large");
        }
        if (weight <= 0.0) continue;
        scratch_.emplace_back(bindingOf(*open.joints[set], index, c, binding), weight);
        sum += weight;
      }
    }
    if (!(sum > 1e-12)) {
      scratch_.assign(1, {firstBinding(index, open, binding), 1.0});
      sum = 1.0;
      if (!open.joints.empty()) notes_.add("vertices whose weights are all zero; they follow their first joint");
    }
    std::ranges::stable_sort(scratch_, {}, &std::pair<int, double>::first);
    for (std::size_t i = 0; i < scratch_.size();) {
      const int to = scratch_[i].first;
      double weight = 0.0;
      for (; i < scratch_.size() && scratch_[i].first == to; ++i) weight += scratch_[i].second;
      if (const auto share = static_cast<float>(weight / sum); share > 0.0f) soup_.influences.push_back({to, share});
    }
    if (soup_.influences.size() > kMostInfluences) refuse(open.position->place(), "more than 33 million skin weights");
    soup_.influenceBegin.push_back(static_cast<int>(soup_.influences.size()));
  }

  int firstBinding(std::uint32_t index, const Attributes& open, const MeshBinding& binding) const {
    if (!binding.skin) return binding.rigid;
    if (open.joints.empty()) return bound_.jointBindings[at(*binding.skin)].front();
    return bindingOf(*open.joints.front(), index, 0, binding);
  }

  int bindingOf(const Accessor& joints, std::uint32_t index, int component, const MeshBinding& binding) const {
    const std::vector<int>& bindings = bound_.jointBindings[at(*binding.skin)];
    const std::uint32_t joint = joints.integer(index, component);
    if (joint >= bindings.size()) {
      refuse(joints.place(), "vertex " + std::to_string(index) + " names joint " + std::to_string(joint) +
                                 "; the skin has " + std::to_string(bindings.size()));
    }
    return bindings[joint];
  }

  struct Taken {
    std::uint32_t stamp = 0;
    std::uint32_t soupVertex = 0;
  };

  const Field root_;
  const BoundSkeleton& bound_;
  Materials& materials_;
  Accessors& accessors_;
  Notes& notes_;
  std::vector<Taken> taken_;  // [vertices of the largest primitive so far]
  std::uint32_t stamp_ = 0;
  std::vector<std::pair<int, double>> scratch_;
  TriangleSoup soup_;
};

}  // namespace

TriangleSoup readTriangles(const Field& root, const NodeTree& tree, const BoundSkeleton& bound, Materials& materials,
                           Accessors& accessors, Notes& notes) {
  SoupReader reader(root, bound, materials, accessors, notes);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    if (bound.meshes[i]) reader.readMesh(tree.nodes[i], *bound.meshes[i]);
  }
  return std::move(reader).take();
}

}  // namespace sinew::gltf
