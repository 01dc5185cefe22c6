#pragma once  // core/rig/validation.h: what makes a rig a rig, in one place for files and editor alike.

#include "core/base/result.h"
#include "core/rig/rig.h"

namespace sinew {

inline constexpr int kMaxPrimitives = 65536;

/// Checks ranges, finiteness, unique names, that groups and mirrors exist, and the blending graph's size.
/// Bones are not checked: a rig may meet another character. The Error's place is a JSON path such as
/// "primitives[2].radii[1]"; its reason says what was expected.
[[nodiscard]] Result<void> validate(const Rig& rig);

}  // namespace sinew
