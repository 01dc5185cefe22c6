// core/files/export/file_morphs.cpp: surface differences into each mesh's space; weights of one node out of all.
#include "core/files/export/file_morphs.h"

#include <algorithm>
#include <unordered_map>

#include "core/files/export/clip_json.h"
#include "core/files/export/into_mesh.h"
#include "core/files/export/morph_targets.h"
#include "core/files/gltf/morph.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

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

/// World of the bind pose -> the space of the primitive's mesh.
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

/// What file and rig give together, in place of the file's channels.
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

}  // namespace

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

}  // namespace sinew::exporting
