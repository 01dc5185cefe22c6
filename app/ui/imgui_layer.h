// app/ui/imgui_layer.h: ImGui on our window, fed from the input queue.
#pragma once

#include <array>
#include <cstdint>

#include "app/ui/fonts.h"
#include "app/ui/input_queue.h"
#include "app/ui/late_letters.h"

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

  /// Between frames: letters drawn anew, spacing and round corners with them. The fonts before are gone.
  /// @return whether it was another.
  bool setScale(float scale);

  /// What a document's names say about Chinese letters.
  void setRegion(HanRegion region) { letters_.setRegion(region); }
  [[nodiscard]] bool hasLetter(char32_t c) { return letters_.has(c); }
  /// The frame that has ended was the first with some letters: the next one has their widths.
  [[nodiscard]] bool lettersMissing() const { return lettersMissing_; }
  /// Of the texture with the letters: equal revisions, equal pixels wherever a letter is.
  [[nodiscard]] std::uint64_t lettersRevision() const { return letters_.revision(); }

  [[nodiscard]] const Fonts& fonts() const { return fonts_; }
  [[nodiscard]] float scale() const { return scale_; }

 private:
  void showCursor();
  void makeFonts();

  GLFWwindow* window_;
  float scale_;
  Fonts fonts_;
  LateLetters letters_;
  bool lettersMissing_ = false;
  int shownCursor_ = -2;
  std::array<GLFWcursor*, 9> cursors_{};  ///< By ImGuiMouseCursor.
};

}  // namespace sinew::app
