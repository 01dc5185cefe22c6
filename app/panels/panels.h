// app/panels/panels.h: the table of panels and the window's layout. A new panel is a file and a row in layout.cpp.
#pragma once

#include <span>

#include "app/document/preferences.h"
#include "app/panels/panel_ui.h"

namespace sinew::app {

inline constexpr float kSplitter = 5.0f;  ///< Design pixels, as all here: width of the bars between panels.
inline constexpr float kStatusHeight = 28.0f;
inline constexpr float kPanelNarrowest = 180.0f;
inline constexpr float kViewportNarrowest = 240.0f;
inline constexpr float kViewportLowest = 240.0f;
inline constexpr float kBottomLowest = 76.0f;
inline constexpr float kHistoryLowest = 64.0f;
inline constexpr float kOutlinerLowest = 240.0f;

/// Sizes in this frame; 0 for hidden panels.
struct LayoutSizes {
  float left = 0.0f;
  float right = 0.0f;
  float bottom = 0.0f;
  float history = 0.0f;
};

/// The wished sizes, reduced to fit. Depends only on its parameters. @param width, height  without the menu bar
[[nodiscard]] LayoutSizes shownSizes(const LayoutState& wished, float width, float height);

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
