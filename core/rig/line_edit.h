// core/rig/line_edit.h: changes of muscle lines, as pure functions rig -> rig.
//
// As in rig_edit.h: a rig is taken by value; indices must be in range (asserted).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Appends; the name is made unique. If `mirror` names a line of the rig, the two become each other's twins.
[[nodiscard]] Result<Rig> addLine(Rig rig, MuscleLine line);
/// The same in place. Error: the rig is as it was.
[[nodiscard]] Result<void> append(Rig& rig, MuscleLine line);
/// `change` must leave name and mirror alone (asserted).
[[nodiscard]] Result<Rig> editLine(Rig rig, int line, const std::function<void(MuscleLine&)>& change);
[[nodiscard]] Result<Rig> renameLine(Rig rig, int line, const std::string& name);
/// Puts primitives on a line, or with -1 on their bones alone. Lines that lose their last primitive go.
[[nodiscard]] Rig setLineOfSeveral(Rig rig, std::span<const int> primitives, int line);
/// Makes two different lines each other's twins; former twins are unlinked.
[[nodiscard]] Rig setLineMirror(Rig rig, int line, int twin);

/// Without those of `lines` that carry no primitive.
[[nodiscard]] Rig withoutIdleLines(Rig rig, std::unordered_set<std::string> lines);

/// Rig indices of the primitives on a line, ascending.
[[nodiscard]] std::vector<int> primitivesOn(const Rig& rig, const std::string& line);

}  // namespace sinew
