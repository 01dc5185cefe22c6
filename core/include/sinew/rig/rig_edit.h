// core/include/sinew/rig/rig_edit.h: edits of a rig as pure functions rig -> rig.
//
// Rigs are taken by value: copied, or edited in place if moved in. Each edit validates what it has changed. Indices are
// into Rig::primitives or Rig::groups and must be in range (asserted).
#pragma once

#include <span>
#include <string>

#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Appends a primitive and makes its name unique. An empty group becomes the first group, or a new one "muscles" if
/// there is none. If `mirror` names a primitive of the rig, the two become twins; a former twin is unlinked.
[[nodiscard]] Result<Rig> addPrimitive(Rig rig, Primitive primitive);
/// The same in place. Error: the rig is not changed.
[[nodiscard]] Result<void> append(Rig& rig, Primitive primitive);
/// Removes primitives, their links to twins, and lines that lose their last primitive. With a belly of a sheet the
/// sheet.
[[nodiscard]] Rig removePrimitives(Rig rig, std::span<const int> indices);
[[nodiscard]] Result<Rig> setPlacement(Rig rig, int index, const Placement& placement);
[[nodiscard]] Result<Rig> renamePrimitive(Rig rig, int index, const std::string& name);
/// Makes two different primitives twins without changing their placements; former twins are unlinked.
[[nodiscard]] Rig setMirror(Rig rig, int index, int twin);
[[nodiscard]] Rig clearMirror(Rig rig, int index);  ///< Unlinks a primitive and its twin.
[[nodiscard]] Result<Rig> addGroup(Rig rig, const std::string& name);
[[nodiscard]] Result<Rig> renameGroup(Rig rig, int group, const std::string& name);
[[nodiscard]] Result<Rig> removeGroup(Rig rig, int group);  ///< Error: primitives are in it.
/// Links two different groups with an amount of 0..1, or unlinks them with 0: then keys and drivers of the amount go.
[[nodiscard]] Result<Rig> setLink(Rig rig, int groupA, int groupB, float amount);
[[nodiscard]] Result<Rig> setSurface(Rig rig, const SurfaceSettings& surface);
[[nodiscard]] Result<Rig> setSmoothing(Rig rig, const SmoothingSettings& smoothing);

}  // namespace sinew
