// app/panels/palette_controls.h: the controls of panels and dialogs that the palette finds, and the way to
// each.
#pragma once

#include <span>
#include <string>

#include "app/editor/actions.h"
#include "app/editor/editor_state.h"

namespace sinew::app {

/// A control that the palette finds. Each is a constant beside the code that draws it, and registers itself.
struct Control {
  using Needs = Possible (*)(const EditorState&);

  const char* id;       ///< As WidgetLog knows it; its beginning says where the control stands: "surface/iso".
  const char* label;    ///< As the name of its row, if it has one.
  const char* words;    ///< What else one may call it, apart by spaces.
  Needs needs;          ///< What it takes to be there; null: what all take that stand there.
  const char* section;  ///< Id of the heading that it is folded under.

  Control(const char* id, const char* label, const char* words, Needs needs = nullptr, const char* section = "");
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  ~Control() = default;
};
/// All, place by place.
[[nodiscard]] const std::vector<const Control*>& controls();
/// Where it stands: "Inspector: Muscle", "Preferences"
[[nodiscard]] const char* placeTitle(const Control& control);
/// Why it is not there now; empty: it is, or revealing it brings it up.
[[nodiscard]] std::string whyNotThere(const Control& control, const EditorState& state);

// What controls need.
[[nodiscard]] Possible nothing(const EditorState& state);
[[nodiscard]] Possible withCharacter(const EditorState& state);
[[nodiscard]] Possible withMuscle(const EditorState& state);
[[nodiscard]] Possible withLine(const EditorState& state);

/// Opens what the control stands in, brings it into sight, gives it the keyboard and marks it for a moment.
void revealControl(EditorState& state, const Control& control);
/// A part of the mesh: its row in the panel Layers, and its mark in the picture. @param part  index into
/// Character::parts
void revealPart(EditorState& state, int part);
/// A muscle of a set in the tab Library; without a muscle the set.
void revealInLibrary(EditorState& state, const SetEntry& entry);

}  // namespace sinew::app
