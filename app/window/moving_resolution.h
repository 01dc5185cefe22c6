// app/window/moving_resolution.h: how fine the picture is drawn while it moves.
#pragma once

#include <array>
#include <cstddef>

namespace sinew::app {

/// What a frame took, seconds.
struct FrameCost {
  double drawing = 0.0;  ///< The picture and the window: what a lower resolution makes cheaper.
  double other = 0.0;    ///< Interface, pose, surface.
  double hidden = 0.0;   ///< Of `other`: while the picture before may have been drawn. 0..other.
};

/// Lowers the resolution of a moving picture step by step until frames keep to kFrameGoal, and raises it where they
/// would keep to it on a finer step too. A function of the times given to it and of nothing else.
class MovingResolution {
 public:
  static constexpr double kFrameGoal = 1.0 / 42.0;  ///< Seconds; a little below what is aimed at, 40 a second.
  static constexpr std::array<float, 5> kScales{1.0f, 0.85f, 0.72f, 0.61f, 0.52f};  ///< Factors on width and height.
  static constexpr std::size_t kFewFrames = 3;    ///< Slow ones in a row: a step down.
  static constexpr std::size_t kManyFrames = 20;  ///< Fast ones in a row: a step up.

  /// A frame was drawn at scale() while the picture moved.
  void add(const FrameCost& cost);
  /// Scale of the next moving picture. Kept from one movement to the next: they cost about the same.
  [[nodiscard]] float scale() const { return kScales[step_]; }
  /// Seconds that drawing may take after all else: at least half of the goal, so that a slow surface does not make a
  /// picture coarse that is not the reason.
  [[nodiscard]] static double room(double other);

 private:
  void change(std::size_t step);

  std::size_t step_ = 0;
  std::size_t slow_ = 0;  ///< Frames in a row.
  std::size_t fast_ = 0;
  double least_ = 0.0;  ///< Drawing of the slow ones.
};

}  // namespace sinew::app
