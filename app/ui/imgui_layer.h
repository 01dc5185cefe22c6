// app/ui/imgui_layer.h: ImGui on our window, fed from the input queue.
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

/// Writes one frame's input into the current ImGui context. Needs no window: tests drive panels through it.
void feedImGui(const RawInput& input);

/// Tells ImGui which codes RawInput::keys uses for the keys it names itself.
void mapKeys();

/// Owns the ImGui context and its OpenGL backend. The window's context must be current for all of its life.
class ImGuiLayer {
 public:
  explicit ImGuiLayer(GLFWwindow* window, float scale);
  ~ImGuiLayer();
  ImGuiLayer(const ImGuiLayer&) = delete;
  ImGuiLayer& operator=(const ImGuiLayer&) = delete;

  /// @param seconds  since the last frame.
  /// @param drawing  what a frame takes now, without waiting for events.
  void beginFrame(const RawInput& input, double seconds, double drawing);
  /// Shows the pointer ImGui asks for. @return what is to be drawn; until the next frame begins.
  ImDrawData& endFrame();

  /// Between frames: the interface at a scale, its texture with all letters that were shown. The fonts before are gone.
  /// @return whether anything is drawn otherwise.
  bool prepareFonts(float scale);
  /// The frame that has ended shows letters that the next one has.
  [[nodiscard]] bool lettersMissing() const { return names_.outdated(); }

  /// Those of a document's names, which say as well whose Chinese letters they are.
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
