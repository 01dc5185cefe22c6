// app/ui/imgui_layer.h: ImGui in the window, fed from the input queue.
#pragma once

#include <array>
#include <string_view>

#include "app/ui/input_queue.h"
#include "app/ui/letters.h"
#include "app/ui/style.h"

struct GLFWcursor;
struct GLFWwindow;
struct ImDrawData;

namespace sinew::app {

void feedImGui(const RawInput& input);  ///< Writes one frame's input into the current ImGui context.
void mapKeys();                         ///< Sets ImGui's key map to the codes of RawInput::keys.

/// Owns the ImGui context and its OpenGL backend. The window's OpenGL context must stay current.
class ImGuiLayer {
 public:
  explicit ImGuiLayer(GLFWwindow* window, float scale);
  ~ImGuiLayer();
  ImGuiLayer(const ImGuiLayer&) = delete;
  ImGuiLayer& operator=(const ImGuiLayer&) = delete;

  /// @param seconds  since the last frame  @param drawing  duration of a frame without waiting for events
  void beginFrame(const RawInput& input, double seconds, double drawing);
  ImDrawData& endFrame();  ///< Sets the pointer's shape. @return what to draw, valid until the next frame

  /// Between frames: rebuilds the fonts for a new scale or new letters. @return whether it did
  bool prepareFonts(float scale);
  /// The last frame lacked letters that the next one will have.
  [[nodiscard]] bool lettersMissing() const { return names_.outdated(); }

  /// Letters of a document's names, with the region of its Chinese letters.
  void wantLetters(std::u32string_view letters, HanRegion region) {
    names_.setRegion(region);
    names_.want(letters);
  }
  [[nodiscard]] bool hasLetter(char32_t c) { return names_.has(c); }

  [[nodiscard]] const Fonts& fonts() const { return fonts_; }
  [[nodiscard]] float scale() const { return scale_; }

 private:
  void showCursor();
  void makeFonts();

  GLFWwindow* window_;
  float scale_;
  Fonts fonts_;
  NameTexture names_;
  int shownCursor_ = -2;
  std::array<GLFWcursor*, 9> cursors_{};  ///< By ImGuiMouseCursor.
};

}  // namespace sinew::app
