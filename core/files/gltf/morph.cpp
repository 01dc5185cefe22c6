// core/files/gltf/morph.cpp: reading morph targets (glTF 2.0, section 3.7.2.2).
#include "core/files/gltf/morph.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "core/geometry/at.h"

namespace sinew::gltf {
namespace {

constexpr double kMaxDelta = 1e12;
constexpr double kMaxWeight = 1000.0;
/// Deltas read, zeros too: accessors may be shared, so a small file could ask for very many.
constexpr std::size_t kMaxReads = 256U << 20;
constexpr std::size_t kMaxDeltas = 32U << 20;  // 512 MiB.

class MorphReader {
 public:
  MorphReader(const File& file, const NodeTree& tree, const BoundSkeleton& bound, const SoupOrigin& origin,
              std::span<const int> standsFor, Accessors& accessors, Notes& notes)
      : file_(file), tree_(tree), bound_(bound), origin_(origin), accessors_(accessors), notes_(notes) {
    verticesOf_.resize(origin.parts.size());
    for (std::size_t v = 0; v < standsFor.size(); ++v) {
      const auto part = std::ranges::upper_bound(origin.parts, toIndex(standsFor[v]), {}, &SoupPart::endVertex);
      verticesOf_[static_cast<std::size_t>(part - origin.parts.begin())].push_back({static_cast<int>(v), standsFor[v]});
    }
  }

  std::vector<MorphTarget> read() && {
    for (std::size_t first = 0; first < origin_.parts.size();) {
      std::size_t end = first;
      while (end < origin_.parts.size() && origin_.parts[end].node == origin_.parts[first].node) ++end;
      readNode(first, end);
      first = end;
    }
    return std::move(targets_);
  }

 private:
  /// A vertex of the welded mesh and of the soup.
  struct Vertex {
    int welded = 0;
    int soup = 0;
  };

  [[nodiscard]] const tinygltf::Primitive& primitiveOf(const SoupPart& part) const {
    return at(at(file_.model().meshes, part.mesh).primitives, part.primitive);
  }

  /// @param first, end  the node's parts
  void readNode(std::size_t first, std::size_t end) {
    const int node = origin_.parts[first].node;
    const int mesh = origin_.parts[first].mesh;
    std::size_t count = 0;
    for (std::size_t p = first; p < end; ++p) count = std::max(count, primitiveOf(origin_.parts[p]).targets.size());
    if (count > kMaxMorphTargets - targets_.size()) {
      refuse(placeOf("meshes", toIndex(mesh)), "more than 1,024 morph targets in one file", "too large");
    }
    for (std::size_t k = 0; k < count; ++k) {
      MorphTarget target;
      target.name = nameOf(node, mesh, k);
      target.node = node;
      target.weight = weightOf(node, mesh, k);
      for (std::size_t p = first; p < end; ++p) {
        if (k < primitiveOf(origin_.parts[p]).targets.size()) readDeltas(p, k, target);
      }
      sortByVertex(target);
      targets_.push_back(std::move(target));
    }
  }

  [[nodiscard]] std::string nameOf(int node, int mesh, std::size_t k) const {
    const std::vector<std::string>& names = file_.targetNames(mesh);
    if (k < names.size() && !names[k].empty()) return names[k];
    const std::string& own = tree_[node].name;
    return (own.empty() ? "shape" : own) + '.' + std::to_string(k + 1);
  }

  [[nodiscard]] float weightOf(int node, int mesh, std::size_t k) const {
    const std::vector<double>& own = at(file_.model().nodes, node).weights;
    const std::vector<double>& weights = own.empty() ? at(file_.model().meshes, mesh).weights : own;
    const double weight = k < weights.size() ? weights[k] : 0.0;
    return static_cast<float>(std::clamp(std::isfinite(weight) ? weight : 0.0, -kMaxWeight, kMaxWeight));
  }

  void readDeltas(std::size_t p, std::size_t k, MorphTarget& target) {
    const SoupPart& part = origin_.parts[p];
    const std::string place = placeOf(
        placeOf(placeOf("meshes", toIndex(part.mesh)) + ".primitives", toIndex(part.primitive)) + ".targets", k);
    file_.expectSound(place);
    file_.expectSound(place + ".POSITION");
    const tinygltf::Primitive& primitive = primitiveOf(part);
    const auto found = primitive.targets[k].find("POSITION");
    if (found == primitive.targets[k].end() || found->second < 0) return;
    const Accessor& deltas = accessors_.open(found->second, place + ".POSITION", TINYGLTF_TYPE_VEC3);
    const Accessor& base = accessors_.open(primitive.attributes.at("POSITION"), place, TINYGLTF_TYPE_VEC3);
    if (deltas.count() != base.count()) {
      refuse(deltas.place(),
             std::to_string(deltas.count()) + " deltas for " + std::to_string(base.count()) + " positions");
    }
    reads_ += verticesOf_[p].size();
    if (reads_ > kMaxReads) refuse(place, "morph targets of more than 268 million vertices", "too large");
    const glm::dmat3 toBind(at(bound_.meshes, part.node)->meshToBind);
    for (const Vertex& vertex : verticesOf_[p]) {
      add(vertex.welded, toBind * deltaAt(deltas, at(origin_.fileVertex, vertex.soup)), target);
    }
  }

  glm::dvec3 deltaAt(const Accessor& deltas, std::uint32_t vertex) {
    glm::dvec3 delta(0.0);
    for (int axis = 0; axis < 3; ++axis) delta[axis] = deltas.number(vertex, axis);
    const double most = std::max({std::abs(delta.x), std::abs(delta.y), std::abs(delta.z)});
    if (most <= kMaxDelta && std::isfinite(delta.x + delta.y + delta.z)) return delta;
    notes_.add("morph targets with deltas that are not finite or too large: 0 is used there");
    return glm::dvec3(0.0);
  }

  void add(int vertex, const glm::dvec3& delta, MorphTarget& target) {
    const glm::vec3 kept(delta);
    if (kept == glm::vec3(0.0f) || !std::isfinite(kept.x + kept.y + kept.z)) return;
    if (++deltas_ > kMaxDeltas) refuse("meshes", "morph targets with more than 33 million deltas", "too large");
    target.vertices.push_back(vertex);
    target.deltas.push_back(kept);
  }

  static void sortByVertex(MorphTarget& target) {
    if (std::ranges::is_sorted(target.vertices)) return;
    std::vector<std::pair<int, glm::vec3>> both;
    for (std::size_t i = 0; i < target.vertices.size(); ++i) both.emplace_back(target.vertices[i], target.deltas[i]);
    std::ranges::sort(both, {}, &std::pair<int, glm::vec3>::first);
    for (std::size_t i = 0; i < both.size(); ++i) std::tie(target.vertices[i], target.deltas[i]) = both[i];
  }

  const File& file_;
  const NodeTree& tree_;
  const BoundSkeleton& bound_;
  const SoupOrigin& origin_;
  Accessors& accessors_;
  Notes& notes_;
  std::vector<std::vector<Vertex>> verticesOf_;  // [parts]
  std::vector<MorphTarget> targets_;
  std::size_t reads_ = 0;
  std::size_t deltas_ = 0;
};

}  // namespace

std::vector<MorphTarget> readMorphs(const File& file, const NodeTree& tree, const BoundSkeleton& bound,
                                    const SoupOrigin& origin, std::span<const int> standsFor, Accessors& accessors,
                                    Notes& notes) {
  return MorphReader(file, tree, bound, origin, standsFor, accessors, notes).read();
}

std::vector<NodeTargets> targetsOfNodes(std::size_t nodes, std::span<const MorphTarget> targets) {
  std::vector<NodeTargets> result(nodes);
  for (std::size_t k = 0; k < targets.size(); ++k) {
    NodeTargets& of = at(result, targets[k].node);
    if (of.count++ == 0) of.first = static_cast<int>(k);
  }
  return result;
}

}  // namespace sinew::gltf
