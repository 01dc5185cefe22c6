// tests/support/euler_characteristic.h: what tells a sphere from a torus.
#pragma once

#include "core/geometry/weld.h"

namespace sinew {

inline int eulerCharacteristic(const Topology& of) { return of.vertices - of.edges + of.triangles; }

}  // namespace sinew
