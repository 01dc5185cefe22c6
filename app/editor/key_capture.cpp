// app/editor/key_capture.cpp: the steps from a click on a key to another key.

#include "app/editor/key_capture.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace sinew::app {
namespace {

bool clears(const Shortcut& pressed) {
  const bool plain = !pressed.control && !pressed.shift && !pressed.alt;
  return plain && (pressed.key == GLFW_KEY_BACKSPACE || pressed.key == GLFW_KEY_DELETE);
}

std::string quoted(const Action& action) { return '"' + std::string(action.label) + '"'; }

}  // namespace

void startKeyCapture(EditorState& state, const Action& action, int slot) {
  KeyCapture& capture = state.dialogs.keyCapture;
  capture = {KeyCapture::Step::kWaiting, action.id, slot, "", ""};
}

void captureKey(EditorState& state, const Shortcut& pressed) {
  KeyCapture& capture = state.dialogs.keyCapture;
  if (capture.step != KeyCapture::Step::kWaiting) return;
  Preferences& preferences = state.session.preferences;
  const Action& wanted = action(capture.action);
  const auto slot = static_cast<std::size_t>(capture.slot);
  if (pressed.key == GLFW_KEY_ESCAPE) return endKeyCapture(state);
  if (clears(pressed)) {
    clearKey(preferences, wanted, slot);
    return endKeyCapture(state);
  }
  capture.notice = whyReserved(pressed);
  if (!capture.notice.empty()) return;
  const Action* owner = ownerOf(pressed, preferences);
  if (owner != nullptr && owner != &wanted) {
    capture.step = KeyCapture::Step::kAsking;
    capture.key = textOf(pressed);
    capture.notice = capture.key + " belongs to " + quoted(*owner) + ". Replace it?";
    return;
  }
  giveKey(preferences, wanted, slot, pressed);
  endKeyCapture(state);
}

void requestKeyReset(EditorState& state, const Action& action) {
  const auto losers = losersToReset(state.session.preferences, action);
  if (losers.empty()) {
    resetKeys(state.session.preferences, action);
    return endKeyCapture(state);
  }
  std::string names;
  for (const Action* loser : losers) names += (names.empty() ? "" : " and ") + quoted(*loser);
  state.dialogs.keyCapture = {KeyCapture::Step::kAsking, action.id, 0, "",
                              "The keymap's keys belong to " + names + ". Replace them?"};
}

void replaceKeys(EditorState& state) {
  const KeyCapture asked = std::exchange(state.dialogs.keyCapture, {});
  if (asked.step != KeyCapture::Step::kAsking) return;
  Preferences& preferences = state.session.preferences;
  if (asked.key.empty()) {
    resetKeys(preferences, action(asked.action));
  } else if (const auto key = shortcutFrom(asked.key)) {
    giveKey(preferences, action(asked.action), static_cast<std::size_t>(asked.slot), *key);
  }
}

void endKeyCapture(EditorState& state) { state.dialogs.keyCapture = {}; }

}  // namespace sinew::app
