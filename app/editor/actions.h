// app/editor/actions.h: the table of actions behind menus, keys and buttons.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "app/document/preferences.h"
#include "app/editor/editor_state.h"
#include "app/ui/input_queue.h"

namespace sinew::app {

/// Whether an action can run; if not, the reason: a short clause without a full stop ("Select a muscle first").
class Possible {
 public:
  constexpr Possible() = default;
  /// @param reason  if `holds` is false; a literal
  constexpr Possible(bool holds, const char* reason) : reason_(holds ? nullptr : reason) {}

  constexpr operator bool() const { return reason_ == nullptr; }  // NOLINT: implicit on purpose
  /// "" if possible.
  [[nodiscard]] constexpr const char* reason() const { return reason_ == nullptr ? "" : reason_; }
  /// Adds a condition; the first reason counts.
  [[nodiscard]] constexpr Possible also(bool holds, const char* reason) const {
    return *this ? Possible(holds, reason) : *this;
  }

 private:
  const char* reason_ = nullptr;
};

/// A GLFW key with modifiers; key 0: none.
struct Shortcut {
  int key = 0;
  bool control = false;
  bool shift = false;
  bool alt = false;

  friend bool operator==(const Shortcut&, const Shortcut&) = default;
};

/// The id is "menu/name".
struct Action {
  const char* id;
  const char* label;
  const char* hint;   ///< One sentence for tooltips and the palette.
  Shortcut shortcut;  ///< In the default keymap (Maya's).
  Shortcut second;    ///< Second key.
  Possible (*enabled)(const EditorState&);
  bool (*checked)(const EditorState&);  ///< Null: not a toggle.
  void (*run)(EditorState&);
  bool separatorBefore = false;

  [[nodiscard]] std::string_view menu() const {  ///< "file" of "file/save".
    const std::string_view all = id;
    return all.substr(0, all.find('/'));
  }
};

/// In order from left to right.
struct Menu {
  const char* id;
  const char* title;
};
[[nodiscard]] std::span<const Menu> menus();

[[nodiscard]] std::span<const Action> actions();          ///< The table, in menu order.
[[nodiscard]] const Action& action(std::string_view id);  ///< By id, which must exist.

/// Keys of an action that differ in another keymap.
struct KeyChange {
  const char* id;
  Shortcut shortcut;
  Shortcut second;
};
[[nodiscard]] std::span<const KeyChange> changesOf(Keymap keymap);  ///< None for the default keymap.
[[nodiscard]] const char* titleOf(Keymap keymap);                   ///< "Maya-like", "Blender-like".
/// Keys of an action in an unchanged keymap.
[[nodiscard]] std::array<Shortcut, 2> shortcutsOf(const Action& action, Keymap keymap);
/// With the user's own keys (app/editor/bindings.h).
[[nodiscard]] std::array<Shortcut, 2> shortcutsOf(const Action& action, const Preferences& preferences);

[[nodiscard]] std::string textOf(const Shortcut& shortcut);                         ///< "Ctrl+Shift+S"; "" for none.
[[nodiscard]] std::string keyText(const Action& action, const EditorState& state);  ///< Its first key; "" for none.
void run(const Action& action, EditorState& state);                                 ///< Runs an enabled action.
/// Runs the action of this frame's key press (or repeat, for undo, redo and stepping). @return whether it had one
bool runShortcut(EditorState& state, const RawInput& input);

}  // namespace sinew::app
