// core/surface/roots/soft_fall.h: first root on an interval of a ray of a field with soft grooves or links in part.
#pragma once

#include <optional>
#include <vector>

#include "core/rig/field.h"
#include "core/surface/roots/polynomial.h"

namespace sinew {

/// A group that a term on the interval is in.
struct SoftPart {
  int slot = 0;
  Bernstein sum;       ///< x_j of GroupBlend.
  Bernstein softness;  ///< y_j
};

/// Parts of phi on an interval, mapped to [0, 1].
struct SoftSums {
  Bernstein everywhere;  ///< The skin, carves, -T.
  std::vector<SoftPart> parts;

  SoftPart& of(int slot);  ///< A new one with sums 0, or the one it has.
};

/// Bounds of a number.
struct Extent {
  double low = 0.0;
  double high = 0.0;
};

struct SoftPartBounds {
  Extent sum;
  Extent slope;
  Extent softness;
  Extent softnessSlope;
  int holders = 0;  ///< Cliques that may have a share and hold the slot.
};

/// x_j and y_j at one place.
struct SoftSample {
  ValueAndSlope sum;
  ValueAndSlope softness;
};

struct SoftFallScratch {
  std::vector<GroupBlend> blends;      ///< For each level.
  std::vector<SoftSums> halves;        ///< [0]: the interval; [i]: a part of it, halved i times.
  std::vector<SoftPartBounds> bounds;  ///< Of each slot.
  std::vector<int> sharing;            ///< Cliques that may have a share.
  std::vector<SoftSample> samples;     ///< Of each part.
};

/// First u in [0, 1] at which sense * phi, positive before, becomes <= 0; 0 if it is not positive there. Halves
/// the interval until bounds of its polynomials prove that there is no root, or that phi only falls. A touch does not
/// count. Changes scratch.halves.  @param levels  those that scratch.blends were started with.
[[nodiscard]] std::optional<double> firstSoftFall(CliqueLevelsView levels, double sense, double tolerance,
                                                  BracketSolver solver, SoftFallScratch& scratch);

}  // namespace sinew
