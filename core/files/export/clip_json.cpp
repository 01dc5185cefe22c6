// core/files/export/clip_json.cpp: members of glTF's animations.
#include "core/files/export/clip_json.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"

namespace sinew::exporting {

namespace {

constexpr float kUnitWithin = 1e-5f;

}  // namespace

std::string clipName(const Json& clip, int index) {
  const std::string name = clip.at("name").text("");
  return name.empty() ? "clip " + std::to_string(index) : name;
}

namespace {

const char* wordFor(Interpolation interpolation) {
  if (interpolation == Interpolation::kStep) return "STEP";
  return interpolation == Interpolation::kCubicSpline ? "CUBICSPLINE" : "LINEAR";
}

const char* wordFor(ChannelPath path) {
  if (path == ChannelPath::kRotation) return "rotation";
  return path == ChannelPath::kScale ? "scale" : "translation";
}

int addKeys(int clip, const std::vector<float>& times, Interpolation interpolation, const AccessorData& values,
            GltfRewrite& rewrite) {
  const int input = addTimes(times, rewrite);
  const int sampler = addSampler(clip, input, rewrite.addAccessor(values), rewrite);
  Json& samplers = *memberOf(rewrite.element("animations", clip), "samplers");
  at(samplers.children, sampler).set("interpolation", wordFor(interpolation));
  return sampler;
}

/// glTF wants unit rotations; tangents are none.
std::vector<float> fileValues(const Channel& channel) {
  const bool turns = channel.path == ChannelPath::kRotation;
  const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
  std::vector<float> values;
  for (std::size_t i = 0; i < channel.values.size(); ++i) {
    glm::vec4 value = channel.values[i];
    const float length = glm::length(value);
    const bool isValue = !cubic || i % 3 == 1;
    if (turns && isValue && length > 0.0f && std::abs(length - 1.0f) > kUnitWithin) value /= length;
    for (int c = 0; c < (turns ? 4 : 3); ++c) values.push_back(value[c]);
  }
  return values;
}

}  // namespace

void addClip(const AnimationClip& clip, std::span<const int> fileNode, std::span<const MorphTarget> targets,
             GltfRewrite& rewrite) {
  Json made = Json::object();
  made.set("name", clip.name).set("samplers", Json::array()).set("channels", Json::array());
  const int index = rewrite.append("animations", std::move(made));
  for (const Channel& channel : clip.channels) {
    const std::vector<float> values = fileValues(channel);
    const char* const type = channel.path == ChannelPath::kRotation ? "VEC4" : "VEC3";
    const AccessorData data{bytesOf(values), TINYGLTF_COMPONENT_TYPE_FLOAT, type, channel.values.size()};
    const int sampler = addKeys(index, channel.times, channel.interpolation, data, rewrite);
    addChannel(index, sampler, at(fileNode, channel.node), wordFor(channel.path), rewrite);
  }
  for (const MorphChannel& channel : clip.morphChannels) {
    const AccessorData data{bytesOf(channel.values), TINYGLTF_COMPONENT_TYPE_FLOAT, "SCALAR", channel.values.size()};
    const int sampler = addKeys(index, channel.times, channel.interpolation, data, rewrite);
    addChannel(index, sampler, at(targets, channel.firstTarget).node, "weights", rewrite);
  }
}

int addTimes(const std::vector<float>& times, GltfRewrite& rewrite) {
  const int input = rewrite.addAccessor({bytesOf(times), TINYGLTF_COMPONENT_TYPE_FLOAT, "SCALAR", times.size()});
  rewrite.element("accessors", input)
      .set("min", Json::array({static_cast<double>(times.front())}))
      .set("max", Json::array({static_cast<double>(times.back())}));
  return input;
}

int addSampler(int clip, int input, int output, GltfRewrite& rewrite) {
  Json sampler = Json::object();
  sampler.set("input", input).set("interpolation", "LINEAR").set("output", output);
  Json& samplers = *memberOf(rewrite.element("animations", clip), "samplers");
  samplers.push(std::move(sampler));
  return static_cast<int>(samplers.children.size()) - 1;
}

int addWeightSampler(int clip, const std::vector<float>& times, const std::vector<float>& weights,
                     GltfRewrite& rewrite) {
  const int input = addTimes(times, rewrite);
  const int output = rewrite.addAccessor({bytesOf(weights), TINYGLTF_COMPONENT_TYPE_FLOAT, "SCALAR", weights.size()});
  return addSampler(clip, input, output, rewrite);
}

void addChannel(int clip, int sampler, int node, const char* path, GltfRewrite& rewrite) {
  Json channel = Json::object();
  channel.set("sampler", sampler).set("target", Json::object().set("node", node).set("path", path));
  memberOf(rewrite.element("animations", clip), "channels")->push(std::move(channel));
}

}  // namespace sinew::exporting
