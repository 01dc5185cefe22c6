// tests/support/rigs/rig_edits.h: changes one member of one primitive by the inspector's edit.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/rig/rig_edit.h"

namespace sinew::test {

inline Result<Rig> setReach(const Rig& rig, int index, float reach) {
  return editPrimitives(rig, std::array{index}, [&](Primitive& primitive) { primitive.reach = reach; });
}

inline Result<Rig> setSign(const Rig& rig, int index, int sign) {
  return editPrimitives(rig, std::array{index}, [&](Primitive& primitive) { primitive.sign = sign; });
}

inline Result<Rig> setBone(const Rig& rig, int index, const std::string& bone, const Placement& placement) {
  return editPrimitives(rig, std::array{index}, [&](Primitive& primitive) {
    primitive.bone = bone;
    primitive.placement = placement;
  });
}

inline Result<Rig> setTerritory(const Rig& rig, int index, const std::optional<std::vector<std::string>>& territory) {
  return editPrimitives(rig, std::array{index}, [&](Primitive& primitive) { primitive.territory = territory; });
}

inline Result<Rig> setGroupOf(const Rig& rig, int index, const std::string& group) {
  return setGroupOfSeveral(rig, std::array{index}, group);
}

}  // namespace sinew::test
