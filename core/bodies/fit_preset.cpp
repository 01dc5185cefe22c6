// core/bodies/fit_preset.cpp: lays each muscle into the flesh, with its twin and its line.
#include "core/bodies/fit_preset.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "core/bodies/body_map.h"
#include "core/bodies/motions.h"
#include "core/character/bindings.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/geometry/normals.h"
#include "core/rig/line_edit.h"
#include "core/rig/line_rest.h"
#include "core/rig/sheet_edit.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

namespace {

constexpr float kDegrees = 180.0f / std::numbers::pi_v<float>;
constexpr float kSearchedAround = 0.3f;  ///< On both sides of the nearest point, fraction of the axis.
constexpr int kHalvings = 40;            ///< To the last bit.

/// The u at a point's level: the root of dot(point - axis(u), direction(u)) next to the nearest point of the axis.
float levelOf(const PartAxis& axis, const glm::vec3& point) {
  const auto level = [&](float u) { return glm::dot(point - axis.point(u), axis.direction(u)); };
  float nearest = 0.0f;
  float least = std::numeric_limits<float>::max();
  float done = 0.0f;
  for (std::size_t i = 0; i + 1 < axis.points.size(); ++i) {
    const glm::vec3 way = axis.points[i + 1] - axis.points[i];
    const float square = glm::dot(way, way);
    float share = square > 0.0f ? glm::dot(point - axis.points[i], way) / square : 0.0f;
    share = std::clamp(share, i == 0 ? -1.0f : 0.0f, i + 2 == axis.points.size() ? 2.0f : 1.0f);
    const float distance = glm::distance(point, axis.points[i] + share * way);
    if (distance < least) {
      least = distance;
      nearest = (done + share * std::sqrt(square)) / axis.length;
    }
    done += std::sqrt(square);
  }
  float low = nearest - kSearchedAround;
  float high = nearest + kSearchedAround;
  if (level(low) < 0.0f || level(high) > 0.0f) return nearest;
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5f * (low + high);
    (level(middle) > 0.0f ? low : high) = middle;
  }
  return 0.5f * (low + high);
}

}  // namespace

PartPlace placeAt(const PartAxis& axis, const glm::vec3& point, float leastAway) {
  PartPlace place;
  place.u = levelOf(axis, point);
  const glm::vec3 off = glm::transpose(axesAt(axis, place.u, 0.0f)) * (point - axis.point(place.u));
  place.away = glm::length(glm::vec2(off));
  place.beside = off.z;
  if (place.away > leastAway) place.angle = kDegrees * std::atan2(off.y, off.x);
  return place;
}

glm::mat3 axesAt(const PartAxis& axis, float u, float angle) {
  return {axis.radial(u, angle), axis.radial(u, angle + 90.0f), axis.direction(u)};
}

namespace {

/// A muscle of the left side or the middle, not yet in a rig; its group is the preset's.
struct PlacedMuscle {
  Primitive belly;
  std::optional<MuscleLine> line;
};

struct PresetPlace {
  const Character& character;
  const BodyFrame& frame;
  const Flesh& flesh;
  const MirrorPlan& plan;
  const Preset& preset;
  PresetTuning tuning;
};

constexpr float kAnchorDepth = 0.45f;  ///< Default depth of anchors, fraction of the flesh.
constexpr float kViaDepth = 0.3f;
constexpr float kMostHeight = 0.6f;     ///< Largest height over half length, so that a belly is no ball.
constexpr float kFewTriangles = 0.55f;  ///< Width over edge length of the mesh below which a belly does not show.
constexpr float kMostWidening = 1.5f;
constexpr float kLeastDefinition = 0.45f;  ///< Smallest factor on the definition of a widened belly.
constexpr float kTerritoryShare = 0.08f;   ///< Smallest fraction of the skin weight under a belly.
constexpr float kNearEnd = 0.8f;           ///< Points that must lie inside, fraction of the half length.
constexpr float kShortening = 0.9f;        ///< Factor on the half length, each time an end lies outside.
constexpr float kDip = 0.06f;              ///< Slope by which that end is lowered.
constexpr int kMostShortenings = 6;
constexpr float kTrunkMass = 0.6f;  ///< Exponents of PresetTuning::mass.
constexpr float kWidthMass = 0.5f;

/// A belly before it is assigned to a bone. World.
struct Belly {
  glm::vec3 skin{0.0f};
  glm::vec3 normal{0.0f};
  glm::vec3 along{0.0f};
  float half = 0.0f;
  float height = 0.0f;
  float width = 0.0f;
  float definition = 0.0f;

  [[nodiscard]] glm::vec3 center() const { return skin - (1.0f - definition) * height * normal; }
  /// A point that must lie in the body: at most half a height below the skin.
  [[nodiscard]] glm::vec3 inner() const { return skin - std::max(1.0f - definition, 0.5f) * height * normal; }
};

/// A unit vector rotated towards another, perpendicular one.
glm::vec3 turned(const glm::vec3& from, const glm::vec3& towards, float degrees) {
  if (degrees == 0.0f) return from;
  const float angle = degrees * std::numbers::pi_v<float> / 180.0f;
  return glm::normalize(std::cos(angle) * from + std::sin(angle) * towards);
}

class MusclePlacer {
 public:
  MusclePlacer(const PresetPlace& place, const PresetMuscle& muscle) : place_(place), muscle_(muscle) {}

  Result<PlacedMuscle> make() {
    const auto found = place_.flesh.measure(muscle_.belly);
    if (!found) return errorAt("", "this body has no skin there");
    flesh_ = *found;
    PlacedMuscle placed;
    if (muscle_.origin) {
      auto line = makeLine();
      if (!line) return line.error();
      placed.line = std::move(line.value());
    }
    shapeBelly();
    keepEndsInside();
    if (muscle_.single) {
      const auto off = static_cast<float>(distanceTo(place_.plan.plane, glm::dvec3(belly_.center())));
      belly_.skin -= off * glm::vec3(place_.plan.plane.normal);
    }
    if (!place_.flesh.isInside(belly_.inner())) return errorAt("", "there is no closed body under the skin there");
    const int bone = placed.line ? lineBone_ : boneUnder();
    if (bone < 0) return errorAt("", "no bone carries it");
    const Bone& own = at(place_.character.skeleton.bones, bone);
    if (!isFinite(own.bindInWorld) || isFlat(glm::dmat3(glm::mat3(own.bindInWorld)))) {
      return errorAt("", "its bone has a scale of zero in the bind pose");
    }
    placed.belly.name = muscle_.name;
    placed.belly.bone = place_.character.skeleton.fileName(bone);
    placed.belly.group = muscle_.group;
    placed.belly.reach = muscle_.reach > 0.0f ? muscle_.reach : place_.preset.reach;
    placed.belly.placement = inBone(own);
    placed.belly.amount = muscle_.amount;
    placed.belly.sign = muscle_.carves ? -1 : 1;
    placed.belly.territory = territory(bone);
    if (placed.line) placed.belly.line = placed.line->name;
    return placed;
  }

 private:
  /// The origin and the via point ride the belly's own bone: only the insertion crosses the joint.
  Result<MuscleLine> makeLine() {
    lineBone_ = place_.frame.boneOf(*muscle_.origin);
    const auto origin = anchor(*muscle_.origin, kAnchorDepth, lineBone_);
    Mark middle = muscle_.belly;
    middle.depth = kViaDepth;
    const auto via = anchor(middle, kViaDepth, lineBone_);
    const auto insertion = anchor(*muscle_.insertion, kAnchorDepth, place_.frame.boneOf(*muscle_.insertion));
    if (!origin || !via || !insertion) return errorAt("", "an end of it has no place on this body");
    MuscleLine line;
    line.name = muscle_.name;
    line.origin = *origin;
    line.insertion = *insertion;
    line.via = *via;
    line.settings = muscle_.line;
    if (const auto rest = lineRest(line, place_.character); !rest) return rest.error();
    return line;
  }

  std::optional<LineAnchor> anchor(const Mark& mark, float depth, int bone) {
    const auto flesh = place_.flesh.measure(mark, false);
    if (!flesh || bone < 0) return std::nullopt;
    const glm::vec3 point = flesh->at(mark.depth > 0.0f ? mark.depth : depth);
    path_.push_back(point);
    return anchorOn(place_.character.skeleton, bone, point);
  }

  void shapeBelly() {
    float u = 0.0f;
    const PartAxis& axis = *place_.frame.axisOf(muscle_.belly, u);
    belly_.skin = flesh_.at(muscle_.belly.depth);
    belly_.normal = flesh_.normal;
    glm::vec3 along = axis.direction(u);
    if (path_.size() == 3) {
      along = path_[2] - path_[0];
      const float length = glm::distance(path_[0], path_[1]) + glm::distance(path_[1], path_[2]);
      belly_.half = 0.5f * (1.0f - muscle_.line.tendons.x - muscle_.line.tendons.y) * length;
    }
    if (muscle_.halfLength > 0.0f) belly_.half = muscle_.halfLength * axis.length;
    along -= glm::dot(along, belly_.normal) * belly_.normal;
    belly_.along = normalizeOr(along, normalizeOr(glm::cross(belly_.normal, flesh_.radial), {0, 1, 0}));
    if (muscle_.turn != 0.0f) {
      // Towards the outer side, whatever the direction of the axis.
      const glm::vec3 side = glm::cross(belly_.along, belly_.normal);
      const float outer = glm::dot(side, axis.radial(u, muscle_.belly.angle + 90.0f)) < 0.0f ? -1.0f : 1.0f;
      belly_.along = turned(belly_.along, outer * side, muscle_.turn);
    }
    const glm::vec3 flat = belly_.along;
    belly_.along = turned(flat, belly_.normal, muscle_.tilt);
    belly_.normal = turned(belly_.normal, -flat, muscle_.tilt);
    belly_.normal = turned(belly_.normal, glm::cross(belly_.along, belly_.normal), muscle_.roll);
    const bool middle = isTrunk(muscle_.belly.slot) || muscle_.belly.slot == Slot::kNeck;
    const float bare = muscle_.height * flesh_.size;
    const float mass = place_.tuning.mass;
    belly_.height = bare * std::pow(mass, middle ? kTrunkMass : 1.0f);
    if (!muscle_.asLaid) belly_.height = std::min(belly_.height, kMostHeight * belly_.half);
    belly_.width = muscle_.width * bare * std::pow(mass, kWidthMass);
    belly_.definition =
        std::clamp(place_.tuning.definition.value_or(place_.preset.definition) * muscle_.definition, 0.0f, 1.0f);
    if (muscle_.midline) return keepOffMidline();
    const float wanted = kFewTriangles * flesh_.edge;
    if (muscle_.asLaid || belly_.width >= wanted) return;
    belly_.definition *= std::max(kLeastDefinition, belly_.width / wanted);
    belly_.width = std::min(wanted, kMostWidening * belly_.width);
    if (belly_.half < belly_.width) belly_.half = belly_.width;
  }

  /// Twins beside the midline do not cross it.
  void keepOffMidline() {
    const glm::vec3 normal(place_.plan.plane.normal);
    const auto away = static_cast<float>(std::abs(distanceTo(place_.plan.plane, glm::dvec3(belly_.center()))));
    const float across = std::abs(glm::dot(glm::cross(belly_.along, belly_.normal), normal));
    if (across > 0.1f) belly_.width = std::min(belly_.width, 0.97f * away / across);
  }

  /// Shortens a belly whose ends come out of a curved body as bumps, and tilts it so that both ends lie equally deep.
  /// On a line the tendons determine its length.
  void keepEndsInside() {
    if (!path_.empty() || muscle_.asLaid) return;
    for (int step = 0; step < kMostShortenings; ++step) {
      const glm::vec3 way = kNearEnd * belly_.half * belly_.along;
      const bool head = place_.flesh.isInside(belly_.inner() + way);
      const bool foot = place_.flesh.isInside(belly_.inner() - way);
      if (head && foot) return;
      if (head != foot) {
        const float dip = (head ? 1.0f : -1.0f) * kDip;
        const glm::vec3 along = glm::normalize(belly_.along + dip * belly_.normal);
        belly_.normal = glm::normalize(belly_.normal - glm::dot(belly_.normal, along) * along);
        belly_.along = along;
      }
      belly_.half *= kShortening;
      belly_.height = std::min(belly_.height, kMostHeight * belly_.half);
    }
  }

  int boneUnder() const {
    if (!isTrunk(muscle_.belly.slot)) return place_.frame.boneOf(muscle_.belly);
    int best = -1;
    float most = 0.0f;
    for (const auto& [bone, weight] : weightsUnder()) {
      if (!mayCarry(bone) || weight <= most) continue;
      best = bone;
      most = weight;
    }
    return best >= 0 ? best : place_.frame.boneOf(muscle_.belly);
  }

  Placement inBone(const Bone& bone) const {
    Placement placement;
    placement.center = belly_.center();
    const glm::vec3 across = glm::cross(belly_.along, belly_.normal);
    placement.rotation = glm::normalize(glm::quat_cast(glm::mat3(across, belly_.along, belly_.normal)));
    placement.radii = {belly_.width, belly_.half, belly_.height};
    placement.shape = legalShape(muscle_.shape, muscle_.reach > 0.0f ? muscle_.reach : place_.preset.reach);
    const glm::dmat4 toBone(bone.inverseBindInWorld);
    return imageOf(placement, {glm::dmat3(toBone), glm::dvec3(toBone[3])});
  }

  std::vector<std::string> territory(int bone) const {
    const std::map<int, float> weights = weightsUnder();
    float sum = 0.0f;
    for (const auto& [other, weight] : weights) sum += weight;
    std::vector<std::string> names{place_.character.skeleton.fileName(bone)};
    for (const auto& [other, weight] : weights) {
      // The skin over a shoulder blade is that of the trunk's muscles too.
      const bool shoulder =
          isTrunk(muscle_.belly.slot) && at(place_.frame.zoneOfBone, other) == zoneOf(Slot::kShoulder);
      if (other == bone || !(weight >= kTerritoryShare * sum) || !(mayCarry(other) || shoulder)) continue;
      names.push_back(place_.character.skeleton.fileName(other));
    }
    return names;
  }

  /// Skin weights under the belly, by bone.
  std::map<int, float> weightsUnder() const {
    std::map<int, float> weights;
    const Slot part = isTrunk(muscle_.belly.slot) ? Slot::kSpine : muscle_.belly.slot;
    const std::vector<Zone> zones = zonesAround(part);
    const glm::vec3 across = glm::cross(belly_.along, belly_.normal);
    const Character& character = place_.character;
    for (const float y : {-0.7f, 0.0f, 0.7f}) {
      for (const float x : {-0.7f, 0.0f, 0.7f}) {
        const glm::vec3 from = belly_.center() + y * belly_.half * belly_.along + x * belly_.width * across;
        const auto exit = place_.flesh.leave(from, belly_.normal, zones);
        if (!exit) continue;
        const auto& corners = at(character.mesh.triangles, exit->triangle).vertices;
        for (int k = 0; k < 3; ++k) {
          for (const auto binding : bindingsOf(character, corners[static_cast<std::size_t>(k)])) {
            weights[binding.bone()] += binding.weight * exit->barycentric[k];
          }
        }
      }
    }
    return weights;
  }

  /// Muscles of the trunk never ride a limb, nor one limb's another.
  bool mayCarry(int bone) const {
    const Zone zone = at(place_.frame.zoneOfBone, bone);
    const Slot own = muscle_.belly.slot;
    if (isTrunk(own)) return zone == zoneOf(Slot::kSpine);
    if (zone == zoneOf(Slot::kSpine)) return own == Slot::kShoulder || own == Slot::kNeck;
    const std::vector<Zone> zones = zonesAround(own);
    return std::ranges::find(zones, zone) != zones.end();
  }

  const PresetPlace& place_;
  const PresetMuscle& muscle_;
  FleshPoint flesh_;
  Belly belly_;
  int lineBone_ = -1;
  std::vector<glm::vec3> path_;  ///< Points of the line, from the origin.
};

/// Each side has its own group, so that left and right never blend where they touch.
std::string groupOf(const std::string& group, BodySide side) { return group + (side == BodySide::kLeft ? " L" : " R"); }

void needGroup(Rig& rig, const std::string& name) {
  if (findGroup(rig, name) < 0) rig.groups.push_back({name, {}});
}

Result<Rig> withLine(Rig rig, MuscleLine line, Primitive& belly) {
  line.name = belly.name;
  auto lined = addLine(std::move(rig), line);
  if (lined) belly.line = lined->lines.back().name;
  return lined;
}

/// The muscle with its line and, where the body has the other side, its twin.
Result<Rig> withMuscle(Rig rig, const PresetMuscle& muscle, PlacedMuscle placed, const MirrorPlan& plan) {
  placed.belly.name = muscle.single ? muscle.name : muscle.name + " L";
  placed.belly.group = muscle.single ? muscle.group : groupOf(muscle.group, BodySide::kLeft);
  needGroup(rig, placed.belly.group);
  if (!muscle.single) needGroup(rig, groupOf(muscle.group, BodySide::kRight));
  if (placed.line) {
    auto lined = withLine(std::move(rig), *placed.line, placed.belly);
    if (!lined) return lined;
    rig = std::move(lined).value();
  }
  const bool paired = !muscle.single && twinBone(plan, placed.belly.bone).ok();
  auto added = paired ? addPair(std::move(rig), std::move(placed.belly), plan)
                      : addPrimitive(std::move(rig), std::move(placed.belly));
  if (!added || !paired) return added;
  rig = std::move(added).value();
  rig.primitives.back().group = groupOf(muscle.group, BodySide::kRight);
  return rig;
}

// Sheets.

constexpr float kSheetMass = 0.5f;  ///< Exponent of PresetTuning::mass on the thickness of sheets.

/// The bone of a point of an edge: above the start of a limb's part, that of the part before.
int boneOfEdgeMark(const BodyFrame& frame, const Mark& mark) {
  if (mark.u >= 0.0f || isTrunk(mark.slot)) return frame.boneOf(mark);
  const Slot before = partBefore(mark.slot);
  const int bone = frame.boneOf({before, isTrunk(before) ? 0.0f : 0.5f, mark.angle, 0.0f});
  return bone >= 0 ? bone : frame.boneOf(mark);
}

/// The sheet with its edges on the skin of this body.
Result<MuscleSheet> placedSheet(const PresetPlace& place, const PresetSheet& marked) {
  MuscleSheet sheet = marked.sheet;
  const Skeleton& skeleton = place.character.skeleton;
  for (const std::vector<Mark>& edge : marked.edges) {
    SheetEdge& placed = sheet.edges.emplace_back();
    for (const Mark& mark : edge) {
      const auto flesh = place.flesh.measure(mark, false);
      const int bone = boneOfEdgeMark(place.frame, mark);
      if (!flesh || bone < 0) return errorAt("", "this body has no skin there");
      glm::vec3 point = flesh->at(mark.depth);
      if (marked.single) {
        point -=
            static_cast<float>(distanceTo(place.plan.plane, glm::dvec3(point))) * glm::vec3(place.plan.plane.normal);
      }
      placed.points.push_back(anchorOn(skeleton, bone, point));
    }
  }
  const float definition = place.tuning.definition.value_or(place.preset.definition);
  const float share = place.preset.definition > 0.0f ? definition / place.preset.definition : 1.0f;
  sheet.crest *= place.tuning.mass * (0.5f + 0.5f * share);
  sheet.thickness *= std::pow(place.tuning.mass, kSheetMass);
  sheet.width *= std::pow(place.tuning.mass, kSheetMass);
  return sheet;
}

Result<Rig> withSheetPair(Rig rig, MuscleSheet sheet, const MirrorPlan& plan) {
  const std::string name = sheet.name;
  const std::string group = sheet.group;
  sheet.name = name + " L";
  sheet.group = groupOf(group, BodySide::kLeft);
  auto added = addSheet(std::move(rig), std::move(sheet));
  if (!added) return added;
  const auto own = static_cast<int>(added->sheets.size()) - 1;
  if (!mirroredSheet(plan, at(added->sheets, own))) return added;
  return mirrorSheetToOtherSide(std::move(added).value(), own, plan);
}

std::string wanted(BodyKind kind) { return kind == BodyKind::kQuadruped ? "an animal on four legs" : "a humanoid"; }

}  // namespace

Result<FittedPreset> fitPreset(Rig rig, const Preset& preset, const PresetTuning& tuning, const Character& character,
                               const MirrorPlan& plan) {
  const BodySlots slots = bodySlots(character, plan, rig.slots);
  if (slots.kind != preset.body) {
    const char* found = slots.kind == BodyKind::kUnknown ? "neither arms nor legs were found" : nameOf(slots.kind);
    return errorAt("",
                   "the set \"" + preset.name + "\" is for " + wanted(preset.body) + ", and of this body " +
                       (slots.kind == BodyKind::kUnknown ? found : "the bones are those of a " + std::string(found)));
  }
  BodyFrame frame = makeBodyFrame(character, slots);
  const Flesh flesh(character, frame);
  const PresetPlace place{character, frame, flesh, plan, preset, tuning};
  FittedPreset fitted{std::move(rig), {}, {}};
  const std::size_t firstLine = fitted.rig.lines.size();
  for (const PresetMuscle& muscle : preset.muscles) {
    auto placed = MusclePlacer(place, muscle).make();
    if (!placed) {
      fitted.leftOut.push_back({muscle.name, placed.error().reason});
      continue;
    }
    auto with = withMuscle(fitted.rig, muscle, std::move(placed).value(), plan);
    if (!with) {
      fitted.leftOut.push_back({muscle.name, with.error().reason});
      continue;
    }
    fitted.rig = std::move(with).value();
    fitted.muscles.push_back(muscle.name);
  }
  for (const PresetSheet& marked : preset.sheets) {
    auto placed = placedSheet(place, marked);
    const auto add = [&] {
      if (!placed) return Result<Rig>(placed.error());
      return marked.single ? addSheet(fitted.rig, std::move(placed).value())
                           : withSheetPair(fitted.rig, std::move(placed).value(), plan);
    };
    auto with = add();
    if (!with) {
      fitted.leftOut.push_back({marked.sheet.name, with.error().reason});
      continue;
    }
    fitted.rig = std::move(with).value();
    fitted.muscles.push_back(marked.sheet.name);
  }
  if (fitted.muscles.empty())
    return errorAt("", "no muscle of the set \"" + preset.name + "\" finds its place on this body" +
                           (fitted.leftOut.empty() ? "" : ": " + fitted.leftOut.front().why));
  fitted.rig = withLearnedLengths(std::move(fitted.rig), firstLine, character);
  return fitted;
}

}  // namespace sinew
