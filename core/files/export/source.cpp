// core/files/export/source.cpp: the stages of the import again, as far as they tell where things come from.
#include "core/files/export/source.h"

#include <algorithm>
#include <utility>

#include "core/files/export/plain_source.h"
#include "core/files/gltf/animation.h"
#include "core/files/gltf/uri.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

bool sameMesh(const ControlMesh& a, const ControlMesh& b) {
  return a.positions == b.positions &&
         std::ranges::equal(a.triangles, b.triangles, {}, &ControlTriangle::vertices, &ControlTriangle::vertices);
}

bool sameSkeleton(const Skeleton& a, const Skeleton& b) {
  return std::ranges::equal(a.nodes, b.nodes, {}, &Node::parent, &Node::parent) &&
         std::ranges::equal(a.bones, b.bones, {}, &Bone::path, &Bone::path) &&
         std::ranges::equal(a.bones, b.bones, {}, &Bone::bindInWorld, &Bone::bindInWorld) &&
         std::ranges::equal(a.bindings, b.bindings, {}, &Binding::bone, &Binding::bone) &&
         std::ranges::equal(a.bindings, b.bindings, {}, &Binding::inverseBind, &Binding::inverseBind);
}

bool sameChannel(const Channel& a, const Channel& b) {
  return a.node == b.node && a.path == b.path && a.interpolation == b.interpolation && a.times == b.times &&
         a.values == b.values;
}

bool sameMorphChannel(const MorphChannel& a, const MorphChannel& b) {
  return a.firstTarget == b.firstTarget && a.targets == b.targets && a.interpolation == b.interpolation &&
         a.times == b.times && a.values == b.values;
}

bool sameClip(const AnimationClip& a, const AnimationClip& b) {
  return a.name == b.name && std::ranges::equal(a.channels, b.channels, sameChannel) &&
         std::ranges::equal(a.morphChannels, b.morphChannels, sameMorphChannel);
}

bool sameMorph(const MorphTarget& a, const MorphTarget& b) {
  return a.name == b.name && a.node == b.node && a.weight == b.weight && a.vertices == b.vertices &&
         a.deltas == b.deltas;
}

}  // namespace

Source::Source(const std::filesystem::path& from) : Source(from, gltf::contentsOf(from)) {}

Source::Source(const std::filesystem::path& from, std::vector<std::uint8_t> contents)
    : path(from),
      root(gltf::parseJson(gltf::openContainer(contents).json, {})),
      file(std::move(contents), gltf::folderOf(from)),
      accessors(file) {
  makePlain(root, file);
  gltf::Notes notes;  // The import has told them.
  const gltf::NodeTree tree = gltf::readNodes(file, notes);
  bound = gltf::bindSkeleton(file, tree, accessors, notes);
  gltf::Materials materials = gltf::readMaterials(file, notes, gltf::Images::kLeftOut);
  soup = gltf::readTriangles(file, tree, bound, materials, accessors, notes, &origin);
  controlTriangle = weldedTriangles(soup, gltf::weldTolerance(soup));
  std::vector<int> standsFor;
  mesh = weld(soup, gltf::weldTolerance(soup), &standsFor);
  morphTargets = gltf::readMorphs(file, tree, bound, origin, standsFor, accessors, notes);
  fileNode.assign(bound.skeleton.nodes.size(), -1);
  for (std::size_t node = 0; node < bound.skeletonNode.size(); ++node) {
    if (bound.skeletonNode[node] >= 0) at(fileNode, bound.skeletonNode[node]) = static_cast<int>(node);
  }
}

bool Source::reads(const std::filesystem::path& other) const {
  std::error_code absent;  // A file that is not there yet is read by nobody.
  if (std::filesystem::equivalent(path, other, absent)) return true;
  for (const char* list : {"buffers", "images"}) {
    for (const Json& item : root.at(list).items()) {
      const std::string uri = item.at("uri").text("");
      if (uri.empty() || gltf::isDataUri(uri)) continue;
      const Result<std::filesystem::path> relative = gltf::relativePathOf(uri);
      if (relative && std::filesystem::equivalent(path.parent_path() / relative.value(), other, absent)) return true;
    }
  }
  return false;
}

int Source::nodeOfBone(int bone) const { return at(fileNode, at(bound.skeleton.bones, bone).node); }

int Source::nodeOf(int binding) const { return nodeOfBone(at(bound.skeleton.bindings, binding).bone); }

void requireSame(const Source& source, const Character& character) {
  gltf::Notes notes;  // The import has told them.
  gltf::Accessors accessors(source.file);
  const auto morphsOf = gltf::targetsOfNodes(source.bound.skeletonNode.size(), source.morphTargets);
  const gltf::ClipTargets targets{source.bound.skeleton, source.bound.skeletonNode, morphsOf};
  const auto clips = gltf::readClips(source.file, targets, accessors, notes);
  std::vector<AnimationClip> imported = character.clips;
  std::erase_if(imported, [](const AnimationClip& clip) { return clip.turnsBindPose || !clip.addedFrom.empty(); });
  if (sameMesh(source.mesh, character.mesh) && sameSkeleton(source.bound.skeleton, character.skeleton) &&
      std::ranges::equal(source.morphTargets, character.morphTargets, sameMorph) &&
      std::ranges::equal(clips, imported, sameClip)) {
    return;
  }
  gltf::refuse({}, "has changed since it was opened: its mesh, joints or clips are others; open it again");
}

}  // namespace sinew::exporting
