// app/editor/sheet_commands.h: edits of the selected sheets.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

[[nodiscard]] std::string namedSheets(const Rig& rig, const std::vector<int>& sheets);  ///< "pectoral L", or "3 sheets"

/// Changes all sheets, or none on a refusal. @param sheets  indices  @param change  must keep name and mirror
[[nodiscard]] Result<Rig> editSheets(Rig rig, const std::vector<int>& sheets,
                                     const std::function<void(MuscleSheet&)>& change);

void setOnLines(EditorState& state,
                bool on);  ///< One undo step: a line for each strip of the selected sheets, or none.
/// One undo step. @return whether there is such a point
bool removeProfilePoint(EditorState& state, const std::string& sheet, bool along, int point);
void breakSelection(EditorState& state);  ///< One undo step: bellies of selected sheets become muscles.

}  // namespace sinew::app
