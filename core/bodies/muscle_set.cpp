// core/bodies/muscle_set.cpp: inverts fit_preset.cpp; moves marks; adds a set and mends it.
#include "core/bodies/muscle_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "core/bodies/body_map.h"
#include "core/bodies/fit_preset.h"
#include "core/bodies/mend.h"
#include "core/bodies/sheets/keep_sheets.h"
#include "core/character/bone_names.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

namespace {

constexpr float kDegreesPerRadian = 180.0f / std::numbers::pi_v<float>;
constexpr float kLeastDepth = 0.01f;  ///< Depth 0 means the default depth of anchors.
constexpr float kAcross = 0.15f;      ///< Distance from the mirror plane, in widths, at which a muscle lies across it.
constexpr float kLeastMarkedDefinition = 0.05f;
constexpr float kNear = 1e-3f;        ///< Tolerance of a belly's place, fraction of H.
constexpr float kLeastRadial = 0.3f;  ///< Cosine between radial line and normal.
constexpr int kSteps = 8;

/// A belly on the left side, with its axes named as in a preset. World, bind pose.
struct WorldBelly {
  Placement world;
  glm::vec3 center{0.0f};
  glm::vec3 across{0.0f};
  glm::vec3 along{0.0f};
  glm::vec3 normal{0.0f};
  float width = 0.0f;
  float half = 0.0f;
  float height = 0.0f;
};

/// @param height  axis of the height: 2 or 0
WorldBelly bellyOf(const Placement& world, glm::length_t height, const glm::vec3& outwards) {
  const glm::mat3 axes = glm::mat3_cast(world.rotation);
  WorldBelly belly;
  belly.world = world;
  belly.center = world.center;
  belly.along = axes[1];
  belly.normal = glm::dot(axes[height], outwards) < 0.0f ? -axes[height] : axes[height];
  belly.across = glm::cross(belly.along, belly.normal);
  belly.half = world.radii.y;
  belly.height = world.radii[height];
  belly.width = world.radii[2 - height];
  return belly;
}

glm::vec2 bendOf(const WorldBelly& belly) {
  const glm::mat3 axes = glm::mat3_cast(belly.world.rotation);
  const glm::vec2& own = belly.world.shape.bend;
  const glm::vec3 way = own.x * belly.world.radii.x * axes[0] + own.y * belly.world.radii.z * axes[2];
  return {glm::dot(way, belly.across) / belly.width, glm::dot(way, belly.normal) / belly.height};
}

class PresetMaker {
 public:
  PresetMaker(const Rig& rig, const Character& character, const MirrorPlan& plan)
      : rig_(rig), body_(character, plan, rig.slots) {}

  [[nodiscard]] BodyKind kind() const { return body_.frame.slots.kind; }

  Result<PresetMuscle> muscle(int index) const {
    const auto own = onLeft(index);
    if (!own) return own.error();
    const Primitive& primitive = own->primitive;
    PresetMuscle muscle;
    muscle.belly.slot = own->slot <= Slot::kUpperChest ? Slot::kSpine : own->slot;
    const PartAxis* axis = axisOf(muscle.belly.slot);
    if (axis == nullptr)
      return errorAt("", std::string("sets have no place for it on the ") + nameOf(muscle.belly.slot));
    const glm::dmat4 bind(bindOf(primitive.bone));
    Placement world = imageOf(primitive.placement, {glm::dmat3(bind), glm::dvec3(bind[3])});
    if (!own->line) world = withLongAxisY(world);
    const PartPlace place = placeAt(*axis, world.center, kOnAxis * body_.frame.height);
    // Muscles laid by the program have their height along z; for others take the axis that fits the skin better.
    const auto under = body_.flesh.measure({muscle.belly.slot, place.u, place.angle, 0.0f});
    const glm::vec3 outwards = under ? under->normal : axis->radial(place.u, place.angle);
    WorldBelly belly = bellyOf(world, 2, outwards);
    auto marked = markBelly(belly, muscle);
    if (!marked || marked->off > kNear * body_.frame.height) {
      const WorldBelly other = bellyOf(world, 0, outwards);
      PresetMuscle turned = muscle;
      auto better = markBelly(other, turned);
      if (better && (!marked || better->off < marked->off)) {
        belly = other;
        muscle = std::move(turned);
        marked = std::move(better);
      }
    }
    if (!marked) return errorAt("", "this body has no skin over it");
    const FleshPoint& flesh = marked->flesh;
    muscle.name = withoutSide(primitive.name);
    muscle.group = withoutSide(primitive.group.empty() ? primitive.name : primitive.group);
    muscle.height = std::clamp(belly.height / flesh.size, kLeastPresetHeight, kMostPresetHeight);
    muscle.width = std::clamp(belly.width / belly.height, kLeastPresetWidth, kMostPresetWidth);
    muscle.halfLength = std::clamp(belly.half / axis->length, kLeastHalfLength, kMostHalfLength);
    muscle.reach = primitive.reach;
    muscle.amount = primitive.amount;
    muscle.carves = primitive.sign < 0;
    muscle.shape = world.shape;
    muscle.shape.bend = bendOf(belly);
    muscle.asLaid = true;
    muscle.single = own->single;
    std::optional<glm::vec3> way;
    if (own->line) {
      const auto origin = anchor(own->line->origin);
      if (!origin) return origin.error();
      const auto insertion = anchor(own->line->insertion);
      if (!insertion) return insertion.error();
      muscle.origin = origin.value();
      muscle.insertion = insertion.value();
      muscle.line = own->line->settings;
      muscle.line.rest = LineSettings{}.rest;  // Only valid on this body.
      muscle.line.base = LineSettings{}.base;
      const auto point = [&](const LineAnchor& end) {
        return glm::vec3(bindOf(end.bone) * glm::vec4(end.point, 1.0f));
      };
      way = point(own->line->insertion) - point(own->line->origin);
    }
    markTurns(belly, flesh, way, muscle);
    return muscle;
  }

 private:
  struct OnLeft {
    Primitive primitive;
    std::optional<MuscleLine> line;
    Slot slot = Slot::kSpine;
    bool single = false;  ///< Across the mirror plane.
  };
  struct Marked {
    FleshPoint flesh;
    float off = 0.0f;  ///< Distance from the wanted center.
  };

  Result<BodySlot> partOf(const std::string& bone) const {
    const auto found = body_.character.skeleton.findBone(bone);
    if (!found) return errorAt("", "this character has no bone \"" + bone + '"');
    const Zone zone = at(body_.frame.zoneOfBone, *found);
    if (zone < 0) return errorAt("", "its bone \"" + bone + "\" is no part of the body");
    return at(allBodySlots(), zone);
  }

  /// The muscle itself, or its mirror image.
  Result<OnLeft> onLeft(int index) const {
    const Primitive& own = at(rig_.primitives, index);
    const auto part = partOf(own.bone);
    if (!part) return part.error();
    OnLeft left{own, std::nullopt, part->slot};
    if (const MuscleLine* line = lineOf(rig_, own)) left.line = *line;
    const glm::vec3 center(bindOf(own.bone) * glm::vec4(own.placement.center, 1.0f));
    const glm::vec3 image(reflected(body_.plan.plane, glm::dvec3(center)));
    const bool isLeft =
        part->isSided() ? part->side == BodySide::kLeft : glm::dot(center - image, body_.frame.slots.left) >= 0.0f;
    if (!part->isSided() && twinOf(rig_, index) < 0) {
      const glm::vec3& radii = own.placement.radii;
      if (glm::distance(center, image) < 2.0f * kAcross * std::max(radii.x, radii.z)) left.single = true;
    }
    if (isLeft) return left;
    auto mirrored = mirroredPrimitive(body_.plan, own);
    if (!mirrored) return mirrored.error();
    left.primitive = std::move(mirrored).value();
    if (left.line) {
      auto line = mirroredLine(body_.plan, *left.line);
      if (!line) return line.error();
      left.line = std::move(line).value();
    }
    return left;
  }

  Result<Mark> anchor(const LineAnchor& anchor) const {
    const auto part = partOf(anchor.bone);
    if (!part) return part.error();
    if (part->isSided() && part->side == BodySide::kRight) return errorAt("", "its line goes to the other side");
    const Slot slot = static_cast<int>(part->slot) <= static_cast<int>(Slot::kUpperChest) ? Slot::kSpine : part->slot;
    // A hand or head of unknown length is the end of the part before it.
    float start = 0.0f;
    const PartAxis* axis = body_.frame.axisOf({slot, 0.0f, 0.0f, 0.0f}, start);
    if (axis == nullptr) return errorAt("", std::string("sets have no place for its line on the ") + nameOf(slot));
    const glm::vec3 point(bindOf(anchor.bone) * glm::vec4(anchor.point, 1.0f));
    const PartPlace place = placeAt(*axis, point, kOnAxis * body_.frame.height);
    Mark mark{slot, axisOf(slot) == axis ? std::clamp(place.u, -kMostU, kMostU) : 0.0f, place.angle, 0.0f};
    const auto flesh = body_.flesh.measure(mark, false);
    if (!flesh) return errorAt("", "an end of its line has no flesh round it");
    mark.depth = std::clamp(1.0f - place.away / flesh->thickness, kLeastDepth, 1.0f);
    return mark;
  }

  /// Finds the mark and definition with which fit_preset.cpp gives this center. nullopt: no skin there.
  std::optional<Marked> markBelly(const WorldBelly& belly, PresetMuscle& muscle) const {
    const PartAxis& axis = *axisOf(muscle.belly.slot);
    const auto exit = body_.flesh.leave(belly.center, belly.normal, zonesAround(muscle.belly.slot));
    glm::vec3 wanted = belly.center + (exit ? exit->distance : belly.height) * belly.normal;
    std::optional<Marked> best;
    for (int step = 0; step < kSteps; ++step) {
      const PartPlace place = placeAt(axis, wanted, kOnAxis * body_.frame.height);
      Mark mark{muscle.belly.slot, std::clamp(place.u, -kMostU, kMostU), place.angle, 0.0f};
      const auto flesh = body_.flesh.measure(mark);
      if (!flesh) break;
      const float under = glm::dot(flesh->at(0.0f) - belly.center, belly.normal);
      const float definition = std::clamp(1.0f - under / belly.height, 0.0f, 1.0f);
      if (under > belly.height) {
        const float radial = std::max(glm::dot(flesh->radial, belly.normal), kLeastRadial);
        mark.depth = std::min((under - belly.height) / (radial * flesh->thickness), 1.0f);
      }
      const glm::vec3 made = flesh->at(mark.depth) - (1.0f - definition) * belly.height * belly.normal;
      if (const float off = glm::distance(made, belly.center); !best || off < best->off) {
        best = Marked{*flesh, off};
        muscle.belly = mark;
        muscle.definition = definition;
      }
      wanted += belly.center - made;
    }
    return best;
  }

  /// Finds turn, tilt and roll from the default direction of the fibres to the actual one.
  void markTurns(const WorldBelly& belly, const FleshPoint& flesh, const std::optional<glm::vec3>& way,
                 PresetMuscle& muscle) const {
    const PartAxis& axis = *axisOf(muscle.belly.slot);
    const auto inSkin = [&](const glm::vec3& direction) {
      return direction - glm::dot(direction, flesh.normal) * flesh.normal;
    };
    const glm::vec3 usual = normalizeOr(inSkin(way.value_or(axis.direction(muscle.belly.u))),
                                        normalizeOr(glm::cross(flesh.normal, flesh.radial), {0, 1, 0}));
    const glm::vec3 side = glm::cross(usual, flesh.normal);
    const float outer = glm::dot(side, axis.radial(muscle.belly.u, muscle.belly.angle + 90.0f)) < 0.0f ? -1.0f : 1.0f;
    glm::vec3 along = belly.along;
    // Without a displaced belly both ends are alike.
    if (belly.world.shape.belly == 0.0f && glm::dot(along, usual) < 0.0f) along = -along;
    const glm::vec3 flat = normalizeOr(inSkin(along), usual);
    muscle.turn = kDegreesPerRadian * std::atan2(outer * glm::dot(flat, side), glm::dot(flat, usual));
    const float rise = glm::dot(along, flesh.normal);
    muscle.tilt = kDegreesPerRadian * std::atan2(rise, glm::dot(along, flat));
    const glm::vec3 normal = glm::normalize(flesh.normal - rise * along);
    muscle.roll = kDegreesPerRadian *
                  std::atan2(glm::dot(belly.normal, glm::cross(along, normal)), glm::dot(belly.normal, normal));
  }

  [[nodiscard]] const PartAxis* axisOf(Slot slot) const {
    const auto& axis = at(body_.frame.axes, static_cast<int>(slot));
    return axis ? &*axis : nullptr;
  }
  [[nodiscard]] glm::mat4 bindOf(const std::string& bone) const {
    const Skeleton& skeleton = body_.character.skeleton;
    return at(skeleton.bones, *skeleton.findBone(bone)).bindInWorld;
  }

  const Rig& rig_;
  MeasuredBody body_;
};

float median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Makes the medians the set's numbers, and each muscle's own numbers relative to them.
void shareNumbers(Preset& preset) {
  std::vector<float> definitions;
  std::vector<float> reaches;
  for (const PresetMuscle& muscle : preset.muscles) {
    definitions.push_back(muscle.definition);
    reaches.push_back(muscle.reach);
  }
  preset.definition = std::max(median(std::move(definitions)), kLeastMarkedDefinition);
  preset.reach = median(std::move(reaches));
  for (PresetMuscle& muscle : preset.muscles) {
    muscle.definition = std::min(muscle.definition / preset.definition, kMostDefinition);
    if (muscle.reach == preset.reach) muscle.reach = 0.0f;
  }
}

}  // namespace

Result<PresetOfMuscles> presetFromMuscles(const Rig& rig, std::span<const int> primitives, const Character& character,
                                          const MirrorPlan& plan) {
  const PresetMaker maker(rig, character, plan);
  if (maker.kind() == BodyKind::kUnknown) return errorAt("", "neither arms nor legs were found on this body");
  PresetOfMuscles made;
  made.preset.body = maker.kind();
  made.preset.skinBlend = rig.surface.skinBlend;
  made.preset.grooves = rig.surface.grooves;
  std::vector<int> twins;
  for (const int index : primitives) {
    if (std::ranges::find(twins, index) != twins.end()) continue;
    if (const int twin = twinOf(rig, index); twin >= 0) twins.push_back(twin);
    auto muscle = maker.muscle(index);
    if (muscle) made.preset.muscles.push_back(std::move(muscle).value());
    else made.leftOut.push_back({at(rig.primitives, index).name, muscle.error().reason});
  }
  if (made.preset.muscles.empty()) {
    const std::string why = made.leftOut.empty() ? "" : ": " + made.leftOut[0].name + ": " + made.leftOut[0].why;
    return errorAt("", "none of the muscles can be in a set" + why);
  }
  shareNumbers(made.preset);
  return made;
}

namespace {

constexpr float kOwnPlace = 0.05f;  ///< Distance up to which a muscle stays at its own place, fraction of H.

Slot partOf(Slot slot) { return isTrunk(slot) ? Slot::kSpine : slot; }

/// Half length that the belly has on its line, fraction of the part; needed when the line is removed.
float halfLengthOf(const PresetMuscle& muscle) {
  if (muscle.halfLength > 0.0f || !muscle.origin) return muscle.halfLength;
  const Mark& from = *muscle.origin;
  const Mark& to = *muscle.insertion;
  const float way = from.slot == to.slot ? std::abs(to.u - from.u) : std::max(1.0f - from.u, 0.0f) + std::abs(to.u);
  const float belly = 1.0f - muscle.line.tendons.x - muscle.line.tendons.y;
  return std::clamp(0.5f * belly * way, kLeastHalfLength, kMostHalfLength);
}

const PartAxis* axisOf(const MeasuredBody& body, Slot slot) {
  const auto& axis = at(body.frame.axes, static_cast<int>(partOf(slot)));
  return axis ? &*axis : nullptr;
}

float turnedBy(float angle, float by) { return std::remainder(angle + by, 360.0f); }

}  // namespace

std::optional<MarkOnSkin> markOnSkin(const MeasuredBody& body, int bone, const glm::vec3& inBind) {
  const Zone zone = at(body.frame.zoneOfBone, bone);
  if (zone < 0) return std::nullopt;
  const BodySlot slot = at(allBodySlots(), zone);
  const PartAxis* axis = axisOf(body, slot.slot);
  if (axis == nullptr) return std::nullopt;
  const glm::vec3 image(reflected(body.plan.plane, glm::dvec3(inBind)));
  MarkOnSkin found;
  if (slot.isSided()) found.side = slot.side;
  else if (glm::dot(inBind - image, body.frame.slots.left) < 0.0f) found.side = BodySide::kRight;
  const PartPlace place = placeAt(*axis, found.side == BodySide::kLeft ? inBind : image, kOnAxis * body.frame.height);
  found.mark = {partOf(slot.slot), std::clamp(place.u, -kMostU, kMostU), place.angle, 0.0f};
  return found;
}

bool isOwnPlace(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body) {
  if (partOf(mark.slot) != partOf(muscle.belly.slot)) return false;
  const auto own = body.flesh.measure(muscle.belly);
  const auto other = body.flesh.measure(mark, false);
  return own && other && glm::distance(own->at(0.0f), other->at(0.0f)) < kOwnPlace * body.frame.height;
}

PresetMuscle muscleAt(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body) {
  if (isOwnPlace(muscle, mark, body)) return muscle;
  PresetMuscle moved = muscle;
  moved.single = false;
  moved.midline = false;
  moved.belly = {mark.slot, mark.u, mark.angle, muscle.belly.depth};
  if (partOf(mark.slot) == partOf(muscle.belly.slot)) {
    if (!moved.origin) return moved;
    const float by = mark.angle - muscle.belly.angle;
    moved.origin->angle = turnedBy(moved.origin->angle, by);
    moved.insertion->angle = turnedBy(moved.insertion->angle, by);
    return moved;
  }
  const PartAxis* ours = axisOf(body, muscle.belly.slot);
  const PartAxis* theirs = axisOf(body, mark.slot);
  moved.halfLength = halfLengthOf(muscle);
  if (ours != nullptr && theirs != nullptr)
    moved.halfLength = std::clamp(moved.halfLength * ours->length / theirs->length, kLeastHalfLength, kMostHalfLength);
  moved.origin.reset();
  moved.insertion.reset();
  moved.turn = 0.0f;
  return moved;
}

Result<FittedPreset> addMuscleSetQuickly(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                         const Motions& motions, const MirrorPlan& plan) {
  if (rig.primitives.empty()) {
    rig.surface.skinBlend = preset.skinBlend;
    rig.surface.grooves = preset.grooves;
  }
  Result<FittedPreset> fitted = fitPreset(std::move(rig), preset, tuning, motions.character(), plan);
  if (fitted) fitted.value().rig = withSheets(std::move(fitted.value().rig), motions.sharedCharacter());
  return fitted;
}

namespace {

/// Removes muscles that still have findings, with their twins, and then new groups that are empty.
void leaveOutFound(AddedSet& added, std::size_t first, std::size_t firstGroup, const Motions& motions) {
  Rig& rig = added.fitted.rig;
  std::vector<int> gone;
  const auto go = [&](int index) {
    if (index >= 0 && std::ranges::find(gone, index) == gone.end()) gone.push_back(index);
  };
  for (const Finding& finding : findingsFrom(rig, first, motions)) {
    if (std::ranges::find(gone, finding.primitive) != gone.end()) continue;
    const int twin = twinOf(rig, finding.primitive);
    const std::string& name = at(rig.primitives, twin < 0 ? finding.primitive : std::min(finding.primitive, twin)).name;
    const std::string own = withoutSide(name);
    added.fitted.leftOut.push_back({own, "it " + textOf(finding) + " in " + finding.clip});
    std::erase(added.fitted.muscles, own);
    std::erase_if(added.mended, [&](const std::string& line) { return line.starts_with(name + ":"); });
    go(finding.primitive);
    go(twin);
  }
  rig = removePrimitives(std::move(rig), gone);
  for (std::size_t i = rig.groups.size(); i-- > firstGroup;) {
    const auto isIn = [&](const Primitive& primitive) { return primitive.group == rig.groups[i].name; };
    if (std::ranges::none_of(rig.primitives, isIn))
      rig.groups.erase(rig.groups.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

Result<AddedSet> addMuscleSet(Rig rig, const Preset& preset, const PresetTuning& tuning, const Motions& motions,
                              const MirrorPlan& plan) {
  // Muscles of sheets come last (Rig::primitives), so those of the set come before.
  const auto first = static_cast<std::size_t>(std::ranges::count(rig.primitives, "", &Primitive::sheet));
  const std::size_t firstGroup = rig.groups.size();
  Result<FittedPreset> fitted = addMuscleSetQuickly(std::move(rig), preset, tuning, motions, plan);
  if (!fitted) return fitted.error();
  Result<MendedRig> mended = withMendedRig(std::move(fitted.value().rig), first, motions, &plan);
  if (!mended) return mended.error();
  fitted.value().rig = std::move(mended.value().rig);
  AddedSet added{std::move(fitted).value(), std::move(mended.value().said)};
  leaveOutFound(added, first, firstGroup, motions);
  return added;
}

}  // namespace sinew
