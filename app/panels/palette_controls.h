// app/panels/palette_controls.h: the controls of panels and dialogs that the palette finds, and the way to
// each.
#pragma once

#include <span>
#include <string>

#include "app/editor/editor_state.h"
#include "app/editor/possible.h"

namespace sinew::app {

/// Where a control stands: what has to be open for it to be there.
enum class Shelf {
  kMuscles,
  kGroups,
  kLibrary,
  kShapes,
  kHistory,
  kMuscle,
  kMuscleShape,
  kSurface,
  kSmoothing,
  kLayers,
  kTimeline,
  kPicture,
  kPreferences,
  kKeys,
  kExport,
  kFarm,
};

struct PaletteControl {
  const char* id;  ///< As WidgetLog knows it.
  const char* label;
  const char* words;  ///< What else one may call it, apart by spaces.
  Shelf shelf = Shelf::kMuscle;
  const char* section = "";  ///< Id of the heading that it is folded under.
  Possible (*enabled)(const EditorState&) = nullptr;
};
[[nodiscard]] std::span<const PaletteControl> paletteControls();
/// "Inspector: Muscle", "Preferences"
[[nodiscard]] const char* titleOf(Shelf shelf);
/// Why it is not there now; empty: it is, or revealing it brings it up.
[[nodiscard]] std::string whyNotThere(const PaletteControl& control, const EditorState& state);

/// Opens what the control stands in, brings it into sight, gives it the keyboard and marks it for a moment.
void revealControl(EditorState& state, const PaletteControl& control);
/// A part of the mesh: its row in the panel Layers, and its mark in the picture. @param part  index into
/// Character::parts
void revealPart(EditorState& state, int part);
/// A muscle of a set in the tab Library; without a muscle the set.
void revealInLibrary(EditorState& state, const SetEntry& entry);

}  // namespace sinew::app
