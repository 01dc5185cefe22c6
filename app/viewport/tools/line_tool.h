// app/viewport/tools/line_tool.h: adds muscle lines by drags from the skin of one bone to that of another.
#pragma once

#include <memory>
#include <optional>

#include "app/viewport/tools/select.h"
#include "app/viewport/tools/viewport_input.h"
#include "core/bodies/motions.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// A line and a muscle on it, not in a rig yet.
struct LaidLine {
  MuscleLine line;
  Primitive belly;
};

[[nodiscard]] Surface bindSkin(const Character& character);  ///< The control mesh in the bind pose as a surface.

/// In the bind pose. Anchors lie half way from the skin to the axes of the bones below: far enough from the joint, and
/// inside the limb in every pose. The belly's y axis spans the tendons, its z axis points away from the bone, and it
/// protrudes from the skin. Error: a bone is flattened in the bind pose, or the places are too near.
/// @param skin  bindSkin
[[nodiscard]] Result<LaidLine> layLine(const Character& character, const Surface& skin, const SkinAnchor& from,
                                       const SkinAnchor& to);

struct MendedLaidLine {
  LaidLine laid;     ///< The belly has no line if none stays in the flesh.
  std::string said;  ///< Changes, for the user; or empty.
};

/// Learns full contraction, and keeps the line in the flesh in all clips (core/bodies/mend.h).
[[nodiscard]] Result<MendedLaidLine> mended(const LaidLine& laid, const Motions& motions);

/// Adds the line and its belly, with twins unless the plan is null. A line near the mirror plane is moved into it.
[[nodiscard]] Result<Rig> withLaidLine(const Rig& rig, const LaidLine& laid, const MirrorPlan* plan);

/// A gesture in progress; the pose is held.
struct LineDrag {
  Surface skin;  ///< At the press.
  Surface bindSkin;
  SkinAnchor start;
  int startBone = -1;
  int endBone = -1;  ///< Under the pointer; -1: none.
  glm::vec2 pressPixel{0.0f};
  std::optional<LaidLine> laid;  ///< Shown.
  Selection selectionBefore;
  std::shared_ptr<const Rig> rigBefore;
};

struct LineToolState {
  std::optional<LineDrag> drag;
};

}  // namespace sinew::app
