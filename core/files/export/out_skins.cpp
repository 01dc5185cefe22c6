// core/files/export/out_skins.cpp: data of muscle lines; joint numbers, inverse bind matrices, skins of nodes.
#include "core/files/export/out_skins.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

#include "core/files/gltf/node_tree.h"
#include "core/geometry/at.h"

namespace sinew::exporting {

// Muscle lines as JSON, in the spaces of the file's nodes or in the line's bind frame.

namespace {

constexpr int kLineDataVersion = 1;

/// As floats.
Json numbers(std::initializer_list<double> values) {
  Json list = Json::array();
  for (const double value : values) list.push(static_cast<float>(value));
  return list;
}

Json floatsOf(const glm::dvec2& v) { return numbers({v.x, v.y}); }
Json floatsOf(const glm::dvec3& v) { return numbers({v.x, v.y, v.z}); }

class LineWriter {
 public:
  LineWriter(const Source& source, const LineJoints& lines, std::span<const int> nodes)
      : source_(source), lines_(lines), nodes_(nodes) {}

  /// Joints of one line are adjacent.
  [[nodiscard]] Json all() const {
    Json list = Json::array();
    const std::vector<HelperJoint>& joints = lines_.joints();
    for (std::size_t first = 0; first < joints.size();) {
      std::size_t end = first;
      while (end < joints.size() && joints[end].line == joints[first].line) ++end;
      list.push(line(first, end));
      first = end;
    }
    return list;
  }

 private:
  [[nodiscard]] const Bone& bone(int index) const { return at(source_.bound.skeleton.bones, index); }

  /// A point in a node's space.
  [[nodiscard]] Json place(const BonePoint& point) const {
    Json data = Json::object();
    data.set("node", source_.nodeOfBone(point.bone)).set("point", floatsOf(point.inBone));
    return data;
  }

  /// With the line's bind frame in the node's space, which shows the rotation and scale of the node in a pose.
  [[nodiscard]] Json end(const BonePoint& point, const LineRest& rest) const {
    const glm::dmat3 frame = glm::inverse(glm::dmat3(glm::dmat4(bone(point.bone).bindInWorld))) * rest.frame;
    Json data = place(point);
    data.set("frame", numbers({frame[0].x, frame[0].y, frame[0].z, frame[1].x, frame[1].y, frame[1].z, frame[2].x,
                               frame[2].y, frame[2].z}));
    return data;
  }

  [[nodiscard]] Json line(std::size_t first, std::size_t end_) const {
    const HelperJoint& joint = lines_.joints()[first];
    const LineRest& rest = lines_.restOf(joint.line);
    const LineSettings& settings = rest.settings;
    const glm::dmat3 intoFrame = glm::transpose(rest.frame);
    const glm::dmat4 parent(bone(joint.bone).bindInWorld);
    Json joints = Json::array();
    for (std::size_t j = first; j < end_; ++j) {
      const glm::dvec3 stands(parent * glm::dvec4(lines_.joints()[j].rest.translation, 1.0));
      Json one = Json::object();
      one.set("node", nodes_[j]).set("at", floatsOf(intoFrame * (stands - rest.start)));
      joints.push(std::move(one));
    }
    Json data = Json::object();
    data.set("name", lines_.nameOf(joint.line)).set("joints", std::move(joints));
    data.set("size", static_cast<float>(std::cbrt(std::abs(glm::determinant(glm::dmat3(parent))))));
    data.set("origin", end(rest.origin, rest)).set("insertion", end(rest.insertion, rest));
    if (rest.via) data.set("via", place(*rest.via).set("shift", floatsOf(intoFrame * rest.viaShift)));
    data.set("length", static_cast<float>(rest.length)).set("rest", settings.rest);
    data.set("tendons", floatsOf(settings.tendons)).set("volume", settings.volume);
    data.set("limits", floatsOf(settings.limits)).set("depth", static_cast<float>(rest.depth));
    data.set("twist", settings.twist).set("flex", floatsOf(settings.flex));
    data.set("base", settings.base).set("gain", settings.gain).set("full", settings.full);
    return data;
  }

  const Source& source_;
  const LineJoints& lines_;
  std::span<const int> nodes_;
};

bool namesAny(const Json& skin, std::span<const int> nodes) {
  return std::ranges::any_of(skin.at("joints").items(), [&](const Json& joint) {
    return std::ranges::find(nodes, static_cast<int>(joint.number(-1.0))) != nodes.end();
  });
}

}  // namespace

bool addLineData(const Source& source, const LineJoints& lines, std::span<const int> nodes, GltfRewrite& rewrite) {
  Json* skins = memberOf(rewrite.root(), "skins");
  if (lines.joints().empty() || !skins) return true;
  bool isHeld = true;
  for (Json& skin : skins->children) {
    if (!namesAny(skin, nodes.first(lines.joints().size()))) continue;
    Json& extras = ensureMember(skin, "extras", Json::object());
    isHeld = extras.kind == Json::Kind::kObject;
    if (!isHeld) continue;
    Json data = Json::object();
    data.set("version", kLineDataVersion).set("joint_scale", nameOf(lines.scale()));
    extras.set("sinew", data.set("lines", LineWriter(source, lines, nodes).all()));
    break;
  }
  return isHeld;
}

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
    else changed = true;  // The import uses the rest pose for such a joint.
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
