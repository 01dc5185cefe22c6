// app/ui/input_queue.cpp: window events, one transition per frame.
#include "app/ui/input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sinew::app {
namespace {

bool isButton(int button) { return button >= 0 && button < kMouseButtons; }
bool isKey(int key) { return key >= 0 && key < kKeyCodes; }

void updateModifiers(RawInput& frame) {
  const auto held = [&](int left, int right) {
    return frame.keys[static_cast<std::size_t>(left)] || frame.keys[static_cast<std::size_t>(right)];
  };
  frame.control = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  frame.shift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  frame.alt = held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  frame.super = held(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}

}  // namespace

void InputQueue::push(const Event& event) { events_.push_back(event); }

void InputQueue::move(const glm::vec2& position) {
  // Only the last of consecutive moves matters.
  if (!events_.empty() && events_.back().kind == Kind::kMove) events_.back().amount = position;
  else push({Kind::kMove, position, 0, false});
}

void InputQueue::enter(bool inside) { push({Kind::kEnter, {}, 0, inside}); }

void InputQueue::button(int button, bool down) {
  if (!isButton(button) || lastButtons_[static_cast<std::size_t>(button)] == down) return;
  lastButtons_[static_cast<std::size_t>(button)] = down;
  push({Kind::kButton, {}, button, down});
}

void InputQueue::scroll(const glm::vec2& amount) {
  if (!events_.empty() && events_.back().kind == Kind::kScroll) events_.back().amount += amount;
  else push({Kind::kScroll, amount, 0, false});
}

void InputQueue::key(int key, bool down) {
  if (!isKey(key) || lastKeys_[static_cast<std::size_t>(key)] == down) return;
  lastKeys_[static_cast<std::size_t>(key)] = down;
  push({Kind::kKey, {}, key, down});
}

void InputQueue::keyRepeat(int key) {
  if (!isKey(key)) return;
  // A slow frame must not collect repeats.
  if (!events_.empty() && events_.back().kind == Kind::kKeyRepeat && events_.back().code == key) return;
  push({Kind::kKeyRepeat, {}, key, true});
}

void InputQueue::character(char32_t codepoint) { push({Kind::kCharacter, {}, static_cast<int>(codepoint), true}); }

void InputQueue::releaseAll() {
  for (int i = 0; i < kMouseButtons; ++i) button(i, false);
  for (int i = 0; i < kKeyCodes; ++i) key(i, false);
}

bool InputQueue::fits(const Event& event) const {
  const bool buttoned = frame_.pressedButton >= 0 || frame_.releasedButton >= 0;
  const bool pressed = frame_.pressedKey >= 0 || frame_.repeatedKey >= 0;
  switch (event.kind) {
    case Kind::kMove:
    case Kind::kEnter:
      return !buttoned && !scrolled_ && !keyed_ && !typed_;
    case Kind::kScroll:
      return !buttoned && !keyed_ && !typed_;
    case Kind::kButton:
      return !buttoned && !moved_ && !scrolled_ && !keyed_ && !typed_;
    case Kind::kKey:
    case Kind::kKeyRepeat:
      return !buttoned && !moved_ && !scrolled_ && !pressed && !typed_;
    case Kind::kCharacter:
      return !buttoned && !moved_ && !scrolled_;
  }
  return false;
}

void InputQueue::take(const Event& event) {
  const auto code = static_cast<std::size_t>(event.code);
  switch (event.kind) {
    case Kind::kMove:
      frame_.mouse = event.amount;
      frame_.mouseInside = true;
      moved_ = true;
      break;
    case Kind::kEnter:
      frame_.mouseInside = event.down;
      moved_ = true;
      break;
    case Kind::kScroll:
      frame_.scroll += event.amount;
      scrolled_ = true;
      break;
    case Kind::kButton:
      frame_.buttons[code] = event.down;
      (event.down ? frame_.pressedButton : frame_.releasedButton) = event.code;
      break;
    case Kind::kKey:
      frame_.keys[code] = event.down;
      if (event.down) frame_.pressedKey = event.code;
      keyed_ = true;
      break;
    case Kind::kKeyRepeat:
      frame_.repeatedKey = event.code;
      keyed_ = true;
      break;
    case Kind::kCharacter:
      frame_.characters.push_back(static_cast<char32_t>(event.code));
      typed_ = true;
      break;
  }
}

const RawInput& InputQueue::next() {
  frame_.scroll = glm::vec2(0.0f);
  frame_.characters.clear();
  frame_.pressedButton = frame_.releasedButton = frame_.pressedKey = frame_.repeatedKey = -1;
  moved_ = scrolled_ = keyed_ = typed_ = false;
  while (!events_.empty() && fits(events_.front())) {
    take(events_.front());
    events_.pop_front();
  }
  updateModifiers(frame_);
  return frame_;
}

}  // namespace sinew::app
