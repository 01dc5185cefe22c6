// core/files/export/skinned_file.cpp: every mesh of the scene made anew, all else left as it is.
#include "core/files/export/skinned_file.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/files/export/clip_json.h"
#include "core/files/export/clip_repair.h"
#include "core/files/export/file_morphs.h"
#include "core/files/export/helper_nodes.h"
#include "core/files/export/line_data.h"
#include "core/files/export/out_primitive.h"
#include "core/files/export/out_skins.h"
#include "core/geometry/at.h"

namespace sinew::exporting {
namespace {

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

  /// Those from other files come behind the file's own, which are repaired by their places in it.
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

  /// Points and lines follow their skin as before; where the mesh had none, there is none that fits them.
  void keepOther(int node, const Json& primitive, std::vector<Json>& made) {
    if (primitive.at("mode").number(kFirstTriangleMode) >= kFirstTriangleMode) return;
    if (at(source_.bound.meshes, node)->skin >= 0) made.push_back(primitive);
    else left_.insert("points and lines of meshes without a skin: nothing would move them");
  }

  /// A mesh that only one node shows is exchanged; of one that several show, each gets its own.
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

  /// By a node that keeps it.
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

  /// Channels of morph weights whose targets are gone, and clips that have no other.
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
