// core/rig/line_edit.cpp: each edit copies the rig, changes the copy, checks what it changed.
#include "core/rig/line_edit.h"

#include <algorithm>
#include <cassert>
#include <unordered_set>
#include <utility>

#include "core/base/at.h"
#include "core/rig/animated_edit.h"
#include "core/rig/refusals.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

std::string placeOf(int line) { return indexed("lines", static_cast<std::size_t>(line)); }

/// Whoever names `gone` as its twin has none any more.
void dropTwin(Rig& rig, const std::string& gone) {
  for (MuscleLine& line : rig.lines) {
    if (line.mirror == gone) line.mirror.clear();
  }
}

}  // namespace

Result<Rig> addLine(const Rig& rig, MuscleLine line) {
  const auto index = static_cast<int>(rig.lines.size());
  line.name = freeLineName(rig, line.name.empty() ? "line" : line.name);
  const int twin = line.mirror.empty() ? -1 : findLine(rig, line.mirror);
  line.mirror.clear();
  if (const auto valid = validateLine(line, placeOf(index)); !valid) return valid.error();
  Rig result = rig;
  result.lines.push_back(std::move(line));
  return twin < 0 ? result : setLineMirror(result, index, twin);
}

Result<Rig> editLine(const Rig& rig, int line, const std::function<void(MuscleLine&)>& change) {
  MuscleLine edited = at(rig.lines, line);
  change(edited);
  assert(edited.name == at(rig.lines, line).name && edited.mirror == at(rig.lines, line).mirror);
  if (const auto valid = validateLine(edited, placeOf(line)); !valid) return valid.error();
  Rig result = rig;
  at(result.lines, line) = std::move(edited);
  return result;
}

Result<Rig> renameLine(const Rig& rig, int line, const std::string& name) {
  const std::string former = at(rig.lines, line).name;
  if (const auto valid = validateName(name, placeOf(line) + ".name"); !valid) return valid.error();
  if (const int owner = findLine(rig, name); owner >= 0 && owner != line) {
    return errorAt(placeOf(line) + ".name", "the name \"" + name + "\" is taken", "name");
  }
  Rig result = rig;
  at(result.lines, line).name = name;
  for (MuscleLine& other : result.lines) {
    if (other.mirror == former) other.mirror = name;
  }
  for (Primitive& primitive : result.primitives) {
    if (primitive.line == former) primitive.line = name;
  }
  renameLineInputs(result, former, name);
  return result;
}

Rig removeLine(const Rig& rig, int line) {
  const std::string name = at(rig.lines, line).name;
  Rig result = rig;
  result.lines.erase(result.lines.begin() + line);
  dropTwin(result, name);
  for (Primitive& primitive : result.primitives) {
    if (primitive.line == name) primitive.line.clear();
  }
  dropLineInputs(result, {name});
  return result;
}

Rig setLineOfSeveral(const Rig& rig, std::span<const int> primitives, int line) {
  Rig result = rig;
  for (const int index : primitives) {
    at(result.primitives, index).line = line < 0 ? std::string() : at(rig.lines, line).name;
  }
  return withoutIdleLines(rig, std::move(result));
}

Rig setLineMirror(const Rig& rig, int line, int twin) {
  assert(line != twin);
  Rig result = rig;
  MuscleLine& a = at(result.lines, line);
  MuscleLine& b = at(result.lines, twin);
  dropTwin(result, a.name);
  dropTwin(result, b.name);
  a.mirror = b.name;
  b.mirror = a.name;
  return result;
}

Rig withoutIdleLines(const Rig& before, Rig edited) {
  std::unordered_set<std::string> busy;
  for (const Primitive& primitive : edited.primitives) busy.insert(primitive.line);
  std::unordered_set<std::string> idle;
  for (const Primitive& primitive : before.primitives) {
    if (!primitive.line.empty() && !busy.contains(primitive.line)) idle.insert(primitive.line);
  }
  if (idle.empty()) return edited;
  std::erase_if(edited.lines, [&](const MuscleLine& line) { return idle.contains(line.name); });
  for (const std::string& gone : idle) dropTwin(edited, gone);
  dropLineInputs(edited, idle);
  return edited;
}

std::vector<int> primitivesOn(const Rig& rig, const std::string& line) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (rig.primitives[i].line == line) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace sinew
