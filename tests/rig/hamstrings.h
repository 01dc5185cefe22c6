// tests/rig/hamstrings.h: a muscle on a line over the knee of makeTwoLegged(), and its twin.
#pragma once

#include "core/rig/line_edit.h"
#include "core/rig/twins.h"

namespace sinew {

/// Lines and primitives "hamstring L" and "hamstring R", linked.
inline Rig hamstrings(const MirrorPlan& plan) {
  MuscleLine line;
  line.name = "hamstring L";
  line.origin = {"leg L", {0.05f, -0.1f, -0.1f}, {}};
  line.insertion = {"shin L", {0.0f, -0.1f, -0.08f}, {}};
  Primitive belly;
  belly.name = "hamstring L";
  belly.bone = "leg L";
  belly.line = "hamstring L";
  belly.placement.center = {0.02f, -0.3f, -0.1f};
  belly.placement.radii = {0.1f, 0.3f, 0.12f};
  return addPair(addLine({}, line).value(), belly, plan).value();
}

}  // namespace sinew
