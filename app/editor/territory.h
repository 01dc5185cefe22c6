// app/editor/territory.h: which bones' skin a muscle may move: the mode, the edits, the tint.
#pragma once

#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

/// Clicks on bones, in the picture and in the outliner, change the active muscle's territory.
[[nodiscard]] bool editsTerritory(const EditorState& state);
void toggleTerritoryMode(EditorState& state);
void endTerritoryMode(ViewportTools& tools);

/// Back to the default: the muscle's bone, the one above it and those below.
[[nodiscard]] Result<Rig> withDefaultTerritory(const Rig& rig, const std::vector<int>& indices);

/// One undo step; a refusal is said as refuse() does.
void toggleTerritoryBone(EditorState& state, int bone);

/// [bones of the territory], ascending; of the mode's muscle. Empty if the mode is off.
[[nodiscard]] std::vector<int> shownTerritory(const EditorState& state);
/// [V] 0..1, how much of the muscle each control vertex takes; empty if the mode is off.
[[nodiscard]] std::vector<float> shownTerritoryWeights(const EditorState& state);

}  // namespace sinew::app
