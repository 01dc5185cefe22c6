// app/viewport/tools/input.h: what one frame's mouse and keyboard did in the viewport, as plain data.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew::app {

inline constexpr float kDragThreshold = 4.0f;  ///< Design pixels a press may move and still be a click.

enum class MouseButton { kLeft = 0, kRight = 1, kMiddle = 2 };  ///< Numbers as in GLFW and ImGui.

struct ButtonState {
  bool down = false;
  bool pressed = false;   ///< Went down in this frame.
  bool released = false;  ///< Went up in this frame.
  bool doubleClicked = false;
};

/// The keys tools listen to during a drag. Values are GLFW's key codes: static_cast<Key>(glfwKey).
enum class Key : int { kX = 88, kY = 89, kZ = 90, kEscape = 256, kEnter = 257, kBackspace = 259, kKeypadEnter = 335 };

/// One frame. Pixels are those of View: x right, y down, (0, 0) the viewport's top left corner.
struct ViewportInput {
  glm::vec2 mouse{0.0f};
  std::array<ButtonState, 3> buttons;  ///< By MouseButton.
  float wheel = 0.0f;                  ///< Steps; up (away from the user) is positive: zoom in.
  bool shift = false;
  bool ctrl = false;
  bool alt = false;
  std::vector<Key> keysPressed;  ///< Pressed or repeated in this frame. Keys other than the named ones may be in it.
  std::string typed;             ///< Characters typed in this frame (text input, not key codes); ASCII is enough.
  float deltaSeconds = 0.0f;     ///< Since the frame before.
  bool mouseTaken = false;       ///< Another panel, popup or widget has the mouse: no press or wheel starts here.
  bool keyboardTaken = false;    ///< A text field has the keyboard.

  [[nodiscard]] const ButtonState& button(MouseButton which) const { return buttons[static_cast<std::size_t>(which)]; }
  [[nodiscard]] bool keyPressed(Key key) const { return std::ranges::find(keysPressed, key) != keysPressed.end(); }
};

}  // namespace sinew::app
