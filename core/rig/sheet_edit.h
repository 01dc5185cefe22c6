// core/rig/sheet_edit.h: checks and edits of sheets as pure functions rig -> rig. Indices must be in range (asserted).
// None lays a sheet: what follows from it is made by core/bodies/sheets.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Unique names, ranges, groups that exist, twins.
[[nodiscard]] Result<void> validateSheets(const Rig& rig);

/// Numbers, profiles and line settings. The Error's place begins with `place`.
[[nodiscard]] Result<void> validateSheetSettings(const MuscleSheet& sheet, const std::string& place);

[[nodiscard]] Rig withoutBellies(Rig rig);  ///< Without what follows from sheets.

/// Rig indices of a sheet's bellies, ascending.
[[nodiscard]] std::vector<int> bellies(const Rig& rig, const std::string& sheet);

/// Appends a sheet and makes its name unique; a group that is missing is added. If `mirror` names a sheet of the rig,
/// the two become twins.
[[nodiscard]] Result<Rig> addSheet(Rig rig, MuscleSheet sheet);
/// `change` must not change name and mirror (asserted).
[[nodiscard]] Result<Rig> editSheet(Rig rig, int sheet, const std::function<void(MuscleSheet&)>& change);
/// Also its bellies and lines, and the twin if mirroredName() of the new name is free.
[[nodiscard]] Result<Rig> renameSheet(Rig rig, int sheet, const std::string& name);
/// Removes a sheet with what follows from it. Its twin stays.
[[nodiscard]] Rig removeSheet(Rig rig, int sheet);
/// The bellies and lines of a sheet and of its twin become muscles like any others.
[[nodiscard]] Rig breakIntoStrips(Rig rig, int sheet);

/// Makes the twin of a sheet its image, or adds one. If the name has no side, both get one. Error: see twinBone.
[[nodiscard]] Result<Rig> mirrorSheetToOtherSide(Rig rig, int sheet, const MirrorPlan& plan);
/// Links two different sheets and makes the second the image of the first, except for its name and group.
[[nodiscard]] Result<Rig> linkSheets(Rig rig, int leader, int follower, const MirrorPlan& plan);

// By their bellies, as rig indices of primitives; each sheet once.

/// Replaces the sheets by their images, with names and links kept. Error: see twinBone.
[[nodiscard]] Result<Rig> flipSheetsOf(Rig rig, std::span<const int> bellies, const MirrorPlan& plan);
/// Appends copies with free names; copies of twins are linked.
[[nodiscard]] Rig duplicateSheetsOf(Rig rig, std::span<const int> bellies);
/// Names of the sheets, in the order of the rig.
[[nodiscard]] std::vector<std::string> sheetsOf(const Rig& rig, std::span<const int> primitives);

/// Bellies and lines of sheets that are twins become twins, number by number. Others have none.
[[nodiscard]] Rig withBellyTwins(Rig rig);

/// The mirror image of a sheet, named by imageName(), in the same group, with `mirror` empty. Error: see twinBone.
[[nodiscard]] Result<MuscleSheet> mirroredSheet(const MirrorPlan& plan, const MuscleSheet& sheet);

}  // namespace sinew
