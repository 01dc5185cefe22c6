// app/editor/library_commands.h: the tab Library: single muscles of sets, and the user's own sets.
#pragma once

#include <glm/vec2.hpp>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Reads the sets for this body if they are not current. Call before showing them.
void readLibrary(EditorState& state);

/// Adds the muscle at its place on this body, with its twin, mended and selected: one undo step.
void layFromLibrary(EditorState& state, int set, int muscle);

/// Drag and drop of a muscle. A drop on the character adds the muscle there, with its twin (core/bodies/muscle_set.h).
/// @param pointer  window coordinates
void takeFromLibrary(EditorState& state, int set, int muscle);
void carryFromLibrary(EditorState& state, const glm::vec2& pointer);
void dropFromLibrary(EditorState& state, const glm::vec2& pointer);
void leaveInLibrary(EditorState& state);

/// Asks for the name of a new set of the selected muscles.
void nameNewSet(EditorState& state);
/// Saves it as LibraryState::name, or sets LibraryState::notice.
void saveNewSet(EditorState& state);
/// @param set  one of the user's own
void removeSetFromLibrary(EditorState& state, int set);

}  // namespace sinew::app
