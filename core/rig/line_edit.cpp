// core/rig/line_edit.cpp: each edit changes the rig that it was given and checks what it changed.
#include "core/rig/line_edit.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/geometry/at.h"
#include "core/rig/animated_edit.h"
#include "core/rig/references.h"
#include "core/rig/refusals.h"
#include "core/rig/validation.h"

namespace sinew {
namespace {

std::string placeOfLine(int line) { return indexed("lines", static_cast<std::size_t>(line)); }

/// Whoever names `gone` as its twin has none any more.
void dropTwin(Rig& rig, const std::string& gone) {
  for (MuscleLine& line : rig.lines) {
    if (line.mirror == gone) line.mirror.clear();
  }
}

void pairUpLines(Rig& rig, int line, int twin) {
  MuscleLine& a = at(rig.lines, line);
  MuscleLine& b = at(rig.lines, twin);
  dropTwin(rig, a.name);
  dropTwin(rig, b.name);
  a.mirror = b.name;
  b.mirror = a.name;
}

}  // namespace

Result<void> append(Rig& rig, MuscleLine line) {
  const auto index = static_cast<int>(rig.lines.size());
  line.name = freeLineName(rig, line.name.empty() ? "line" : line.name);
  const int twin = line.mirror.empty() ? -1 : findLine(rig, line.mirror);
  line.mirror.clear();
  if (const auto valid = validateLine(line, placeOfLine(index)); !valid) return valid.error();
  rig.lines.push_back(std::move(line));
  if (twin >= 0) pairUpLines(rig, index, twin);
  return {};
}

Result<Rig> addLine(Rig rig, MuscleLine line) {
  if (const auto added = append(rig, std::move(line)); !added) return added.error();
  return rig;
}

Result<Rig> editLine(Rig rig, int line, const std::function<void(MuscleLine&)>& change) {
  MuscleLine& edited = at(rig.lines, line);
  [[maybe_unused]] const std::pair names(edited.name, edited.mirror);
  change(edited);
  assert(names == std::pair(edited.name, edited.mirror));
  if (const auto valid = validateLine(edited, placeOfLine(line)); !valid) return valid.error();
  return rig;
}

Result<Rig> renameLine(Rig rig, int line, const std::string& name) {
  if (const auto valid = validateName(name, placeOfLine(line) + ".name"); !valid) return valid.error();
  if (const int owner = findLine(rig, name); owner >= 0 && owner != line) {
    return errorAt(placeOfLine(line) + ".name", "the name \"" + name + "\" is taken", "name");
  }
  const std::string former = std::exchange(at(rig.lines, line).name, name);
  renameReferences(rig, Named::kLine, former, name);
  return rig;
}

Rig setLineOfSeveral(Rig rig, std::span<const int> primitives, int line) {
  std::unordered_set<std::string> left;
  for (const int index : primitives) {
    left.insert(std::exchange(at(rig.primitives, index).line, line < 0 ? "" : at(rig.lines, line).name));
  }
  return withoutIdleLines(std::move(rig), std::move(left));
}

Rig setLineMirror(Rig rig, int line, int twin) {
  assert(line != twin);
  pairUpLines(rig, line, twin);
  return rig;
}

Rig withoutIdleLines(Rig rig, std::unordered_set<std::string> lines) {
  for (const Primitive& primitive : rig.primitives) lines.erase(primitive.line);
  lines.erase("");
  if (lines.empty()) return rig;
  std::erase_if(rig.lines, [&](const MuscleLine& line) { return lines.contains(line.name); });
  for (const std::string& gone : lines) dropTwin(rig, gone);
  dropLineInputs(rig, lines);
  return rig;
}

std::vector<int> primitivesOn(const Rig& rig, const std::string& line) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (rig.primitives[i].line == line) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

}  // namespace sinew
