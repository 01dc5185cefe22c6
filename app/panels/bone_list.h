// app/panels/bone_list.h: a list of bones to choose from: near ones first, the rest by typing.
#pragma once

#include <functional>
#include <string>

#include "app/panels/panel_ui.h"

namespace sinew::app {

/// Inside a list that has just been opened: bones to choose from, the nearest in the tree first; typing leaves those
/// that have the text in their names, Enter takes the first. Rows note themselves as ID/NAME. @param near  -1: in the
/// tree's order; @param chosen  marked, or -1
/// @param drawOthers  what else the list offers, under the search @return the bone that was taken, or -1
[[nodiscard]] int boneList(PanelUi& ui, const std::string& id, int near, int chosen,
                           const std::function<bool(int)>& isOffered, const std::function<void()>& drawOthers = {});

}  // namespace sinew::app
