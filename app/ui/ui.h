// app/ui/ui.h: what every control is handed, and the few controls that all panels share.
#pragma once

#include <string>

#include "app/ui/fonts.h"
#include "app/ui/icons.h"
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
};

/// A section heading: bold text.
void heading(Ui& ui, const char* text);
void mutedText(const char* text);
/// Shown while the last item is hovered.
void tooltip(Ui& ui, const std::string& text);

/// Square button with an icon; lit when active. Notes itself as `id`.
bool iconButton(Ui& ui, const std::string& id, Icon icon, bool active, float size, const std::string& hint = "");
/// Small rounded button with a word; filled when active. Notes itself as `id`.
bool pillButton(Ui& ui, const std::string& id, const char* label, bool active);

/// Around a slider: instead of a grab that hides the number, the part left of the value is tinted.
/// @param fraction  of the width, 0 to 1
void beginFilledSlider(Ui& ui, float fraction);
void endFilledSlider();

/// A property's name in the left column; the next item fills the rest of the row.
void beginRow(Ui& ui, const char* label);

/// Around a modal window: padding and round corners.
void pushDialogStyle(Ui& ui);
void popDialogStyle();

/// Once a frame, before all panels: Esc closes the topmost menu or list (ImGui does so only with its own keyboard
/// navigation). @return whether one was closed: then Esc has done its work.
bool closeMenuOnEscape();
/// Esc in this frame, and no menu or list has taken it.
[[nodiscard]] bool escapePressed(const Ui& ui);

/// Two or more words of which one is chosen, in a row that fills the width; notes itself as ID/WORD in lower case.
/// @return the index that was clicked, or -1
int segmented(Ui& ui, const std::string& id, const char* const* words, int count, int chosen, float width);

/// Text with an ellipsis in its middle if it does not fit a width, into a draw list.
void clippedText(ImDrawList& list, const ImVec2& at, float width, ImU32 color, const std::string& text);

}  // namespace sinew::app
