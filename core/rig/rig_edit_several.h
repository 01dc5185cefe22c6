// core/rig/rig_edit_several.h: changes of several primitives at once, as pure functions rig -> rig.
//
// As in rig_edit.h: the rig that is given stays as it is; indices must be in range (asserted).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Changes each of several primitives; every one must stand up by itself afterwards, and its group must exist. `change`
/// must leave name and mirror alone (asserted). One refusal, and nothing is changed.
[[nodiscard]] Result<Rig> editPrimitives(const Rig& rig, std::span<const int> indices,
                                         const std::function<void(Primitive&)>& change);

/// Puts several primitives into a group.
[[nodiscard]] Result<Rig> setGroupOfSeveral(const Rig& rig, std::span<const int> indices, const std::string& group);
/// The same with a group that is made for it.
[[nodiscard]] Result<Rig> moveToNewGroup(const Rig& rig, std::span<const int> indices, const std::string& name);
/// Removes a group whose primitives go to another one. Error: the two are the same.
[[nodiscard]] Result<Rig> dissolveGroup(const Rig& rig, int group, int into);

/// Rig indices of a group's primitives, ascending.
[[nodiscard]] std::vector<int> membersOf(const Rig& rig, const std::string& group);

}  // namespace sinew
