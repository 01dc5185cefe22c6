// app/panels/field_edit.h: fields whose edits are one undo step, and the keys and drivers of their numbers.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/animate.h"
#include "app/editor/edit.h"
#include "app/panels/panel_ui.h"
#include "app/ui/number_field.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

// Keys and drivers of a field's numbers: colors, tooltip, menu, and edits while driven keys are set.

/// The numbers behind a field.
struct AnimatedField {
  std::vector<NumberRef> refs;  ///< In the document's rig, of one parameter, the shown one first; empty: none.
  std::vector<float> scales;    ///< [refs] shown units per unit of the rig.
  const char* format = "%.3f";  ///< For shown units.
};

/// How keys and drivers change the shown number.
struct AnimatedLook {
  bool driven = false;
  bool keyedHere = false;       ///< In the current clip.
  bool keyedElsewhere = false;  ///< In other clips only.
  bool keyNow = false;          ///< There is a key at the current time.
  bool beingSet = false;        ///< Its driven keys are being set.
  std::string words;            ///< For the tooltip, with a line end; empty: not animated.
};
[[nodiscard]] AnimatedLook lookOf(PanelUi& ui, const AnimatedField& field);

/// Around the field: its background, then its border and the mark of a key.
void pushAnimatedColors(const AnimatedLook& look);
void popAnimatedColors(PanelUi& ui, const AnimatedLook& look);

/// Call right after the item: remembers the number under the pointer for the action edit/key.
void notePointed(PanelUi& ui, const AnimatedField& field);

void animationMenu(PanelUi& ui, const AnimatedField& field);  ///< Rows of an open menu: key, drive, set driven key.

/// Replaces the field while its driven keys are set: an edit adds a point at the current input. The caller sets the
/// width. Notes itself as `id`.
/// @param look  without `typing`
void drawDrivenKeyField(PanelUi& ui, const std::string& id, const AnimatedField& field, NumberLook look);

/// An edit of numbers that share a field: a typed number is assigned to all, a drag makes the same change to all.
struct SharedEdit {
  bool same = false;
  bool fromStart = false;  ///< "+=0.1": relative to the values before the edit.
  float to = 0.0f;         ///< The shown one's; shown units.
};

/// A number of several muscles or lines.
struct SharedNumber {
  float shown = 0.0f;     ///< The active one's.
  bool differ = false;    ///< "mixed" is shown.
  const char* step = "";  ///< Label of the undo step.
};

/// The field of a number that is not being set by driven keys. The caller ends the edit (endFieldEdit).
/// @param change  called if the number is edited; a number out of range is refused there, with the reason
void drawSharedField(PanelUi& ui, const std::string& id, const AnimatedField& field, const AnimatedLook& animation,
                     const SharedNumber& number, NumberLook look, const std::function<void(const SharedEdit&)>& change);

void beginFieldEdit(PanelUi& ui, const std::string& id, const char* label);  ///< The first and last part of editField.
/// @param label  of the step, with its values; "": as it began
void endFieldEdit(PanelUi& ui, const std::string& label = {});
/// Call once a frame, after all panels: ends the step of a field that has vanished while it was edited.
void endAbandonedEdit(EditorState& state);

/// Call right after a field: everything between its activation and its end is one undo step; Esc cancels it.
/// @param edited  as the field returned it
/// @param makeRig  () -> Result<Rig>: called only if edited; errors as in edit()
template <class MakeRig>
void editField(PanelUi& ui, const std::string& id, const char* label, bool edited, MakeRig makeRig) {
  beginFieldEdit(ui, id, label);
  if (edited) edit(ui.state, label, makeRig());
  endFieldEdit(ui);
}

/// The same for a number: reports a refused number; the step names the values, "Tightness 0.3 to 0.4".
/// @param shown  (const Rig&) -> std::string: the number as the field shows it
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
