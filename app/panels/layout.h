// app/panels/layout.h: the sizes of the panels in a window of a given size.
#pragma once

#include "app/document/preferences.h"

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

}  // namespace sinew::app
