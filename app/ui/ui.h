// app/ui/ui.h: what every control is handed, and the few controls that all panels share.
#pragma once

#include <algorithm>
#include <span>
#include <string>

#include "app/ui/icons.h"
#include "app/ui/reading_order.h"
#include "app/ui/style.h"
#include "app/ui/widget_log.h"

namespace sinew::app {

/// The interface for the length of a frame. Knows no document.
struct Ui {
  WidgetLog& widgets;
  const Fonts& fonts;
  float scale = 1.0f;        ///< Window coordinates per design pixel.
  double wakeAfter = 0.0;    ///< Out: seconds until another frame is wanted though nothing happens; 0: none is.
  bool escapeTaken = false;  ///< Esc has closed a menu or list in this frame.

  /// Design pixels -> window coordinates.
  [[nodiscard]] float px(float design) const { return design * scale; }
  /// Another frame is wanted in so many seconds at the latest.
  void wakeIn(double seconds) { wakeAfter = wakeAfter > 0.0 ? std::min(wakeAfter, seconds) : seconds; }
};

/// A section heading: bold text.
void heading(Ui& ui, const char* text);
void mutedText(const char* text);
/// Shown while the last item is hovered, disabled or not, after a short delay.
void tooltip(Ui& ui, const std::string& text);

/// Square button with an icon; lit when active. Notes itself as `id`.
bool iconButton(Ui& ui, const std::string& id, Icon icon, bool active, float size, const std::string& hint = "");
/// Small rounded button with a word; filled when active. Notes itself as `id`.
bool pillButton(Ui& ui, const std::string& id, const char* label, bool active);

/// A property's name in the left column; the next item fills the rest of the row. In a narrow panel the name gets less
/// room, and is elided.
void beginRow(Ui& ui, const char* label);
/// The same where the row needs much room: in a narrow panel the name stands above it.
void beginWideRow(Ui& ui, const char* label);

/// Around a modal window: padding and round corners.
void pushDialogStyle(Ui& ui);
void popDialogStyle();
/// Before a modal window: in the middle, as wide as wished and no larger than the window; what is too high scrolls.
void placeDialog(Ui& ui, float designWidth);

/// Once a frame, before all panels: Esc closes the topmost menu or list (ImGui does so only with its own keyboard
/// navigation). @return whether one was closed: then Esc has done its work.
bool closeMenuOnEscape();
/// Esc in this frame, and no menu or list has taken it.
[[nodiscard]] bool escapePressed(const Ui& ui);

/// Two or more words of which one is chosen, in a row that fills the width; notes itself as ID/WORD in lower case.
/// @return the index that was clicked, or -1
int segmented(Ui& ui, const std::string& id, const char* const* words, int count, int chosen, float width);

/// A text as elided() makes it for a width in the current font.
[[nodiscard]] std::string fitted(const std::string& text, float width, const SharedEnds& shared = {});
/// The same into a draw list. @return whether something was left out: then a tooltip says it all.
bool clippedText(ImDrawList& list, const ImVec2& at, float width, ImU32 color, const std::string& text,
                 const SharedEnds& shared = {});
/// At the cursor, muted, no wider than the room that is left; the whole text in the tooltip.
void mutedLine(Ui& ui, const std::string& text);
/// Shown while `over` holds, for what is drawn by hand.
void tooltipWhile(Ui& ui, bool over, const std::string& text);

/// How many of the items fit into a room, in order. If not all do, the rest is reached through a button of the width
/// `more`, which then has room too.
[[nodiscard]] std::size_t fittingCount(std::span<const float> widths, float room, float more);
/// The button for what did not fit; a click opens a menu of it. Notes itself as `id`. True: endMore() has to follow.
bool beginMore(Ui& ui, const std::string& id, const ImVec2& size);
void endMore();

}  // namespace sinew::app
