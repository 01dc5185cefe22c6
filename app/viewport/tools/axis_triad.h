// app/viewport/tools/axis_triad.h: the axis gizmo in a corner of the viewport: shows and rotates the camera.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/viewport/tools/camera.h"
#include "app/viewport/tools/viewport_input.h"

struct ImDrawList;

namespace sinew::app {

enum class AxisEnd { kX = 0, kMinusX, kY, kMinusY, kZ, kMinusZ };  ///< Even: positive.

inline constexpr float kTriadRadius = 44.0f;  ///< The ball's, design pixels.
inline constexpr float kTriadMargin = 14.0f;  ///< From the corner to the ball.

/// State between frames.
struct AxisTriad {
  std::optional<AxisEnd> hovered;
  bool ballHovered = false;
  bool pressed = false;  ///< The left button is held since a press on it.
  bool turning = false;  ///< Has moved the camera, so that the release is no click.
  glm::vec2 pressPixel{0.0f};
  glm::vec2 lastPixel{0.0f};
};

/// Pixels of the viewport, y down.
struct TriadLayout {
  struct End {
    AxisEnd end = AxisEnd::kX;
    glm::vec2 pixel{0.0f};
    float radius = 0.0f;  ///< Of the knob.
    float depth = 0.0f;   ///< -1 furthest from the eye .. 1 nearest.
  };
  glm::vec2 center{0.0f};
  float radius = 0.0f;
  std::array<End, 6> ends{};  ///< Furthest first.
};

/// In the lower right corner. @param size  of the viewport, pixels  @param uiScale  pixels per design pixel
[[nodiscard]] TriadLayout layoutTriad(const Camera& camera, const glm::ivec2& size, float uiScale);

/// The knob under a pixel that is nearest to the eye.
[[nodiscard]] std::optional<AxisEnd> axisEndAt(const TriadLayout& layout, const glm::vec2& pixel);

/// One frame: hovers; a click on an end looks from there, a drag on the ball orbits. @return whether it has the mouse
bool routeTriad(AxisTriad& triad, Camera& camera, const ViewportInput& input, const glm::ivec2& size, float uiScale);

/// routeTriad(), and the input left for others: no mouse while it is on the ball or rotates it.
/// @param busy  something else has the mouse since its press, and the triad is inactive
[[nodiscard]] ViewportInput passTriad(AxisTriad& triad, Camera& camera, ViewportInput input, const glm::ivec2& size,
                                      float uiScale, bool busy);

[[nodiscard]] std::string describe(const AxisTriad& triad);  ///< For the status line; "" if the pointer is elsewhere.

/// @param topLeft of the viewport, in the list's units.  @param unitsPerPixel  list units per viewport pixel.
void drawTriad(ImDrawList& list, const AxisTriad& triad, const TriadLayout& layout, const glm::vec2& topLeft,
               float unitsPerPixel);

}  // namespace sinew::app
