// app/ui/window.h: the editor's window: OpenGL 4.5 core, events into a queue, dropped files.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/ui/input_queue.h"
#include "sinew/geometry/result.h"

struct GLFWwindow;
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

/// The key with the printed letter, because GLFW's codes name places on a US keyboard. Letters and punctuation follow
/// the user's layout; digits keep their place (AZERTY has them with Shift), and so do keys with signs beyond ASCII.
/// @param key  GLFW's code  @param printed  from glfwGetKeyName; may be null
[[nodiscard]] int keyMeaning(int key, const char* printed);

/// Owns GLFW and the window. One at a time, main thread only. Never moves, because callbacks keep its address.
class Window {
 public:
  /// Opens the window and makes its context current. Error: no display, or no OpenGL 4.5.
  /// @param size  for the first start; grows with the screen's content scale
  /// @param before  the last place; ignored if it is on no screen
  [[nodiscard]] static Result<std::unique_ptr<Window>> open(const glm::ivec2& size, const std::string& title,
                                                            const WindowPlace& before = {});
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  [[nodiscard]] GLFWwindow* handle() const { return window_; }
  [[nodiscard]] InputQueue& input() { return input_; }
  [[nodiscard]] glm::ivec2 size() const;             ///< Window coordinates.
  [[nodiscard]] glm::ivec2 framebufferSize() const;  ///< Pixels.
  [[nodiscard]] float contentScale() const;          ///< 1 on ordinary screens, 2 on dense ones.
  [[nodiscard]] WindowPlace place() const;           ///< While maximized or minimized, the place before.

  void setTitle(const std::string& title);
  [[nodiscard]] bool closeRequested() const;
  void clearCloseRequest();

  void poll();                ///< Takes waiting events.
  void wait(double seconds);  ///< Sleeps until an event, at most so long.
  void swap();
  [[nodiscard]] std::vector<std::filesystem::path> takeDrops();  ///< Files dropped since the last call.
  [[nodiscard]] bool takeRefresh();  ///< The window was uncovered or resized since the last call.

 private:
  Window() = default;
  void installCallbacks();
  void takeKey(int key, int scancode, int action);

  GLFWwindow* window_ = nullptr;
  InputQueue input_;
  std::vector<std::filesystem::path> drops_;
  std::string title_;
  mutable WindowPlace place_;              ///< The last one neither maximized nor minimized.
  std::array<int, kKeyCodes> meanings_{};  ///< keyMeaning() of a held key when it was pressed; 0: it is up.
  bool refresh_ = true;
};

}  // namespace sinew::app
