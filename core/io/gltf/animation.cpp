// core/io/gltf/animation.cpp: reading animations (glTF 2.0, section 3.11).

#include "core/io/gltf/animation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "core/base/at.h"

namespace sinew::gltf {
namespace {

/// Key values of all clips together: 256 MiB. Accessors may be shared, so a small file could ask for much more.
constexpr std::size_t kMaxKeyValues = 16U << 20;
constexpr double kMaxValue = 1e15;

class ClipReader {
 public:
  ClipReader(const File& file, const Skeleton& skeleton, std::span<const int> skeletonNode, Accessors& accessors,
             Notes& notes)
      : file_(file), skeleton_(skeleton), skeletonNode_(skeletonNode), accessors_(accessors), notes_(notes) {}

  AnimationClip read(std::size_t index) {
    const std::string place = placeOf("animations", index);
    file_.expectSound(place);
    const tinygltf::Animation& animation = file_.model().animations[index];
    AnimationClip clip;
    clip.name = animation.name.empty() ? "clip " + std::to_string(index) : animation.name;
    std::set<std::pair<int, ChannelPath>> driven;
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
      const std::string channelPlace = placeOf(place + ".channels", i);
      std::optional<Channel> channel = target(animation.channels[i], channelPlace);
      if (!channel) continue;
      if (!driven.emplace(channel->node, channel->path).second) {
        notes_.add("clip \"" + clip.name +
                   "\": further channels for the same property are ignored: the first one plays");
        continue;
      }
      const std::size_t sampler = samplerOf(animation, i, channelPlace + ".sampler");
      const std::string samplerPlace = placeOf(place + ".samplers", sampler);
      if (!fillKeys(animation.samplers[sampler], samplerPlace, clip.name, *channel)) continue;
      clip.duration = std::max(clip.duration, channel->times.back());
      clip.channels.push_back(std::move(*channel));
    }
    return clip;
  }

 private:
  /// Which node and property; nullopt for what moves nothing of the skeleton.
  std::optional<Channel> target(const tinygltf::AnimationChannel& from, const std::string& place) {
    file_.expectSound(place);
    Channel channel;
    if (from.target_path == "translation") channel.path = ChannelPath::kTranslation;
    else if (from.target_path == "rotation") channel.path = ChannelPath::kRotation;
    else if (from.target_path == "scale") channel.path = ChannelPath::kScale;
    else {
      notes_.add("animation channels for \"" + from.target_path.substr(0, 40) +
                 "\" are ignored: bones play their position, rotation and scale only");
      return std::nullopt;
    }
    file_.expectSound(place + ".target.node");
    channel.node = from.target_node < 0 ? -1 : at(skeletonNode_, from.target_node);
    if (channel.node < 0) {
      notes_.add("animation channels for nodes that move no bone are ignored: nothing follows them");
      return std::nullopt;
    }
    if (at(skeleton_.nodes, channel.node).rest.matrix) {
      notes_.add("animation channels for nodes placed by a matrix are ignored: such nodes stay still");
      return std::nullopt;
    }
    return channel;
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

  /// False for a sampler without keys.
  bool fillKeys(const tinygltf::AnimationSampler& sampler, const std::string& place, const std::string& clip,
                Channel& channel) {
    file_.expectSound(place);
    const std::string& mode = sampler.interpolation;
    if (mode == "STEP") channel.interpolation = Interpolation::kStep;
    else if (mode == "CUBICSPLINE") channel.interpolation = Interpolation::kCubicSpline;
    else if (mode != "LINEAR") refuse(place + ".interpolation", "expected LINEAR, STEP or CUBICSPLINE");

    const Accessor& input = accessors_.open(sampler.input, place + ".input", TINYGLTF_TYPE_SCALAR);
    const bool rotation = channel.path == ChannelPath::kRotation;
    const Accessor& output =
        accessors_.open(sampler.output, place + ".output", rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3);
    const std::size_t perKey = channel.interpolation == Interpolation::kCubicSpline ? 3 : 1;
    if (output.count() / perKey < input.count()) {
      refuse(place, std::to_string(output.count()) + " values for " + std::to_string(input.count()) + " keys");
    }
    if (input.count() == 0) {
      notes_.add("clip \"" + clip + "\": channels without keys are ignored: these bones stay still");
      return false;
    }
    if (input.count() > (kMaxKeyValues - keyValues_) / perKey) refuse(place, "the file has too many keys");
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
      if (!(std::abs(number) <= kMaxValue)) {
        refuse(output.place(), "value " + std::to_string(element) + " is not finite or too large");
      }
      value[c] = static_cast<float>(number);
    }
    // A rotation of no length has no direction; it stands for none.
    if (path == ChannelPath::kRotation && isValue && value == glm::vec4(0.0f)) value.w = 1.0f;
    return value;
  }

  const File& file_;
  const Skeleton& skeleton_;
  std::span<const int> skeletonNode_;
  Accessors& accessors_;
  Notes& notes_;
  std::size_t keyValues_ = 0;
};

}  // namespace

std::vector<AnimationClip> readClips(const File& file, const Skeleton& skeleton, std::span<const int> skeletonNode,
                                     Accessors& accessors, Notes& notes) {
  ClipReader reader(file, skeleton, skeletonNode, accessors, notes);
  std::vector<AnimationClip> clips;
  for (std::size_t i = 0; i < file.model().animations.size(); ++i) {
    AnimationClip clip = reader.read(i);
    if (clip.channels.empty()) notes.add("clip \"" + clip.name + "\" is ignored: it moves no bone");
    else clips.push_back(std::move(clip));
  }
  return clips;
}

}  // namespace sinew::gltf
