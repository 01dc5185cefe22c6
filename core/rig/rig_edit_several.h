// core/rig/rig_edit_several.h: changes of several primitives at once, as pure functions rig -> rig.
//
// As in rig_edit.h: a rig is taken by value; indices must be in range (asserted).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Changes each of several primitives; every one must stand up by itself afterwards, and its group must exist. `change`
/// must leave name and mirror alone (asserted). One refusal, and nothing is changed.
[[nodiscard]] Result<Rig> editPrimitives(Rig rig, std::span<const int> indices,
                                         const std::function<void(Primitive&)>& change);

/// Puts several primitives into a group.
[[nodiscard]] Result<Rig> setGroupOfSeveral(Rig rig, std::span<const int> indices, const std::string& group);
/// The same with a group that is made for it.
[[nodiscard]] Result<Rig> moveToNewGroup(Rig rig, std::span<const int> indices, const std::string& name);
/// Removes a group whose primitives go to another one. Error: the two are the same.
[[nodiscard]] Result<Rig> dissolveGroup(Rig rig, int group, int into);

/// Rig indices of a group's primitives, ascending.
[[nodiscard]] std::vector<int> membersOf(const Rig& rig, const std::string& group);

}  // namespace sinew
