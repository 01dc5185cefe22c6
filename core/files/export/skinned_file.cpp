// core/files/export/skinned_file.cpp: replaces every mesh of the scene, and keeps everything else.
#include "core/files/export/skinned_file.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include <glm/vec4.hpp>

#include "core/files/export/clip_repair.h"
#include "core/files/export/morph_targets.h"
#include "core/files/export/out_primitive.h"
#include "core/files/fit/helper_motion.h"
#include "core/files/fit/played_surface.h"
#include "core/files/gltf/animation.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

// Added joints: nodes, and keys in the clips.

/// glTF's order.
glm::vec4 xyzw(const glm::dquat& q) {
  return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

std::string freeName(std::set<std::string>& taken, const std::string& wanted) {
  std::string name = wanted;
  for (int number = 2; !taken.insert(name).second; ++number) name = wanted + ' ' + std::to_string(number);
  return name;
}

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
      const bool isFar =
          !rotations.empty() && glm::dot(rotations.back(), turn) < 0.0f;  // The shorter rotation between keys.
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

/// Adds a node with a unique name for each joint below that of its bone. Returns the nodes.
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

/// Adds linear channels for the joints to the file's clips; none where a joint stays at rest.
/// @param nodes  [joints]  @param clips  in the order of the file's, which may have more
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

// The file's morph targets on the written meshes, and keys for those that the rig changes.

struct FileMorphs {
  const Source& source;
  const PlayedMorphs& played;
  const Surface& bind;  ///< Without targets.
  bool refined = true;  ///< Else the meshes keep their own targets.
};

std::vector<float> weightsOf(const gltf::NodeTargets& of, std::span<const float> all) {
  const auto own = all.subspan(toIndex(of.first), toIndex(of.count));
  return {own.begin(), own.end()};
}

std::unordered_map<int, glm::vec3> byVertex(const std::vector<int>& vertices, const std::vector<glm::vec3>& values) {
  std::unordered_map<int, glm::vec3> result;
  for (std::size_t i = 0; i < vertices.size(); ++i) result.emplace(vertices[i], values[i]);
  return result;
}

std::vector<glm::vec3> spread(const std::vector<int>& of, const std::unordered_map<int, glm::vec3>& known) {
  std::vector<glm::vec3> values;
  values.reserve(of.size());
  for (const int vertex : of) {
    const auto found = known.find(vertex);
    values.push_back(found == known.end() ? glm::vec3(0.0f) : found->second);
  }
  return values;
}

/// Deltas of a target in the space of the primitive's mesh.
TargetDeltas deltasOf(const RefinedTarget& target, const OutPrimitive& primitive, const Surface& bind,
                      const IntoMesh& into) {
  TargetDeltas deltas{spread(primitive.refined, byVertex(target.vertices, target.deltas)),
                      spread(primitive.drawn, byVertex(target.drawn, target.normals))};
  for (glm::vec3& delta : deltas.positions) delta = glm::vec3(into.way(glm::dvec3(delta)));
  for (std::size_t v = 0; v < deltas.normals.size(); ++v) {
    glm::vec3& turn = deltas.normals[v];
    if (turn == glm::vec3(0.0f)) continue;
    const glm::vec3 normal = shadingNormal(bind, toIndex(primitive.drawn[v]));
    turn = into.normal(normal + turn) - into.normal(normal);
  }
  return deltas;
}

void addTargets(int node, const gltf::NodeTargets& of, const FileMorphs& morphs,
                std::span<const OutPrimitive> primitives, const OutSkins& skins, GltfRewrite& rewrite) {
  const IntoMesh into(skins.meshToBind(node));
  MeshTargets mesh;
  mesh.weights = weightsOf(of, morphs.played.rest);
  for (int k = of.first; k < of.first + of.count; ++k) mesh.names.push_back(at(morphs.source.morphTargets, k).name);
  mesh.deltas = [&](std::size_t primitive, std::size_t target) {
    return deltasOf(at(morphs.played.targets, of.first + static_cast<int>(target)), primitives[primitive], morphs.bind,
                    into);
  };
  addMorphTargets(node, primitives, mesh, rewrite);
}

void dropChannels(int clip, int node, GltfRewrite& rewrite) {
  Json* channels = memberOf(rewrite.element("animations", clip), "channels");
  if (!channels) return;
  std::erase_if(channels->children, [&](const Json& channel) {
    const Json& target = channel.at("target");
    return target.at("path").text("") == "weights" && target.at("node").number(-1.0) == node;
  });
}

/// Replaces the file's channels by the weights of file and rig together.
void replaceKeys(int node, const gltf::NodeTargets& of, const PlayedMorphs& played, GltfRewrite& rewrite) {
  const std::size_t all = played.rest.size();
  const auto inFile = static_cast<int>(rewrite.root().at("animations").items().size());
  std::size_t next = 0;
  for (int clip = 0; clip < inFile && next < played.clips.size(); ++clip) {
    const MorphKeys& keys = played.clips[next];
    if (clipName(rewrite.element("animations", clip), clip) != keys.clip) continue;
    ++next;
    dropChannels(clip, node, rewrite);
    std::vector<float> weights;
    for (std::size_t key = 0; key < keys.times.size(); ++key) {
      const std::vector<float> own = weightsOf(of, std::span(keys.weights).subspan(key * all, all));
      weights.insert(weights.end(), own.begin(), own.end());
    }
    addChannel(clip, addWeightSampler(clip, keys.times, weights, rewrite), node, "weights", rewrite);
  }
}

/// Adds targets to refined meshes, and weights and keys to nodes that the rig changes.
void addFileMorphs(const FileMorphs& morphs, std::span<const OutPrimitive> primitives, const OutSkins& skins,
                   GltfRewrite& rewrite) {
  const PlayedMorphs& played = morphs.played;
  if (played.targets.empty()) return;
  const auto targets = gltf::targetsOfNodes(morphs.source.bound.skeletonNode.size(), morphs.source.morphTargets);
  for (const int node : nodesOf(primitives)) {
    const gltf::NodeTargets& of = at(targets, node);
    if (of.count == 0) continue;
    if (morphs.refined) addTargets(node, of, morphs, primitives, skins, rewrite);
    if (!at(played.keyed, of.first)) continue;
    if (!morphs.refined) rewrite.element("nodes", node).set("weights", numbersOf(weightsOf(of, played.rest)));
    replaceKeys(node, of, played, rewrite);
  }
}

constexpr double kFirstTriangleMode = TINYGLTF_MODE_TRIANGLES;

class FileMaker {
 public:
  FileMaker(Source& source, const Character& character, const JointFit& fit, const SkinnedExportSettings& settings,
            const FinishFile& finish)
      : source_(source),
        fit_(fit),
        settings_(settings),
        finish_(finish),
        rewrite_(source.root, source.file),
        skins_(source),
        primitives_(source, character.mesh, fit.bind(), fit.weights(), skins_),
        character_(character) {}

  SkinnedFile run() {
    keepClips();
    repairClips(source_, rewrite_, left_);
    addClips();
    addHelpers();
    for (const gltf::SoupPart& part : source_.origin.parts) partsOf_[part.node].push_back(part);
    for (const auto& [node, parts] : partsOf_) makeMesh(node, parts);
    addFileMorphs({source_, fit_.morphs(), fit_.bind(), isRefined()}, written_, skins_, rewrite_);
    skins_.write(rewrite_);
    if (!addLineData(source_, fit_.lines(), helperNodes_, rewrite_)) {
      left_.insert("line data: extras of the skin are no object");
    }
    dropEmptyClips();
    ensureMember(rewrite_.root(), "asset", Json::object()).set("generator", "Sinew");
    result_.left.assign(left_.begin(), left_.end());
    if (finish_) finish_(rewrite_, skins_, written_);
    result_.joints = skins_.jointNodes();
    result_.packed = std::move(rewrite_).pack();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool isRefined() const { return settings_.mesh == ExportMesh::kRefined; }

  /// Appends clips from other files, after the repair of the file's own.
  void addClips() {
    for (const AnimationClip& clip : character_.clips) {
      const bool isWanted = settings_.clips.empty() || std::ranges::count(settings_.clips, clip.name) > 0;
      if (!clip.addedFrom.empty() && isWanted) addClip(clip, source_.fileNode, character_.morphTargets, rewrite_);
    }
  }

  void keepClips() {
    Json* clips = memberOf(rewrite_.root(), "animations");
    if (!clips || settings_.clips.empty()) return;
    std::vector<Json> kept;
    int index = 0;
    for (Json& clip : clips->children) {
      const std::string name = clipName(clip, index++);
      if (!std::ranges::count(settings_.clips, name)) continue;
      clip.set("name", name);
      kept.push_back(std::move(clip));
    }
    clips->children = std::move(kept);
  }

  void addHelpers() {
    const std::vector<HelperJoint> joints = fit_.helpers();
    helperNodes_ = addHelperNodes(source_, joints, rewrite_);
    skins_.addJoints(joints, helperNodes_);
    addHelperKeys(joints, helperNodes_, fit_.helperClips(), rewrite_);
  }

  void makeMesh(int node, const std::vector<gltf::SoupPart>& parts) {
    const int number = parts.front().mesh;
    const Json& from = at(source_.root.at("meshes").items(), number);
    Json mesh = from;
    std::vector<Json> made;
    const std::vector<Json>& primitives = from.at("primitives").items();
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const auto part = std::ranges::find(parts, static_cast<int>(p), &gltf::SoupPart::primitive);
      if (part != parts.end()) {
        Json primitive = primitives[p];
        if (makePrimitive(*part, static_cast<int>(made.size()), primitive)) made.push_back(std::move(primitive));
      } else {
        keepOther(node, primitives[p], made);
      }
    }
    place(node, number, std::move(mesh), std::move(made));
  }

  bool makePrimitive(const gltf::SoupPart& part, int place, Json& primitive) {
    WrittenPrimitive written = isRefined() ? primitives_.writeRefined(part, rewrite_, primitive, left_)
                                           : primitives_.writeOriginal(part, rewrite_, primitive, left_);
    result_.vertices += static_cast<std::int64_t>(written.vertices);
    result_.triangles += static_cast<std::int64_t>(written.triangles);
    if (written.vertices == 0) return false;
    written_.push_back({part.node, place, std::move(written.refined), std::move(written.drawn)});
    return true;
  }

  /// Points and lines keep their skin; without one, they are left out.
  void keepOther(int node, const Json& primitive, std::vector<Json>& made) {
    if (primitive.at("mode").number(kFirstTriangleMode) >= kFirstTriangleMode) return;
    if (at(source_.bound.meshes, node)->skin >= 0) made.push_back(primitive);
    else left_.insert("points and lines of meshes without a skin: nothing would move them");
  }

  /// Replaces a mesh that one node shows; several nodes each get their own.
  void place(int node, int number, Json mesh, std::vector<Json> primitives) {
    Json& user = rewrite_.element("nodes", node);
    if (isRefined()) removeMember(user, "weights");
    if (primitives.empty()) {
      removeMember(user, "mesh");
      removeMember(user, "skin");
      return;
    }
    if (isRefined()) removeMember(mesh, "weights");
    mesh.set("primitives", Json::array(std::move(primitives)));
    if (replaced_.insert(number).second && !isShownElsewhere(number)) {
      mesh.key = {};
      rewrite_.element("meshes", number) = std::move(mesh);
      return;
    }
    const int added = rewrite_.append("meshes", std::move(mesh));
    rewrite_.element("nodes", node).set("mesh", added);
  }

  /// Whether a node that keeps the mesh shows it.
  [[nodiscard]] bool isShownElsewhere(int mesh) const {
    const std::vector<Json>& nodes = source_.root.at("nodes").items();
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      if (nodes[node].at("mesh").number(-1.0) == mesh && !partsOf_.contains(static_cast<int>(node))) return true;
    }
    return false;
  }

  [[nodiscard]] bool hasTargets(int node) const {
    return !fit_.morphs().targets.empty() && std::ranges::count(source_.morphTargets, node, &MorphTarget::node) > 0;
  }

  /// Removes channels of removed morph targets, and clips without channels.
  void dropEmptyClips() {
    Json* clips = memberOf(rewrite_.root(), "animations");
    if (!clips) return;
    if (isRefined()) {
      for (Json& clip : clips->children) {
        Json* channels = memberOf(clip, "channels");
        if (!channels) continue;
        std::erase_if(channels->children, [&](const Json& channel) {
          const Json& target = channel.at("target");
          const auto node = static_cast<int>(target.at("node").number(-1.0));
          return target.at("path").text("") == "weights" && partsOf_.contains(node) && !hasTargets(node);
        });
      }
    }
    std::erase_if(clips->children, [](const Json& clip) { return clip.at("channels").items().empty(); });
    if (clips->children.empty()) removeMember(rewrite_.root(), "animations");
  }

  Source& source_;
  const JointFit& fit_;
  const SkinnedExportSettings& settings_;
  const FinishFile& finish_;
  std::vector<OutPrimitive> written_;
  GltfRewrite rewrite_;
  OutSkins skins_;
  OutPrimitives primitives_;
  const Character& character_;
  std::map<int, std::vector<gltf::SoupPart>> partsOf_;  // by node
  std::vector<int> helperNodes_;
  std::set<int> replaced_;  // meshes
  std::set<std::string> left_;
  SkinnedFile result_;
};

}  // namespace

SkinnedFile skinnedFile(Source& source, const Character& character, const JointFit& fit,
                        const SkinnedExportSettings& settings, const FinishFile& finish) {
  return FileMaker(source, character, fit, settings, finish).run();
}

}  // namespace sinew::exporting
