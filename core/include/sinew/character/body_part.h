// core/include/sinew/character/body_part.h: what a .vrm file says of its character beyond glTF.
#pragma once

#include <string>
#include <vector>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// The file says which bone is this part of the body.
struct BodyPart {
  std::string slot;  ///< "hips", "upperArm.L": a name of core/character/body_slots.h.
  int bone = 0;      ///< Index into Skeleton::bones.
};

/// Morph targets that are set together: an expression. Its weight times `share` is added to each.
struct MorphSet {
  struct Share {
    int target = 0;  ///< Index into Character::morphTargets.
    float share = 1.0f;
  };
  std::string name;
  std::vector<Share> shares;
};

}  // namespace sinew
