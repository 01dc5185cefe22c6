// core/symmetry/motion_clip.cpp: the range of motion as one more clip.
#include "core/symmetry/motion_clip.h"

#include <algorithm>
#include <utility>

#include "core/character/skin_bones.h"
#include "core/skeleton/range_of_motion.h"
#include "core/symmetry/mirror.h"

namespace sinew {

int findClip(const Character& character, std::string_view name) {
  const auto found = std::ranges::find(character.clips, name, &AnimationClip::name);
  return found == character.clips.end() ? -1 : static_cast<int>(found - character.clips.begin());
}

std::shared_ptr<const Character> withRangeOfMotion(std::shared_ptr<const Character> character) {
  if (findClip(*character, kRangeOfMotionName) >= 0) return character;
  const MirrorPlan mirror = makeMirrorPlan(*character);
  RangeOfMotionHints hints;
  hints.twinOf = mirror.twinOf;
  hints.planeNormal = glm::vec3(mirror.plane.normal);
  hints.carriesSkin = bonesWithSkin(*character);
  AnimationClip clip = rangeOfMotion(character->skeleton, hints);
  if (clip.channels.empty()) return character;
  auto extended = std::make_shared<Character>(*character);
  extended->clips.push_back(std::move(clip));
  return extended;
}

std::shared_ptr<const Character> withClipNamed(std::shared_ptr<const Character> character, const std::string& clip) {
  return clip == kRangeOfMotionName ? withRangeOfMotion(std::move(character)) : character;
}

}  // namespace sinew
