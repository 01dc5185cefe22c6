// app/panels/panels.h: the table of panels. A new panel is a file and a row in panel_table.cpp.
#pragma once

#include <span>

#include "app/panels/panel_ui.h"

namespace sinew::app {

enum class Region { kLeftTop, kLeftBottom, kRight, kBottom, kInViewport, kDialog };

struct Panel {
  const char* id;     ///< Stable; the first part of its controls' ids.
  const char* title;  ///< "": none.
  Region region;
  void (*draw)(PanelUi&);
  bool always = false;                                   ///< Also drawn without a character.
  bool (*isWanted)(const EditorState& state) = nullptr;  ///< Hides panel and title if false. Null: never hidden.
};

[[nodiscard]] std::span<const Panel> panels();  ///< In drawing order.

void drawLeftTabs(PanelUi& ui);  ///< The tabs at the left, of which one is shown.
void drawOutliner(PanelUi& ui);
void drawLibrary(PanelUi& ui);
void drawShapes(PanelUi& ui);
/// Once a frame where the outliner is not drawn: keeps the label of a dragged muscle beside the pointer.
void keepDraggedShown(PanelUi& ui);
void drawHistory(PanelUi& ui);
void drawTimeline(PanelUi& ui);

/// The whole window. Sets state.frame.viewport and viewportPixels.
/// @return whether the mouse is over the picture and nothing is in front of it
bool drawLayout(PanelUi& ui);
float drawMenuBar(PanelUi& ui);  ///< Height in window coordinates.

}  // namespace sinew::app
