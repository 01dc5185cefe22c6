// app/ui/window_place.h: position and size of the window.
#pragma once

namespace sinew::app {

/// Screen coordinates of its content; width 0: never placed.
struct WindowPlace {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  bool maximized = false;

  friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

}  // namespace sinew::app
