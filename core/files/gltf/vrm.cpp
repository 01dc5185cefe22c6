// core/files/gltf/vrm.cpp: two versions of one extension, read tolerantly: it is not what the mesh needs.
#include "core/files/gltf/vrm.h"

#include <algorithm>
#include <cmath>

namespace sinew::gltf {
namespace {

constexpr double kPercent = 100.0;  ///< Weights of 0.x.
constexpr double kMostShare = 100.0;

int indexIn(const Json& value) {
  const double number = value.number(-1.0);
  const bool whole = number >= 0.0 && number < 1e9 && number == std::floor(number);
  return whole ? static_cast<int>(number) : -1;
}

float shareOf(const Json& value, double unit) {
  return static_cast<float>(std::clamp(value.number(unit) / unit, -kMostShare, kMostShare));
}

/// VRM 1.0: objects by name.
void readNew(const Json& vrm, Vrm& out) {
  for (const Json& bone : vrm.at("humanoid").at("humanBones").children) {
    if (bone.kind == Json::Kind::kObject) out.bones.push_back({bone.key, indexIn(bone.at("node"))});
  }
  for (const char* list : {"preset", "custom"}) {
    for (const Json& expression : vrm.at("expressions").at(list).children) {
      if (expression.kind != Json::Kind::kObject) continue;
      Vrm::Expression& made = out.expressions.emplace_back();
      made.name = expression.key;
      for (const Json& bind : expression.at("morphTargetBinds").items()) {
        made.binds.push_back(
            {indexIn(bind.at("node")), -1, indexIn(bind.at("index")), shareOf(bind.at("weight"), 1.0)});
      }
    }
  }
}

/// VRM 0.x: lists; weights in per cent, of meshes.
void readOld(const Json& vrm, Vrm& out) {
  for (const Json& bone : vrm.at("humanoid").at("humanBones").items()) {
    out.bones.push_back({bone.at("bone").text(""), indexIn(bone.at("node"))});
  }
  for (const Json& group : vrm.at("blendShapeMaster").at("blendShapeGroups").items()) {
    Vrm::Expression& made = out.expressions.emplace_back();
    made.name = group.at("name").text("");
    if (made.name.empty()) made.name = group.at("presetName").text("");
    for (const Json& bind : group.at("binds").items()) {
      made.binds.push_back(
          {-1, indexIn(bind.at("mesh")), indexIn(bind.at("index")), shareOf(bind.at("weight"), kPercent)});
    }
  }
}

}  // namespace

Vrm readVrm(const Json& root) {
  Vrm vrm;
  const Json& extensions = root.at("extensions");
  if (extensions.at("VRMC_vrm").kind == Json::Kind::kObject) readNew(extensions.at("VRMC_vrm"), vrm);
  else if (extensions.at("VRM").kind == Json::Kind::kObject) readOld(extensions.at("VRM"), vrm);
  return vrm;
}

}  // namespace sinew::gltf
