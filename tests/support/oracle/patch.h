// tests/support/oracle/patch.h: curved patches in double, written from their papers.
#pragma once

#include <array>

#include "sinew/rig/rig.h"
#include "tests/support/oracle/math.h"

namespace sinew::oracle {

/// Corners of a control triangle with unit normals.
struct Corners {
  std::array<Vec, 3> position;
  std::array<Vec, 3> normal;
};

struct PatchPoint {
  Vec position;
  Vec normal;  ///< Unit.
};

/// Whether patchPoint knows the kind (spherigons have several readings and are tested by their properties).
bool knowsPatch(PatchKind kind);

/// `pn`: Vlachos, Peters, Boyd & Mitchell 2001, cubic position and quadratic normal. `phong`: Boubekeur & Alexa 2008,
/// alpha 3/4, interpolated normal. `flat`: barycentric position and normal.
PatchPoint patchPoint(PatchKind kind, const Corners& corners, const std::array<double, 3>& barycentric);

/// Barycentric position and renormalized barycentric normal.
PatchPoint flatPoint(const Corners& corners, const std::array<double, 3>& barycentric);

}  // namespace sinew::oracle
