// app/ui/ui.h: the interface of a frame, and the controls that all panels share.
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "app/ui/icons.h"
#include "app/ui/reading_order.h"
#include "app/ui/style.h"
#include "app/ui/widget_log.h"

namespace sinew::app {

/// The interface during a frame. Knows no document.
struct Ui {
  WidgetLog& widgets;
  const Fonts& fonts;
  float scale = 1.0f;        ///< Window coordinates per design pixel.
  double wakeAfter = 0.0;    ///< Out: seconds until another frame is wanted without input; 0: none.
  bool escapeTaken = false;  ///< Esc has closed a menu or list in this frame.

  /// Design pixels to window coordinates.
  [[nodiscard]] float px(float design) const { return design * scale; }
  /// Requests a frame within so many seconds.
  void wakeIn(double seconds) { wakeAfter = wakeAfter > 0.0 ? std::min(wakeAfter, seconds) : seconds; }
};

void heading(Ui& ui, const char* text);
void mutedText(const char* text);
void tooltip(Ui& ui, const std::string& text);  ///< Tooltip of the last item, disabled or not, after a short delay.

/// Square button with an icon, lit when active; notes itself as `id`.
bool iconButton(Ui& ui, const std::string& id, Icon icon, bool active, float size, const std::string& hint = "");
/// Small rounded button, filled when active; notes itself as `id`.
bool pillButton(Ui& ui, const std::string& id, const char* label, bool active);

/// A property's name, elided if needed, in the left column; the next item fills the rest of the row.
void beginRow(Ui& ui, const char* label);
void beginWideRow(Ui& ui, const char* label);  ///< The same for wide items: in a narrow panel the name stands above.

void pushDialogStyle(Ui& ui);  ///< Padding and corners of a modal window.
void popDialogStyle();
/// Before a modal window: centers it, with this width but no larger than the window.
void placeDialog(Ui& ui, float designWidth);

/// Once a frame, before all panels: Esc closes the topmost menu or list. @return whether one was closed
bool closeMenuOnEscape();
[[nodiscard]] bool escapePressed(const Ui& ui);  ///< Esc was pressed in this frame and closed no menu or list.

/// A row of words of which one is chosen; notes itself as ID/WORD in lower case. @return the clicked index, or -1
int segmented(Ui& ui, const std::string& id, const char* const* words, int count, int chosen, float width);

/// elided() for a width in the current font.
[[nodiscard]] std::string fitted(const std::string& text, float width, const SharedEnds& shared = {});
/// Draws it into a list. @return whether something was left out, for a tooltip
bool clippedText(ImDrawList& list, const ImVec2& at, float width, ImU32 color, const std::string& text,
                 const SharedEnds& shared = {});
/// Muted, elided to the available width, with the whole text as tooltip.
void mutedLine(Ui& ui, const std::string& text);
void tooltipWhile(Ui& ui, bool over, const std::string& text);  ///< Tooltip for what is drawn by hand.

/// How many items fit into a room; if not all, together with a button of width `more` for the rest.
[[nodiscard]] std::size_t fittingCount(std::span<const float> widths, float room, float more);
/// Button with a menu for items that did not fit; notes itself as `id`. If true, endMore() must follow.
bool beginMore(Ui& ui, const std::string& id, const ImVec2& size);
void endMore();

}  // namespace sinew::app
