// app/panels/palette_controls.h: the controls of panels and dialogs that the palette finds, and how it shows them.
#pragma once

#include <string>
#include <vector>

#include "app/editor/actions.h"
#include "app/editor/editor_state.h"

namespace sinew::app {

/// A control that the palette finds: a constant beside the code that draws it, which registers itself.
struct Control {
  using Needs = Possible (*)(const EditorState&);

  const char* id;       ///< Its id in WidgetLog, "surface/iso"; the beginning says which panel draws it.
  const char* label;    ///< Also the name of its row, if it has one.
  const char* words;    ///< Other names for it, separated by spaces.
  Needs needs;          ///< When it is drawn; null: whenever its panel is.
  const char* section;  ///< Id of the heading or row that folds it away.

  Control(const char* id, const char* label, const char* words, Needs needs = nullptr, const char* section = "");
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  ~Control() = default;
};
[[nodiscard]] const std::vector<const Control*>& controls();   ///< All, panel by panel.
[[nodiscard]] const char* placeTitle(const Control& control);  ///< Its panel: "Inspector: Muscle", "Preferences"
/// Why it cannot be shown now; "" if it can.
[[nodiscard]] std::string whyNotThere(const Control& control, const EditorState& state);

// Common values of `needs`.
[[nodiscard]] Possible nothing(const EditorState& state);
[[nodiscard]] Possible withCharacter(const EditorState& state);
[[nodiscard]] Possible withMuscle(const EditorState& state);
[[nodiscard]] Possible withSingleMuscle(const EditorState& state);  ///< The active muscle is no sheet.
[[nodiscard]] Possible withSheet(const EditorState& state);         ///< It is one.
[[nodiscard]] Possible withLine(const EditorState& state);
[[nodiscard]] Possible withExport(const EditorState& state);
[[nodiscard]] Possible withFarmJob(const EditorState& state);

/// Opens its panel, scrolls to it, gives it the keyboard focus and highlights it for a moment.
void revealControl(EditorState& state, const Control& control);
/// Shows a part of the mesh in the panel Layers and in the picture. @param part  index into Character::parts
void revealPart(EditorState& state, int part);
/// Shows a muscle of a set in the tab Library; without a muscle the set.
void revealInLibrary(EditorState& state, const SetEntry& entry);

}  // namespace sinew::app
