#pragma once  // tests/support/oracle_finish.h: fold guard and shading normals of a whole surface, in double.
//
// Written from docs/design.md, "Folds" and "Normals". It shares no code with the smoothing.

#include <vector>

#include "core/smoothing/surface.h"
#include "tests/support/oracle_math.h"

namespace sinew::oracle {

/// What the stages after projection should make of a surface. [V'] each.
struct Finished {
  std::vector<double> kept;  ///< Share of its lift that the fold guard left; 1: left alone.
  std::vector<Vec> positions;
  std::vector<Vec> normals;  ///< For shading, unit.
};

/// @param patch  positions and normals without muscles.  @param raw  the same after projection, before guard and
/// shading.
Finished finish(const Surface& bindPatch, const Surface& patch, const Surface& raw);

/// Of a body that muscles wrap, under `replace`: what projection made stands.
Finished unfinished(const Surface& raw);

}  // namespace sinew::oracle
