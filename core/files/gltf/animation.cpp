// core/files/gltf/animation.cpp: morph targets (glTF 2.0, section 3.7.2.2) and animations (section 3.11).
#include "core/files/gltf/animation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/geometry/at.h"

namespace sinew::gltf {

// Morph targets.

namespace {

constexpr double kMaxDelta = 1e12;
constexpr double kMaxWeight = 1000.0;
/// Deltas to read, including zeros: accessors may be shared, so that a small file could need very many.
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
    const std::string place = placeOf(placeOfPrimitive(toIndex(part.mesh), toIndex(part.primitive)) + ".targets", k);
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

// Clips.

namespace {

/// Key values of all clips: 256 MiB. Accessors may be shared, so that a small file could need much more.
constexpr std::size_t kMaxKeyValues = 16U << 20;
constexpr double kMaxValue = 1e15;
constexpr std::string_view kWeights = "weights";

class ClipReader {
 public:
  ClipReader(const File& file, const ClipTargets& targets, Accessors& accessors, Notes& notes)
      : file_(file), targets_(targets), accessors_(accessors), notes_(notes) {}

  AnimationClip read(std::size_t index) {
    const std::string place = placeOf("animations", index);
    file_.expectSound(place);
    const tinygltf::Animation& animation = file_.model().animations[index];
    AnimationClip clip;
    clip.name = animation.name.empty() ? "clip " + std::to_string(index) : animation.name;
    std::set<std::pair<int, std::string>> driven;
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      const std::string channelPlace = placeOf(place + ".channels", i);
      const std::optional<int> node = nodeOf(animation.channels[i], channelPlace);
      if (!node) continue;
      const std::string& path = animation.channels[i].target_path;
      if (!driven.emplace(*node, path).second) {
        notes_.add("clip \"" + clip.name +
                   "\": further channels for the same property are ignored: the first one plays");
        continue;
      }
      const std::size_t sampler = samplerOf(animation, i, channelPlace + ".sampler");
      const Keys keys{animation.samplers[sampler], placeOf(place + ".samplers", sampler)};
      if (path == kWeights) readMorphs(keys, at(targets_.morphsOf, *node), clip);
      else readChannel(keys, at(targets_.skeletonNode, *node), *pathNamed(path), clip);
    }
    return clip;
  }

 private:
  /// A sampler and its JSON path.
  struct Keys {
    const tinygltf::AnimationSampler& sampler;
    std::string place;
  };
  /// Its accessors, opened.
  struct OpenKeys {
    const Accessor& input;
    const Accessor& output;
    std::size_t perKey = 1;          ///< Values of one key: 3 with tangents.
    std::vector<std::size_t> order;  ///< Keys in increasing time, each time once.
  };

  static std::optional<ChannelPath> pathNamed(const std::string& path) {
    if (path == "translation") return ChannelPath::kTranslation;
    if (path == "rotation") return ChannelPath::kRotation;
    if (path == "scale") return ChannelPath::kScale;
    return std::nullopt;
  }

  /// File number of the node that a channel moves; nullopt: none.
  std::optional<int> nodeOf(const tinygltf::AnimationChannel& from, const std::string& place) {
    file_.expectSound(place);
    const bool morphs = from.target_path == kWeights;
    if (!morphs && !pathNamed(from.target_path)) {
      notes_.add("animation channels for \"" + from.target_path.substr(0, 40) +
                 "\" are ignored: bones play their position, rotation and scale only");
      return std::nullopt;
    }
    file_.expectSound(place + ".target.node");
    if (morphs) {
      const bool known = from.target_node >= 0 && !targets_.morphsOf.empty();
      if (known && at(targets_.morphsOf, from.target_node).count > 0) return from.target_node;
      notes_.add("animation channels for the weights of nodes without morph targets are ignored: they move nothing");
      return std::nullopt;
    }
    const int node = from.target_node < 0 ? -1 : at(targets_.skeletonNode, from.target_node);
    if (node < 0) {
      notes_.add("animation channels for nodes that move no bone are ignored: nothing follows them");
      return std::nullopt;
    }
    if (at(targets_.skeleton.nodes, node).rest.matrix) {
      notes_.add("animation channels for nodes placed by a matrix are ignored: such nodes stay still");
      return std::nullopt;
    }
    return from.target_node;
  }

  std::size_t samplerOf(const tinygltf::Animation& animation, std::size_t channel, const std::string& place) const {
    file_.expectSound(place);
    const int sampler = animation.channels[channel].sampler;
    const std::size_t samplers = animation.samplers.size();
    if (sampler < 0) refuse(place, "missing");
    if (toIndex(sampler) >= samplers) {
      refuse(place, "there is no sampler " + std::to_string(sampler) + "; the file has " + std::to_string(samplers));
    }
    return toIndex(sampler);
  }

  static Interpolation interpolationOf(const Keys& keys) {
    const std::string& mode = keys.sampler.interpolation;
    if (mode == "STEP") return Interpolation::kStep;
    if (mode == "CUBICSPLINE") return Interpolation::kCubicSpline;
    if (mode != "LINEAR") refuse(keys.place + ".interpolation", "expected LINEAR, STEP or CUBICSPLINE");
    return Interpolation::kLinear;
  }

  /// nullopt for a sampler without keys.  @param type  of the output  @param width  elements per value
  std::optional<OpenKeys> open(const Keys& keys, int type, std::size_t width, const std::string& clip) {
    const std::string& place = keys.place;
    file_.expectSound(place);
    const std::size_t perKey = interpolationOf(keys) == Interpolation::kCubicSpline ? 3 : 1;
    const Accessor& input = accessors_.open(keys.sampler.input, place + ".input", TINYGLTF_TYPE_SCALAR);
    const Accessor& output = accessors_.open(keys.sampler.output, place + ".output", type);
    if (output.count() / perKey / width < input.count()) {
      refuse(place, std::to_string(output.count()) + " values for " + std::to_string(input.count()) + " keys");
    }
    if (input.count() == 0) {
      notes_.add("clip \"" + clip + "\": channels without keys are ignored: these bones stay still");
      return std::nullopt;
    }
    if (input.count() > (kMaxKeyValues - keyValues_) / perKey / width) refuse(place, "the file has too many keys");
    keyValues_ += perKey * width * input.count();
    return OpenKeys{input, output, perKey, orderedKeys(input, clip)};
  }

  void readChannel(const Keys& keys, int node, ChannelPath path, AnimationClip& clip) {
    const int type = path == ChannelPath::kRotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3;
    const std::optional<OpenKeys> from = open(keys, type, 1, clip.name);
    if (!from) return;
    Channel channel;
    channel.node = node;
    channel.path = path;
    channel.interpolation = interpolationOf(keys);
    channel.values.reserve(from->perKey * from->order.size());
    for (const std::size_t key : from->order) {
      channel.times.push_back(timeOf(from->input, key));
      for (std::size_t part = 0; part < from->perKey; ++part) {
        const bool isValue = from->perKey == 1 || part == 1;
        channel.values.push_back(valueOf(from->output, from->perKey * key + part, channel.path, isValue));
      }
    }
    clip.duration = std::max(clip.duration, channel.times.back());
    clip.channels.push_back(std::move(channel));
  }

  void readMorphs(const Keys& keys, const NodeTargets& of, AnimationClip& clip) {
    const std::size_t width = toIndex(of.count);
    const std::optional<OpenKeys> from = open(keys, TINYGLTF_TYPE_SCALAR, width, clip.name);
    if (!from) return;
    MorphChannel channel;
    channel.firstTarget = of.first;
    channel.targets = of.count;
    channel.interpolation = interpolationOf(keys);
    channel.values.reserve(from->perKey * width * from->order.size());
    for (const std::size_t key : from->order) {
      channel.times.push_back(timeOf(from->input, key));
      for (std::size_t i = 0; i < from->perKey * width; ++i) {
        channel.values.push_back(static_cast<float>(numberAt(from->output, key * from->perKey * width + i, 0)));
      }
    }
    clip.duration = std::max(clip.duration, channel.times.back());
    clip.morphChannels.push_back(std::move(channel));
  }

  std::vector<std::size_t> orderedKeys(const Accessor& input, const std::string& clip) {
    std::vector<std::size_t> keys(input.count());
    std::iota(keys.begin(), keys.end(), std::size_t{0});
    bool ordered = true;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const double time = input.number(k, 0);
      if (!(std::abs(time) <= kMaxValue))
        refuse(input.place(), "key time " + std::to_string(k) + " is not finite or too large");
      ordered = ordered && (k == 0 || timeOf(input, k - 1) < timeOf(input, k));
    }
    if (ordered) return keys;
    notes_.add("clip \"" + clip +
               "\": key times were out of order or repeated: they are sorted, and the last of equal ones plays");
    std::ranges::stable_sort(keys, {}, [&](std::size_t k) { return timeOf(input, k); });
    std::vector<std::size_t> kept;
    for (const std::size_t key : keys) {
      if (!kept.empty() && timeOf(input, kept.back()) == timeOf(input, key)) kept.pop_back();
      kept.push_back(key);
    }
    return kept;
  }

  static float timeOf(const Accessor& input, std::size_t key) { return static_cast<float>(input.number(key, 0)); }

  static double numberAt(const Accessor& output, std::size_t element, int component) {
    const double number = output.number(element, component);
    if (!(std::abs(number) <= kMaxValue)) {
      refuse(output.place(), "value " + std::to_string(element) + " is not finite or too large");
    }
    return number;
  }

  /// @param isValue  not a tangent
  static glm::vec4 valueOf(const Accessor& output, std::size_t element, ChannelPath path, bool isValue) {
    glm::vec4 value(0.0f);
    for (int c = 0; c < output.components(); ++c) value[c] = static_cast<float>(numberAt(output, element, c));
    // A rotation of length 0 becomes the identity.
    if (path == ChannelPath::kRotation && isValue && value == glm::vec4(0.0f)) value.w = 1.0f;
    return value;
  }

  const File& file_;
  const ClipTargets& targets_;
  Accessors& accessors_;
  Notes& notes_;
  std::size_t keyValues_ = 0;
};

}  // namespace

std::vector<AnimationClip> readClips(const File& file, const ClipTargets& targets, Accessors& accessors, Notes& notes) {
  ClipReader reader(file, targets, accessors, notes);
  std::vector<AnimationClip> clips;
  for (std::size_t i = 0; i < file.model().animations.size(); ++i) {
    AnimationClip clip = reader.read(i);
    if (!clip.channels.empty() || !clip.morphChannels.empty()) clips.push_back(std::move(clip));
    else notes.add("clip \"" + clip.name + "\" is ignored: it moves no bone and no shape");
  }
  return clips;
}

}  // namespace sinew::gltf
