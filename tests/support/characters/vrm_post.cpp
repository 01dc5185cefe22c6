// tests/support/characters/vrm_post.cpp: bones and expressions of an avatar.

#include "tests/support/characters/vrm_post.h"

namespace sinew::test {

using nlohmann::ordered_json;

ordered_json newVrm() {
  ordered_json bones{{"hips", {{"node", 1}}}, {"leftUpperLeg", {{"node", 2}}}, {"leftEye", {{"node", 2}}}};
  ordered_json binds = ordered_json::array();
  binds.push_back({{"node", 0}, {"index", 0}, {"weight", 0.5}});
  binds.push_back({{"node", 0}, {"index", 2}, {"weight", 1.0}});
  ordered_json vrm;
  vrm["humanoid"]["humanBones"] = bones;
  vrm["expressions"]["preset"]["happy"] = {{"morphTargetBinds", binds}};
  vrm["expressions"]["custom"]["none"] = {{"isBinary", true}};
  return {{"VRMC_vrm", vrm}};
}

ordered_json oldVrm() {
  ordered_json binds = ordered_json::array();
  binds.push_back({{"mesh", 0}, {"index", 0}, {"weight", 50}});
  binds.push_back({{"mesh", 0}, {"index", 2}, {"weight", 100}});
  ordered_json vrm;
  vrm["humanoid"]["humanBones"].push_back({{"bone", "hips"}, {"node", 1}});
  vrm["humanoid"]["humanBones"].push_back({{"bone", "leftUpperLeg"}, {"node", 2}});
  vrm["blendShapeMaster"]["blendShapeGroups"].push_back({{"name", "happy"}, {"presetName", "joy"}, {"binds", binds}});
  return {{"VRM", vrm}};
}

}  // namespace sinew::test
