// core/lines/line_block.h: eight muscle lines in the bind pose, a lane each, and what they are posed by.
#pragma once

#include <array>
#include <span>

#include "core/lanes/instruction_set.h"
#include "core/lanes/lane_doubles.h"

namespace sinew {

struct PosedLine;

/// What LineRest and its settings say. Lengths in character units, world of the bind pose.
struct LineBlock {
  std::array<int, kDoubleLanes> line{};  ///< Where in PoseFrame::out.
  std::size_t count = 0;                 ///< Lanes from here on hold no line.
  bool hasVia = false;                   ///< All of them or none.

  // Which of PoseFrame::bones they ride, and where in its space.
  std::array<int, kDoubleLanes> originBone{};
  std::array<int, kDoubleLanes> insertionBone{};
  std::array<int, kDoubleLanes> viaBone{};
  LaneVectors origin{};
  LaneVectors insertion{};

  LaneVectors direction{};
  LaneVectors height{};  ///< Unit, the frame's third column.
  LaneVectors start{};
  LaneDoubles depth{};
  LaneDoubles length{};
  LaneDoubles restLength{};  ///< `rest` times length.
  LaneDoubles tendon{};      ///< The origin's, of the rest length, as the next.
  LaneDoubles belly{};
  LaneDoubles bellyStretch{};  ///< In the bind pose.

  LaneDoubles exponent{};  ///< -volume / 2
  LaneDoubles least{};     ///< As GirthRest has them.
  LaneDoubles most{};
  LaneDoubles inBind{};

  LaneDoubles twist{};
  LaneDoubles flexHeight{};
  LaneDoubles flexWidth{};
  LaneDoubles base{};
  LaneDoubles gain{};
  LaneDoubles full{};

  LaneVectors via{};  ///< Bone space. These two only where hasVia.
  LaneVectors viaShift{};
};

/// A bone in a pose, as lanes gather it: four numbers at a time.
struct alignas(64) PosedBone {
  static constexpr std::size_t kMatrix = 0;  ///< Twelve: bone -> world, column by column.
  static constexpr std::size_t kTurn = 12;   ///< Nine: BoneMotion::turn.
  static constexpr std::size_t kScale = 21;
  static constexpr std::size_t kMoved = 22;  ///< 0 or 1.

  /// Not a number where the bone is not usable.
  std::array<double, 24> number{};
};

struct PoseFrame {
  std::span<const LineBlock> blocks;
  std::span<const LaneDoubles> flex;  ///< [blocks] added to each line's base.
  const PosedBone* bones = nullptr;
  PosedLine* out = nullptr;
};

using LineKernel = void (*)(const PoseFrame& frame);

/// The same bits whatever the set.
[[nodiscard]] LineKernel lineKernel(InstructionSet set);

}  // namespace sinew
