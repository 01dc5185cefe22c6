// core/io/gltf/animation.cpp: reading animations (glTF 2.0, section 3.11).

#include "core/io/gltf/animation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "sinew/io/gltf_import.h"

namespace sinew::gltf {
namespace {

/// Key values of all clips together: 256 MiB. Accessors may be shared, so a small file could ask for much more.
constexpr std::size_t kMostKeyValues = 16U << 20;
constexpr double kLargestValue = 1e15;

class ClipReader {
 public:
  ClipReader(const Skeleton& skeleton, std::span<const int> skeletonNode, Accessors& accessors, Notes& notes)
      : skeleton_(skeleton), skeletonNode_(skeletonNode), accessors_(accessors), notes_(notes) {}

  AnimationClip read(const Field& field, std::size_t number) {
    AnimationClip clip;
    clip.name = std::string(field.member("name").text(""));
    if (clip.name.empty()) clip.name = "clip " + std::to_string(number);
    const Field channels = field.member("channels");
    std::set<std::pair<int, ChannelPath>> driven;
    for (std::size_t i = 0; i < channels.size(); ++i) {
      std::optional<Channel> channel = target(channels.item(i).member("target"));
      if (!channel) continue;
      if (!driven.emplace(channel->node, channel->path).second) {
        notes_.add("clip \"" + clip.name + "\": more than one channel for the same property; the first counts");
        continue;
      }
      const Field samplers = field.member("samplers");
      const int sampler = channels.item(i).member("sampler").requiredIndex(samplers.size(), "sampler");
      if (!fillKeys(samplers.item(static_cast<std::size_t>(sampler)), clip.name, *channel)) continue;
      clip.duration = std::max(clip.duration, channel->times.back());
      clip.channels.push_back(std::move(*channel));
    }
    return clip;
  }

 private:
  /// Which node and property; nullopt for what moves nothing of the skeleton.
  std::optional<Channel> target(const Field& field) {
    Channel channel;
    const std::string_view path = field.member("path").text("");
    if (path == "translation") channel.path = ChannelPath::kTranslation;
    else if (path == "rotation") channel.path = ChannelPath::kRotation;
    else if (path == "scale") channel.path = ChannelPath::kScale;
    else {
      notes_.add("animation channels for \"" + std::string(path.substr(0, 40)) + "\"");
      return std::nullopt;
    }
    const std::optional<int> node = field.member("node").index(skeletonNode_.size(), "node");
    channel.node = node ? skeletonNode_[static_cast<std::size_t>(*node)] : -1;
    if (channel.node < 0) {
      notes_.add("animation channels for nodes that move no bone");
      return std::nullopt;
    }
    if (skeleton_.nodes[static_cast<std::size_t>(channel.node)].rest.matrix) {
      notes_.add("animation channels for nodes placed by a matrix, which cannot be animated");
      return std::nullopt;
    }
    return channel;
  }

  /// False for a sampler without keys.
  bool fillKeys(const Field& sampler, const std::string& clip, Channel& channel) {
    const std::string_view mode = sampler.member("interpolation").text("LINEAR");
    if (mode == "STEP") channel.interpolation = Interpolation::kStep;
    else if (mode == "CUBICSPLINE") channel.interpolation = Interpolation::kCubicSpline;
    else if (mode != "LINEAR") refuse(sampler.member("interpolation").place(), "expected LINEAR, STEP or CUBICSPLINE");

    const Accessor& input = accessors_.open(sampler.member("input"), {"SCALAR"});
    const bool rotation = channel.path == ChannelPath::kRotation;
    const Accessor& output = accessors_.open(sampler.member("output"), {rotation ? "VEC4" : "VEC3"});
    const std::size_t perKey = channel.interpolation == Interpolation::kCubicSpline ? 3 : 1;
    if (output.count() / perKey < input.count()) {
      refuse(sampler.place(),
             std::to_string(output.count()) + " values for " + std::to_string(input.count()) + " keys");
    }
    if (input.count() == 0) {
      notes_.add("clip \"" + clip + "\": channels without keys");
      return false;
    }
    if (input.count() > (kMostKeyValues - keyValues_) / perKey) refuse(sampler.place(), "the file has too many keys");
    keyValues_ += perKey * input.count();
    readKeys(input, output, perKey, orderedKeys(input, clip), channel);
    return true;
  }

  /// Keys in increasing time, each time once.
  std::vector<std::size_t> orderedKeys(const Accessor& input, const std::string& clip) {
    std::vector<std::size_t> keys(input.count());
    std::iota(keys.begin(), keys.end(), std::size_t{0});
    bool ordered = true;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const double time = input.number(k, 0);
      if (!(std::abs(time) <= kLargestValue))
        refuse(input.place(), "key time " + std::to_string(k) + " is not finite or too large");
      ordered = ordered && (k == 0 || timeOf(input, k - 1) < timeOf(input, k));
    }
    if (ordered) return keys;
    notes_.add("clip \"" + clip + "\": key times out of order or repeated; sorted, the last of equal ones counts");
    std::ranges::stable_sort(keys, {}, [&](std::size_t k) { return timeOf(input, k); });
    std::vector<std::size_t> kept;
    for (const std::size_t key : keys) {
      if (!kept.empty() && timeOf(input, kept.back()) == timeOf(input, key)) kept.pop_back();
      kept.push_back(key);
    }
    return kept;
  }

  static float timeOf(const Accessor& input, std::size_t key) { return static_cast<float>(input.number(key, 0)); }

  static void readKeys(const Accessor& input, const Accessor& output, std::size_t perKey,
                       const std::vector<std::size_t>& keys, Channel& channel) {
    channel.times.reserve(keys.size());
    channel.values.reserve(perKey * keys.size());
    for (const std::size_t key : keys) {
      channel.times.push_back(timeOf(input, key));
      for (std::size_t part = 0; part < perKey; ++part) {
        channel.values.push_back(valueOf(output, perKey * key + part, channel.path, perKey == 1 || part == 1));
      }
    }
  }

  /// @param isValue not a tangent.
  static glm::vec4 valueOf(const Accessor& output, std::size_t element, ChannelPath path, bool isValue) {
    glm::vec4 value(0.0f);
    for (int c = 0; c < output.components(); ++c) {
      const double number = output.number(element, c);
      if (!(std::abs(number) <= kLargestValue)) {
        refuse(output.place(), "value " + std::to_string(element) + " is not finite or too large");
      }
      value[c] = static_cast<float>(number);
    }
    // A rotation of no length has no direction; it stands for none.
    if (path == ChannelPath::kRotation && isValue && value == glm::vec4(0.0f)) value.w = 1.0f;
    return value;
  }

  const Skeleton& skeleton_;
  std::span<const int> skeletonNode_;
  Accessors& accessors_;
  Notes& notes_;
  std::size_t keyValues_ = 0;
};

}  // namespace

std::vector<AnimationClip> readClips(const Field& root, const Skeleton& skeleton, std::span<const int> skeletonNode,
                                     Accessors& accessors, Notes& notes) {
  const Field list = root.member("animations");
  if (list.size() > static_cast<std::size_t>(kMaxClips)) refuse(list.place(), "more than 1000 clips");
  ClipReader reader(skeleton, skeletonNode, accessors, notes);
  std::vector<AnimationClip> clips;
  for (std::size_t i = 0; i < list.size(); ++i) {
    AnimationClip clip = reader.read(list.item(i), i);
    if (clip.channels.empty()) notes.add("clip \"" + clip.name + "\": moves no bone");
    else clips.push_back(std::move(clip));
  }
  return clips;
}

}  // namespace sinew::gltf
