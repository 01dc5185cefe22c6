// app/panels/palette_words.h: what the palette finds besides the menus' actions, and other words for things.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/editor/editor_state.h"
#include "app/editor/possible.h"

namespace sinew::app {

/// A button of a panel.
struct PanelCommand {
  const char* id;  ///< "panel/learn"
  const char* label;
  const char* context;   ///< Where the button is.
  const char* synonyms;  ///< What else one may call it, apart by spaces.
  Possible (*enabled)(const EditorState&);
  void (*run)(EditorState&);
};
[[nodiscard]] std::span<const PanelCommand> panelCommands();

/// What other programs call an action, apart by spaces; "" for most.
[[nodiscard]] std::string_view synonymsOf(std::string_view actionId);

}  // namespace sinew::app
