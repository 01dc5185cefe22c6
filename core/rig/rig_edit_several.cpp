// core/rig/rig_edit_several.cpp: several primitives changed in one copy of the rig.
#include "core/rig/rig_edit_several.h"

#include <cassert>
#include <utility>

#include "core/base/at.h"
#include "core/rig/rig_edit.h"
#include "core/rig/validation.h"

namespace sinew {

Result<Rig> editPrimitives(const Rig& rig, std::span<const int> indices,
                           const std::function<void(Primitive&)>& change) {
  Rig result = rig;
  for (const int index : indices) {
    assert(index >= 0 && static_cast<std::size_t>(index) < rig.primitives.size());
    Primitive& primitive = at(result.primitives, index);
    change(primitive);
    assert(primitive.name == at(rig.primitives, index).name);
    assert(primitive.mirror == at(rig.primitives, index).mirror);
    const std::string place = "primitives[" + std::to_string(index) + ']';
    if (const auto valid = validatePrimitive(primitive, place); !valid) return valid.error();
    if (findGroup(rig, primitive.group) < 0) {
      return errorAt(place + ".group", "there is no group \"" + primitive.group + '"',
                     "muscle \"" + primitive.name + "\", group");
    }
  }
  return result;
}

Result<Rig> setGroupOfSeveral(const Rig& rig, std::span<const int> indices, const std::string& group) {
  return editPrimitives(rig, indices, [&](Primitive& primitive) { primitive.group = group; });
}

Result<Rig> moveToNewGroup(const Rig& rig, std::span<const int> indices, const std::string& name) {
  const Result<Rig> grown = addGroup(rig, name);
  return grown ? setGroupOfSeveral(grown.value(), indices, name) : grown;
}

Result<Rig> dissolveGroup(const Rig& rig, int group, int into) {
  if (group == into) return errorAt("groups", "a group's primitives cannot go to the group that is removed", "groups");
  assert(into >= 0 && static_cast<std::size_t>(into) < rig.groups.size());
  const std::string heir = at(rig.groups, into).name;
  const std::vector<int> members = membersOf(rig, at(rig.groups, group).name);
  const Result<Rig> moved = setGroupOfSeveral(rig, members, heir);
  return moved ? removeGroup(moved.value(), group) : moved;
}

std::vector<int> membersOf(const Rig& rig, const std::string& group) {
  std::vector<int> members;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (rig.primitives[i].group == group) members.push_back(static_cast<int>(i));
  }
  return members;
}

}  // namespace sinew
