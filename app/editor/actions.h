// app/editor/actions.h: the one table of what a menu, a key or a button can do.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "app/document/preferences.h"
#include "app/editor/editor_state.h"
#include "app/ui/input_queue.h"

namespace sinew::app {

// Whether an action can run now and, if not, the reason that the user is shown.

/// Yes, or no with a reason: a short clause that names what is missing ("Select a muscle first"), without a full stop.
class Possible {
 public:
  /// Yes.
  constexpr Possible() = default;
  /// @param reason  used if `holds` is false; outlives everything (a literal)
  constexpr Possible(bool holds, const char* reason) : reason_(holds ? nullptr : reason) {}

  constexpr operator bool() const { return reason_ == nullptr; }  // NOLINT: implicit on purpose, it is a condition
  /// "" if it is possible.
  [[nodiscard]] constexpr const char* reason() const { return reason_ == nullptr ? "" : reason_; }
  /// The same, and one thing more; the first reason is the one that counts.
  [[nodiscard]] constexpr Possible also(bool holds, const char* reason) const {
    return *this ? Possible(holds, reason) : *this;
  }

 private:
  const char* reason_ = nullptr;
};

/// A key with its modifiers; key 0: none. Codes are GLFW's.
struct Shortcut {
  int key = 0;
  bool control = false;
  bool shift = false;
  bool alt = false;

  friend bool operator==(const Shortcut&, const Shortcut&) = default;
};

/// One thing to do. The id is "menu/name": its menu, and what tests and --log-state call it.
struct Action {
  const char* id;
  const char* label;
  const char* hint;   ///< One sentence for tooltips and the palette.
  Shortcut shortcut;  ///< In the default keymap (Maya's); others: shortcutsOf.
  Shortcut second;    ///< Another key for the same.
  Possible (*enabled)(const EditorState&);
  bool (*checked)(const EditorState&);  ///< Null: not a toggle.
  void (*run)(EditorState&);
  bool separatorBefore = false;

  [[nodiscard]] std::string_view menu() const {  ///< "file" of "file/save".
    const std::string_view all = id;
    return all.substr(0, all.find('/'));
  }
};

/// Menus from left to right: id part and title.
struct Menu {
  const char* id;
  const char* title;
};
[[nodiscard]] std::span<const Menu> menus();

/// The table, in menu order.
[[nodiscard]] std::span<const Action> actions();
/// By id; the id must exist (asserted).
[[nodiscard]] const Action& action(std::string_view id);

/// One way a keymap differs from the table.
struct KeyChange {
  const char* id;
  Shortcut shortcut;
  Shortcut second;
};
/// All of them; none for the default keymap. In keymaps.cpp.
[[nodiscard]] std::span<const KeyChange> changesOf(Keymap keymap);
/// "Maya-like", "Blender-like".
[[nodiscard]] const char* titleOf(Keymap keymap);
/// What an action answers to in a keymap as it comes; keys 0: to nothing.
[[nodiscard]] std::array<Shortcut, 2> shortcutsOf(const Action& action, Keymap keymap);
/// ... and with the user's own keys (app/editor/bindings.h).
[[nodiscard]] std::array<Shortcut, 2> shortcutsOf(const Action& action, const Preferences& preferences);

/// "Ctrl+Shift+S"; "" for none.
[[nodiscard]] std::string textOf(const Shortcut& shortcut);
/// The action's first key, as the user has set it; "" for none.
[[nodiscard]] std::string keyText(const Action& action, const EditorState& state);
/// Runs it if it is enabled.
void run(const Action& action, EditorState& state);
/// Runs what, with the user's keys, the key pressed (or repeated, for undo, redo and stepping) in this frame means.
/// @return whether it meant anything.
bool runShortcut(EditorState& state, const RawInput& input);

}  // namespace sinew::app
