// core/rig/rig_edit.cpp: edits primitives, groups, links and settings, and validates what has changed.
#include "core/rig/rig_edit.h"

#include <algorithm>
#include <cassert>
#include <unordered_set>
#include <utility>

#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/references.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

// Finds entries of morph weights by name.

namespace {

constexpr std::size_t kMostMorphs = 1024;

Result<void> validateWeight(float weight, const std::string& place) {
  if (weight >= kLeastMorphWeight && weight <= kMostMorphWeight) return {};
  return outOfRange(place, "a number from -10 to 10", weight, "weight");
}

}  // namespace

std::vector<std::string> morphNames(const Character& character) {
  std::vector<std::string> names;
  std::unordered_set<std::string> known;
  for (const MorphSet& set : character.morphSets) {
    if (known.insert(set.name).second) names.push_back(set.name);
  }
  for (const MorphTarget& target : character.morphTargets) {
    if (known.insert(target.name).second) names.push_back(target.name);
  }
  return names;
}

bool isIdle(const MorphWeight& morph) {
  return morph.weight == 0.0f && morph.animated.empty() && morph.unknownKeys.empty();
}

Rig withMorphsOf(Rig rig, const Character& character, KeepIdle idle) {
  const std::vector<std::string> names = morphNames(character);
  if (std::ranges::equal(rig.morphs, names, {}, &MorphWeight::name)) return rig;
  std::vector<MorphWeight> morphs;
  for (const std::string& name : names) {
    const int index = findMorph(rig, name);
    if (index < 0) morphs.push_back({.name = name, .weight = 0.0f, .animated = {}, .unknownKeys = {}});
    else morphs.push_back(std::exchange(at(rig.morphs, index), {}));
  }
  for (MorphWeight& other : rig.morphs) {
    const bool stays = idle == KeepIdle::kYes || !isIdle(other);
    if (!other.name.empty() && stays) morphs.push_back(std::move(other));
  }
  rig.morphs = std::move(morphs);
  return rig;
}

Result<Rig> setMorphWeight(Rig rig, const std::string& name, float weight) {
  int index = findMorph(rig, name);
  if (index < 0) {
    index = static_cast<int>(rig.morphs.size());
    rig.morphs.push_back({.name = name, .weight = 0.0f, .animated = {}, .unknownKeys = {}});
  }
  const std::string place = indexed("shapes", static_cast<std::size_t>(index));
  if (auto valid = validateWeight(weight, place + ".weight"); !valid)
    return about(quoted("shape", name), valid.error());
  at(rig.morphs, index).weight = weight;
  return rig;
}

Rig withoutMorphWeights(Rig rig) {
  for (MorphWeight& morph : rig.morphs) morph.weight = 0.0f;
  return rig;
}

Result<void> validateMorphs(const Rig& rig) {
  const auto used = rig.morphs.size() - static_cast<std::size_t>(std::ranges::count_if(rig.morphs, isIdle));
  if (auto count = validateCount("shapes", "shapes", used, kMostMorphs); !count) return count;
  std::unordered_set<std::string> known;
  for (std::size_t i = 0; i < rig.morphs.size(); ++i) {
    const MorphWeight& morph = rig.morphs[i];
    const std::string place = indexed("shapes", i);
    const std::string subject = quoted("shape", morph.name);
    if (auto name = validateName(morph.name, place + ".name"); !name) return about("a shape", name.error());
    if (!known.insert(morph.name).second) {
      return errorAt(place + ".name", "expected each shape once, but \"" + morph.name + "\" is there twice", subject);
    }
    if (auto weight = validateWeight(morph.weight, place + ".weight"); !weight) return about(subject, weight.error());
    if (auto animated = validateAnimated(morph.animated, ParameterOwner::kMorph, place); !animated) {
      return about(subject, animated.error());
    }
  }
  return {};
}

RigNumbers drawnNumbers(const Rig& rig) {
  RigNumbers numbers;
  numbers.skinBlend = rig.surface.skinBlend;
  numbers.grooves = rig.surface.grooves;
  numbers.lines.reserve(rig.lines.size());
  for (const MuscleLine& line : rig.lines) numbers.lines.push_back(line.settings);
  numbers.primitives.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) {
    numbers.primitives.push_back({primitive.placement, primitive.reach, primitive.amount});
  }
  for (const MorphWeight& morph : rig.morphs) numbers.morphs.push_back(morph.weight);
  for (const Link& link : rig.links) numbers.links.push_back(link.amount);
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
    case ParameterOwner::kLink:
      return at(numbers.links, ref.owner);
    case ParameterOwner::kSurface:
      break;
  }
  return ref.parameter == Parameter::kGrooves ? numbers.grooves : numbers.skinBlend;
}

float numberOf(const RigNumbers& numbers, const NumberRef& ref) {
  return numberIn(const_cast<RigNumbers&>(numbers), ref);  // Only reads.
}

namespace {

std::string placeOf(int index) { return indexed("primitives", static_cast<std::size_t>(index)); }

Result<void> checkGroup(const Rig& rig, const Primitive& primitive, int index) {
  if (findGroup(rig, primitive.group) >= 0) return {};
  return errorAt(placeOf(index) + ".group", "there is no group \"" + primitive.group + '"',
                 quoted("muscle", primitive.name) + ", group");
}

}  // namespace

namespace {

/// Group and sign of an edited belly hold for its whole sheet.
void giveToSheet(Rig& rig, const Primitive& belly) {
  const int found = findSheet(rig, belly.sheet);
  if (found < 0) return;
  MuscleSheet& sheet = at(rig.sheets, found);
  if (sheet.group == belly.group && sheet.sign == belly.sign) return;
  sheet.group = belly.group;
  sheet.sign = belly.sign;
  for (Primitive& other : rig.primitives) {
    if (other.sheet != sheet.name) continue;
    other.group = sheet.group;
    other.sign = sheet.sign;
  }
}

/// Marks all bellies of sheets of which some are marked, and removes the sheets.
void takeSheets(Rig& rig, std::vector<bool>& leaves) {
  std::unordered_set<std::string> sheets;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (leaves[i] && !rig.primitives[i].sheet.empty()) sheets.insert(rig.primitives[i].sheet);
  }
  if (sheets.empty()) return;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (sheets.contains(rig.primitives[i].sheet)) leaves[i] = true;
  }
  std::erase_if(rig.sheets, [&](const MuscleSheet& sheet) { return sheets.contains(sheet.name); });
  for (MuscleSheet& sheet : rig.sheets) {
    if (sheets.contains(sheet.mirror)) sheet.mirror.clear();
  }
}

}  // namespace

Result<Rig> editPrimitives(Rig rig, std::span<const int> indices, const std::function<void(Primitive&)>& change) {
  for (const int index : indices) {
    assert(index >= 0 && static_cast<std::size_t>(index) < rig.primitives.size());
    Primitive& primitive = at(rig.primitives, index);
    [[maybe_unused]] const std::pair names(primitive.name, primitive.mirror);
    change(primitive);
    assert(names == std::pair(primitive.name, primitive.mirror));
    if (const auto valid = validatePrimitive(primitive, placeOf(index)); !valid) return valid.error();
    if (const auto group = checkGroup(rig, primitive, index); !group) return group.error();
    giveToSheet(rig, Primitive(primitive));
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

namespace {

const Primitive& primitiveAt(const Rig& rig, int index) {
  assert(index >= 0 && static_cast<std::size_t>(index) < rig.primitives.size());
  return at(rig.primitives, index);
}

Primitive& primitiveAt(Rig& rig, int index) { return const_cast<Primitive&>(primitiveAt(std::as_const(rig), index)); }

const Group& groupAt(const Rig& rig, int index) {
  assert(index >= 0 && static_cast<std::size_t>(index) < rig.groups.size());
  return at(rig.groups, index);
}

/// Changes one primitive, which must be valid by itself afterwards.
template <class Change>
Result<Rig> withPrimitive(Rig rig, int index, Change change) {
  Primitive& edited = primitiveAt(rig, index);
  change(edited);
  if (const auto valid = validatePrimitive(edited, placeOf(index)); !valid) return valid.error();
  return rig;
}

Error nameTaken(std::string place, const std::string& name) {
  return errorAt(std::move(place), "the name \"" + name + "\" is taken", "name");
}

/// Unlinks primitives whose twin is one of `gone`.
void dropTwins(Rig& rig, const std::unordered_set<std::string>& gone) {
  for (Primitive& primitive : rig.primitives) {
    if (gone.contains(primitive.mirror)) primitive.mirror.clear();
  }
}

void pairUp(Rig& rig, int index, int twin) {
  dropTwins(rig, {primitiveAt(rig, index).name, primitiveAt(rig, twin).name});
  primitiveAt(rig, index).mirror = primitiveAt(rig, twin).name;
  primitiveAt(rig, twin).mirror = primitiveAt(rig, index).name;
}

}  // namespace

Result<void> append(Rig& rig, Primitive primitive) {
  if (rig.primitives.size() >= static_cast<std::size_t>(kMaxPrimitives)) {
    return errorAt("primitives", "a rig holds at most " + std::to_string(kMaxPrimitives) + " primitives", "the rig");
  }
  const bool makesGroup = primitive.group.empty() && rig.groups.empty();
  if (primitive.group.empty()) primitive.group = makesGroup ? "muscles" : rig.groups.front().name;
  primitive.name = freePrimitiveName(rig, primitive.name.empty() ? "muscle" : primitive.name);
  const int index = static_cast<int>(rig.primitives.size());
  if (const auto valid = validatePrimitive(primitive, placeOf(index)); !valid) return valid.error();
  if (!makesGroup) {
    if (auto group = checkGroup(rig, primitive, index); !group) return group;
  }
  if (!primitive.line.empty() && findLine(rig, primitive.line) < 0) {
    return errorAt(placeOf(index) + ".line", "there is no muscle line \"" + primitive.line + '"',
                   quoted("muscle", primitive.name) + ", line");
  }
  const int twin = primitive.mirror.empty() ? -1 : findPrimitive(rig, primitive.mirror);
  if (!primitive.mirror.empty() && twin < 0) {
    return errorAt(placeOf(index) + ".mirror", "there is no primitive \"" + primitive.mirror + '"',
                   quoted("muscle", primitive.name) + ", twin");
  }
  if (makesGroup) rig.groups.push_back({primitive.group, {}});
  rig.primitives.push_back(std::move(primitive));
  if (twin >= 0) pairUp(rig, index, twin);
  return {};
}

Result<Rig> addPrimitive(Rig rig, Primitive primitive) {
  if (const auto added = append(rig, std::move(primitive)); !added) return added.error();
  return rig;
}

Rig removePrimitives(Rig rig, std::span<const int> indices) {
  std::vector<bool> leaves(rig.primitives.size(), false);
  for (const int index : indices) {
    assert(index >= 0 && static_cast<std::size_t>(index) < leaves.size());
    at(leaves, index) = true;
  }
  takeSheets(rig, leaves);
  std::unordered_set<std::string> gone;
  std::unordered_set<std::string> lines;
  std::vector<Primitive> kept;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    Primitive& primitive = rig.primitives[i];
    if (leaves[i]) {
      gone.insert(primitive.name);
      lines.insert(primitive.line);
    } else {
      kept.push_back(std::move(primitive));
    }
  }
  rig.primitives = std::move(kept);
  dropTwins(rig, gone);
  return withoutIdleLines(std::move(rig), std::move(lines));
}

Result<Rig> setPlacement(Rig rig, int index, const Placement& placement) {
  return withPrimitive(std::move(rig), index, [&](Primitive& primitive) { primitive.placement = placement; });
}

Result<Rig> renamePrimitive(Rig rig, int index, const std::string& name) {
  const std::string former = primitiveAt(rig, index).name;
  if (const int owner = findPrimitive(rig, name); owner >= 0 && owner != index) {
    return nameTaken(placeOf(index) + ".name", name);
  }
  auto result = withPrimitive(std::move(rig), index, [&](Primitive& primitive) { primitive.name = name; });
  if (result) renameReferences(result.value(), Named::kPrimitive, former, name);
  return result;
}

Rig setMirror(Rig rig, int index, int twin) {
  assert(index != twin);
  pairUp(rig, index, twin);
  return rig;
}

Rig clearMirror(Rig rig, int index) {
  if (const int sheet = findSheet(rig, primitiveAt(rig, index).sheet); sheet >= 0) {
    for (MuscleSheet& other : rig.sheets) {
      if (other.mirror == at(rig.sheets, sheet).name) other.mirror.clear();
    }
    at(rig.sheets, sheet).mirror.clear();
  }
  dropTwins(rig, {primitiveAt(rig, index).name});
  primitiveAt(rig, index).mirror.clear();
  return rig;
}

Result<Rig> addGroup(Rig rig, const std::string& name) {
  const std::string place = "groups[" + std::to_string(rig.groups.size()) + "].name";
  if (const auto valid = validateName(name, place); !valid) return valid.error();
  if (findGroup(rig, name) >= 0) return nameTaken(place, name);
  rig.groups.push_back({name, {}});
  // A group without links is a clique of its own, so even adding groups can give too many cliques.
  if (const auto valid = validateLinks(rig); !valid) return valid.error();
  return rig;
}

Result<Rig> renameGroup(Rig rig, int group, const std::string& name) {
  const std::string former = groupAt(rig, group).name;
  const std::string place = "groups[" + std::to_string(group) + "].name";
  if (const auto valid = validateName(name, place); !valid) return valid.error();
  if (const int owner = findGroup(rig, name); owner >= 0 && owner != group) return nameTaken(place, name);
  at(rig.groups, group).name = name;
  renameReferences(rig, Named::kGroup, former, name);
  return rig;
}

Result<Rig> removeGroup(Rig rig, int group) {
  const std::string name = groupAt(rig, group).name;
  const auto members = std::ranges::count(rig.primitives, name, &Primitive::group);
  if (members > 0) {
    return errorAt("groups[" + std::to_string(group) + ']',
                   "the group \"" + name + "\" still has " + std::to_string(members) +
                       (members == 1 ? " primitive" : " primitives"),
                   "groups");
  }
  if (const auto sheet = std::ranges::find(rig.sheets, name, &MuscleSheet::group); sheet != rig.sheets.end()) {
    return errorAt("groups[" + std::to_string(group) + ']',
                   "the group \"" + name + "\" still has the sheet \"" + sheet->name + '"', "groups");
  }
  rig.groups.erase(rig.groups.begin() + group);
  std::erase_if(rig.links, [&](const Link& link) { return std::ranges::find(link.groups, name) != link.groups.end(); });
  return rig;
}

Result<Rig> setLink(Rig rig, int groupA, int groupB, float amount) {
  const std::string& a = groupAt(rig, groupA).name;
  const std::string& b = groupAt(rig, groupB).name;
  if (groupA == groupB)
    return errorAt("links", "a group cannot be linked to itself; its primitives always blend", "link");
  if (!(amount >= 0.0f && amount <= 1.0f)) {
    return errorAt("links", "expected an amount from 0 to 1, got " + numberText(amount), "link");
  }
  if (linkAmount(rig, a, b) == amount) return rig;
  const auto joins = [&](const Link& link) { return link.joins(a, b); };
  const auto first = std::ranges::find_if(rig.links, joins);
  if (first == rig.links.end()) {
    rig.links.push_back({{a, b}, amount});
  } else {
    first->amount = amount;
    rig.links.erase(std::remove_if(first + (amount > 0.0f ? 1 : 0), rig.links.end(), joins), rig.links.end());
  }
  // Also after removing a link, which may increase the number of cliques.
  if (const auto valid = validateLinks(rig); !valid) return valid.error();
  return rig;
}

Result<Rig> setSurface(Rig rig, const SurfaceSettings& surface) {
  if (const auto valid = validateSurface(surface); !valid) return valid.error();
  rig.surface = surface;
  return rig;
}

Result<Rig> setSmoothing(Rig rig, const SmoothingSettings& smoothing) {
  if (const auto valid = validateSmoothing(smoothing); !valid) return valid.error();
  rig.smoothing = smoothing;
  return rig;
}

}  // namespace sinew
