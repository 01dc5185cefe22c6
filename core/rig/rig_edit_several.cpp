// core/rig/rig_edit_several.cpp: several primitives changed in one rig.
#include "core/rig/rig_edit_several.h"

#include <cassert>
#include <utility>

#include "core/geometry/at.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

// The numbers of a rig, read out of it and found among themselves.

RigNumbers drawnNumbers(const Rig& rig) {
  RigNumbers numbers;
  numbers.skinBlend = rig.surface.skinBlend;
  numbers.lines.reserve(rig.lines.size());
  for (const MuscleLine& line : rig.lines) numbers.lines.push_back(line.settings);
  numbers.primitives.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) {
    numbers.primitives.push_back({primitive.placement, primitive.reach, primitive.amount});
  }
  for (const MorphWeight& morph : rig.morphs) numbers.morphs.push_back(morph.weight);
  return numbers;
}

float& numberIn(RigNumbers& numbers, const NumberRef& ref) {
  switch (ownerOf(ref.parameter)) {
    case ParameterOwner::kPrimitive:
      return *numberIn(at(numbers.primitives, ref.owner), ref.parameter);
    case ParameterOwner::kLine:
      return *numberIn(at(numbers.lines, ref.owner), ref.parameter);
    case ParameterOwner::kMorph:
      return at(numbers.morphs, ref.owner);
    case ParameterOwner::kSurface:
      break;
  }
  return numbers.skinBlend;
}

float numberOf(const RigNumbers& numbers, const NumberRef& ref) {
  return numberIn(const_cast<RigNumbers&>(numbers), ref);  // Finding changes nothing.
}

Result<Rig> editPrimitives(Rig rig, std::span<const int> indices, const std::function<void(Primitive&)>& change) {
  for (const int index : indices) {
    assert(index >= 0 && static_cast<std::size_t>(index) < rig.primitives.size());
    Primitive& primitive = at(rig.primitives, index);
    [[maybe_unused]] const std::pair names(primitive.name, primitive.mirror);
    change(primitive);
    assert(names == std::pair(primitive.name, primitive.mirror));
    const std::string place = "primitives[" + std::to_string(index) + ']';
    if (const auto valid = validatePrimitive(primitive, place); !valid) return valid.error();
    if (findGroup(rig, primitive.group) < 0) {
      return errorAt(place + ".group", "there is no group \"" + primitive.group + '"',
                     "muscle \"" + primitive.name + "\", group");
    }
  }
  return rig;
}

Result<Rig> setGroupOfSeveral(Rig rig, std::span<const int> indices, const std::string& group) {
  return editPrimitives(std::move(rig), indices, [&](Primitive& primitive) { primitive.group = group; });
}

Result<Rig> moveToNewGroup(Rig rig, std::span<const int> indices, const std::string& name) {
  Result<Rig> grown = addGroup(std::move(rig), name);
  return grown ? setGroupOfSeveral(std::move(grown).value(), indices, name) : grown;
}

Result<Rig> dissolveGroup(Rig rig, int group, int into) {
  if (group == into) return errorAt("groups", "a group's primitives cannot go to the group that is removed", "groups");
  assert(into >= 0 && static_cast<std::size_t>(into) < rig.groups.size());
  const std::string heir = at(rig.groups, into).name;
  const std::vector<int> members = membersOf(rig, at(rig.groups, group).name);
  Result<Rig> moved = setGroupOfSeveral(std::move(rig), members, heir);
  return moved ? removeGroup(std::move(moved).value(), group) : moved;
}

std::vector<int> membersOf(const Rig& rig, const std::string& group) {
  std::vector<int> members;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (rig.primitives[i].group == group) members.push_back(static_cast<int>(i));
  }
  return members;
}

}  // namespace sinew
