// tests/support/euler_characteristic.h: Euler characteristic of a mesh.
#pragma once

#include "core/geometry/weld.h"

namespace sinew {

inline int eulerCharacteristic(const Topology& of) { return of.vertices - of.edges + of.triangles; }

}  // namespace sinew
