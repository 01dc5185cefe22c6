// app/panels/panels.h: every panel there is. A new one is a file and a row in panel_table.cpp.
#pragma once

#include <span>

#include "app/panels/panel_ui.h"

namespace sinew::app {

enum class Region { kLeftTop, kLeftBottom, kRight, kBottom, kInViewport, kDialog };

struct Panel {
  const char* id;     ///< Stable; first part of its controls' names.
  const char* title;  ///< Shown above it; "" for none.
  Region region;
  void (*draw)(PanelUi&);
  bool always = false;  ///< Also without a character.
  bool (*isWanted)(const EditorState& state) =
      nullptr;  ///< Kept out, title and all, where it says no. Null: it never is.
};

/// In drawing order.
[[nodiscard]] std::span<const Panel> panels();

// Those of this directory.
/// Outliner and groups, of which one is shown.
void drawLeftTabs(PanelUi& ui);
void drawHistory(PanelUi& ui);

/// Menu bar, regions, splitters, status line, dialogs: the whole window. Fills state.frame.viewport and viewportPixels.
/// @return whether the mouse is over the picture and nothing lies in front of it.
bool drawLayout(PanelUi& ui);
/// Height in window coordinates.
float drawMenuBar(PanelUi& ui);

}  // namespace sinew::app
