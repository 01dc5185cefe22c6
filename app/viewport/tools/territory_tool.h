// app/viewport/tools/territory_tool.h: territory mode: clicks on bones choose the skin that the active muscle may move.
#pragma once

#include "app/document/document.h"

namespace sinew::app {

/// Rig index of the active muscle if this character has its bone, else -1.
[[nodiscard]] int territorySubject(const Document& document);

/// Adds or removes a bone, naming all of the territory; bones that the character lacks stay. Error: it is the last.
[[nodiscard]] Result<Rig> withTerritoryBone(const Rig& rig, int index, int bone, const Skeleton& skeleton);

/// The same for the active muscle, as one undo step. Error: nothing has changed.
Result<void> toggleTerritoryBone(Document& document, int bone);

}  // namespace sinew::app
