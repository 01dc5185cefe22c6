// core/files/export/morph_targets.cpp: sample times; targets, names and channels as JSON and bytes.
#include "core/files/export/morph_targets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/files/fit/poses.h"
#include "core/files/gltf/file.h"
#include "core/geometry/at.h"

namespace sinew::exporting {

// Sample times.

namespace {

const AnimationClip& clipOf(const Character& character, const BakedExportSettings& settings) {
  return *std::ranges::find(character.clips, settings.clip, &AnimationClip::name);
}

}  // namespace

BakedClip::BakedClip(const Character& character, const BakedExportSettings& settings)
    : clip(clipOf(character, settings)), times(clipTimes(clip, momentsPerSecond(settings))) {
  for (std::size_t frame = 0; frame < times.size(); ++frame) frames.push_back(static_cast<double>(frame));
  const double end = static_cast<double>(clip.duration) * momentsPerSecond(settings);
  if (std::abs(end - frames.back()) > kSameTime) frames.back() = end;
}

double momentsPerSecond(const BakedExportSettings& settings) { return settings.framesPerSecond * settings.substeps; }

void refuseClip(const BakedExportSettings& settings, const std::string& what) {
  throw gltf::Refusal{
      errorAt("clip \"" + settings.clip + '"', what + "; expected fewer frames a second, or a smaller depth")};
}

void requireFrames(const Character& character, const BakedExportSettings& settings, int most) {
  const AnimationClip& clip = clipOf(character, settings);
  if (static_cast<double>(clip.duration) * momentsPerSecond(settings) >= most) {
    refuseClip(settings, "has more than " + std::to_string(most) + " frames");
  }
}

// Targets.

namespace {

constexpr std::size_t kSparseJson = 250;  ///< Approximate size of the JSON of a sparse accessor and its two views.

template <class Number>
int addIndices(GltfRewrite& rewrite, const std::vector<std::size_t>& indices) {
  std::vector<Number> numbers;
  for (const std::size_t index : indices) numbers.push_back(static_cast<Number>(index));
  return rewrite.addView(bytesOf(numbers), 0);
}

/// @param moved  elements that are not 0; not empty, rising
int addSparse(GltfRewrite& rewrite, const std::vector<std::size_t>& moved, const std::vector<glm::vec3>& values,
              std::size_t count, const Bounds& bounds) {
  const bool isNarrow = count <= std::numeric_limits<std::uint16_t>::max();
  Json indices = Json::object();
  indices.set("bufferView",
              isNarrow ? addIndices<std::uint16_t>(rewrite, moved) : addIndices<std::uint32_t>(rewrite, moved));
  indices.set("componentType",
              isNarrow ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT : TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
  Json places = Json::object();
  places.set("bufferView", rewrite.addView(bytesOf(values), 0));
  Json sparse = Json::object();
  sparse.set("count", static_cast<long long>(moved.size()));
  sparse.set("indices", std::move(indices)).set("values", std::move(places));
  Json accessor = Json::object();
  accessor.set("componentType", TINYGLTF_COMPONENT_TYPE_FLOAT).set("count", static_cast<long long>(count));
  accessor.set("type", "VEC3").set("min", numbersOf(bounds.low)).set("max", numbersOf(bounds.high));
  accessor.set("sparse", std::move(sparse));
  return rewrite.append("accessors", std::move(accessor));
}

int addDeltas(GltfRewrite& rewrite, const std::vector<glm::vec3>& deltas) {
  std::vector<std::size_t> moved;
  std::vector<glm::vec3> values;
  for (std::size_t v = 0; v < deltas.size(); ++v) {
    if (deltas[v] == glm::vec3(0.0f)) continue;
    moved.push_back(v);
    values.push_back(deltas[v]);
  }
  const Bounds bounds = boundsOf(deltas);
  if (moved.empty()) {  // Some readers need data.
    moved.push_back(0);
    values.emplace_back(0.0f);
  }
  const std::size_t indexBytes = deltas.size() <= std::numeric_limits<std::uint16_t>::max() ? 2 : 4;
  const std::size_t sparseBytes = moved.size() * (sizeof(glm::vec3) + indexBytes) + kSparseJson;
  if (sparseBytes < deltas.size() * sizeof(glm::vec3)) {
    return addSparse(rewrite, moved, values, deltas.size(), bounds);
  }
  return rewrite.addAttribute(deltas, "VEC3", bounds);
}

Json targetsOf(std::size_t primitive, const MeshTargets& mesh, GltfRewrite& rewrite) {
  Json targets = Json::array();
  for (std::size_t k = 0; k < mesh.names.size(); ++k) {
    const TargetDeltas deltas = mesh.deltas(primitive, k);
    Json target = Json::object();
    target.set("POSITION", addDeltas(rewrite, deltas.positions));
    target.set("NORMAL", addDeltas(rewrite, deltas.normals));
    targets.push(std::move(target));
  }
  return targets;
}

/// Idle targets of points and lines.
Json idleTargets(const Json& primitive, std::size_t targets, GltfRewrite& rewrite) {
  const auto positions = static_cast<int>(primitive.at("attributes").at("POSITION").number(0.0));
  const double count = rewrite.element("accessors", positions).at("count").number(1.0);
  const int still = addDeltas(rewrite, std::vector<glm::vec3>(static_cast<std::size_t>(count), glm::vec3(0.0f)));
  Json list = Json::array();
  for (std::size_t k = 0; k < targets; ++k) {
    Json target = Json::object();
    target.set("POSITION", still);
    list.push(std::move(target));
  }
  return list;
}

int meshOf(int node, GltfRewrite& rewrite) {
  return static_cast<int>(rewrite.element("nodes", node).at("mesh").number(0.0));
}

}  // namespace

std::set<int> nodesOf(std::span<const OutPrimitive> primitives) {
  std::set<int> nodes;
  for (const OutPrimitive& primitive : primitives) nodes.insert(primitive.node);
  return nodes;
}

void addMorphTargets(int node, std::span<const OutPrimitive> primitives, const MeshTargets& mesh,
                     GltfRewrite& rewrite) {
  if (mesh.names.empty()) return;
  const int number = meshOf(node, rewrite);
  const std::size_t parts = rewrite.element("meshes", number).at("primitives").items().size();
  for (std::size_t place = 0; place < parts; ++place) {
    const auto own = std::ranges::find_if(primitives, [&](const OutPrimitive& primitive) {
      return primitive.node == node && toIndex(primitive.place) == place;
    });
    const Json& primitive = rewrite.element("meshes", number).at("primitives").items()[place];
    Json targets = own == primitives.end()
                       ? idleTargets(primitive, mesh.names.size(), rewrite)
                       : targetsOf(static_cast<std::size_t>(own - primitives.begin()), mesh, rewrite);
    memberOf(rewrite.element("meshes", number), "primitives")->children[place].set("targets", std::move(targets));
  }
  Json& to = rewrite.element("meshes", number);
  to.set("weights", numbersOf(mesh.weights));
  if (to.at("extras").kind != Json::Kind::kObject) to.set("extras", Json::object());
  memberOf(to, "extras")->set("targetNames", jsonList(mesh.names));
}

void addMorphWeights(const std::set<int>& nodes, const std::vector<float>& times, const std::vector<float>& weights,
                     const std::string& clip, GltfRewrite& rewrite) {
  if (weights.empty()) return;
  if (rewrite.root().at("animations").items().empty()) {
    Json made = Json::object();
    made.set("name", clip).set("channels", Json::array()).set("samplers", Json::array());
    rewrite.append("animations", std::move(made));
  }
  const int sampler = addWeightSampler(0, times, weights, rewrite);
  for (const int node : nodes) addChannel(0, sampler, node, "weights", rewrite);
}

}  // namespace sinew::exporting
