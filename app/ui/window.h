// app/ui/window.h: the one window: OpenGL 4.5 core, events into a queue, dropped files.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/ui/input_queue.h"
#include "app/ui/window_place.h"
#include "sinew/geometry/result.h"

struct GLFWwindow;
namespace sinew::app {

// The letter printed on a key, not its place on a US keyboard.

/// GLFW names keys by their place on a US keyboard; what shortcuts mean is the letter that the user's layout gives.
/// Letters and punctuation follow the layout. The row of digits keeps its place, as some layouts (AZERTY) give
/// punctuation there and digits with Shift only; so do keys whose sign is no ASCII character (a Cyrillic layout, say).
/// @param key  GLFW's code; @param printed  what glfwGetKeyName says of it, null if nothing.
[[nodiscard]] int keyMeaning(int key, const char* printed);

/// Owns GLFW and the window. One at a time, main thread only. Its address is what the callbacks know, so it never
/// moves.
class Window {
 public:
  /// Opens the window and makes its context current. Error: no display, or no OpenGL 4.5.
  /// @param size  for a first start: grows with the screen's content scale.
  /// @param before  where it was the last time; matters if it is still on a screen.
  [[nodiscard]] static Result<std::unique_ptr<Window>> open(const glm::ivec2& size, const std::string& title,
                                                            const WindowPlace& before = {});
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] GLFWwindow* handle() const { return window_; }
  [[nodiscard]] InputQueue& input() { return input_; }
  [[nodiscard]] glm::ivec2 size() const;             ///< Window coordinates, as the mouse has them.
  [[nodiscard]] glm::ivec2 framebufferSize() const;  ///< Pixels.
  [[nodiscard]] float contentScale() const;          ///< 1 on ordinary screens, 2 on dense ones.
  /// Now; of a maximized or minimized window, what it was before.
  [[nodiscard]] WindowPlace place() const;

  void setTitle(const std::string& title);
  [[nodiscard]] bool closeRequested() const;
  void clearCloseRequest();

  void poll();                ///< Takes what has come.
  void wait(double seconds);  ///< Sleeps until something comes, or that long.
  void swap();
  /// Files dropped since the last call.
  [[nodiscard]] std::vector<std::filesystem::path> takeDrops();
  /// Since the last call, the system asked for a new picture (uncovered, resized).
  [[nodiscard]] bool takeRefresh();

 private:
  Window() = default;
  void installCallbacks();
  void takeKey(int key, int scancode, int action);

  GLFWwindow* window_ = nullptr;
  InputQueue input_;
  std::vector<std::filesystem::path> drops_;
  std::string title_;
  mutable WindowPlace place_;              ///< The last that was neither maximized nor minimized.
  std::array<int, kKeyCodes> meanings_{};  ///< What a held key meant when it went down; 0: it is up.
  bool refresh_ = true;
};

}  // namespace sinew::app
