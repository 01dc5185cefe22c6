// core/lines/carriers.cpp: bones first, then what lines make of them.
#include "core/lines/carriers.h"

#include <string_view>
#include <unordered_map>

#include "core/base/at.h"

namespace sinew {
namespace {

/// [Rig::primitives] bone and line, -1 for none.
std::vector<LineCarrier> ridesOf(const Rig& rig, const Skeleton& skeleton) {
  std::unordered_map<std::string_view, int> lineOf;
  for (std::size_t i = 0; i < rig.lines.size(); ++i) lineOf.emplace(rig.lines[i].name, static_cast<int>(i));
  std::vector<LineCarrier> rides;
  rides.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) {
    const auto line = primitive.line.empty() ? lineOf.end() : lineOf.find(primitive.line);
    rides.push_back({skeleton.findBone(primitive.bone).value_or(-1), line == lineOf.end() ? -1 : line->second});
  }
  return rides;
}

/// A muscle as its line's via point bends it; nullopt: the via point moves nothing.
/// @param carrier  of the muscle, with the line's whole shift
std::optional<BentMuscle> bendOnLine(const LineRest& rest, const PosedLine& line, const Placement& placement,
                                     const glm::mat4& boneInBind, const glm::mat4& carrier) {
  if (line.aside == glm::vec3(0.0f)) return std::nullopt;
  return bentMuscle(viaBend(rest, placement, boneInBind), carrier, line.aside);
}

}  // namespace

Carriers::Carriers(const Rig& rig, const Character& character, std::span<const LineCarrier> onLines)
    : onLines_(onLines.begin(), onLines.end()) {
  if (onLines_.empty()) return;
  rests_ = lineRests(rig, character);
}

void Carriers::settle(const Rig& rig) {
  for (std::size_t i = 0; i < rests_.size(); ++i) {
    if (rests_[i]) sinew::settle(*rests_[i], rig.lines[i].settings);
  }
}

void Carriers::pose(std::span<const FieldPrimitive> primitives, const Pose& pose, const Skeleton& skeleton,
                    std::vector<PosedPrimitive>& out) {
  if (onLines_.empty()) return poseField(primitives, pose.boneInWorld, out);
  poseLines(rests_, skeleton, pose, scratch_, lines_);
  matrices_.assign(pose.boneInWorld.begin(), pose.boneInWorld.end());
  for (const auto& [bone, line] : onLines_) matrices_.push_back(carrierInWorld(bone, line, skeleton, pose, lines_));
  poseField(primitives, matrices_, out);
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    const FieldPrimitive& primitive = primitives[i];
    const int onLine = primitive.carrier - static_cast<int>(skeleton.bones.size());
    if (onLine < 0) continue;
    const auto [bone, line] = at(onLines_, onLine);
    const std::optional<LineRest>& rest = at(rests_, line);
    if (!rest) continue;
    const std::optional<BentMuscle> bent =
        bendOnLine(*rest, at(lines_, line), primitive.placement, at(skeleton.bones, bone).bindInWorld,
                   at(matrices_, primitive.carrier));
    if (bent) out[i].influence = unitBallMap(bent->placement, primitive.reach, bent->carrier);
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
  poseLines(lineRests(rig, character), character.skeleton, pose, scratch, lines);
  return lines;
}

std::vector<std::optional<glm::mat4>> carriersOf(const Rig& rig, const Character& character, const Pose& pose) {
  return carriersOf(rig, character, pose, posedLines(rig, character, pose));
}

std::vector<std::optional<glm::mat4>> carriersOf(const Rig& rig, const Character& character, const Pose& pose,
                                                 std::span<const PosedLine> lines) {
  std::vector<std::optional<glm::mat4>> matrices;
  matrices.reserve(rig.primitives.size());
  for (const auto& [bone, line] : ridesOf(rig, character.skeleton)) {
    const bool attached = bone >= 0 && (line < 0 || at(lines, line).usable);
    matrices.push_back(attached ? std::optional(carrierInWorld(bone, line, character.skeleton, pose, lines))
                                : std::nullopt);
  }
  return matrices;
}

std::vector<std::optional<BentMuscle>> carriedMuscles(const Rig& rig, const Character& character, const Pose& pose,
                                                      std::span<const PosedLine> lines) {
  const std::vector<LineCarrier> rides = ridesOf(rig, character.skeleton);
  std::vector<std::optional<BentMuscle>> muscles(rides.size());
  for (std::size_t i = 0; i < rides.size(); ++i) {
    const auto& [bone, line] = rides[i];
    if (bone < 0 || (line >= 0 && !at(lines, line).usable)) continue;
    const Placement& placement = rig.primitives[i].placement;
    const glm::mat4 carrier = carrierInWorld(bone, line, character.skeleton, pose, lines);
    muscles[i] = {carrier, placement};
    if (line < 0 || !at(rig.lines, line).via) continue;
    const Result<LineRest> rest = lineRest(at(rig.lines, line), character);
    if (!rest) continue;
    const auto bent =
        bendOnLine(rest.value(), at(lines, line), placement, at(character.skeleton.bones, bone).bindInWorld, carrier);
    if (bent) muscles[i] = *bent;
  }
  return muscles;
}

std::optional<glm::mat4> carrierOf(const Rig& rig, const Primitive& primitive, const Character& character,
                                   const Pose& pose) {
  const std::optional<int> bone = character.skeleton.findBone(primitive.bone);
  if (!bone) return std::nullopt;
  const int index = primitive.line.empty() ? -1 : findLine(rig, primitive.line);
  if (index < 0) return at(pose.boneInWorld, *bone);
  const Result<LineRest> rest = lineRest(at(rig.lines, index), character);
  if (!rest) return std::nullopt;
  const PosedLine line = posedLine(rest.value(), character.skeleton, pose, pose.flexOf(index));
  if (!line.usable) return std::nullopt;
  return line.deformation * at(character.skeleton.bones, *bone).bindInWorld;
}

}  // namespace sinew
