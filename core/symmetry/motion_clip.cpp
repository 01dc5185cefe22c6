// core/symmetry/motion_clip.cpp: the range of motion as one more clip.
#include "core/symmetry/motion_clip.h"

#include <algorithm>
#include <utility>

#include "core/character/skin_bones.h"

namespace sinew {

int findClip(const Character& character, std::string_view name) {
  const auto found = std::ranges::find(character.clips, name, &AnimationClip::name);
  return found == character.clips.end() ? -1 : static_cast<int>(found - character.clips.begin());
}

namespace {

RangeOfMotionHints hintsOf(const Character& character, const MirrorPlan& mirror) {
  RangeOfMotionHints hints;
  hints.twinOf = mirror.twinOf;
  hints.planeNormal = glm::vec3(mirror.plane.normal);
  hints.carriesSkin = bonesWithSkin(character);
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

}  // namespace sinew
