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

void Carriers::pose(std::span<const FieldPrimitive> primitives, const Pose& pose, const Skeleton& skeleton,
                    std::vector<PosedPrimitive>& out) {
  if (onLines_.empty()) return poseField(primitives, pose.boneInWorld, out);
  poseLines(lanes_, skeleton, pose, scratch_, lines_);
  matrices_.assign(pose.boneInWorld.begin(), pose.boneInWorld.end());
  for (const auto& [bone, line] : onLines_) matrices_.push_back(carrierInWorld(bone, line, skeleton, pose, lines_));
  poseField(primitives, matrices_, out);
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const FieldPrimitive& primitive = primitives[i];
    const int onLine = primitive.carrier - static_cast<int>(skeleton.bones.size());
    if (onLine < 0) continue;
    const auto [bone, line] = at(onLines_, onLine);
    const glm::vec3& aside = at(lines_, line).aside;
    const std::optional<LineRest>& rest = at(rests_, line);
    if (!rest || aside == glm::vec3(0.0f)) continue;
    const ViaBend bend = viaBend(*rest, primitive.placement, at(skeleton.bones, bone).bindInWorld);
    const BentMuscle bent = bentMuscle(bend, at(matrices_, primitive.carrier), aside);
    out[i].influence = unitBallMap(bent.placement, primitive.reach, bent.carrier);
  }
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

std::vector<std::optional<BentMuscle>> carriedMuscles(const Rig& rig, const Character& character, const Pose& pose,
                                                      std::span<const PosedLine> lines) {
  const std::vector<std::optional<glm::mat4>> carriers = carriersOf(rig, character, pose, lines);
  std::vector<std::optional<BentMuscle>> muscles(carriers.size());
  for (std::size_t i = 0; i < carriers.size(); ++i) {
    if (!carriers[i]) continue;
    const Primitive& primitive = rig.primitives[i];
    muscles[i] = {*carriers[i], primitive.placement};
    const int line = findLine(rig, primitive.line);
    if (line < 0 || at(lines, line).aside == glm::vec3(0.0f)) continue;
    const Result<LineRest> rest = lineRest(at(rig.lines, line), character);
    const std::optional<int> bone = character.skeleton.findBone(primitive.bone);
    if (!rest || !bone) continue;
    const ViaBend bend = viaBend(rest.value(), primitive.placement, at(character.skeleton.bones, *bone).bindInWorld);
    muscles[i] = bentMuscle(bend, *carriers[i], at(lines, line).aside);
  }
  return muscles;
}

std::optional<glm::mat4> carrierOf(const Rig& rig, const Primitive& primitive, const Character& character,
                                   const Pose& pose) {
  Rig one;
  if (const MuscleLine* line = lineOf(rig, primitive)) one.lines.push_back(*line);
  one.primitives.push_back(primitive);
  return carriersOf(one, character, pose).front();
}

}  // namespace sinew
