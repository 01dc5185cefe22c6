// app/viewport/tools/territory_tool.h: the territory mode: clicks on bones say whose skin the active muscle may move.
#pragma once

#include "app/document/document.h"

namespace sinew::app {

/// Rig index of the muscle whose territory is edited: the active one, if its bone is there; else -1.
[[nodiscard]] int territorySubject(const Document& document);

/// Names every bone of the muscle's territory, one more or one less. Bones that this character lacks stay in it. Error:
/// it would be the last one.
[[nodiscard]] Result<Rig> withTerritoryBone(const Rig& rig, int index, int bone, const Skeleton& skeleton);

/// The same for the document's active muscle, as one undo step. Error: refused, nothing has changed.
Result<void> toggleTerritoryBone(Document& document, int bone);

}  // namespace sinew::app
