// core/rig/rig_edit.h: every change of a rig, as pure functions rig -> rig.
//
// Nothing here touches the rig it is given. Each result has passed what can break by that edit; an Error names the
// reason and the caller's rig stands. Indices are into Rig::primitives or Rig::groups and must be in range (asserted).
#pragma once

#include <span>
#include <string>

#include "sinew/base/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Appends; the name is made unique; an empty group becomes the first group, made ("muscles") if there is none. If
/// `mirror` names a primitive of the rig, the two become each other's twins (a former twin is unlinked).
[[nodiscard]] Result<Rig> addPrimitive(const Rig& rig, Primitive primitive);
/// Removes several, and lines that lose their last primitive; twins of removed ones lose their link.
[[nodiscard]] Rig removePrimitives(const Rig& rig, std::span<const int> indices);
[[nodiscard]] Result<Rig> setPlacement(const Rig& rig, int index, const Placement& placement);
[[nodiscard]] Result<Rig> renamePrimitive(const Rig& rig, int index, const std::string& name);
/// Makes two different primitives each other's twins; former twins are unlinked. Placements stay as they are.
[[nodiscard]] Rig setMirror(const Rig& rig, int index, int twin);
/// Unlinks the twin, on both sides.
[[nodiscard]] Rig clearMirror(const Rig& rig, int index);
[[nodiscard]] Result<Rig> addGroup(const Rig& rig, const std::string& name);
[[nodiscard]] Result<Rig> renameGroup(const Rig& rig, int group, const std::string& name);
/// Refused while primitives are in it.
[[nodiscard]] Result<Rig> removeGroup(const Rig& rig, int group);
/// Links or unlinks two different groups.
[[nodiscard]] Result<Rig> setLink(const Rig& rig, int groupA, int groupB, bool linked);
[[nodiscard]] Result<Rig> setSurface(const Rig& rig, const SurfaceSettings& surface);
[[nodiscard]] Result<Rig> setSmoothing(const Rig& rig, const SmoothingSettings& smoothing);

}  // namespace sinew
