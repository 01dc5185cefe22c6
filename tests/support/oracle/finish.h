// tests/support/oracle/finish.h: folds and shading normals of a whole surface, in double.
//
// Written from docs/design.md, "Folds" and "Normals". It shares no code with the smoothing.
#pragma once

#include <vector>

#include "sinew/surface/surface.h"
#include "tests/support/oracle/math.h"

namespace sinew::oracle {

/// What the stages after projection should make of a surface. [V'] each.
struct Finished {
  std::vector<bool> guarded;  ///< Moved again because a triangle had folded.
  std::vector<Vec> positions;
  std::vector<Vec> normals;  ///< For shading, unit.
};

/// @param patch  positions and normals without muscles.  @param raw  the same after projection, before folds and
/// shading.  @param swells  heights are filtered.
Finished finish(const ControlMesh& mesh, const Surface& bindPatch, const Surface& patch, const Surface& raw,
                bool swells);

/// The surface of a body that muscles wrap, under `replace`: the projection's result as it is.
Finished unfinished(const Surface& raw);

}  // namespace sinew::oracle
