// core/lines/carriers.cpp: bones first, then what lines make of them.
#include "core/lines/carriers.h"

#include <string_view>
#include <unordered_map>

#include "core/base/at.h"

namespace sinew {

Carriers::Carriers(const Rig& rig, const Character& character, std::span<const LineCarrier> onLines)
    : onLines_(onLines.begin(), onLines.end()) {
  if (onLines_.empty()) return;
  rests_ = lineRests(rig, character);
  lanes_ = LineLanes(rests_);
}

void Carriers::settle(const Rig& rig) {
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    if (!rests_[i]) continue;
    sinew::settle(*rests_[i], rig.lines[i].settings);
    lanes_.settle(static_cast<int>(i), *rests_[i]);
  }
}

std::span<const glm::mat4> Carriers::in(const Pose& pose, const Skeleton& skeleton) {
  if (onLines_.empty()) return pose.boneInWorld;
  poseLines(lanes_, skeleton, pose, scratch_, lines_);
  matrices_.assign(pose.boneInWorld.begin(), pose.boneInWorld.end());
  for (const auto& [bone, line] : onLines_) matrices_.push_back(carrierInWorld(bone, line, skeleton, pose, lines_));
  return matrices_;
}

std::vector<glm::mat4> Carriers::inBind(const Skeleton& skeleton) const {
  std::vector<glm::mat4> matrices = bindPose(skeleton).boneInWorld;
  for (const LineCarrier& carrier : onLines_) matrices.push_back(at(skeleton.bones, carrier.bone).bindInWorld);
  return matrices;
}

std::vector<PosedLine> posedLines(const Rig& rig, const Character& character, const Pose& pose) {
  LineScratch scratch;
  std::vector<PosedLine> lines;
  poseLines(LineLanes(lineRests(rig, character)), character.skeleton, pose, scratch, lines);
  return lines;
}

std::vector<std::optional<glm::mat4>> carriersOf(const Rig& rig, const Character& character, const Pose& pose) {
  return carriersOf(rig, character, pose, posedLines(rig, character, pose));
}

std::vector<std::optional<glm::mat4>> carriersOf(const Rig& rig, const Character& character, const Pose& pose,
                                                 std::span<const PosedLine> lines) {
  std::unordered_map<std::string_view, int> lineOf;
  for (std::size_t i = 0; i < rig.lines.size(); ++i) lineOf.emplace(rig.lines[i].name, static_cast<int>(i));
  std::vector<std::optional<glm::mat4>> matrices;
  matrices.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) {
    const std::optional<int> bone = character.skeleton.findBone(primitive.bone);
    const auto line = primitive.line.empty() ? lineOf.end() : lineOf.find(primitive.line);
    const int index = line == lineOf.end() ? -1 : line->second;
    const bool attached = bone && (index < 0 || lines[static_cast<std::size_t>(index)].usable);
    matrices.push_back(attached ? std::optional(carrierInWorld(*bone, index, character.skeleton, pose, lines))
                                : std::nullopt);
  }
  return matrices;
}

std::optional<glm::mat4> carrierOf(const Rig& rig, const Primitive& primitive, const Character& character,
                                   const Pose& pose) {
  Rig one;
  if (const MuscleLine* line = lineOf(rig, primitive)) one.lines.push_back(*line);
  one.primitives.push_back(primitive);
  return carriersOf(one, character, pose).front();
}

}  // namespace sinew
