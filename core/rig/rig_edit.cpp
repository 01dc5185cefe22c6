// core/rig/rig_edit.cpp: each edit copies the rig, changes the copy, checks what it changed.
#include "core/rig/rig_edit.h"

#include <algorithm>
#include <cassert>
#include <unordered_set>
#include <utility>

#include "core/base/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/validation.h"

namespace sinew {
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

std::string placeOf(int index) { return "primitives[" + std::to_string(index) + ']'; }

/// A copy of the rig with one primitive changed by `change`, if that primitive stands up by itself.
template <class Change>
Result<Rig> withPrimitive(const Rig& rig, int index, Change change) {
  Primitive edited = primitiveAt(rig, index);
  change(edited);
  if (const auto valid = validatePrimitive(edited, placeOf(index)); !valid) return valid.error();
  Rig result = rig;
  primitiveAt(result, index) = std::move(edited);
  return result;
}

Error nameTaken(std::string place, const std::string& name) {
  return errorAt(std::move(place), "the name \"" + name + "\" is taken", "name");
}

/// Whoever names one of `gone` as its twin has none any more.
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

bool joins(const std::array<std::string, 2>& link, const std::string& a, const std::string& b) {
  return (link[0] == a && link[1] == b) || (link[0] == b && link[1] == a);
}

std::vector<bool> marked(const Rig& rig, std::span<const int> indices) {
  std::vector<bool> marks(rig.primitives.size(), false);
  for (const int index : indices) {
    assert(index >= 0 && static_cast<std::size_t>(index) < marks.size());
    at(marks, index) = true;
  }
  return marks;
}

}  // namespace

Result<Rig> addPrimitive(const Rig& rig, Primitive primitive) {
  if (rig.primitives.size() >= static_cast<std::size_t>(kMaxPrimitives)) {
    return errorAt("primitives", "a rig holds at most " + std::to_string(kMaxPrimitives) + " primitives", "the rig");
  }
  Rig result = rig;
  if (primitive.group.empty()) {
    if (result.groups.empty()) result.groups.push_back({"muscles", {}});
    primitive.group = result.groups.front().name;
  }
  primitive.name = freePrimitiveName(rig, primitive.name.empty() ? "muscle" : primitive.name);
  const int index = static_cast<int>(rig.primitives.size());
  if (const auto valid = validatePrimitive(primitive, placeOf(index)); !valid) return valid.error();
  if (findGroup(result, primitive.group) < 0) {
    return errorAt(placeOf(index) + ".group", "there is no group \"" + primitive.group + '"',
                   "muscle \"" + primitive.name + "\", group");
  }
  if (!primitive.line.empty() && findLine(rig, primitive.line) < 0) {
    return errorAt(placeOf(index) + ".line", "there is no muscle line \"" + primitive.line + '"',
                   "muscle \"" + primitive.name + "\", line");
  }
  const int twin = primitive.mirror.empty() ? -1 : findPrimitive(rig, primitive.mirror);
  if (!primitive.mirror.empty() && twin < 0) {
    return errorAt(placeOf(index) + ".mirror", "there is no primitive \"" + primitive.mirror + '"',
                   "muscle \"" + primitive.name + "\", twin");
  }
  result.primitives.push_back(std::move(primitive));
  if (twin >= 0) pairUp(result, index, twin);
  return result;
}

Rig removePrimitives(const Rig& rig, std::span<const int> indices) {
  const std::vector<bool> leaves = marked(rig, indices);
  std::unordered_set<std::string> gone;
  Rig result = rig;
  result.primitives.clear();
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (leaves[i]) {
      gone.insert(rig.primitives[i].name);
    } else {
      result.primitives.push_back(rig.primitives[i]);
    }
  }
  dropTwins(result, gone);
  return withoutIdleLines(rig, std::move(result));
}

Result<Rig> setPlacement(const Rig& rig, int index, const Placement& placement) {
  return withPrimitive(rig, index, [&](Primitive& primitive) { primitive.placement = placement; });
}

Result<Rig> renamePrimitive(const Rig& rig, int index, const std::string& name) {
  const std::string former = primitiveAt(rig, index).name;
  if (const int owner = findPrimitive(rig, name); owner >= 0 && owner != index) {
    return nameTaken(placeOf(index) + ".name", name);
  }
  auto result = withPrimitive(rig, index, [&](Primitive& primitive) { primitive.name = name; });
  if (!result) return result;
  for (Primitive& other : result.value().primitives) {
    if (other.mirror == former) other.mirror = name;
  }
  return result;
}

Rig setMirror(const Rig& rig, int index, int twin) {
  assert(index != twin);
  Rig result = rig;
  pairUp(result, index, twin);
  return result;
}

Rig clearMirror(const Rig& rig, int index) {
  Rig result = rig;
  dropTwins(result, {primitiveAt(rig, index).name});
  primitiveAt(result, index).mirror.clear();
  return result;
}

Result<Rig> addGroup(const Rig& rig, const std::string& name) {
  const std::string place = "groups[" + std::to_string(rig.groups.size()) + "].name";
  if (const auto valid = validateName(name, place); !valid) return valid.error();
  if (findGroup(rig, name) >= 0) return nameTaken(place, name);
  Rig result = rig;
  result.groups.push_back({name, {}});
  // A group without links is a clique of its own, so that many groups alone can be too many cliques.
  if (const auto valid = validateLinks(result); !valid) return valid.error();
  return result;
}

Result<Rig> renameGroup(const Rig& rig, int group, const std::string& name) {
  const std::string former = groupAt(rig, group).name;
  const std::string place = "groups[" + std::to_string(group) + "].name";
  if (const auto valid = validateName(name, place); !valid) return valid.error();
  if (const int owner = findGroup(rig, name); owner >= 0 && owner != group) return nameTaken(place, name);
  Rig result = rig;
  at(result.groups, group).name = name;
  for (auto& link : result.links) std::ranges::replace(link, former, name);
  for (Primitive& primitive : result.primitives) {
    if (primitive.group == former) primitive.group = name;
  }
  return result;
}

Result<Rig> removeGroup(const Rig& rig, int group) {
  const std::string name = groupAt(rig, group).name;
  const auto members = std::ranges::count(rig.primitives, name, &Primitive::group);
  if (members > 0) {
    return errorAt("groups[" + std::to_string(group) + ']',
                   "the group \"" + name + "\" still has " + std::to_string(members) +
                       (members == 1 ? " primitive" : " primitives"),
                   "groups");
  }
  Rig result = rig;
  result.groups.erase(result.groups.begin() + group);
  std::erase_if(result.links, [&](const auto& link) { return link[0] == name || link[1] == name; });
  return result;
}

Result<Rig> setLink(const Rig& rig, int groupA, int groupB, bool linked) {
  const std::string& a = groupAt(rig, groupA).name;
  const std::string& b = groupAt(rig, groupB).name;
  if (groupA == groupB)
    return errorAt("links", "a group cannot be linked to itself; its primitives always blend", "link");
  const bool already = std::ranges::any_of(rig.links, [&](const auto& link) { return joins(link, a, b); });
  if (already == linked) return rig;
  Rig result = rig;
  if (linked) {
    result.links.push_back({a, b});
  } else {
    std::erase_if(result.links, [&](const auto& link) { return joins(link, a, b); });
  }
  // Both ways: what a link held together may fall into more cliques than it was.
  if (const auto valid = validateLinks(result); !valid) return valid.error();
  return result;
}

Result<Rig> setSurface(const Rig& rig, const SurfaceSettings& surface) {
  if (const auto valid = validateSurface(surface); !valid) return valid.error();
  Rig result = rig;
  result.surface = surface;
  return result;
}

Result<Rig> setSmoothing(const Rig& rig, const SmoothingSettings& smoothing) {
  if (const auto valid = validateSmoothing(smoothing); !valid) return valid.error();
  Rig result = rig;
  result.smoothing = smoothing;
  return result;
}

}  // namespace sinew
