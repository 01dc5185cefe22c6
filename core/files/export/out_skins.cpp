// core/files/export/out_skins.cpp: joint numbers, inverse bind matrices, skins of nodes.
#include "core/files/export/out_skins.h"

#include <algorithm>

#include "core/files/gltf/node_tree.h"
#include "core/geometry/at.h"

namespace sinew::exporting {

OutSkins::OutSkins(Source& source) : source_(source) {
  for (const gltf::SoupPart& part : source.origin.parts) {
    const gltf::MeshBinding& binding = *at(source.bound.meshes, part.node);
    Skin& skin = skins_[keyOf(part.node)];
    if (!std::ranges::count(skin.users, part.node)) skin.users.push_back(part.node);
    skin.meshToBind = binding.meshToBind;
    if (binding.skin < 0 || !skin.bindings.empty()) continue;
    skin.bindings = at(source.bound.jointBindings, binding.skin);
    skin.own = skin.bindings.size();
    for (std::size_t j = 0; j < skin.own; ++j) skin.jointOf.emplace(skin.bindings[j], static_cast<int>(j));
  }
}

void OutSkins::addJoints(std::span<const HelperJoint> joints, std::span<const int> nodes) {
  addedNodes_.assign(nodes.begin(), nodes.end());
  for (const HelperJoint& joint : joints) addedInverseBinds_.push_back(joint.inverseBind);
}

int OutSkins::nodeOf(int binding) const {
  const int added = binding - static_cast<int>(source_.bound.skeleton.bindings.size());
  return added < 0 ? source_.nodeOf(binding) : at(addedNodes_, added);
}

glm::dmat4 OutSkins::inverseBindOf(int binding) const {
  const int added = binding - static_cast<int>(source_.bound.skeleton.bindings.size());
  return added < 0 ? glm::dmat4(at(source_.bound.skeleton.bindings, binding).inverseBind)
                   : at(addedInverseBinds_, added);
}

int OutSkins::keyOf(int node) const {
  const int skin = at(source_.bound.meshes, node)->skin;
  return skin < 0 ? -1 - node : skin;
}

int OutSkins::jointOf(int node, int binding) {
  Skin& skin = skins_.at(keyOf(node));
  const auto [place, isNew] = skin.jointOf.emplace(binding, static_cast<int>(skin.bindings.size()));
  if (isNew) skin.bindings.push_back(binding);
  return place->second;
}

const glm::dmat4& OutSkins::meshToBind(int node) const { return skins_.at(keyOf(node)).meshToBind; }

std::vector<glm::mat4> OutSkins::inverseBinds(int fileSkin, const Skin& skin, bool& changed) {
  std::vector<glm::mat4> matrices;
  for (const int binding : skin.bindings) {
    matrices.emplace_back(inverseBindOf(binding) * skin.meshToBind);
  }
  changed = skin.bindings.size() > skin.own;
  if (fileSkin < 0) return matrices;
  const int accessor = at(source_.file.model().skins, fileSkin).inverseBindMatrices;
  if (accessor < 0) {
    std::fill_n(matrices.begin(), skin.own, glm::mat4(1.0f));
    return matrices;
  }
  const gltf::Accessor& from = source_.accessors.open(accessor, "skins", TINYGLTF_TYPE_MAT4);
  for (std::size_t j = 0; j < skin.own; ++j) {
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = from.number(j, i);
    if (gltf::affineInverse(matrix)) matrices[j] = glm::mat4(matrix);
    else changed = true;  // The import binds such a joint by its rest pose.
  }
  return matrices;
}

void OutSkins::writeSkin(int fileSkin, const Skin& skin, GltfRewrite& rewrite) {
  bool changed = false;
  const std::vector<glm::mat4> matrices = inverseBinds(fileSkin, skin, changed);
  int number = fileSkin;
  if (fileSkin < 0) {
    Json made = Json::object();
    made.set("joints", Json::array());
    number = rewrite.append("skins", std::move(made));
  }
  if (changed) {
    Json& joints = *memberOf(rewrite.element("skins", number), "joints");
    for (std::size_t j = skin.own; j < skin.bindings.size(); ++j) joints.push(nodeOf(skin.bindings[j]));
    const std::string_view bytes(reinterpret_cast<const char*>(matrices.data()), matrices.size() * sizeof(glm::mat4));
    const int accessor = rewrite.addAccessor({bytes, TINYGLTF_COMPONENT_TYPE_FLOAT, "MAT4", matrices.size()});
    rewrite.element("skins", number).set("inverseBindMatrices", accessor);
  }
  for (const int node : skin.users) {
    Json& user = rewrite.element("nodes", node);
    if (user.find("mesh")) user.set("skin", number);
  }
}

void OutSkins::write(GltfRewrite& rewrite) {
  for (const auto& [fileSkin, skin] : skins_) {
    if (skin.bindings.empty()) continue;
    for (const int binding : skin.bindings) nodes_.insert(nodeOf(binding));
    writeSkin(fileSkin, skin, rewrite);
  }
}

}  // namespace sinew::exporting
