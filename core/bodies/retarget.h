// core/bodies/retarget.h: the muscles of one character on another.
#pragma once

#include <string>
#include <vector>

#include "core/bodies/motions.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

struct Retargeted {
  struct LeftOut {
    std::string name;  ///< Of the muscle.
    std::string why;   ///< "this body has no upperArm.L"
  };
  Rig rig;  ///< Its character is still the first one's.
  std::vector<LeftOut> leftOut;
  std::vector<std::string> mended;  ///< Of each line that was changed: "calf L: pivot 0.3".
};

/// Each muscle at the place of the other body that corresponds to its own (body_map.h), as much larger as the part and
/// its flesh are, with its line, keys, drivers and territory. What has no place there is left out; a driver whose bone
/// has none goes alone. On another body lines learn their lengths anew, and are mended where they leave the flesh; on
/// the same body nothing changes. Error: no muscle finds a place, or the result is no rig.
/// @param motions  of the other character, with the range of motion as a clip
[[nodiscard]] Result<Retargeted> retarget(const Rig& rig, const Character& from, const MirrorPlan& fromPlan,
                                          const Motions& motions, const MirrorPlan& toPlan);

}  // namespace sinew
