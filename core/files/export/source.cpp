// core/files/export/source.cpp: runs stages of the import again to find the origin of mesh, joints and clips.
#include "core/files/export/source.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "core/character/clip_names.h"
#include "core/files/export/formats.h"
#include "core/files/export/gltf_rewrite.h"
#include "core/files/gltf/animation.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

// Compressed files.

void removeExtension(Json& element, std::string_view name) {
  Json* const extensions = memberOf(element, "extensions");
  if (!extensions) return;
  removeMember(*extensions, name);
  if (extensions->children.empty()) removeMember(element, "extensions");
}

double componentAt(int type, const std::uint8_t* from) {
  return gltf::withComponent(type, [&](auto number) {
    std::memcpy(&number, from, sizeof(number));
    return static_cast<double>(number);
  });
}

/// Minimum and maximum of each component in the view; nullopt if beyond it or not finite.
std::optional<std::pair<Json, Json>> boundsIn(gltf::Bytes view, const tinygltf::Accessor& accessor,
                                              std::size_t stride) {
  const std::size_t components = toIndex(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  const std::size_t size =
      toIndex(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
  if (stride == 0) stride = components * size;
  // Unused accessors are unchecked.
  if (accessor.count == 0 || accessor.byteOffset > view.size() || stride < components * size ||
      (view.size() - accessor.byteOffset) / stride + 1 < accessor.count ||
      accessor.byteOffset + (accessor.count - 1) * stride + components * size > view.size()) {
    return std::nullopt;
  }
  std::pair<Json, Json> bounds{Json::array(), Json::array()};
  for (std::size_t c = 0; c < components; ++c) {
    const std::uint8_t* from = view.data() + accessor.byteOffset + c * size;
    double low = componentAt(accessor.componentType, from);
    double high = low;
    for (std::size_t i = 0; i < accessor.count; ++i) {
      const double number = componentAt(accessor.componentType, from + i * stride);
      if (!std::isfinite(number)) return std::nullopt;
      low = std::min(low, number);
      high = std::max(high, number);
    }
    bounds.first.push(low);
    bounds.second.push(high);
  }
  return bounds;
}

/// Makes views, accessors and primitives plain, as in the file's model; compression leaves no trace. `root`: all JSON.
class PlainMaker {
 public:
  PlainMaker(Json& root, const gltf::File& file) : root_(root), file_(file), model_(file.model()) {}

  void run() {
    plainPrimitives();
    plainViews();
    plainAccessors();
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
      Json* const names = memberOf(root_, list);
      if (!names) continue;
      std::erase_if(names->children,
                    [](const Json& name) { return name.content == gltf::kDraco || name.content == gltf::kMeshopt; });
      if (names->children.empty()) removeMember(root_, list);
    }
  }

 private:
  void plainPrimitives() {
    Json* const meshes = memberOf(root_, "meshes");
    for (std::size_t m = 0; meshes && m < model_.meshes.size(); ++m) {
      Json* const primitives = memberOf(meshes->children[m], "primitives");
      for (std::size_t p = 0; primitives && p < model_.meshes[m].primitives.size(); ++p) {
        Json& primitive = primitives->children[p];
        const int mode = model_.meshes[m].primitives[p].mode;
        const Json* const extensions = memberOf(primitive, "extensions");
        if (!extensions || !extensions->find(gltf::kDraco)) continue;
        removeExtension(primitive, gltf::kDraco);
        if (mode == TINYGLTF_MODE_TRIANGLES) removeMember(primitive, "mode");  // strips became lists
      }
    }
  }

  void plainViews() {
    Json* const views = memberOf(root_, "bufferViews");
    if (!views) return;
    for (Json& view : views->children) removeExtension(view, gltf::kMeshopt);
    // Views must stay, so those of compressed meshes become as small as possible.
    for (const std::size_t spent : file_.unpacked().spent) {
      if (isUsed(spent)) continue;
      Json& view = views->children[spent];
      for (const char* member : {"byteStride", "target"}) removeMember(view, member);
      view.set("byteLength", 1);
    }
    for (std::size_t added = views->children.size(); added < model_.bufferViews.size(); ++added) {
      Json view = Json::object();
      view.set("buffer", 0).set("byteLength", static_cast<long long>(model_.bufferViews[added].byteLength));
      views->push(std::move(view));
    }
  }

  /// Whether anything except the compression uses a view.
  [[nodiscard]] bool isUsed(std::size_t view) const {
    const auto isIt = [&](int index) { return index == static_cast<int>(view); };
    return std::ranges::any_of(model_.images, isIt, &tinygltf::Image::bufferView) ||
           std::ranges::any_of(model_.accessors, [&](const tinygltf::Accessor& accessor) {
             const auto& sparse = accessor.sparse;
             return isIt(accessor.bufferView) ||
                    (sparse.isSparse && (isIt(sparse.indices.bufferView) || isIt(sparse.values.bufferView)));
           });
  }

  void plainAccessors() {
    Json* const accessors = memberOf(root_, "accessors");
    if (!accessors) return;
    for (std::size_t i = 0; i < model_.accessors.size(); ++i) {
      const tinygltf::Accessor& from = model_.accessors[i];
      Json& accessor = accessors->children[i];
      if (file_.unpacked().accessors.contains(i)) {
        accessor.set("bufferView", from.bufferView).set("count", static_cast<long long>(from.count));
        removeMember(accessor, "byteOffset");
      }
      if (from.bufferView < 0 || from.sparse.isSparse) continue;
      const auto view = file_.unpacked().views.find(toIndex(from.bufferView));
      if (view == file_.unpacked().views.end()) continue;
      tellBounds(accessor, from, view->second);
    }
  }

  /// Updates bounds to the decoded values, which lost digits.
  void tellBounds(Json& accessor, const tinygltf::Accessor& from, gltf::Bytes view) const {
    if (!memberOf(accessor, "min") && !memberOf(accessor, "max")) return;
    auto bounds = boundsIn(view, from, at(model_.bufferViews, from.bufferView).byteStride);
    if (!bounds) return;
    accessor.set("min", std::move(bounds->first)).set("max", std::move(bounds->second));
  }

  Json& root_;
  const gltf::File& file_;
  const tinygltf::Model& model_;
};

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
  PlainMaker(root, file).run();
  gltf::Notes notes;  // reported by the import
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
  std::error_code absent;  // a new file
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
  gltf::Notes notes;  // reported by the import
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

// Checks and writing.

constexpr double kMostSeconds = 3600.0;

Result<void> checkClips(const std::filesystem::path& file, const Character& character,
                        const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    if (std::ranges::find(character.clips, name, &AnimationClip::name) != character.clips.end()) continue;
    return Error{file.string(), "clip \"" + name + '"', noSuchClip(name, character.clips)};
  }
  return {};
}

Result<void> checkSeconds(const std::filesystem::path& file, const Character& character,
                          const std::vector<std::string>& asked) {
  double seconds = 0.0;
  for (const AnimationClip& clip : character.clips) {
    if (asked.empty() || std::ranges::count(asked, clip.name) > 0) seconds += static_cast<double>(clip.duration);
  }
  if (seconds <= kMostSeconds) return {};
  return Error{file.string(), "clips",
               "last " + std::to_string(std::llround(seconds)) + " seconds together; expected at most " +
                   std::to_string(std::llround(kMostSeconds)) + ": choose fewer of them"};
}

Result<void> checkPlaces(const Source& source, const std::vector<std::filesystem::path>& files) {
  const std::filesystem::path& file = files.back();
  std::error_code unknown;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path(), unknown)) {
    return Error{file.string(), {}, "cannot be written: there is no such folder"};
  }
  for (const std::filesystem::path& place : files) {
    if (std::filesystem::is_directory(place, unknown)) {
      return Error{place.string(), {}, "cannot be written: it is a folder"};
    }
    if (source.reads(place)) {
      return Error{place.string(), {}, "cannot be written: the character is read from it"};
    }
  }
  return {};
}

Result<std::uint64_t> writeFiles(const Source& source, const std::vector<NamedBytes>& files) {
  std::vector<std::filesystem::path> places;
  std::uint64_t bytes = 0;
  for (const NamedBytes& each : files) {
    places.push_back(each.file);
    bytes += each.bytes.size();
  }
  if (auto free = checkPlaces(source, places); !free) return free.error();
  const auto written =
      files.size() == 1 ? writeFileAtomically(files.front().file, files.front().bytes) : writeFilesAtomically(files);
  if (!written) return written.error();
  return bytes;
}

Result<std::uint64_t> writeGlb(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                               std::vector<std::string>& /*left*/) {
  const Result<std::string> bytes = glbOf(packed);
  if (!bytes) return Error{file.string(), {}, bytes.error().reason};
  return writeFiles(source, {{file, bytes.value()}});
}

Result<std::uint64_t> writeGltf(const Source& source, const PackedGltf& packed, const std::filesystem::path& file,
                                std::vector<std::string>& /*left*/) {
  std::filesystem::path binary = file;
  binary.replace_extension(".bin");
  const std::string text = gltfOf(packed, binary.filename().string());
  return writeFiles(source, {{binary, packed.binary}, {file, text}});
}

}  // namespace sinew::exporting
