// app/panels/field_edit.h: a number or text field whose edits are one undo step.
#pragma once

#include <string>

#include "app/editor/edit.h"
#include "app/panels/panel_ui.h"
#include "app/ui/number_field.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// Right after a field: makes one undo step of everything between its activation and its end; Esc cancels it.
/// @param edited  what the field returned.
/// @param makeRig  () -> Result<Rig>: called only when edited; refusals as in edit().
template <class MakeRig>
void editField(PanelUi& ui, const std::string& id, const char* label, bool edited, MakeRig makeRig);

/// The same for a number: what was typed and refused is said, and the step names the values, "Tightness 0.3 to 0.4".
/// @param shown  (const Rig&) -> std::string: the number as the field shows it.
template <class MakeRig, class Shown>
void editNumber(PanelUi& ui, const std::string& id, const char* label, bool edited, const Typing& typing,
                MakeRig makeRig, Shown shown);

/// The parts of editField that know no types.
void beginFieldEdit(PanelUi& ui, const std::string& id, const char* label);
/// @param label  of the step, if its values are to be named; "": as it began.
void endFieldEdit(PanelUi& ui, const std::string& label = {});
/// Once a frame, after all panels: ends the step of a field that has vanished while it was being edited.
void endAbandonedEdit(EditorState& state);

template <class MakeRig>
void editField(PanelUi& ui, const std::string& id, const char* label, bool edited, MakeRig makeRig) {
  beginFieldEdit(ui, id, label);
  if (edited) edit(ui.state, label, makeRig());
  endFieldEdit(ui);
}

template <class MakeRig, class Shown>
void editNumber(PanelUi& ui, const std::string& id, const char* label, bool edited, const Typing& typing,
                MakeRig makeRig, Shown shown) {
  beginFieldEdit(ui, id, label);
  if (edited) edit(ui.state, label, makeRig());
  if (!typing.refusal.empty()) refuse(ui.state, errorAt({}, typing.refusal));
  const CommandStack& commands = ui.state.document.commands;
  endFieldEdit(ui, std::string(label) + " " + shown(commands.rigOfStep()) + " to " + shown(commands.rig()));
}

}  // namespace sinew::app
