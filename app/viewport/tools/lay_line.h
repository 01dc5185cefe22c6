// app/viewport/tools/lay_line.h: a muscle line and its belly between two places on the skin.
#pragma once

#include "app/viewport/tools/select.h"
#include "core/bodies/motions.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// A line, and a muscle on it; the muscle's `line` is the line's name. Neither is in a rig yet.
struct LaidLine {
  MuscleLine line;
  Primitive belly;
};

/// The control mesh in the bind pose, as a surface that rays can meet.
[[nodiscard]] Surface bindSkin(const Character& character);

/// Anchors lie half way from the skin to the axes of the bones below: far enough from a joint to pull at it, and inside
/// the limb in every pose. The belly's long axis (y) reaches from tendon to tendon; its height (z) points away from the
/// bone, and it stands out of the bind pose's skin. All is laid in the bind pose, whatever pose the places were picked
/// in. Error: a bone is flattened in the bind pose, or the places are too near each other.
/// @param skin  bindSkin
[[nodiscard]] Result<LaidLine> layLine(const Character& character, const Surface& skin, const SkinAnchor& from,
                                       const SkinAnchor& to);

/// A laid line that stays in the flesh in all clips.
struct MendedLaidLine {
  LaidLine laid;     ///< Its belly names no line where none would do.
  std::string said;  ///< What was changed; empty: nothing.
};

/// Learns full contraction, and mends what leaves the flesh (core/bodies/mend.h).
[[nodiscard]] Result<MendedLaidLine> mended(const LaidLine& laid, const Motions& motions);

/// The rig with the line and its belly, at the end of Rig::primitives; under symmetry with those of the other side. A
/// line that begins and ends near the mirror plane is laid into it.
/// @param plan  null: without symmetry
[[nodiscard]] Result<Rig> withLaidLine(const Rig& rig, const LaidLine& laid, const MirrorPlan* plan);

}  // namespace sinew::app
