// core/lines/line_lanes.h: a rig's muscle lines in the bind pose as lineKernel() reads them. Made once per edit.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/lines/line_block.h"
#include "core/lines/line_rest.h"

namespace sinew {

class LineLanes {
 public:
  LineLanes() = default;
  /// @param rests  [Rig::lines] nullopt where there is no line.
  explicit LineLanes(std::span<const std::optional<LineRest>> rests);

  /// Takes over what sinew::settle() made of a line; no nullopt. Allocates nothing.
  void settle(int line, const LineRest& rest);

  [[nodiscard]] std::size_t size() const { return placeOf_.size(); }
  [[nodiscard]] std::span<const LineBlock> blocks() const { return blocks_; }
  /// Those that lines ride, indices into the skeleton's; blocks name them by their place here.
  [[nodiscard]] std::span<const int> bones() const { return bones_; }
  /// Lines that are in no block.
  [[nodiscard]] std::span<const int> missing() const { return missing_; }

 private:
  void add(int line, const LineRest& rest);
  [[nodiscard]] int placeOfBone(int bone);

  std::vector<LineBlock> blocks_;     ///< Lines without a via point first.
  std::vector<std::size_t> placeOf_;  ///< [lines] block and lane.
  std::vector<int> missing_;
  std::vector<int> bones_;
};

/// One lane of a block, but for its bones.
void setLane(LineBlock& block, std::size_t lane, const LineRest& rest);

}  // namespace sinew
