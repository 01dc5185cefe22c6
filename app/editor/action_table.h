// app/editor/action_table.h: what the rows of the action table are made of; one file a menu.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <span>

#include "app/editor/actions.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"

/// Rows read: id, label, hint, key, another key, when, checked, run, separator before. The keys are those of the
/// default keymap; where another keymap differs is said in keymaps.cpp.
namespace sinew::app::table {

using State = EditorState;

// The menus, each in its own file: action_table_NAME.cpp.
[[nodiscard]] std::span<const Action> fileActions();
[[nodiscard]] std::span<const Action> editActions();
[[nodiscard]] std::span<const Action> muscleActions();
[[nodiscard]] std::span<const Action> viewActions();
[[nodiscard]] std::span<const Action> toolActions();
[[nodiscard]] std::span<const Action> playActions();
[[nodiscard]] std::span<const Action> windowActions();
[[nodiscard]] std::span<const Action> helpActions();

// When, and why not.
inline Possible always(const State&) { return {}; }
inline Possible open(const State& s) { return {s.hasCharacter(), "Open a character first"}; }
/// Nothing is being dragged or typed.
inline Possible idle(const State& s) {
  return open(s).also(!ownsKeyboard(s.view.tools) && s.open.gestureItem == 0, "Finish the current edit first");
}
inline Possible selected(const State& s) {
  return idle(s).also(s.document.activePrimitive() >= 0, "Select a muscle first");
}

// Commands that change one part of the state as rows of the table.
template <void (*kCommand)(Document&)>
void onDocument(State& s) {
  kCommand(s.document);
}
template <void (*kCommand)(Dialogs&)>
void onDialogs(State& s) {
  kCommand(s.dialogs);
}

// Keys.
inline constexpr Shortcut kNone{};
constexpr Shortcut key(int code) { return {code, false, false, false}; }
constexpr Shortcut ctrl(int code) { return {code, true, false, false}; }
constexpr Shortcut shift(int code) { return {code, false, true, false}; }
constexpr Shortcut alt(int code) { return {code, false, false, true}; }
constexpr Shortcut ctrlShift(int code) { return {code, true, true, false}; }

}  // namespace sinew::app::table
