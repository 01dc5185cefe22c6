// tests/ui/input_queue_test.cpp: no input is lost or reordered between the window and a slow frame.

#include "app/ui/input_queue.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace sinew::app {
namespace {

constexpr int kKeyA = 65;
constexpr int kKeyS = 83;
constexpr int kLeftControl = 341;

TEST(InputQueue, ClickWithinOneFrameIsPressAndRelease) {
  InputQueue queue;
  queue.move({10, 20});
  queue.button(0, true);
  queue.button(0, false);
  EXPECT_EQ(queue.next().mouse, glm::vec2(10, 20));
  EXPECT_EQ(queue.next().pressedButton, 0);
  EXPECT_TRUE(queue.pending());
  const RawInput& released = queue.next();
  EXPECT_EQ(released.releasedButton, 0);
  EXPECT_FALSE(released.buttons[0]);
  EXPECT_FALSE(queue.pending());
}

TEST(InputQueue, LastPositionOfADragComesBeforeItsRelease) {
  InputQueue queue;
  queue.button(0, true);
  static_cast<void>(queue.next());
  for (int x = 1; x <= 100; ++x) queue.move({x, 0});
  queue.button(0, false);
  const RawInput moved = queue.next();
  EXPECT_EQ(moved.mouse.x, 100.0f);
  EXPECT_TRUE(moved.buttons[0]);
  EXPECT_EQ(queue.next().releasedButton, 0);
}

TEST(InputQueue, MoveAfterThePressDoesNotMoveThePress) {
  InputQueue queue;
  queue.move({5, 5});
  queue.button(0, true);
  queue.move({90, 90});
  static_cast<void>(queue.next());
  const RawInput pressed = queue.next();
  EXPECT_EQ(pressed.pressedButton, 0);
  EXPECT_EQ(pressed.mouse, glm::vec2(5, 5));
  EXPECT_EQ(queue.next().mouse, glm::vec2(90, 90));
}

TEST(InputQueue, ShortcutKeepsItsModifier) {
  InputQueue queue;
  queue.key(kLeftControl, true);
  queue.key(kKeyS, true);
  queue.key(kKeyS, false);
  queue.key(kLeftControl, false);
  bool seen = false;
  while (queue.pending()) {
    const RawInput& frame = queue.next();
    if (frame.pressedKey != kKeyS) continue;
    seen = true;
    EXPECT_TRUE(frame.control);
  }
  EXPECT_TRUE(seen);
  EXPECT_FALSE(queue.next().control);
}

TEST(InputQueue, TypedTextArrivesWholeAndInOrder) {
  InputQueue queue;
  const std::string text = "Biceps.L";
  for (const char c : text) {
    queue.key(kKeyA, true);
    queue.character(static_cast<char32_t>(c));
    queue.key(kKeyA, false);
  }
  std::string got;
  while (queue.pending()) {
    for (const char32_t c : queue.next().characters) got.push_back(static_cast<char>(c));
  }
  EXPECT_EQ(got, text);
}

TEST(InputQueue, ScrollKeepsItsPointerPosition) {
  InputQueue queue;
  queue.move({1, 1});
  queue.scroll({0, 1});
  queue.scroll({0, 2});
  queue.move({50, 50});
  const RawInput scrolled = queue.next();
  EXPECT_EQ(scrolled.scroll.y, 3.0f);
  EXPECT_EQ(scrolled.mouse, glm::vec2(1, 1));
  const RawInput moved = queue.next();
  EXPECT_EQ(moved.scroll.y, 0.0f);
  EXPECT_EQ(moved.mouse, glm::vec2(50, 50));
}

TEST(InputQueue, LosingFocusReleasesAllKeysAndButtons) {
  InputQueue queue;
  queue.key(kKeyA, true);
  queue.button(1, true);
  queue.releaseAll();
  while (queue.pending()) static_cast<void>(queue.next());
  const RawInput& rest = queue.next();
  EXPECT_FALSE(rest.keys[kKeyA]);
  EXPECT_FALSE(rest.buttons[1]);
}

TEST(InputQueue, UnknownCodesAreIgnored) {
  InputQueue queue;
  queue.key(-1, true);
  queue.key(kKeyCodes, true);
  queue.button(kMouseButtons, true);
  EXPECT_FALSE(queue.pending());
}

/// Name of one transition, as a recorder would list it.
std::string name(int kind, int code, bool down) {
  return std::to_string(kind) + ":" + std::to_string(code) + (down ? "+" : "-");
}

TEST(InputQueue, RandomEventsKeepTheirOrderAtMostOnePerFrame) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    InputQueue queue;
    std::vector<std::string> sent;
    std::vector<std::string> got;
    std::array<bool, 3> buttons{};
    std::array<bool, 4> keys{};
    const auto drain = [&](bool all) {
      do {
        const RawInput old = queue.next();
        if (old.pressedButton >= 0) got.push_back(name(0, old.pressedButton, true));
        if (old.releasedButton >= 0) got.push_back(name(0, old.releasedButton, false));
        EXPECT_LE((old.pressedButton >= 0) + (old.releasedButton >= 0) + (old.pressedKey >= 0), 1);
        if (old.pressedKey >= 0) got.push_back(name(1, old.pressedKey, true));
      } while (all && queue.pending());
    };
    for (int i = 0; i < 60; ++i) {
      switch (random() % 4) {
        case 0: {
          const std::size_t b = random() % buttons.size();
          buttons[b] = !buttons[b];
          queue.button(static_cast<int>(b), buttons[b]);
          sent.push_back(name(0, static_cast<int>(b), buttons[b]));
          break;
        }
        case 1: {
          const std::size_t k = random() % keys.size();
          keys[k] = !keys[k];
          queue.key(kKeyA + static_cast<int>(k), keys[k]);
          if (keys[k]) sent.push_back(name(1, kKeyA + static_cast<int>(k), true));
          break;
        }
        case 2:
          queue.move({static_cast<float>(i), 0.0f});
          break;
        default:
          drain(false);
          break;
      }
    }
    drain(true);
    EXPECT_EQ(got, sent);
  }
}

}  // namespace
}  // namespace sinew::app
