#pragma once  // app/panels/panels.h: every panel there is. A new one is a file and a row in panel_table.cpp.

#include <span>

#include "app/panels/ui.h"

namespace sinew::app {

enum class Region { kLeftTop, kLeftBottom, kRight, kBottom, kInViewport, kDialog };

struct Panel {
  const char* id;     ///< Stable; first part of its controls' names.
  const char* title;  ///< Shown above it; "" for none.
  Region region;
  void (*draw)(Ui&);
  bool always = false;  ///< Also without a character.
};

/// In drawing order.
[[nodiscard]] std::span<const Panel> panels();

// Left.
/// Outliner and groups, of which one is shown.
void drawLeftTabs(Ui& ui);
void drawOutliner(Ui& ui);
void drawBlending(Ui& ui);
void drawHistory(Ui& ui);
// Right.
void drawInspector(Ui& ui);
void drawSurfacePanel(Ui& ui);
void drawSmoothingPanel(Ui& ui);
// Bottom.
void drawTimeline(Ui& ui);
// Over the picture.
void drawToolStrip(Ui& ui);
void drawDisplayBar(Ui& ui);
void drawNumbers(Ui& ui);
void drawLegend(Ui& ui);
void drawMessages(Ui& ui);
// In front of all.
void drawFileDialog(Ui& ui);
void drawUnsavedQuestion(Ui& ui);
void drawRecoveryQuestion(Ui& ui);
void drawKeySheet(Ui& ui);
void drawPreferences(Ui& ui);
void drawPalette(Ui& ui);

/// Menu bar, regions, splitters, status line, dialogs: the whole window. Fills state.viewport and viewportPixels.
/// @return whether the mouse is over the picture and nothing lies in front of it.
bool drawLayout(Ui& ui);
/// How many messages there are, at the right end of the current line; a click shows or hides them. @return its width,
/// 0 without messages.
float drawMessageBadge(Ui& ui);
/// Height in window coordinates.
float drawMenuBar(Ui& ui);

}  // namespace sinew::app
