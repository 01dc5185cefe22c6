// app/viewport/tools/viewport_input.h: one frame's mouse and keyboard input in the viewport.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/ui/input_queue.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {

inline constexpr float kDragThreshold = 4.0f;  ///< Design pixels a press may move and still be a click.

enum class MouseButton { kLeft = 0, kRight = 1, kMiddle = 2 };  ///< As in GLFW and ImGui.

struct ButtonState {
  bool down = false;
  bool pressed = false;   ///< Went down in this frame.
  bool released = false;  ///< Went up in this frame.
  bool doubleClicked = false;
};

/// Keys that tools use during a drag; GLFW's key codes.
enum class Key : int { kX = 88, kY = 89, kZ = 90, kEscape = 256, kEnter = 257, kBackspace = 259, kKeypadEnter = 335 };

/// In pixels of View: x right, y down, (0, 0) the top left corner.
struct ViewportInput {
  glm::vec2 mouse{0.0f};
  std::array<ButtonState, 3> buttons;  ///< By MouseButton.
  float wheel = 0.0f;                  ///< Steps; positive zooms in.
  bool shift = false;
  bool ctrl = false;
  bool alt = false;
  std::vector<Key> keysPressed;  ///< Pressed or repeated, also other keys than the named ones.
  std::string typed;             ///< ASCII characters of text input.
  float deltaSeconds = 0.0f;     ///< Since the frame before.
  bool mouseTaken = false;       ///< A panel, popup or widget has the mouse.

  [[nodiscard]] const ButtonState& button(MouseButton which) const { return buttons[static_cast<std::size_t>(which)]; }
  [[nodiscard]] bool keyPressed(Key key) const { return std::ranges::find(keysPressed, key) != keysPressed.end(); }
};

/// ImGui's use of the same input.
struct InterfaceClaims {
  bool viewportFree = false;   ///< The mouse is over the picture, nothing in front.
  bool doubleClicked = false;  ///< Left button.
};

/// @param pixelsPerUnit  framebuffer pixels per window coordinate
[[nodiscard]] ViewportInput viewportInput(const RawInput& input, const InterfaceClaims& claims,
                                          const glm::vec4& viewport, const glm::vec2& pixelsPerUnit, double seconds);

}  // namespace sinew::app
