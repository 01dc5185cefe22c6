// app/ui/input_queue.h: window events recorded as they come, handed out one transition a frame.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

#include <glm/vec2.hpp>

namespace sinew::app {

inline constexpr int kMouseButtons = 5;
inline constexpr int kKeyCodes = 512;  ///< GLFW's key codes are below this.

/// What the interface sees in one frame: the state after its one transition, and that transition.
struct RawInput {
  glm::vec2 mouse{-1.0f};  ///< Window coordinates, pixels of the window; (0, 0) the top left corner.
  bool mouseInside = false;
  std::array<bool, kMouseButtons> buttons{};  ///< 0 left, 1 right, 2 middle.
  std::array<bool, kKeyCodes> keys{};
  bool control = false;
  bool shift = false;
  bool alt = false;
  bool super = false;
  glm::vec2 scroll{0.0f};            ///< Sum of this frame; y > 0 away from the user.
  std::vector<char32_t> characters;  ///< Typed text.
  int pressedButton = -1;
  int releasedButton = -1;
  int pressedKey = -1;
  int repeatedKey = -1;  ///< Held down and repeated by the system.
};

/// The interface samples its input once a frame; a click, or a drag's last move and its release, would be lost when a
/// slow frame swallows both. So events wait here and next() gives as many as one frame can tell apart: any run of
/// moves; or one button; or releases of keys, one press and the text it typed. A position never overtakes a button, or
/// the reverse.
class InputQueue {
 public:
  void move(const glm::vec2& position);
  void enter(bool inside);
  void button(int button, bool down);  ///< Others than kMouseButtons are ignored, as are repeats of the same state.
  void scroll(const glm::vec2& amount);
  void key(int key, bool down);
  void keyRepeat(int key);
  void character(char32_t codepoint);
  /// Focus went away: releases whatever is held, as the system will not tell.
  void releaseAll();

  /// The next frame's input. Without events: the state as it stands, no transition.
  [[nodiscard]] const RawInput& next();
  /// More is waiting: the next frame should not wait for the system.
  [[nodiscard]] bool pending() const { return !events_.empty(); }

 private:
  enum class Kind { kMove, kEnter, kButton, kScroll, kKey, kKeyRepeat, kCharacter };
  struct Event {
    Kind kind = Kind::kMove;
    glm::vec2 amount{0.0f};
    int code = 0;
    bool down = false;
  };
  void push(const Event& event);
  [[nodiscard]] bool fits(const Event& event) const;
  void take(const Event& event);

  std::deque<Event> events_;
  RawInput frame_;
  // As they will stand once the queue is empty; against these repeats are dropped.
  std::array<bool, kMouseButtons> lastButtons_{};
  std::array<bool, kKeyCodes> lastKeys_{};
  // What the frame in the making has taken.
  bool moved_ = false;
  bool scrolled_ = false;
  bool keyed_ = false;
  bool typed_ = false;
};

}  // namespace sinew::app
