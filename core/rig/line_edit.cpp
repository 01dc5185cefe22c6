// core/rig/line_edit.cpp: each edit changes the rig that it was given and checks what it changed.
#include "core/rig/line_edit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/animated_edit.h"
#include "core/rig/references.h"
#include "core/rig/refusals.h"
#include "core/rig/validation.h"

namespace sinew {

// A muscle in another bone's space.

namespace {

/// In its own space.
float lengthOf(const Skeleton& skeleton, int bone) { return glm::length(at(skeleton.bones, bone).tip); }

void scaleLengths(std::vector<AnimatedNumber>& animated, float factor) {
  const auto scale = [&](Curve& curve) {
    for (glm::vec2& point : curve.points) point.y *= factor;
  };
  for (AnimatedNumber& number : animated) {
    if (!isLength(number.parameter)) continue;
    for (KeyTrack& track : number.keys) scale(track.curve);
    for (Driver& driver : number.drivers) {
      if (driver.mode != DriverMode::kMultiply) scale(driver.curve);
    }
  }
}

}  // namespace

Placement carryToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld) {
  if (!isFinite(fromInWorld) || !isFinite(toInWorld)) return inFrom;
  const glm::dmat4 from(fromInWorld);
  const glm::dmat4 to(toInWorld);
  if (isFlat(glm::dmat3(from)) || isFlat(glm::dmat3(to))) return inFrom;
  const glm::dmat4 toFromFrom = glm::inverse(to) * from;
  const Placement image = imageOf(inFrom, {glm::dmat3(toFromFrom), glm::dvec3(toFromFrom[3])});
  const bool usable =
      isFinite(image.center) && isFinite(image.radii) && std::min({image.radii.x, image.radii.y, image.radii.z}) > 0.0f;
  return usable ? image : inFrom;
}

Primitive scaleToBone(Primitive primitive, const Skeleton& skeleton, int bone) {
  const std::optional<int> from = skeleton.findBone(primitive.bone);
  const float before = from ? lengthOf(skeleton, *from) : 0.0f;
  const float factor = before > 0.0f ? lengthOf(skeleton, bone) / before : 1.0f;
  if (factor > 0.0f && std::isfinite(factor)) {
    primitive.placement.center *= factor;
    primitive.placement.radii *= factor;
    scaleLengths(primitive.animated, factor);
  }
  primitive.bone = skeleton.fileName(bone);
  primitive.territory.reset();
  return primitive;
}

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
