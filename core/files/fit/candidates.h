// core/files/fit/candidates.h: which joints a vertex may follow when its weights are fitted.
#pragma once

#include <vector>

#include "core/files/fit/four_weights.h"
#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::exporting {

/// Up to kMostCandidates (best_weights.h) bindings for each refined vertex: its own as interpolatedWeights() gives
/// them, the four largest first; then the bones of muscles that reach it; then what the vertices around its control
/// triangles follow, the most followed first; then the bones of the skin nearest in the skeleton to that of its largest
/// weight. Every binding once. Error: the rig does not fit the character.
[[nodiscard]] Result<std::vector<std::vector<int>>> weightCandidates(const Character& character, const Rig& rig,
                                                                     const Refinement& refinement,
                                                                     const std::vector<std::vector<Share>>& own);

}  // namespace sinew::exporting
