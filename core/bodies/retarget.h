// core/bodies/retarget.h: transfers the muscles of one character to another.
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
    std::string name;
    std::string why;  ///< "this body has no upperArm.L"
  };
  Rig rig;  ///< Still names the first character.
  std::vector<LeftOut> leftOut;
  std::vector<std::string> mended;  ///< One entry for each changed line: "calf L: pivot 0.3".
};

/// Moves each muscle to the corresponding place of the other body (body_map.h), scaled with the part and its flesh,
/// with its line, keys, drivers and territory. Muscles and drivers without counterpart are left out. On another body
/// lines learn their lengths again and are mended where they leave the flesh; on the same body nothing changes. Error:
/// no muscle finds a place, or the result is not a valid rig.
/// @param motions  of the other character, with the range of motion as a clip
[[nodiscard]] Result<Retargeted> retarget(const Rig& rig, const Character& from, const MirrorPlan& fromPlan,
                                          const Motions& motions, const MirrorPlan& toPlan);

}  // namespace sinew
