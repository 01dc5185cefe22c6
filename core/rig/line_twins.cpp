// core/rig/line_twins.cpp: images of lines, made and kept.
#include "core/rig/line_twins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/character/side_names.h"
#include "core/geometry/at.h"
#include "core/rig/animated_twins.h"
#include "core/rig/line_edit.h"
#include "core/rig/twins.h"

namespace sinew {
namespace {

constexpr float kOwnImage = 1e-4f;  // Fraction of H.

bool anchorInPlane(const MirrorPlan& plan, const LineAnchor& anchor, float tolerance) {
  const std::optional<int> bone = plan.skeleton.findBone(anchor.bone);
  if (!bone || at(plan.twinOf, *bone) != *bone) return false;
  const glm::dmat4 bind(at(plan.skeleton.bones, *bone).bindInWorld);
  const double off = distanceTo(plan.plane, glm::dvec3(bind * glm::dvec4(glm::dvec3(anchor.point), 1.0)));
  return std::abs(off) <= static_cast<double>(tolerance * plan.characterHeight);
}

/// The side of the line's middle.
bool isLeft(const MirrorPlan& plan, const MuscleLine& line) {
  Primitive there;
  there.bone = line.origin.bone;
  there.placement.center = line.origin.point;
  return sideOf(plan, there) == Side::kLeft;
}

bool sameShape(const MuscleLine& a, const MuscleLine& b) {
  return a.origin == b.origin && a.insertion == b.insertion && a.via == b.via && a.settings == b.settings &&
         a.animated == b.animated;
}

const MuscleLine* named(const Rig& rig, const std::string& name) {
  const int index = findLine(rig, name);
  return index < 0 ? nullptr : &at(rig.lines, index);
}

void follow(const Rig& rig, const MuscleLine& leader, MuscleLine& follower, const MirrorPlan& plan) {
  const Result<MuscleLine> image = mirroredLine(plan, leader);
  follower.settings = leader.settings;
  follower.animated = mirroredAnimation(plan, leader);
  readTwinLines(rig, follower.animated);
  if (!image) return;
  follower.origin = image->origin;
  follower.insertion = image->insertion;
  follower.via = image->via;
}

/// Whether the second of a pair leads: it changed, and the first did not, or not since the gesture began.
bool secondLeads(const Rig& atStart, const Rig& shown, const MuscleLine& first, const MuscleLine& second) {
  const auto changed = [](const Rig& since, const MuscleLine& now) {
    const MuscleLine* then = named(since, now.name);
    return then && !sameShape(*then, now);
  };
  if (changed(shown, first) != changed(shown, second)) return changed(shown, second);
  return changed(shown, first) && !changed(atStart, first) && changed(atStart, second);
}

}  // namespace

Result<LineAnchor> mirroredAnchor(const MirrorPlan& plan, const LineAnchor& anchor) {
  Result<std::string> bone = twinBone(plan, anchor.bone);
  if (!bone) return bone.error();
  const AffineMap& map = *at(plan.mirrors, *plan.skeleton.findBone(anchor.bone));
  return LineAnchor{std::move(bone).value(), glm::vec3(map.linear * glm::dvec3(anchor.point) + map.offset),
                    anchor.unknownKeys};
}

Result<MuscleLine> mirroredLine(const MirrorPlan& plan, const MuscleLine& line) {
  Result<LineAnchor> origin = mirroredAnchor(plan, line.origin);
  if (!origin) return origin.error();
  Result<LineAnchor> insertion = mirroredAnchor(plan, line.insertion);
  if (!insertion) return insertion.error();
  MuscleLine image = line;
  image.mirror.clear();
  image.identity = {};
  image.animated = mirroredAnimation(plan, line);
  image.name = imageName(plan, line.name, line.origin.bone);
  image.origin = std::move(origin).value();
  image.insertion = std::move(insertion).value();
  if (line.via) {
    Result<LineAnchor> via = mirroredAnchor(plan, *line.via);
    if (!via) return via.error();
    image.via = std::move(via).value();
  }
  return image;
}

bool liesInPlane(const MirrorPlan& plan, const MuscleLine& line, float tolerance) {
  return anchorInPlane(plan, line.origin, tolerance) && anchorInPlane(plan, line.insertion, tolerance) &&
         (!line.via || anchorInPlane(plan, *line.via, tolerance));
}

Result<TwinLine> withTwinLine(Rig rig, std::string name, const MirrorPlan& plan) {
  const int index = name.empty() ? -1 : findLine(rig, name);
  if (index < 0) return TwinLine{std::move(rig), {}};
  const MuscleLine& line = at(rig.lines, index);
  if (!line.mirror.empty()) name = line.mirror;
  if (!line.mirror.empty() || liesInPlane(plan, line, kOwnImage)) return TwinLine{std::move(rig), std::move(name)};
  Result<MuscleLine> image = mirroredLine(plan, line);
  if (!image) return about("muscle line \"" + name + '"', image.error());
  if (image->name == name) {
    const std::string own = freeLineName(rig, name + (isLeft(plan, line) ? " L" : " R"));
    Result<Rig> renamed = renameLine(std::move(rig), index, own);
    if (!renamed) return renamed.error();
    rig = std::move(renamed).value();
    image.value().name = mirroredName(own).value_or(own);
  }
  image.value().mirror = at(rig.lines, index).name;
  readTwinLines(rig, image.value().animated);
  if (const auto added = append(rig, std::move(image).value()); !added) return added.error();
  std::string twin = rig.lines.back().name;
  return TwinLine{std::move(rig), std::move(twin)};
}

Rig withTwinOnLine(Rig rig, int primitive, const MirrorPlan& plan) {
  const int twin = twinOf(rig, primitive);
  const std::string& line = at(rig.primitives, primitive).line;
  if (twin < 0 || line.empty()) return rig;
  Result<TwinLine> image = withTwinLine(rig, line, plan);
  if (!image) return rig;
  Rig& lined = image.value().rig;
  const int twinLine = findLine(lined, image->name);
  return setLineOfSeveral(std::move(lined), std::array{twin}, twinLine);
}

std::string twinLineName(const Rig& rig, const std::string& line) {
  const MuscleLine* own = line.empty() ? nullptr : named(rig, line);
  return own && !own->mirror.empty() ? own->mirror : line;
}

void keepLineTwins(const Rig& atStart, const Rig& shown, Rig& edited, const MirrorPlan& plan) {
  for (std::size_t i = 0; i < edited.lines.size(); ++i) {
    MuscleLine& first = edited.lines[i];
    const int twin = first.mirror.empty() ? -1 : findLine(edited, first.mirror);
    if (twin < 0 || static_cast<std::size_t>(twin) <= i) continue;
    MuscleLine& second = at(edited.lines, twin);
    const MuscleLine* firstThen = named(shown, first.name);
    const MuscleLine* secondThen = named(shown, second.name);
    // New links and new lines are left alone, as are pairs that nobody touched.
    if (!firstThen || !secondThen || firstThen->mirror != second.name) continue;
    if (sameShape(*firstThen, first) && sameShape(*secondThen, second)) continue;
    if (secondLeads(atStart, shown, first, second)) {
      follow(edited, second, first, plan);
    } else {
      follow(edited, first, second, plan);
    }
  }
}

}  // namespace sinew
