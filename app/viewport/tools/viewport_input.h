// app/viewport/tools/viewport_input.h: the window's input as the viewport's tools want it.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/ui/input_queue.h"
#include "app/viewport/tools/input.h"

namespace sinew::app {

/// What ImGui knows about the same frame.
struct InterfaceClaims {
  bool viewportFree = false;   ///< The mouse is over the picture, nothing in front.
  bool textWanted = false;     ///< A text field has the keyboard.
  bool doubleClicked = false;  ///< Left button.
};

/// @param pixelsPerUnit  framebuffer pixels per window coordinate.
[[nodiscard]] ViewportInput viewportInput(const RawInput& input, const InterfaceClaims& claims,
                                          const glm::vec4& viewport, const glm::vec2& pixelsPerUnit, double seconds);

}  // namespace sinew::app
