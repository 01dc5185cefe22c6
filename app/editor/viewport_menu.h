// app/editor/viewport_menu.h: what the picture's context menu does that no other menu does.
#pragma once

#include <string>
#include <string_view>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// What a right click was made on becomes what the menu's actions work on: a muscle that is not selected is selected
/// alone, a bone too; on nothing the selection stays.
void selectForMenu(Document& document, const ViewportHover& target);

/// Only this muscle, or only this bone.
void selectEntry(Document& document, const PickEntry& entry);

/// A muscle on the skin where the menu was asked for, as a click of the add-muscle tool makes one, in the pose of this
/// frame. One undo step. Without skin there: nothing.
void addMuscleAt(EditorState& state, const ViewportHover& target);

/// Why an action of the menu is gray; "" while it is not, or where nothing better than its hint can be said.
[[nodiscard]] std::string whyDisabled(const EditorState& state, std::string_view actionId);

}  // namespace sinew::app
