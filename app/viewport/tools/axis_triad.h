// app/viewport/tools/axis_triad.h: the axis gizmo in a corner of the viewport: shows how the camera is turned, and
// turns it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/viewport/tools/camera.h"
#include "app/viewport/tools/input.h"

struct ImDrawList;

namespace sinew::app {

/// The six ends of the axes. Even: positive.
enum class AxisEnd { kX = 0, kMinusX, kY, kMinusY, kZ, kMinusZ };

inline constexpr float kTriadRadius = 44.0f;  ///< The ball's, design pixels.
inline constexpr float kTriadMargin = 14.0f;  ///< From the corner to the ball.

/// What the triad remembers between frames.
struct AxisTriad {
  std::optional<AxisEnd> hovered;
  bool ballHovered = false;
  bool pressed = false;  ///< The left button went down on it and is still held.
  bool turning = false;  ///< ... and has moved the camera: its release is no click.
  glm::vec2 pressPixel{0.0f};
  glm::vec2 lastPixel{0.0f};
};

/// Where everything is on screen. Pixels of the viewport, y down.
struct TriadLayout {
  struct End {
    AxisEnd end = AxisEnd::kX;
    glm::vec2 pixel{0.0f};
    float radius = 0.0f;  ///< Its knob's.
    float depth = 0.0f;   ///< -1 furthest from the eye .. 1 nearest.
  };
  glm::vec2 center{0.0f};
  float radius = 0.0f;
  std::array<End, 6> ends{};  ///< Furthest first: the order to draw in.
};

/// The ball stands in the lower right corner.
/// @param size of the viewport, pixels.  @param uiScale pixels per design pixel.
[[nodiscard]] TriadLayout layoutTriad(const Camera& camera, const glm::ivec2& size, float uiScale);

/// The nearest knob under a pixel; where two lie over each other the one nearer to the eye.
[[nodiscard]] std::optional<AxisEnd> axisEndAt(const TriadLayout& layout, const glm::vec2& pixel);

/// The standard view whose eye stands on that end: kX shows the character's left.
[[nodiscard]] StandardView viewFrom(AxisEnd end);
/// Looks from an end of an axis; from there already, from the opposite one.
void lookFrom(Camera& camera, AxisEnd end);

/// Everything for one frame: hover, a click on an end looks from there, a drag anywhere on the ball orbits.
/// @return whether the triad has the mouse: nothing else may have it.
bool routeTriad(AxisTriad& triad, Camera& camera, const ViewportInput& input, const glm::ivec2& size, float uiScale);

/// What is left of the input for those behind the triad: nothing of the mouse while it is on the ball or turns it.
/// @param busy something else holds the mouse since its press: the triad sleeps.
[[nodiscard]] ViewportInput passTriad(AxisTriad& triad, Camera& camera, ViewportInput input, const glm::ivec2& size,
                                      float uiScale, bool busy);

/// "Click: look from the front (+Z)"; "" if the pointer is elsewhere.
[[nodiscard]] std::string describe(const AxisTriad& triad);

/// @param topLeft of the viewport, in the list's units.  @param unitsPerPixel  list units per viewport pixel.
void drawTriad(ImDrawList& list, const AxisTriad& triad, const TriadLayout& layout, const glm::vec2& topLeft,
               float unitsPerPixel);

}  // namespace sinew::app
