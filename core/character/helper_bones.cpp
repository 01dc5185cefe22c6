// core/character/helper_bones.cpp: bones that move no skin.
#include "core/character/helper_bones.h"

#include <algorithm>

#include "core/geometry/at.h"

namespace sinew {

std::vector<bool> bonesThatMoveSkin(const Skeleton& skeleton, const std::vector<bool>& carriesSkin) {
  const std::size_t count = skeleton.bones.size();
  std::vector<bool> moves = carriesSkin;
  moves.resize(count, carriesSkin.empty());
  // Children stand behind their parents.
  for (std::size_t i = count; i-- > 0;) {
    if (moves[i] && skeleton.bones[i].parent >= 0) at(moves, skeleton.bones[i].parent) = true;
  }
  return moves;
}

std::vector<bool> helperBones(const Skeleton& skeleton, const std::vector<bool>& carriesSkin) {
  std::vector<bool> helpers = bonesThatMoveSkin(skeleton, carriesSkin);
  helpers.flip();
  if (std::ranges::find(helpers, false) == helpers.end()) helpers.flip();
  return helpers;
}

}  // namespace sinew
