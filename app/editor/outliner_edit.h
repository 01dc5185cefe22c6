// app/editor/outliner_edit.h: what the outliner does to rig and selection.
#pragma once

#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "app/editor/outliner_rows.h"

namespace sinew::app {

inline constexpr const char* kMusclePayload = "sinew.muscles";  ///< Drag and drop: the grabbed muscle's rig index, int.

/// Moves muscles to another bone; each keeps its place in the world at the moment that is shown. One undo step;
/// a refusal is said as refuse() does.
void reparentMuscles(EditorState& state, const std::vector<int>& indices, int bone);

/// A click on a muscle's row. @param range  Shift: all from the anchor to here; @param toggle  Ctrl.
void clickMuscle(EditorState& state, const std::vector<OutlinerRow>& rows, int position, bool range, bool toggle);
/// A click on a bone's row: selects it, or in territory mode lets it join or leave.
void clickBone(EditorState& state, int bone);
/// Up and down among the rows. @param extend  Shift: muscles on the way are added.
void moveCursor(EditorState& state, const std::vector<OutlinerRow>& rows, int by, bool extend);

void selectMuscles(Document& document, const std::vector<int>& indices);
/// Closes or opens a bone's row. @param all  those below it too
void setFolded(EditorState& state, int bone, bool folded, bool all);
/// Opens what hides a muscle's row.
void unfoldTo(EditorState& state, int bone);
/// The same in the flat lists. @param muscle  rig index
void unfoldParts(EditorState& state, int muscle);
/// Closes or opens a part of a flat list.
void setPartFolded(EditorState& state, const std::string& part, bool folded);

}  // namespace sinew::app
