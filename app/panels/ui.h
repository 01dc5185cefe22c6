#pragma once  // app/panels/ui.h: what every panel is handed, and the few controls they share.

#include <string>

#include "app/panels/actions.h"
#include "app/panels/editor_state.h"
#include "app/panels/icons.h"
#include "app/panels/widget_log.h"
#include "app/platform/fonts.h"
#include "app/platform/style.h"
#include "core/base/result.h"

namespace sinew::app {

/// References for the length of a frame.
struct Ui {
  EditorState& state;
  WidgetLog& widgets;
  const Fonts& fonts;

  [[nodiscard]] float px(float design) const {
    return design * state.uiScale;
  }  ///< Design pixels -> window coordinates.
};

/// Small capitals would be too much; a strong line with room above.
void heading(Ui& ui, const char* text);
void mutedText(const char* text);
/// Shown while the last item is hovered.
void tooltip(Ui& ui, const std::string& text);
/// Label, key (in the user's keymap) and hint of an action.
[[nodiscard]] std::string tooltipOf(const Ui& ui, const Action& action);

/// Square button with a picture; lit when active. Notes itself as `id`.
bool iconButton(Ui& ui, const std::string& id, Icon icon, bool active, float size);
/// The same for an action, with its tooltip; disabled when the action is.
void actionButton(Ui& ui, const std::string& id, const Action& action, Icon icon, float size);
/// Small pill that is lit when the action is checked.
void actionPill(Ui& ui, const std::string& id, const Action& action);

/// Around a slider: instead of a grab that hides the number, the part left of the value is tinted.
/// @param fraction  of the width, 0 to 1
void beginFilledSlider(Ui& ui, float fraction);
void endFilledSlider();

/// A property's name in the left column; the next item fills the rest of the row.
void beginRow(Ui& ui, const char* label);

/// Around a modal window: room and round corners.
void pushDialogStyle(Ui& ui);
void popDialogStyle();

/// Once a frame, before all panels: Esc closes the topmost menu or list (ImGui does so only with its own keyboard
/// navigation). @return whether one was closed: then Esc has done its work.
bool closeMenuOnEscape();
/// Esc in this frame, and no menu or list has taken it.
[[nodiscard]] bool escapePressed(const Ui& ui);

/// Right after a field: makes one undo step of everything between its activation and its end; Esc takes it back.
/// @param edited  what the field returned.
/// @param makeRig  () -> Result<Rig>: called only when edited; a refusal is shown in the status line.
template <class MakeRig>
void editField(Ui& ui, const std::string& id, const char* label, bool edited, MakeRig makeRig);

/// The parts of editField that know no types.
void beginFieldEdit(Ui& ui, const std::string& id, const char* label);
void applyFieldEdit(Ui& ui, const char* label, const Result<Rig>& rig);
void endFieldEdit(Ui& ui);
/// Once a frame, after all panels: ends the step of a field that has vanished while it was being edited.
void endAbandonedEdit(EditorState& state);

template <class MakeRig>
void editField(Ui& ui, const std::string& id, const char* label, bool edited, MakeRig makeRig) {
  beginFieldEdit(ui, id, label);
  if (edited) applyFieldEdit(ui, label, makeRig());
  endFieldEdit(ui);
}

}  // namespace sinew::app
