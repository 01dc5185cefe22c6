// core/lines/line_pose.cpp: bones first, then the lines they carry, by the widest vectors there are.
#include "core/lines/line_pose.h"

#include <limits>

#include "core/base/at.h"
#include "core/lanes/instruction_set.h"
#include "core/lines/bone_motion.h"
#include "sinew/base/geometry.h"

namespace sinew {
namespace {

/// What a via point rides need not be usable as a line's end: it is only a place.
PosedBone posedBone(const Bone& bone, const glm::mat4& now) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const BoneMotion motion = boneMotion(bone.bindInWorld, bone.inverseBindInWorld, now);
  const bool isPlace = isFinite(now);
  PosedBone posed;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const auto i = toIndex(3 * column + row);
      posed.number[PosedBone::kMatrix + i] = isPlace ? static_cast<double>(now[column][row]) : kNone;
      if (column < 3) posed.number[PosedBone::kTurn + i] = motion.turn[column][row];
    }
  }
  posed.number[PosedBone::kScale] = motion.usable ? motion.scale : kNone;
  posed.number[PosedBone::kMoved] = motion.moved ? 1.0 : 0.0;
  return posed;
}

void fillFlex(const LineLanes& lines, const Pose& pose, std::vector<LaneDoubles>& flex) {
  LaneDoubles all{};
  all.lane.fill(static_cast<double>(pose.flex));
  const std::span<const LineBlock> blocks = lines.blocks();
  flex.assign(blocks.size(), all);
  if (pose.flexedLines.empty()) return;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t lane = 0; lane < blocks[i].count; ++lane) {
      flex[i].lane[lane] = static_cast<double>(pose.flexOf(blocks[i].line[lane]));
    }
  }
}

}  // namespace

void poseLines(const LineLanes& lines, const Skeleton& skeleton, const Pose& pose, LineScratch& scratch,
               std::vector<PosedLine>& out) {
  scratch.bones.clear();
  for (const int bone : lines.bones()) {
    scratch.bones.push_back(posedBone(at(skeleton.bones, bone), at(pose.boneInWorld, bone)));
  }
  fillFlex(lines, pose, scratch.flex);
  out.resize(lines.size());
  for (const int line : lines.missing()) at(out, line) = {};
  lineKernel(chosenInstructionSet())({lines.blocks(), scratch.flex, scratch.bones.data(), out.data()});
}

PosedLine posedLine(const LineRest& rest, const Skeleton& skeleton, const Pose& pose, float flex) {
  const auto posed = [&](int bone) { return posedBone(at(skeleton.bones, bone), at(pose.boneInWorld, bone)); };
  std::array<PosedBone, 3> bones{posed(rest.origin.bone), posed(rest.insertion.bone), {}};
  if (rest.via) bones[2] = posed(rest.via->bone);
  LineBlock block;
  block.count = 1;
  setLane(block, 0, rest);
  block.insertionBone[0] = 1;
  block.viaBone[0] = 2;
  LaneDoubles added{};
  added.lane[0] = static_cast<double>(flex);
  PosedLine line;
  lineKernel(chosenInstructionSet())({{&block, 1}, {&added, 1}, bones.data(), &line});
  return line;
}

glm::mat4 carrierInWorld(int bone, int line, const Skeleton& skeleton, const Pose& pose,
                         std::span<const PosedLine> lines) {
  if (line < 0) return at(pose.boneInWorld, bone);
  return lines[static_cast<std::size_t>(line)].deformation * at(skeleton.bones, bone).bindInWorld;
}

}  // namespace sinew
