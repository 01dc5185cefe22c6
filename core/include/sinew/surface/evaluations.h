// core/include/sinew/surface/evaluations.h: how much work the search for roots was.
#pragma once

#include <cstdint>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Counted along projection rays alone; what every projection does the same (F on the skin, normals) is left out.
struct Evaluations {
  std::int64_t field = 0;    ///< phi from its primitives: at a point, or a stretch of the ray made into quartics.
  std::int64_t quartic = 0;  ///< A quartic of a stretch: its value, a halving of it, or its roots in closed form.
};

}  // namespace sinew
