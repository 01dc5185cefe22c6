// core/export/clip_json.cpp: members of glTF's animations.
#include "core/export/clip_json.h"

#include <utility>

namespace sinew::exporting {

std::string clipName(const Json& clip, int index) {
  const std::string name = clip.at("name").text("");
  return name.empty() ? "clip " + std::to_string(index) : name;
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
