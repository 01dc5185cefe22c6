// app/viewport/tools/viewport_input.cpp: the window's input for the viewport's tools.

#include "app/viewport/tools/viewport_input.h"

namespace sinew::app {

ViewportInput viewportInput(const RawInput& input, const InterfaceClaims& claims, const glm::vec4& viewport,
                            const glm::vec2& pixelsPerUnit, double seconds) {
  ViewportInput result;
  result.mouse = (input.mouse - glm::vec2(viewport.x, viewport.y)) * pixelsPerUnit;
  for (std::size_t i = 0; i < result.buttons.size(); ++i) {
    const int button = static_cast<int>(i);
    result.buttons[i].down = input.buttons[i];
    result.buttons[i].pressed = input.pressedButton == button;
    result.buttons[i].released = input.releasedButton == button;
  }
  result.buttons[0].doubleClicked = claims.doubleClicked;
  result.wheel = input.scroll.y;
  result.shift = input.shift;
  result.ctrl = input.control;
  result.alt = input.alt;
  for (const int key : {input.pressedKey, input.repeatedKey}) {
    if (key >= 0) result.keysPressed.push_back(static_cast<Key>(key));
  }
  for (const char32_t c : input.characters) {
    if (c >= 32 && c < 127) result.typed.push_back(static_cast<char>(c));
  }
  result.deltaSeconds = static_cast<float>(seconds);
  result.mouseTaken = !claims.viewportFree;
  return result;
}

}  // namespace sinew::app
