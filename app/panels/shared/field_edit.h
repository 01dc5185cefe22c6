// app/panels/shared/field_edit.h: a number or text field whose edits are one undo step.
#pragma once

#include <string>

#include "app/editor/edit.h"
#include "app/panels/shared/panel_ui.h"
#include "sinew/base/result.h"

namespace sinew::app {

/// Right after a field: makes one undo step of everything between its activation and its end; Esc cancels it.
/// @param edited  what the field returned.
/// @param makeRig  () -> Result<Rig>: called only when edited; refusals as in edit().
template <class MakeRig>
void editField(PanelUi& ui, const std::string& id, const char* label, bool edited, MakeRig makeRig);

/// The parts of editField that know no types.
void beginFieldEdit(PanelUi& ui, const std::string& id, const char* label);
void endFieldEdit(PanelUi& ui);
/// Once a frame, after all panels: ends the step of a field that has vanished while it was being edited.
void endAbandonedEdit(EditorState& state);

template <class MakeRig>
void editField(PanelUi& ui, const std::string& id, const char* label, bool edited, MakeRig makeRig) {
  beginFieldEdit(ui, id, label);
  if (edited) edit(ui.state, label, makeRig());
  endFieldEdit(ui);
}

}  // namespace sinew::app
