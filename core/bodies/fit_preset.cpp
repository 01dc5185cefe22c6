// core/bodies/fit_preset.cpp: each muscle with its twin, then what its line does over all clips.
#include "core/bodies/fit_preset.h"

#include <algorithm>
#include <utility>

#include "core/bodies/character_slots.h"
#include "core/bodies/learned_lengths.h"
#include "core/bodies/place_muscle.h"
#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {
namespace {

/// Each side has its own: left and right never blend where they touch.
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
    auto placed = placeMuscle(place, muscle);
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
  if (fitted.muscles.empty())
    return errorAt("", "no muscle of the set \"" + preset.name + "\" finds its place on this body" +
                           (fitted.leftOut.empty() ? "" : ": " + fitted.leftOut.front().why));
  fitted.rig = withLearnedLengths(std::move(fitted.rig), firstLine, character);
  return fitted;
}

}  // namespace sinew
