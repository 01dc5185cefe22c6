// core/bodies/sheets/lay_sheet.h: the bellies and lines of a sheet on a character's skin. docs/muscles.md, Sheets.
#pragma once

#include <string>
#include <vector>

#include "core/bodies/sheets/sheet_skin.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

struct LaidSheet {
  std::vector<Primitive> bellies;  ///< Strip by strip, from the origin. "name 1.1"
  std::vector<MuscleLine> lines;   ///< One a strip; none without MuscleSheet::line. "name 1"
};

/// The same sheet on the same skin gives the same bits. Error: the character lacks a bone, or the edges coincide.
[[nodiscard]] Result<LaidSheet> laySheet(const MuscleSheet& sheet, const SheetSkin& skin);

/// Amounts of overlapping bellies such that their sum at the top of each is nearly that of one belly alone.
/// @param axes [bellies] columns: half axes, world  @param out  unit, out of the skin  @param reach  of all
[[nodiscard]] std::vector<float> evenAmounts(const std::vector<glm::vec3>& centers, const std::vector<glm::mat3>& axes,
                                             float reach);

/// An edge at `count` places, in the middles of so many equal parts of its length; of a single point the point.
[[nodiscard]] std::vector<glm::vec3> spreadAlong(const std::vector<glm::vec3>& edge, int count);

}  // namespace sinew
