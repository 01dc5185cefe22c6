// app/panels/layout_sizes.cpp: what is shown of the wished panel sizes in a window of a given size.

#include "app/panels/layout_sizes.h"

#include <algorithm>

namespace sinew::app {
namespace {

/// Two sizes that share a room: what is too much is taken from both, in proportion to what each has over `least`.
void share(float& a, float& b, float leastA, float leastB, float room) {
  const float spare = (a - leastA) + (b - leastB);
  const float over = a + b - std::max(room, leastA + leastB);
  if (over <= 0.0f || spare <= 0.0f) return;
  const float part = std::min(over / spare, 1.0f);
  a -= part * (a - leastA);
  b -= part * (b - leastB);
}

}  // namespace

LayoutSizes shownSizes(const LayoutState& wished, float width, float height) {
  LayoutSizes sizes;
  const float leastLeft = wished.leftShown ? kPanelNarrowest : 0.0f;
  const float leastRight = wished.rightShown ? kPanelNarrowest : 0.0f;
  const float bars = (wished.leftShown ? kSplitter : 0.0f) + (wished.rightShown ? kSplitter : 0.0f);
  if (wished.leftShown) sizes.left = std::max(wished.left, kPanelNarrowest);
  if (wished.rightShown) sizes.right = std::max(wished.right, kPanelNarrowest);
  share(sizes.left, sizes.right, leastLeft, leastRight, width - bars - kViewportNarrowest);
  const float bottomBar = wished.bottomShown ? kSplitter : 0.0f;
  const float upright = height - kStatusHeight - bottomBar;
  if (wished.bottomShown) {
    sizes.bottom = std::clamp(wished.bottom, kBottomLowest, std::max(kBottomLowest, upright - kViewportLowest));
  }
  const float column = upright - sizes.bottom - kSplitter;
  sizes.history = std::clamp(wished.history, kHistoryLowest, std::max(kHistoryLowest, column - kOutlinerLowest));
  // A very low window: the outliner keeps the larger half.
  sizes.history = std::max(0.0f, std::min(sizes.history, 0.45f * column));
  return sizes;
}

}  // namespace sinew::app
