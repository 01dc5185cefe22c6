// core/include/sinew/character/body_part.h: body parts and expressions in .vrm files.
#pragma once

#include <string>
#include <vector>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// The bone of a body part, as given in the file.
struct BodyPart {
  std::string slot;  ///< "hips", "upperArm.L": a name of core/character/body_slots.h.
  int bone = 0;      ///< Index into Skeleton::bones.
};

/// An expression: morph targets that are set together. Its weight times `share` is added to each.
struct MorphSet {
  struct Share {
    int target = 0;  ///< Index into Character::morphTargets.
    float share = 1.0f;
  };
  std::string name;
  std::vector<Share> shares;
};

}  // namespace sinew
