// core/files/export/helper_nodes.cpp: nodes, samplers and channels as JSON and bytes.
#include "core/files/export/helper_nodes.h"

#include <algorithm>
#include <set>
#include <string>

#include <glm/vec4.hpp>

#include "core/files/export/clip_json.h"

namespace sinew::exporting {
namespace {

/// glTF's order.
glm::vec4 xyzw(const glm::dquat& q) {
  return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

std::string freeName(std::set<std::string>& taken, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; !taken.insert(name).second; ++number) name = wanted + ' ' + std::to_string(number);
  return name;
}

/// One clip of the file, with channels to come.
class ClipKeys {
 public:
  ClipKeys(int clip, const HelperClip& keys, GltfRewrite& rewrite)
      : clip_(clip), rewrite_(rewrite), input_(addTimes(keys.times, rewrite)) {}

  void add(const HelperJoint& joint, int node, const std::vector<Trs>& locals) {
    std::vector<glm::vec3> translations;
    std::vector<glm::vec4> rotations;
    std::vector<glm::vec3> scales;
    for (const Trs& local : locals) {
      translations.emplace_back(local.translation);
      scales.emplace_back(local.scale);
      const glm::vec4 turn = xyzw(local.rotation);
      const bool isFar = !rotations.empty() && glm::dot(rotations.back(), turn) < 0.0f;  // The short way between keys.
      rotations.push_back(isFar ? -turn : turn);
    }
    addPath(node, "translation", "VEC3", translations, glm::vec3(joint.rest.translation));
    addPath(node, "rotation", "VEC4", rotations, xyzw(joint.rest.rotation));
    addPath(node, "scale", "VEC3", scales, glm::vec3(joint.rest.scale));
  }

 private:
  template <class Value>
  void addPath(int node, const char* path, const char* type, const std::vector<Value>& values, const Value& rest) {
    if (std::ranges::all_of(values, [&](const Value& value) { return value == rest; })) return;
    const int output = rewrite_.addAccessor({bytesOf(values), TINYGLTF_COMPONENT_TYPE_FLOAT, type, values.size()});
    addChannel(clip_, addSampler(clip_, input_, output, rewrite_), node, path, rewrite_);
  }

  int clip_;
  GltfRewrite& rewrite_;
  int input_;
};

}  // namespace

std::vector<int> addHelperNodes(const Source& source, std::span<const HelperJoint> joints, GltfRewrite& rewrite) {
  std::set<std::string> taken;
  for (const Json& node : rewrite.root().at("nodes").items()) taken.insert(node.at("name").text(""));
  std::vector<int> nodes;
  for (const HelperJoint& joint : joints) {
    const glm::vec4 turn = xyzw(joint.rest.rotation);
    Json node = Json::object();
    node.set("name", freeName(taken, joint.name)).set("translation", numbersOf(joint.rest.translation));
    node.set("rotation", Json::array({static_cast<double>(turn.x), static_cast<double>(turn.y),
                                      static_cast<double>(turn.z), static_cast<double>(turn.w)}));
    nodes.push_back(rewrite.append("nodes", std::move(node)));
    Json& parent = rewrite.element("nodes", source.nodeOfBone(joint.bone));
    ensureMember(parent, "children", Json::array()).push(nodes.back());
  }
  return nodes;
}

void addHelperKeys(std::span<const HelperJoint> joints, std::span<const int> nodes, std::span<const HelperClip> clips,
                   GltfRewrite& rewrite) {
  if (joints.empty()) return;
  const auto inFile = static_cast<int>(rewrite.root().at("animations").items().size());
  std::size_t next = 0;
  for (int clip = 0; clip < inFile && next < clips.size(); ++clip) {
    if (clipName(rewrite.element("animations", clip), clip) != clips[next].clip) continue;
    ClipKeys keys(clip, clips[next], rewrite);
    for (std::size_t j = 0; j < joints.size(); ++j) keys.add(joints[j], nodes[j], clips[next].locals[j]);
    ++next;
  }
}

}  // namespace sinew::exporting
