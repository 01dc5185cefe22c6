// app/editor/action_table.h: building blocks of the rows of the action table.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <span>

#include "app/editor/actions.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"

/// Rows: id, label, hint, key, second key, enabled, checked, run, separator before. Keys are the default keymap's.
namespace sinew::app::table {

using State = EditorState;

// The menus: View, Tool and Play in action_table_view.cpp, the others in action_table.cpp.
[[nodiscard]] std::span<const Action> fileActions();
[[nodiscard]] std::span<const Action> editActions();
[[nodiscard]] std::span<const Action> muscleActions();
[[nodiscard]] std::span<const Action> viewActions();
[[nodiscard]] std::span<const Action> toolActions();
[[nodiscard]] std::span<const Action> playActions();
[[nodiscard]] std::span<const Action> windowActions();
[[nodiscard]] std::span<const Action> helpActions();

// Conditions.
inline Possible always(const State&) { return {}; }
inline Possible open(const State& s) { return {s.hasCharacter(), "Open a character first"}; }
inline Possible idle(const State& s) {
  return open(s).also(!ownsKeyboard(s.view.tools) && s.open.gestureItem == 0, "Finish the current edit first");
}
inline Possible selected(const State& s) {
  return idle(s).also(s.document.activePrimitive() >= 0, "Select a muscle first");
}

/// A command on the document alone.
template <void (*kCommand)(Document&)>
void onDocument(State& s) {
  kCommand(s.document);
}

// Keys.
inline constexpr Shortcut kNone{};
constexpr Shortcut key(int code) { return {code, false, false, false}; }
constexpr Shortcut ctrl(int code) { return {code, true, false, false}; }
constexpr Shortcut shift(int code) { return {code, false, true, false}; }
constexpr Shortcut alt(int code) { return {code, false, false, true}; }
constexpr Shortcut ctrlShift(int code) { return {code, true, true, false}; }

}  // namespace sinew::app::table
