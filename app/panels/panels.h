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

/// The tabs at the left, of which one is shown.
void drawLeftTabs(PanelUi& ui);
void drawOutliner(PanelUi& ui);
void drawLibrary(PanelUi& ui);
void drawShapes(PanelUi& ui);
/// Once a frame where the outliner is not drawn: keeps the label of a dragged muscle beside the pointer.
void keepDraggedShown(PanelUi& ui);
void drawHistory(PanelUi& ui);
void drawTimeline(PanelUi& ui);

/// Menu bar, regions, splitters, status line, dialogs: the whole window. Fills state.frame.viewport and viewportPixels.
/// @return whether the mouse is over the picture and nothing lies in front of it.
bool drawLayout(PanelUi& ui);
/// Height in window coordinates.
float drawMenuBar(PanelUi& ui);

}  // namespace sinew::app
