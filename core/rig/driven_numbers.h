// core/rig/driven_numbers.h: the numbers of a rig that follow the pose. Made once per edit, applied once per pose.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/rig/driver_input.h"
#include "core/rig/rig_numbers.h"

namespace sinew {

/// Memory that is reused from pose to pose; carries nothing from one to the next.
struct DriverScratch {
  std::vector<PosedLine> lines;  ///< [Rig::lines] those that inputs read.
  LineScratch posing;
  InputScratch inputs;
};

/// Order: lines are measured as the rig has them, then every driver, none reading another's result. A driver whose
/// input this character lacks is left out.
class DrivenNumbers {
 public:
  DrivenNumbers() = default;
  DrivenNumbers(const Rig& rig, const Character& character);

  [[nodiscard]] bool isEmpty() const { return numbers_.empty(); }
  /// Whether some number belongs to an owner of this kind.
  [[nodiscard]] bool changes(ParameterOwner owner) const;
  /// @param numbers  as drawn (drawnNumbers); afterwards as they are in the pose
  void apply(const Pose& pose, const Skeleton& skeleton, DriverScratch& scratch, RigNumbers& numbers) const;

 private:
  struct Join {
    FoundInput input;
    Curve curve;
    DriverMode mode = DriverMode::kAdd;
  };
  struct Number {
    NumberRef ref;
    std::vector<KeyTrack> keys;
    std::vector<Join> drivers;
  };
  void add(const std::vector<AnimatedNumber>& animated, int owner, const Rig& rig, const Character& character);
  [[nodiscard]] float valueOf(const Number& number, float drawn, const Pose& pose, const Skeleton& skeleton,
                              DriverScratch& scratch) const;

  std::vector<Number> numbers_;
  std::vector<std::optional<LineRest>> rests_;  ///< [Rig::lines] those that inputs read; empty: none are.
};

}  // namespace sinew
