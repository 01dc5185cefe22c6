// core/rig/twins.cpp: mirrors animation and lines; makes, links and keeps twins.
#include "core/rig/twins.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "core/character/bone_names.h"
#include "core/character/pose_override.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/motion_clip.h"
#include "core/rig/references.h"
#include "core/rig/sheet_edit.h"
#include "core/rig/validation.h"
#include "sinew/rig/mirror_edit.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

Result<LineAnchor> mirroredAnchor(const MirrorPlan& plan, const LineAnchor& anchor) {
  Result<std::string> bone = twinBone(plan, anchor.bone);
  if (!bone) return bone.error();
  const AffineMap& map = *at(plan.mirrors, *plan.skeleton.findBone(anchor.bone));
  return LineAnchor{std::move(bone).value(), glm::vec3(map.linear * glm::dvec3(anchor.point) + map.offset),
                    anchor.unknownKeys};
}

namespace {

/// value of the image = factor * value + offset.
struct NumberMap {
  Parameter parameter = Parameter::kAmount;
  float factor = 1.0f;
  float offset = 0.0f;
};

constexpr float kStray = 1e-3f;  // Largest fraction of a step along one axis that appears on another.

bool mirrorBone(const MirrorPlan& plan, std::string& bone) {
  Result<std::string> twin = twinBone(plan, bone);
  if (!twin) return false;
  bone = std::move(twin).value();
  return true;
}

bool mirrorAnchor(const MirrorPlan& plan, LineAnchor& anchor) {
  Result<LineAnchor> image = mirroredAnchor(plan, anchor);
  if (!image) return false;
  anchor = std::move(image).value();
  return true;
}

glm::quat mirroredTurn(const MirrorPlan& plan, const glm::quat& turn, int bone) {
  const int twin = at(plan.twinOf, bone);
  return sinew::mirroredTurn(turn, at(plan.skeleton.bones, bone), at(plan.skeleton.bones, twin),
                             glm::vec3(plan.plane.normal));
}

/// The curve of -x.
void reverse(Curve& curve) {
  std::vector<glm::vec2>& points = curve.points;
  for (glm::vec2& point : points) point.x = -point.x;
  std::ranges::reverse(points);
  if (curve.kind != CurveKind::kStep) return;
  // The value of a step holds after its point, and of the reversed curve before it.
  for (std::size_t i = points.size() - 1; i > 0; --i) points[i].x = points[i - 1].x;
  points.front().x -= std::max(1.0f, 1e-3f * std::abs(points.front().x));
}

float stepFor(const Primitive& primitive, Parameter parameter) {
  const glm::vec3& radii = primitive.placement.radii;
  const float size = std::min({radii.x, radii.y, radii.z});
  return isLength(parameter) ? 0.125f * size : 0.03125f;
}

constexpr int kFirst = static_cast<int>(Parameter::kCenterX);
constexpr int kLast = static_cast<int>(shapeParameter(kShapeNumbers - 1));

/// Finds how a number of a primitive changes its image by a small step: exactly one number of the image may change.
std::optional<NumberMap> mapOf(const MirrorPlan& plan, const Primitive& primitive, Parameter parameter) {
  if (parameter == Parameter::kAmount || parameter == Parameter::kReach) return NumberMap{parameter, 1.0f, 0.0f};
  const std::optional<int> bone = plan.skeleton.findBone(primitive.bone);
  if (!bone || at(plan.twinOf, *bone) < 0) return std::nullopt;
  const AffineMap& map = *at(plan.mirrors, *bone);
  Primitive before = primitive;
  before.placement = imageOf(primitive.placement, map);
  Primitive stepped = primitive;
  const float step = stepFor(primitive, parameter);
  *numberIn(stepped, parameter) += step;
  stepped.placement = imageOf(stepped.placement, map);

  std::optional<NumberMap> found;
  float most = 0.0f;
  for (int i = kFirst; i <= kLast; ++i) {
    const auto other = static_cast<Parameter>(i);
    const float moved = numberOf(stepped, other) - numberOf(before, other);
    if (std::abs(moved) <= most) continue;
    most = std::abs(moved);
    found = NumberMap{other, moved / step, 0.0f};
  }
  if (!found) return std::nullopt;
  for (int i = kFirst; i <= kLast; ++i) {
    const auto other = static_cast<Parameter>(i);
    if (other == found->parameter) continue;
    if (std::abs(numberOf(stepped, other) - numberOf(before, other)) > kStray * most) return std::nullopt;
  }
  // Rounds inexact factors 1 and -1.
  const float rounded = std::round(found->factor);
  if (std::abs(found->factor - rounded) < kStray) found->factor = rounded;
  found->offset = numberOf(before, found->parameter) - found->factor * numberOf(primitive, parameter);
  if (std::abs(found->offset) < kStray * step) found->offset = 0.0f;
  return found;
}

void mapValues(Curve& curve, float factor, float offset) {
  for (glm::vec2& point : curve.points) point.y = factor * point.y + offset;
}

/// False: a multiplying driver has no counterpart.
bool mapDriver(const NumberMap& map, Driver& driver) {
  switch (driver.mode) {
    case DriverMode::kAdd:
      mapValues(driver.curve, map.factor, 0.0f);
      return true;
    case DriverMode::kReplace:
      mapValues(driver.curve, map.factor, map.offset);
      return true;
    case DriverMode::kMultiply:
      break;
  }
  return map.offset == 0.0f;
}

std::optional<AnimatedNumber> mirrored(const MirrorPlan& plan, const AnimatedNumber& number, const NumberMap& map) {
  AnimatedNumber image = number;
  image.parameter = map.parameter;
  for (KeyTrack& track : image.keys) mapValues(track.curve, map.factor, map.offset);
  image.drivers.clear();
  for (const Driver& driver : number.drivers) {
    std::optional<Driver> twin = mirroredDriver(plan, driver);
    if (twin && mapDriver(map, *twin)) image.drivers.push_back(std::move(*twin));
  }
  if (image.keys.empty() && image.drivers.empty()) return std::nullopt;
  return image;
}

}  // namespace

std::optional<Driver> mirroredDriver(const MirrorPlan& plan, const Driver& driver) {
  Driver image = driver;
  DriverInput& input = image.input;
  switch (input.kind) {
    case DriverInputKind::kLength:
    case DriverInputKind::kChannel:
      return image;
    case DriverInputKind::kDistance:
      return mirrorAnchor(plan, input.from) && mirrorAnchor(plan, input.to) ? std::optional(image) : std::nullopt;
    default:
      break;
  }
  const std::optional<int> bone = plan.skeleton.findBone(driver.input.bone);
  if (!mirrorBone(plan, input.bone)) return std::nullopt;
  if (input.kind == DriverInputKind::kTwist) reverse(image.curve);
  if (input.kind == DriverInputKind::kPose) input.rotation = mirroredTurn(plan, driver.input.rotation, *bone);
  if (input.kind == DriverInputKind::kAxis) {
    // The image of a half turn about the axis.
    const glm::vec3& axis = driver.input.axis;
    const glm::quat turn = mirroredTurn(plan, glm::quat(0.0f, axis.x, axis.y, axis.z), *bone);
    input.axis = glm::vec3(turn.x, turn.y, turn.z);
  }
  return image;
}

std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const Primitive& primitive) {
  std::vector<AnimatedNumber> images;
  for (const AnimatedNumber& number : primitive.animated) {
    const std::optional<NumberMap> map = mapOf(plan, primitive, number.parameter);
    if (!map) continue;
    if (std::optional<AnimatedNumber> image = mirrored(plan, number, *map)) images.push_back(std::move(*image));
  }
  return images;
}

namespace {

/// Of numbers that are the same on the other side.
std::vector<AnimatedNumber> mirroredInputs(const MirrorPlan& plan, const std::vector<AnimatedNumber>& animated) {
  std::vector<AnimatedNumber> images;
  for (const AnimatedNumber& number : animated) {
    const NumberMap same{number.parameter, 1.0f, 0.0f};
    if (std::optional<AnimatedNumber> image = mirrored(plan, number, same)) images.push_back(std::move(*image));
  }
  return images;
}

}  // namespace

std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const MuscleLine& line) {
  return mirroredInputs(plan, line.animated);
}

std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const Link& link) {
  return mirroredInputs(plan, link.animated);
}

namespace {

constexpr float kOwnImage = 1e-4f;  // Fraction of H.

bool anchorInPlane(const MirrorPlan& plan, const LineAnchor& anchor, float tolerance) {
  const std::optional<int> bone = plan.skeleton.findBone(anchor.bone);
  if (!bone || at(plan.twinOf, *bone) != *bone) return false;
  const glm::dmat4 bind(at(plan.skeleton.bones, *bone).bindInWorld);
  const double off = distanceTo(plan.plane, glm::dvec3(bind * glm::dvec4(glm::dvec3(anchor.point), 1.0)));
  return std::abs(off) <= static_cast<double>(tolerance * plan.characterHeight);
}

/// The side of the line's origin.
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

/// The name of a line's twin, or of the line itself if it has none.
std::string twinLineName(const Rig& rig, const std::string& line) {
  const MuscleLine* own = line.empty() ? nullptr : named(rig, line);
  return own && !own->mirror.empty() ? own->mirror : line;
}

/// Makes drivers read the lengths of twin lines.
void readTwinLines(const Rig& rig, std::vector<AnimatedNumber>& animated) {
  for (AnimatedNumber& number : animated) {
    for (Driver& driver : number.drivers) {
      if (driver.input.kind == DriverInputKind::kLength) driver.input.line = twinLineName(rig, driver.input.line);
    }
  }
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

/// The second of a pair leads: it changed, and the first did not, or not since the gesture began.
bool secondLeads(const Rig& atStart, const Rig& shown, const MuscleLine& first, const MuscleLine& second) {
  const auto changed = [](const Rig& since, const MuscleLine& now) {
    const MuscleLine* then = named(since, now.name);
    return then && !sameShape(*then, now);
  };
  if (changed(shown, first) != changed(shown, second)) return changed(shown, second);
  return changed(shown, first) && !changed(atStart, first) && changed(atStart, second);
}

struct TwinLine {
  Rig rig;
  std::string name;  ///< Empty: none.
};

/// Finds the twin of a line, or makes and links it; the line itself if it lies in the plane. If the name has no side,
/// both get one. Error: see mirroredLine.
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

}  // namespace

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

namespace {

/// keepTwins() for lines: copies mirrored anchors and settings of the edited one to the other.
void keepLineTwins(const Rig& atStart, const Rig& shown, Rig& edited, const MirrorPlan& plan) {
  for (std::size_t i = 0; i < edited.lines.size(); ++i) {
    MuscleLine& first = edited.lines[i];
    const int twin = first.mirror.empty() ? -1 : findLine(edited, first.mirror);
    if (twin < 0 || static_cast<std::size_t>(twin) <= i) continue;
    MuscleLine& second = at(edited.lines, twin);
    const MuscleLine* firstThen = named(shown, first.name);
    const MuscleLine* secondThen = named(shown, second.name);
    // Ignores new links, new lines and unchanged pairs.
    if (!firstThen || !secondThen || firstThen->mirror != second.name) continue;
    if (sameShape(*firstThen, first) && sameShape(*secondThen, second)) continue;
    const bool swapped = secondLeads(atStart, shown, first, second);
    follow(edited, swapped ? second : first, swapped ? first : second, plan);
  }
}

using Index = std::unordered_map<std::string_view, const Primitive*>;

Index byName(const Rig& rig) {
  Index index;
  index.reserve(rig.primitives.size());
  for (const Primitive& primitive : rig.primitives) index.emplace(primitive.name, &primitive);
  return index;
}

const Primitive* find(const Index& index, const std::string& name) {
  const auto found = index.find(name);
  return found == index.end() ? nullptr : found->second;
}

bool samePlace(const Primitive& a, const Primitive& b) { return a.bone == b.bone && a.placement == b.placement; }

/// One of a pair of twins.
struct Half {
  Primitive& now;
  const Primitive* shown;    ///< Not null.
  const Primitive* atStart;  ///< Null: it did not exist.
};

/// 1: a leads, -1: b leads, 0: neither changed.
template <class Same>
int leader(const Half& a, const Half& b, Same same) {
  const bool aChanged = !same(*a.shown, a.now);
  const bool bChanged = !same(*b.shown, b.now);
  if (aChanged != bChanged) return aChanged ? 1 : -1;
  if (!aChanged) return 0;
  if (!a.atStart || !b.atStart) return 1;
  return same(*a.atStart, a.now) && !same(*b.atStart, b.now) ? -1 : 1;
}

bool nearlySame(const Shape& a, const Shape& b) {
  return std::ranges::all_of(shapeNumbers(),
                             [&](const ShapeNumber& number) { return std::abs(number.of(a) - number.of(b)) <= 1e-5f; });
}

/// Two placements are equal up to rounding and the sign of the quaternion.
bool nearlySame(const Placement& a, const Placement& b) {
  const float size = glm::length(a.radii);
  const float turn = std::abs(glm::dot(glm::normalize(a.rotation), glm::normalize(b.rotation)));
  return glm::length(a.center - b.center) <= 1e-5f * (size + glm::length(a.center)) && turn >= 1.0f - 1e-6f &&
         glm::length(a.radii - b.radii) <= 1e-5f * size && nearlySame(a.shape, b.shape);
}

/// Makes bone and placement of the follower those of the leader's image. Unchanged parts stay bit for bit.
/// @param both  both were edited: differences by rounding stay
void followPlace(const Half& leads, Primitive& follower, bool both, const MirrorPlan& plan) {
  const Result<Primitive> image = mirroredPrimitive(plan, leads.now);
  if (!image) return;
  Placement placement = image->placement;
  if (both && follower.bone == image->bone && nearlySame(follower.placement, placement)) return;
  const Result<Primitive> before = mirroredPrimitive(plan, *leads.shown);
  if (before && before->bone == image->bone && follower.bone == image->bone) {
    if (leads.shown->placement.center == leads.now.placement.center) placement.center = follower.placement.center;
    if (leads.shown->placement.radii == leads.now.placement.radii && before->placement.radii == placement.radii) {
      placement.radii = follower.placement.radii;
    }
    if (leads.shown->placement.rotation == leads.now.placement.rotation &&
        before->placement.rotation == placement.rotation) {
      placement.rotation = follower.placement.rotation;
    }
    if (leads.shown->placement.shape == leads.now.placement.shape && before->placement.shape == placement.shape) {
      placement.shape = follower.placement.shape;
    }
  }
  if (!validatePlacement(placement, "")) return;
  follower.bone = image->bone;
  follower.placement = placement;
}

void keepPair(const Rig& edited, const Half& a, const Half& b, const MirrorPlan& plan) {
  if (const int leads = leader(a, b, samePlace); leads != 0) {
    const bool both = !samePlace(*a.shown, a.now) && !samePlace(*b.shown, b.now);
    leads > 0 ? followPlace(a, b.now, both, plan) : followPlace(b, a.now, both, plan);
  }
  const auto copyField = [&](auto field) {
    const auto same = [&](const Primitive& x, const Primitive& y) { return x.*field == y.*field; };
    const int leads = leader(a, b, same);
    if (leads > 0) b.now.*field = a.now.*field;
    if (leads < 0) a.now.*field = b.now.*field;
  };
  copyField(&Primitive::reach);
  copyField(&Primitive::amount);
  // The shape of one may not be legal with the other's reach.
  for (const Half* half : {&a, &b}) {
    half->now.placement.shape = legalShape(half->now.placement.shape, half->now.reach);
  }
  copyField(&Primitive::sign);
  copyField(&Primitive::group);
  const auto sameLine = [](const Primitive& x, const Primitive& y) { return x.line == y.line; };
  const int lineLeads = leader(a, b, sameLine);
  if (lineLeads > 0) b.now.line = twinLineName(edited, a.now.line);
  if (lineLeads < 0) a.now.line = twinLineName(edited, b.now.line);
  const auto sameAnimation = [](const Primitive& x, const Primitive& y) { return x.animated == y.animated; };
  if (const int leads = leader(a, b, sameAnimation); leads != 0) {
    Primitive& to = leads > 0 ? b.now : a.now;
    to.animated = mirroredAnimation(plan, leads > 0 ? a.now : b.now);
    readTwinLines(edited, to.animated);
  }
  const auto sameTerritory = [](const Primitive& x, const Primitive& y) { return x.territory == y.territory; };
  if (const int leads = leader(a, b, sameTerritory); leads != 0) {
    const Primitive& from = leads > 0 ? a.now : b.now;
    Primitive& to = leads > 0 ? b.now : a.now;
    to.territory = from.territory;
    if (!to.territory) return;
    for (std::string& bone : *to.territory) {
      if (Result<std::string> twin = twinBone(plan, bone)) bone = std::move(twin).value();
    }
  }
}

/// The image of `leader` with the follower's name and link.
Result<Primitive> imageAs(const MirrorPlan& plan, const Primitive& leader, const Primitive& follower) {
  Result<Primitive> image = mirroredPrimitive(plan, leader);
  if (!image) return image;
  image.value().name = follower.name;
  image.value().mirror = follower.mirror;
  image.value().unknownKeys = follower.unknownKeys;
  return image;
}

/// "belly" -> "belly L": a free name whose mirroredName() is free, too, if possible.
std::string nameWithSide(const Rig& rig, const Primitive& primitive, const MirrorPlan& plan) {
  const bool left = sideOf(plan, primitive) == Side::kLeft;
  std::string name = freePrimitiveName(rig, primitive.name + (left ? " L" : " R"));
  for (int number = 2; number <= kMaxPrimitives; ++number) {
    const std::optional<std::string> other = mirroredName(name);
    if (!other || findPrimitive(rig, *other) < 0) break;
    const std::string next = primitive.name + (left ? " L " : " R ") + std::to_string(number);
    if (findPrimitive(rig, next) < 0) name = next;
  }
  return name;
}

/// The plane's normal points to the left.
bool leftIsPositive(const MirrorPlan& plan) {
  double sum = 0.0;
  for (std::size_t i = 0; i < plan.skeleton.bones.size(); ++i) {
    const Bone& bone = plan.skeleton.bones[i];
    const std::optional<Side> side = sideNamed(bone.name);
    if (!side || plan.twinOf[i] < 0 || plan.twinOf[i] == static_cast<int>(i)) continue;
    const double distance = distanceTo(plan.plane, glm::dvec3(bone.bindInWorld[3]));
    sum += *side == Side::kLeft ? distance : -distance;
  }
  return sum != 0.0 ? sum > 0.0 : plan.plane.normal.x >= 0.0;
}

}  // namespace

Side sideOf(const MirrorPlan& plan, const Primitive& primitive) {
  const std::optional<int> bone = plan.skeleton.findBone(primitive.bone);
  if (!bone) return Side::kLeft;
  const glm::dmat4 bind(at(plan.skeleton.bones, *bone).bindInWorld);
  const double distance = distanceTo(plan.plane, glm::dvec3(bind * glm::dvec4(primitive.placement.center, 1.0f)));
  return (distance >= 0.0) == leftIsPositive(plan) ? Side::kLeft : Side::kRight;
}

Rig keepTwins(const Rig& rigAtStart, const Rig& rigShown, Rig edited, const MirrorPlan& plan) {
  // Renames the items of the former rigs, so that renaming is no change.
  const std::optional<Rig> startRenamed = withNamesOf(rigAtStart, edited);
  const std::optional<Rig> shownRenamed = withNamesOf(rigShown, edited);
  const Rig& atStart = startRenamed ? *startRenamed : rigAtStart;
  const Rig& shown = shownRenamed ? *shownRenamed : rigShown;
  keepLineTwins(atStart, shown, edited, plan);
  const bool anyLinked = std::ranges::any_of(edited.primitives, [](const Primitive& p) { return !p.mirror.empty(); });
  if (!anyLinked) return edited;
  const Index then = byName(atStart);
  const Index before = byName(shown);
  std::unordered_map<std::string, std::size_t> now;
  for (std::size_t i = 0; i < edited.primitives.size(); ++i) now.emplace(edited.primitives[i].name, i);
  for (std::size_t i = 0; i < edited.primitives.size(); ++i) {
    Primitive& primitive = edited.primitives[i];
    const auto twin = primitive.mirror.empty() ? now.end() : now.find(primitive.mirror);
    if (twin == now.end() || twin->second <= i) continue;
    Primitive& other = edited.primitives[twin->second];
    const Half a{primitive, find(before, primitive.name), find(then, primitive.name)};
    const Half b{other, find(before, other.name), find(then, other.name)};
    const bool linkedBefore = a.shown && b.shown && a.shown->mirror == other.name && b.shown->mirror == primitive.name;
    if (linkedBefore && other.mirror == primitive.name) keepPair(edited, a, b, plan);
  }
  return edited;
}

int twinOf(const Rig& rig, int index) {
  const std::string& mirror = at(rig.primitives, index).mirror;
  return mirror.empty() ? -1 : findPrimitive(rig, mirror);
}

std::vector<int> withTwins(const Rig& rig, std::span<const int> indices) {
  std::vector<int> all(indices.begin(), indices.end());
  for (const int index : indices) {
    if (const int twin = twinOf(rig, index); twin >= 0) all.push_back(twin);
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Result<Rig> addPair(Rig rig, Primitive primitive, const MirrorPlan& plan) {
  const auto index = static_cast<int>(rig.primitives.size());
  if (const auto added = append(rig, std::move(primitive)); !added) return added.error();
  if (liesInPlane(plan, at(rig.primitives, index), kOwnImage)) return rig;
  return mirrorToOtherSide(std::move(rig), index, plan);
}

Result<Rig> mirrorToOtherSide(Rig rig, int index, const MirrorPlan& plan) {
  if (const int sheet = findSheet(rig, at(rig.primitives, index).sheet); sheet >= 0) {
    return mirrorSheetToOtherSide(std::move(rig), sheet, plan);
  }
  if (const int twin = twinOf(rig, index); twin >= 0) return linkTwins(std::move(rig), index, twin, plan);
  const Primitive& original = at(rig.primitives, index);
  if (liesInPlane(plan, original, kOwnImage)) {
    return errorAt("", '"' + original.name + "\" lies in the middle: it is its own mirror image");
  }
  Result<Primitive> image = mirroredPrimitive(plan, original);
  if (!image) return image.error();
  const std::string sided = nameWithSide(rig, original, plan);
  if (image->name == original.name && mirroredName(sided)) {
    Result<Rig> renamed = renamePrimitive(std::move(rig), index, sided);
    return renamed ? mirrorToOtherSide(std::move(renamed).value(), index, plan) : renamed;
  }
  image.value().mirror = original.name;
  const std::string ownLine = original.line;
  Result<TwinLine> line = withTwinLine(std::move(rig), ownLine, plan);
  if (!line) return line.error();
  image.value().line = line->name;
  readTwinLines(line->rig, image.value().animated);
  return addPrimitive(std::move(line).value().rig, std::move(image).value());
}

Result<Rig> linkTwins(Rig rig, int leader, int follower, const MirrorPlan& plan) {
  assert(leader != follower);
  const int leadingSheet = findSheet(rig, at(rig.primitives, leader).sheet);
  const int followingSheet = findSheet(rig, at(rig.primitives, follower).sheet);
  if (leadingSheet >= 0 && followingSheet >= 0) {
    return linkSheets(std::move(rig), leadingSheet, followingSheet, plan);
  }
  if (leadingSheet >= 0 || followingSheet >= 0) return errorAt("", "a sheet and a single muscle cannot be twins");
  const std::string ownLine = at(rig.primitives, leader).line;
  Result<TwinLine> line = withTwinLine(std::move(rig), ownLine, plan);
  if (!line) return line.error();
  Rig linked = setMirror(std::move(line.value().rig), leader, follower);
  Primitive& second = at(linked.primitives, follower);
  Result<Primitive> image = imageAs(plan, at(linked.primitives, leader), second);
  if (!image) return image.error();
  if (const auto valid = validatePrimitive(image.value(), "primitives"); !valid) return valid.error();
  const std::string former = std::exchange(second, std::move(image).value()).line;
  second.line = line->name;
  readTwinLines(linked, second.animated);
  return withoutIdleLines(std::move(linked), {former});
}

namespace {

/// Replaces the lines of flipped primitives by their images, but keeps their names.
Result<Rig> withFlippedLines(Rig rig, std::span<const int> indices, const MirrorPlan& plan) {
  std::vector<int> done{-1};
  for (const int index : indices) {
    const int line = findLine(rig, at(rig.primitives, index).line);
    if (std::ranges::find(done, line) != done.end()) continue;
    done.push_back(line);
    Result<MuscleLine> image = mirroredLine(plan, at(rig.lines, line));
    if (!image) return about("muscle line \"" + at(rig.lines, line).name + '"', image.error());
    Result<Rig> turned = editLine(std::move(rig), line, [&](MuscleLine& own) {
      own.origin = image->origin;
      own.insertion = image->insertion;
      own.via = image->via;
      own.animated = image->animated;
    });
    if (!turned) return turned;
    rig = std::move(turned).value();
  }
  return rig;
}

}  // namespace

Result<Rig> flipPrimitives(Rig rig, std::span<const int> indices, const MirrorPlan& plan) {
  std::vector<int> flipped = withTwins(rig, indices);
  Result<Rig> withSheets = flipSheetsOf(std::move(rig), flipped, plan);
  if (!withSheets) return withSheets;
  rig = std::move(withSheets).value();
  std::erase_if(flipped, [&](int index) { return !at(rig.primitives, index).sheet.empty(); });
  for (const int index : flipped) {
    Primitive& primitive = at(rig.primitives, index);
    Result<Primitive> image = imageAs(plan, primitive, primitive);
    if (!image) return image.error();
    if (const auto valid = validatePrimitive(image.value(), "primitives"); !valid) return valid.error();
    primitive = std::move(image).value();
  }
  return withFlippedLines(std::move(rig), flipped, plan);
}

namespace {

/// Moves bellies of sheets out of a list of primitives.
std::vector<int> takeBellies(const Rig& rig, std::vector<int>& primitives) {
  std::vector<int> bellies;
  std::ranges::copy_if(primitives, std::back_inserter(bellies),
                       [&](int index) { return !at(rig.primitives, index).sheet.empty(); });
  std::erase_if(primitives, [&](int index) { return !at(rig.primitives, index).sheet.empty(); });
  return bellies;
}

}  // namespace

Rig duplicatePairs(Rig rig, std::span<const int> indices) {
  std::vector<int> sources(indices.begin(), indices.end());
  std::ranges::sort(sources);
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  const std::size_t room = static_cast<std::size_t>(kMaxPrimitives) - rig.primitives.size();
  if (sources.size() > room) sources.resize(room);
  const std::vector<int> bellies = takeBellies(rig, sources);
  rig = duplicateSheetsOf(std::move(rig), bellies);
  std::unordered_map<int, int> copyOf;  // Indices.
  for (const int source : sources) {
    Primitive copy = at(rig.primitives, source);
    const int twin = twinOf(rig, source);
    const auto twinsCopy = copyOf.find(twin);
    // Names the second of a pair after the first one's copy.
    copy.name = twinsCopy != copyOf.end() && mirroredName(copy.mirror) == copy.name
                    ? twinName(rig, at(rig.primitives, twinsCopy->second).name)
                    : freePrimitiveName(rig, copy.name);
    copy.mirror.clear();
    const auto index = static_cast<int>(rig.primitives.size());
    if (twinsCopy != copyOf.end()) {
      Primitive& other = at(rig.primitives, twinsCopy->second);
      copy.mirror = other.name;
      other.mirror = copy.name;
    }
    copyOf.emplace(source, index);
    rig.primitives.push_back(std::move(copy));
  }
  return rig;
}

Result<Rig> renameWithTwin(Rig rig, int index, const std::string& name) {
  const int twin = twinOf(rig, index);
  Result<Rig> renamed = renamePrimitive(std::move(rig), index, name);
  if (!renamed || twin < 0) return renamed;
  const std::optional<std::string> other = mirroredName(name);
  if (!other || findPrimitive(renamed.value(), *other) >= 0) return renamed;
  return renamePrimitive(std::move(renamed).value(), twin, *other);
}

std::string twinName(const Rig& rig, const std::string& name) {
  return freePrimitiveName(rig, mirroredName(name).value_or(name));
}

// The edits of twins with the character's plan.

struct MirrorEdits::State {
  MirrorPlan plan;
};

MirrorEdits::MirrorEdits(const Character& character)
    : state_(std::make_unique<State>(State{makeMirrorPlan(character)})) {}
MirrorEdits::~MirrorEdits() = default;
MirrorEdits::MirrorEdits(MirrorEdits&&) noexcept = default;
MirrorEdits& MirrorEdits::operator=(MirrorEdits&&) noexcept = default;

bool MirrorEdits::usable() const { return state_->plan.usable(); }

Result<Rig> MirrorEdits::addPair(Rig rig, Primitive primitive) const {
  return sinew::addPair(std::move(rig), std::move(primitive), state_->plan);
}

Result<Rig> MirrorEdits::mirrorToOtherSide(Rig rig, int index) const {
  return sinew::mirrorToOtherSide(std::move(rig), index, state_->plan);
}

Result<Rig> MirrorEdits::linkTwins(Rig rig, int leader, int follower) const {
  return sinew::linkTwins(std::move(rig), leader, follower, state_->plan);
}

AnimationClip rangeOfMotion(const Character& character) {
  return rangeOfMotion(character.skeleton, motionHints(character));
}

}  // namespace sinew
