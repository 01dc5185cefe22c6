// core/include/sinew/rig/rig_edit.h: every change of a rig, as pure functions rig -> rig.
//
// A rig is taken by value: given a named one, it is copied and the caller's stands; moved in, it is edited where it
// lies. Each result has passed what can break by that edit; an Error names the reason. Indices are into Rig::primitives
// or Rig::groups and must be in range (asserted).
#pragma once

#include <span>
#include <string>

#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Appends; the name is made unique; an empty group becomes the first group, made ("muscles") if there is none. If
/// `mirror` names a primitive of the rig, the two become each other's twins (a former twin is unlinked).
[[nodiscard]] Result<Rig> addPrimitive(Rig rig, Primitive primitive);
/// The same in place. Error: the rig is as it was.
[[nodiscard]] Result<void> append(Rig& rig, Primitive primitive);
/// Removes several, and lines that lose their last primitive; twins of removed ones lose their link.
[[nodiscard]] Rig removePrimitives(Rig rig, std::span<const int> indices);
[[nodiscard]] Result<Rig> setPlacement(Rig rig, int index, const Placement& placement);
[[nodiscard]] Result<Rig> renamePrimitive(Rig rig, int index, const std::string& name);
/// Makes two different primitives each other's twins; former twins are unlinked. Placements stay as they are.
[[nodiscard]] Rig setMirror(Rig rig, int index, int twin);
/// Unlinks the twin, on both sides.
[[nodiscard]] Rig clearMirror(Rig rig, int index);
[[nodiscard]] Result<Rig> addGroup(Rig rig, const std::string& name);
[[nodiscard]] Result<Rig> renameGroup(Rig rig, int group, const std::string& name);
/// Refused while primitives are in it.
[[nodiscard]] Result<Rig> removeGroup(Rig rig, int group);
/// Links or unlinks two different groups.
[[nodiscard]] Result<Rig> setLink(Rig rig, int groupA, int groupB, bool linked);
[[nodiscard]] Result<Rig> setSurface(Rig rig, const SurfaceSettings& surface);
[[nodiscard]] Result<Rig> setSmoothing(Rig rig, const SmoothingSettings& smoothing);

}  // namespace sinew
