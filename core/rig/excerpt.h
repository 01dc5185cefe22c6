// core/rig/excerpt.h: some muscles of a rig as a rig of their own.
#pragma once

#include <span>

#include "sinew/rig/rig.h"

namespace sinew {

/// The primitives with the lines that they ride, the lines and channels that drivers of these read, their groups and
/// the links between these. Links to twins that stay behind are left out, as are drivers of lines that are only read.
/// @param primitives  rig indices, in the order that they get
[[nodiscard]] Rig excerpt(const Rig& rig, std::span<const int> primitives);

}  // namespace sinew
