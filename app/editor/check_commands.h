// app/editor/check_commands.h: Play > Check muscles: the list of findings, going to one, mending.
#pragma once

#include "app/editor/editor_state.h"

namespace sinew::app {

/// Looks through all clips and shows what was found.
void checkMuscles(EditorState& state);
void closeCheck(EditorState& state);
/// Whether the rig is still the one that was checked.
[[nodiscard]] bool checkIsCurrent(const EditorState& state);
/// Selects the muscle and goes to the moment. @param finding  index into CheckState::findings
void goToFinding(EditorState& state, int finding);
/// One undo step; then checks again.
void mendFindings(EditorState& state);

}  // namespace sinew::app
