// core/files/gltf/skin.cpp: bones and their bind pose.

#include "core/files/gltf/skin.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"

namespace sinew::gltf {
namespace {

/// Bindings of two skins that differ less (relative to the skeleton's size) are the same.
constexpr double kSameBinding = 1e-5;
/// Paths repeat the names of all ancestors: long chains of long names could fill the memory.
constexpr std::size_t kMaxPathBytes = 64U << 20;
constexpr std::size_t kMaxSkinJoints = 1U << 18;  ///< Joints of all skins, and additional bindings.
constexpr std::size_t kMaxExtraBindings = 4096;

struct Skin {
  std::vector<int> joints;               // nodes
  std::vector<glm::dmat4> inverseBinds;  // [joints] POSITION -> joint
  std::vector<bool> singular;            // [joints] has no usable inverse bind matrix
  glm::dmat4 meshToBind{1.0};            // M of docs/design.md
  std::vector<int> bindings;             // [joints]
};

class Binder {
 public:
  Binder(const File& file, const NodeTree& tree, Accessors& accessors, Notes& notes, BonesFrom from)
      : allNodes_(from == BonesFrom::kNodes && std::ranges::none_of(tree.nodes, hasSkin)),
        file_(file),
        tree_(tree),
        accessors_(accessors),
        notes_(notes),
        boneOfNode_(tree.nodes.size(), -1),
        nearestBone_(tree.nodes.size(), -1),
        inBone_(tree.nodes.size(), glm::dmat4(1.0)) {}

  BoundSkeleton run() && {
    readSkins();
    collectBones();
    nameBones();
    for (auto& skin : skins_) {
      if (skin) bindSkin(*skin);
    }
    bindRest();
    for (std::size_t b = 0; b < bones().size(); ++b) bones()[b].bindInWorld = glm::mat4(bindInWorld_[b]);
    finishBones(result_.skeleton);
    makeBindings();
    bindMeshes();
    return std::move(result_);
  }

 private:
  static bool hasSkin(const TreeNode& node) { return node.inScene && node.mesh >= 0 && node.skin >= 0; }

  std::vector<Bone>& bones() { return result_.skeleton.bones; }

  void readSkins() {
    skins_.resize(file_.model().skins.size());
    for (const TreeNode& node : tree_.nodes) {
      if (!node.inScene || node.mesh < 0 || node.skin < 0 || at(skins_, node.skin)) continue;
      at(skins_, node.skin) = readSkin(toIndex(node.skin));
    }
    for (std::size_t skin = 0; allNodes_ && skin < skins_.size(); ++skin) skins_[skin] = readSkin(skin);
    const auto unused = std::ranges::count_if(skins_, [](const auto& skin) { return !skin; });
    if (unused > 0) notes_.add("skins (" + std::to_string(unused) + ") that no mesh of the scene uses are ignored");
  }

  Skin readSkin(std::size_t index) {
    const std::string place = placeOf("skins", index);
    file_.expectSound(place);
    const tinygltf::Skin& from = file_.model().skins[index];
    if (from.joints.empty()) refuse(place + ".joints", "a skin needs at least one joint");
    skinJoints_ += from.joints.size();
    if (from.joints.size() > toIndex(kMaxJoints) || skinJoints_ > kMaxSkinJoints) refuseJoints();
    Skin skin;
    skin.joints = from.joints;
    skin.inverseBinds.assign(from.joints.size(), glm::dmat4(1.0));
    skin.singular.assign(from.joints.size(), false);
    if (from.inverseBindMatrices >= 0) {
      const std::string reference = place + ".inverseBindMatrices";
      readInverseBinds(accessors_.open(from.inverseBindMatrices, reference, TINYGLTF_TYPE_MAT4), skin);
    }
    return skin;
  }

  void readInverseBinds(const Accessor& matrices, Skin& skin) {
    if (!matrices.isFloat()) refuse(matrices.place(), "inverse bind matrices must be floats");
    if (matrices.count() < skin.joints.size()) {
      refuse(matrices.place(), std::to_string(matrices.count()) + " inverse bind matrices for " +
                                   std::to_string(skin.joints.size()) + " joints");
    }
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      glm::dmat4& matrix = skin.inverseBinds[j];
      for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = matrices.number(j, i);
      for (int column = 0; column < 4; ++column) matrix[column][3] = column == 3 ? 1.0 : 0.0;
      if (!isTame(matrix))
        refuse(matrices.place(), "inverse bind matrix " + std::to_string(j) + " is not finite or too large");
      if (affineInverse(matrix)) continue;
      skin.singular[j] = true;
      notes_.add("the inverse bind matrix of joint \"" + tree_[skin.joints[j]].name +
                 "\" is singular and ignored: the joint's rest pose is used");
    }
  }

  [[noreturn]] static void refuseJoints() {
    refuse("skins", "more than " + std::to_string(kMaxJoints) + " joints", "too large");
  }

  /// Bones in the order of the skins, then mesh nodes; ancestors first.
  void collectBones() {
    std::vector<bool> isBone(tree_.nodes.size(), false);
    std::vector<int> wanted;
    const auto want = [&](int node) {
      if (at(isBone, node)) return;
      at(isBone, node) = true;
      wanted.push_back(node);
      if (wanted.size() > toIndex(kMaxJoints)) refuseJoints();
    };
    for (const auto& skin : skins_) {
      if (skin) std::ranges::for_each(skin->joints, want);
    }
    for (const int node : tree_.order) {
      if (allNodes_ && tree_[node].inScene) want(node);
    }
    wantUncarriedMeshes(std::vector<bool>(isBone), want);
    makeSkeletonNodes(isBone);
    std::vector<int> boneAbove(tree_.nodes.size(), -1);  // node of the nearest bone above
    for (const int node : tree_.order) {
      const int parent = tree_[node].parent;
      if (parent >= 0) at(boneAbove, node) = at(isBone, parent) ? parent : at(boneAbove, parent);
    }
    for (const int node : wanted) addBone(node, boneAbove);
    for (const int node : tree_.order) {
      const int parent = tree_[node].parent;
      const bool bone = at(isBone, node);
      at(nearestBone_, node) = bone ? at(boneOfNode_, node) : parent < 0 ? -1 : at(nearestBone_, parent);
      at(inBone_, node) = bone || parent < 0 ? glm::dmat4(1.0) : at(inBone_, parent) * tree_[node].local;
    }
  }

  template <class Want>
  void wantUncarriedMeshes(std::vector<bool> carried, const Want& want) {
    for (const int node : tree_.order) {
      const int parent = tree_[node].parent;
      if (parent >= 0 && at(carried, parent)) at(carried, node) = true;
    }
    for (std::size_t node = 0; node < tree_.nodes.size(); ++node) {
      const TreeNode& mesh = tree_.nodes[node];
      if (mesh.inScene && mesh.mesh >= 0 && mesh.skin < 0 && !carried[node]) want(static_cast<int>(node));
    }
  }

  /// Bones and their ancestors.
  void makeSkeletonNodes(const std::vector<bool>& isBone) {
    std::vector<bool> needed = isBone;
    for (std::size_t i = tree_.order.size(); i-- > 0;) {
      const int node = tree_.order[i];
      if (at(needed, node) && tree_[node].parent >= 0) needed[toIndex(tree_[node].parent)] = true;
    }
    result_.skeletonNode.assign(tree_.nodes.size(), -1);
    for (const int node : tree_.order) {
      if (!at(needed, node)) continue;
      at(result_.skeletonNode, node) = static_cast<int>(result_.skeleton.nodes.size());
      const TreeNode& from = tree_[node];
      const int parent = from.parent < 0 ? -1 : at(result_.skeletonNode, from.parent);
      result_.skeleton.nodes.push_back({.name = from.name, .parent = parent, .rest = from.rest});
    }
  }

  /// Adds the bone of a node after those of its ancestors.
  void addBone(int node, const std::vector<int>& boneAbove) {
    std::vector<int> chain;
    for (int n = node; n >= 0 && at(boneOfNode_, n) < 0; n = at(boneAbove, n)) chain.push_back(n);
    std::ranges::reverse(chain);
    for (const int n : chain) {
      Bone bone;
      bone.name = tree_[n].name;
      bone.node = at(result_.skeletonNode, n);
      bone.parent = at(boneAbove, n) < 0 ? -1 : boneOfNode_[toIndex(at(boneAbove, n))];
      at(boneOfNode_, n) = static_cast<int>(bones().size());
      bones().push_back(std::move(bone));
    }
  }

  void nameBones() {
    std::size_t total = 0;
    std::vector<std::size_t> length(bones().size(), 0);
    for (std::size_t b = 0; b < bones().size(); ++b) {
      Bone& bone = bones()[b];
      if (bone.name.empty()) bone.name = "joint " + std::to_string(b);
      length[b] = bone.name.size() + 8 + (bone.parent < 0 ? 0 : at(length, bone.parent));
      total += length[b];
    }
    if (total > kMaxPathBytes) refuse("nodes", "the joints' names are too long for so deep a skeleton");
    bindInWorld_.assign(bones().size(), glm::dmat4(1.0));
    isBound_.assign(bones().size(), false);
  }

  glm::dmat4 restOf(int node) const {
    const glm::dmat4& rest = tree_[node].restInWorld;
    if (affineInverse(rest)) return rest;
    glm::dmat4 upright(1.0);
    upright[3] = rest[3];
    return upright;
  }

  /// Chooses M, then places joints that no earlier skin has placed.
  void bindSkin(Skin& skin) {
    chooseMeshToBind(skin);
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const auto bone = toIndex(boneOfNode_[toIndex(skin.joints[j])]);
      if (isBound_[bone]) continue;
      isBound_[bone] = true;
      const std::optional<glm::dmat4> bind = skin.singular[j] ? std::nullopt : affineInverse(skin.inverseBinds[j]);
      const glm::dmat4 placed = bind ? skin.meshToBind * *bind : restOf(skin.joints[j]);
      bindInWorld_[bone] = affineInverse(placed) ? placed : restOf(skin.joints[j]);
    }
  }

  /// M of docs/design.md: the root joint's rest x its inverse bind matrix. A joint shared with an earlier skin is used
  /// instead, so that parts of one body stay together if rest and bind pose differ.
  void chooseMeshToBind(Skin& skin) {
    const std::size_t root = rootOf(skin);
    glm::dmat4 anchor = restOf(skin.joints[root]);
    std::size_t by = root;
    for (std::size_t j = 0; j < skin.joints.size(); ++j) {
      const int bone = boneOfNode_[toIndex(skin.joints[j])];
      if (!at(isBound_, bone) || skin.singular[j]) continue;
      anchor = at(bindInWorld_, bone);
      by = j;
      break;
    }
    if (skin.singular[by]) return;
    const glm::dmat4 meshToBind = anchor * skin.inverseBinds[by];
    if (affineInverse(meshToBind)) skin.meshToBind = meshToBind;
  }

  /// First joint without an ancestor in the same skin.
  std::size_t rootOf(const Skin& skin) const {
    std::vector<bool> inSkin(result_.skeleton.bones.size(), false);
    for (const int joint : skin.joints) inSkin[toIndex(at(boneOfNode_, joint))] = true;
    std::vector<bool> below(inSkin.size(), false);  // an ancestor is in the skin
    for (std::size_t b = 0; b < inSkin.size(); ++b) {
      const int parent = result_.skeleton.bones[b].parent;
      below[b] = parent >= 0 && (at(below, parent) || at(inSkin, parent));
    }
    const auto isRoot = [&](int joint) { return !below[toIndex(at(boneOfNode_, joint))]; };
    return static_cast<std::size_t>(std::ranges::find_if(skin.joints, isRoot) - skin.joints.begin());
  }

  /// Places bones of unskinned meshes at rest.
  void bindRest() {
    for (std::size_t node = 0; node < tree_.nodes.size(); ++node) {
      const int bone = boneOfNode_[node];
      if (bone >= 0 && !at(isBound_, bone)) at(bindInWorld_, bone) = restOf(static_cast<int>(node));
    }
  }

  /// Binding i < bones is that of bone i; more follow for skins that bind a joint differently.
  void makeBindings() {
    std::vector<Binding>& bindings = result_.skeleton.bindings;
    double size = 0.0;
    for (const glm::dmat4& bind : bindInWorld_) size = std::max(size, glm::length(glm::dvec3(bind[3])));
    for (std::size_t b = 0; b < bones().size(); ++b) {
      bindings.push_back({.bone = static_cast<int>(b), .inverseBind = bones()[b].inverseBindInWorld});
    }
    for (auto& skin : skins_) {
      if (!skin) continue;
      const glm::dmat4 bindToMesh = affineInverse(skin->meshToBind).value_or(glm::dmat4(1.0));
      for (std::size_t j = 0; j < skin->joints.size(); ++j) {
        const int bone = boneOfNode_[toIndex(skin->joints[j])];
        skin->bindings.push_back(skin->singular[j] ? bone : bindingOf(bone, skin->inverseBinds[j] * bindToMesh, size));
      }
    }
    if (bindings.size() > bones().size()) {
      notes_.add("skins: " + std::to_string(bindings.size() - bones().size()) +
                 " joints are bound differently by a second skin: the bind pose shows the first one's");
    }
  }

  int bindingOf(int bone, const glm::dmat4& inverseBind, double size) {
    std::vector<Binding>& bindings = result_.skeleton.bindings;
    const auto same = [&](const glm::dmat4& other) {
      const glm::dmat4 change = at(bindInWorld_, bone) * (inverseBind - other);
      for (int column = 0; column < 4; ++column) {
        const double allowed = kSameBinding * (column == 3 ? std::max(size, 1e-30) : 1.0);
        if (!(glm::length(glm::dvec3(change[column])) <= allowed)) return false;
      }
      return true;
    };
    if (same(affineInverse(at(bindInWorld_, bone)).value_or(glm::dmat4(1.0)))) return bone;
    for (std::size_t b = bones().size(); b < bindings.size(); ++b) {
      if (bindings[b].bone == bone && same(glm::dmat4(bindings[b].inverseBind))) return static_cast<int>(b);
    }
    if (bindings.size() - bones().size() >= kMaxExtraBindings)
      refuse("skins", "too many skins bind the same joints differently");
    bindings.push_back({.bone = bone, .inverseBind = glm::mat4(inverseBind)});
    return static_cast<int>(bindings.size()) - 1;
  }

  void bindMeshes() {
    result_.meshes.resize(tree_.nodes.size());
    for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
      const TreeNode& node = tree_.nodes[i];
      if (node.mesh < 0) continue;
      if (!node.inScene) {
        notes_.add("meshes outside the default scene are ignored: they are not shown");
        continue;
      }
      MeshBinding binding;
      if (node.skin >= 0) {
        binding.skin = node.skin;
        binding.meshToBind = at(skins_, node.skin)->meshToBind;
      } else {
        binding.rigid = nearestBone_[i];
        binding.meshToBind = at(bindInWorld_, binding.rigid) * inBone_[i];
      }
      result_.meshes[i] = binding;
    }
    for (auto& skin : skins_) result_.jointBindings.push_back(skin ? std::move(skin->bindings) : std::vector<int>{});
  }

  bool allNodes_;
  const File& file_;
  const NodeTree& tree_;
  Accessors& accessors_;
  Notes& notes_;
  std::vector<std::optional<Skin>> skins_;  // set where in use
  std::vector<int> boneOfNode_;
  std::vector<int> nearestBone_;         // [nodes] at or above the node
  std::vector<glm::dmat4> inBone_;       // [nodes] node -> its nearest bone, at rest
  std::vector<glm::dmat4> bindInWorld_;  // [bones]
  std::vector<bool> isBound_;            // [bones] placed by a skin
  std::size_t skinJoints_ = 0;
  BoundSkeleton result_;
};

}  // namespace

BoundSkeleton bindSkeleton(const File& file, const NodeTree& tree, Accessors& accessors, Notes& notes, BonesFrom from) {
  return Binder(file, tree, accessors, notes, from).run();
}

}  // namespace sinew::gltf
