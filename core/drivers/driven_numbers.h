// core/drivers/driven_numbers.h: the numbers of a rig that follow the pose. Made once per edit, applied once per pose.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/drivers/driver_input.h"
#include "core/rig/animated_edit.h"

namespace sinew {

/// Which kinds of numbers a pose has changed, of those that something is made of beforehand.
struct DrivenChange {
  bool primitives = false;
  bool lines = false;
};

/// Order: lines are measured as the rig has them, then every driver, none reading another's result. The same pose gives
/// the same numbers, whatever came before. A driver whose input this character lacks is left out.
class DrivenNumbers {
 public:
  DrivenNumbers() = default;
  DrivenNumbers(const Rig& rig, const Character& character);

  [[nodiscard]] bool isEmpty() const { return numbers_.empty(); }
  /// @param rig  the one that this was made of, or what apply() made of it before
  DrivenChange apply(const Pose& pose, const Skeleton& skeleton, Rig& rig);

 private:
  struct Join {
    FoundInput input;
    Curve curve;
    DriverMode mode = DriverMode::kAdd;
  };
  struct Number {
    NumberRef ref;
    float drawn = 0.0f;  ///< The rig's own.
    std::vector<KeyTrack> keys;
    std::vector<Join> drivers;
  };
  void take(const std::vector<AnimatedNumber>& animated, int owner, const Rig& rig, const Character& character);
  void measureLines(const Pose& pose, const Skeleton& skeleton);
  [[nodiscard]] float valueOf(const Number& number, const Pose& pose, const Skeleton& skeleton);

  std::vector<Number> numbers_;
  std::vector<std::optional<LineRest>> rests_;  ///< [Rig::lines] those that inputs read; empty: none are.
  LineScratch lineScratch_;                     ///< Memory kept from pose to pose, as are the next.
  std::vector<PosedLine> lines_;
  InputScratch inputs_;
};

/// Keys, drivers or both change some number of the rig.
[[nodiscard]] bool isAnimated(const Rig& rig);
/// The rig as it is in a pose: what smoothing it shows, and what a picture of its primitives must show.
[[nodiscard]] Rig drivenRig(const Rig& rig, const Character& character, const Pose& pose);
/// The same, or the rig itself where nothing animates it. @param memory  holds the driven one
[[nodiscard]] const Rig& inPose(const Rig& rig, const Character& character, const Pose& pose, Rig& memory);

}  // namespace sinew
