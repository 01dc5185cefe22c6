// core/surface/roots/soft_fall.h: first root on an interval of a ray of a field with soft grooves or links in part.
#pragma once

#include <optional>
#include <vector>

#include "core/rig/field.h"
#include "core/surface/roots/polynomial.h"

namespace sinew {

/// Parts of phi on an interval, mapped to [0, 1].
struct SoftSums {
  Bernstein everywhere;             ///< The skin, carves, -T.
  std::vector<Bernstein> ofSlot;    ///< x_j of GroupBlend.
  std::vector<Bernstein> softness;  ///< y_j
};

struct SoftFallScratch {
  GroupBlend blend;
  std::vector<SoftSums> halves;  ///< [0]: the interval; [i]: a part of it, halved i times.
};

/// First u in [0, 1] at which sense * phi, positive before, becomes <= 0; 0 if it is not positive there. Halves
/// the interval until bounds of its polynomials prove that there is no root, or that phi only falls. A touch does not
/// count. Changes scratch.halves.
[[nodiscard]] std::optional<double> firstSoftFall(const CliqueLevels& levels, double sense, double tolerance,
                                                  BracketSolver solver, SoftFallScratch& scratch);

}  // namespace sinew
