// app/editor/hidden_bones.h: the helper bones that the editor leaves out of picture, tree and lists.
#pragma once

#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// [bones] Helper bones (core/character/joint_roles.h) while they are not asked for. Those that carry a muscle, are
/// selected, turned by hand or part of the territory that is being edited are never hidden. Empty: none is.
[[nodiscard]] std::vector<bool> hiddenBones(const EditorState& state);
/// @param hidden  of hiddenBones()
[[nodiscard]] bool isHidden(const std::vector<bool>& hidden, int bone);

}  // namespace sinew::app
