// app/panels/animated_field.h: what keys and drivers add to a number's field: its colors, its words, its menu,
// and its edits while driven keys are set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/animate.h"
#include "app/panels/panel_ui.h"
#include "app/ui/number_field.h"

namespace sinew::app {

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

}  // namespace sinew::app
