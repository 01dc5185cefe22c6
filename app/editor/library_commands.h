// app/editor/library_commands.h: the tab Library: muscles of sets laid one at a time, and own sets.
#pragma once

#include <glm/vec2.hpp>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Sets and pictures for this body; nothing where they are as they should be. Called before they are shown.
void readLibrary(EditorState& state);

/// Where it belongs on this body, with its twin: one undo step, mended, selected.
void layFromLibrary(EditorState& state, int set, int muscle);

/// The pointer has taken a muscle, moves with it, lets it go. What is let go over the character is laid there, with its
/// twin (core/bodies/muscle_set.h).  @param pointer  window coordinates
void takeFromLibrary(EditorState& state, int set, int muscle);
void carryFromLibrary(EditorState& state, const glm::vec2& pointer);
void dropFromLibrary(EditorState& state, const glm::vec2& pointer);
void leaveInLibrary(EditorState& state);

/// Asks for the name of a set of the selected muscles, in the tab.
void nameNewSet(EditorState& state);
/// Saves them under LibraryState::name; its notice says why not.
void saveNewSet(EditorState& state);
/// One of the user's own.
void removeSetFromLibrary(EditorState& state, int set);

}  // namespace sinew::app
