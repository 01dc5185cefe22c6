// app/panels/field_edit.h: a number or text field whose edits are one undo step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/animate.h"
#include "app/editor/edit.h"
#include "app/panels/panel_ui.h"
#include "app/ui/number_field.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// What keys and drivers add to a number's field: its colors, its words, its menu,
// and its edits while driven keys are set.

/// The numbers behind a field.
struct AnimatedField {
  std::vector<NumberRef> refs;  ///< Into the document's rig, of one parameter, the shown one first; empty: none.
  std::vector<float> scales;    ///< [refs] shown units per unit of the rig.
  const char* format = "%.3f";  ///< For shown units.
};

/// What keys and drivers do to the shown number.
struct AnimatedLook {
  bool driven = false;
  bool keyedHere = false;       ///< In the clip that shows.
  bool keyedElsewhere = false;  ///< In other clips alone.
  bool keyNow = false;          ///< A key stands at this moment.
  bool beingSet = false;        ///< Set driven key is on for it.
  std::string words;            ///< For the tooltip, with a line end; empty: nothing animates it.
};
[[nodiscard]] AnimatedLook lookOf(PanelUi& ui, const AnimatedField& field);

/// Around the field: its ground, then its edge and the mark of a key.
void pushAnimatedColors(const AnimatedLook& look);
void popAnimatedColors(PanelUi& ui, const AnimatedLook& look);

/// Right after the item: remembers the number under the pointer, for the key that keys it.
void notePointed(PanelUi& ui, const AnimatedField& field);

/// Rows of a menu that is open: key, drive, set driven key.
void animationMenu(PanelUi& ui, const AnimatedField& field);

/// In the place of the field while driven keys are set: edits are points at where the input is now. The width is the
/// caller's. Notes itself as `id`.
/// @param look  without `typing`
void drawDrivenKeyField(PanelUi& ui, const std::string& id, const AnimatedField& field, NumberLook look);

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
