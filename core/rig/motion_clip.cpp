// core/rig/motion_clip.cpp: adds the range of motion to a character's clips; sample times of clips.
#include "core/rig/motion_clip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/character/bindings.h"
#include "core/character/body_slots.h"
#include "core/geometry/at.h"

namespace sinew {

int findClip(const Character& character, std::string_view name) {
  const auto found = std::ranges::find(character.clips, name, &AnimationClip::name);
  return found == character.clips.end() ? -1 : static_cast<int>(found - character.clips.begin());
}

namespace {

/// Finds the body parts, by names and places or as the file gives them, and the left side that follows from them.
void addParts(const Character& character, RangeOfMotionHints& hints) {
  const Skeleton& skeleton = character.skeleton;
  const BodySlots found =
      findBodySlots(skeleton, {hints.twinOf, hints.planeNormal, hints.carriesSkin, character.height});
  hints.parts.resize(skeleton.bones.size());
  if (found.kind != BodyKind::kUnknown) hints.left = found.left;
  glm::vec3 toLeft(0.0f);
  for (const BodyPart& part : character.bodyParts) {
    const BodySlot slot = bodySlotNamed(part.slot).value();
    at(hints.parts, part.bone) = slot.slot;
    const glm::vec3 place(at(skeleton.bones, part.bone).bindInWorld[3]);
    if (slot.isSided()) toLeft += slot.side == BodySide::kLeft ? place : -place;
  }
  if (toLeft != glm::vec3(0.0f)) hints.left = normalizeOr(toLeft, {1.0f, 0.0f, 0.0f});
  if (!character.bodyParts.empty()) return;
  for (const BodySlot slot : allBodySlots()) {
    const int bone = found[slot].bone;
    if (bone >= 0 && !at(hints.parts, bone)) at(hints.parts, bone) = slot.slot;
  }
}

RangeOfMotionHints hintsOf(const Character& character, const MirrorPlan& mirror) {
  RangeOfMotionHints hints;
  hints.twinOf = mirror.twinOf;
  hints.planeNormal = glm::vec3(mirror.plane.normal);
  if (!character.mesh.triangles.empty()) hints.carriesSkin = bonesWithSkin(character);
  addParts(character, hints);
  return hints;
}

}  // namespace

RangeOfMotionHints motionHints(const Character& character) { return hintsOf(character, makeMirrorPlan(character)); }

std::shared_ptr<const Character> withRangeOfMotion(std::shared_ptr<const Character> character) {
  if (findClip(*character, kRangeOfMotionName) >= 0) return character;
  const MirrorPlan plan = makeMirrorPlan(*character);
  return withRangeOfMotion(std::move(character), plan);
}

std::shared_ptr<const Character> withRangeOfMotion(std::shared_ptr<const Character> character, const MirrorPlan& plan) {
  if (findClip(*character, kRangeOfMotionName) >= 0) return character;
  AnimationClip clip = rangeOfMotion(character->skeleton, hintsOf(*character, plan));
  if (clip.channels.empty()) return character;
  auto extended = std::make_shared<Character>(*character);
  extended->clips.push_back(std::move(clip));
  return extended;
}

std::shared_ptr<const Character> withClipNamed(std::shared_ptr<const Character> character, const std::string& clip) {
  return clip == kRangeOfMotionName ? withRangeOfMotion(std::move(character)) : character;
}

std::vector<ClipTime> sampleTimes(std::span<const AnimationClip> clips, double most) {
  constexpr float kHertz = 15.0f;
  // A float: a file may give a clip any duration.
  const auto stepsOf = [](const AnimationClip& clip, float hertz) {
    return std::max(1.0f, std::ceil(clip.duration * hertz));
  };
  double all = 0.0;
  for (const AnimationClip& clip : clips) all += static_cast<double>(stepsOf(clip, kHertz));
  const float hertz = all > most ? static_cast<float>(static_cast<double>(kHertz) * most / all) : kHertz;
  std::vector<ClipTime> times;
  for (const AnimationClip& clip : clips) {
    const int steps = static_cast<int>(stepsOf(clip, hertz));
    for (int step = 0; step <= steps; ++step) {
      times.push_back({&clip, clip.duration * static_cast<float>(step) / static_cast<float>(steps)});
    }
  }
  return times;
}

}  // namespace sinew
