// app/ui/input_queue.h: window events, handed out one transition per frame.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <vector>

#include <glm/vec2.hpp>

namespace sinew::app {

inline constexpr int kMouseButtons = 5;
inline constexpr int kKeyCodes = 512;  ///< GLFW's key codes are below this.

/// Input of one frame: the state after one transition, and the transition.
struct RawInput {
  glm::vec2 mouse{-1.0f};  ///< Window coordinates, from the top left corner.
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

/// The interface samples its input once per frame, so a slow frame would lose a click. Events wait here, and next()
/// takes what one frame can tell apart, in order: any run of moves; or one button; or releases of keys, one press and
/// its text.
class InputQueue {
 public:
  void move(const glm::vec2& position);
  void enter(bool inside);
  void button(int button, bool down);  ///< Ignores unknown buttons and repeats.
  void scroll(const glm::vec2& amount);
  void key(int key, bool down);
  void keyRepeat(int key);
  void character(char32_t codepoint);
  void releaseAll();  ///< Releases all keys and buttons when the focus is lost, as the system does not report it.

  [[nodiscard]] const RawInput& next();  ///< The next frame's input; without events, no transition.
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
  // States once the queue is empty, to drop repeats.
  std::array<bool, kMouseButtons> lastButtons_{};
  std::array<bool, kKeyCodes> lastKeys_{};
  // Taken for the current frame.
  bool moved_ = false;
  bool scrolled_ = false;
  bool keyed_ = false;
  bool typed_ = false;
};

}  // namespace sinew::app
