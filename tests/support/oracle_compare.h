#pragma once  // tests/support/oracle_compare.h: a surface against the oracle, with a tally that can be read.

#include <string>

#include "core/smoothing/surface.h"
#include "tests/support/oracle.h"

namespace sinew::oracle {

/// What the comparison of some vertices came to. "Far": more than 1e-4 H from the oracle.
struct Tally {
  int compared = 0;
  int sought = 0;           ///< The oracle looked for a root there.
  int far = 0;              ///< Of the sought.
  int farUnsought = 0;      ///< Of the others, where the surface must be the patch.
  int anotherRoot = 0;      ///< Of the far: the surface lies on a later root of the same ray.
  int nearTangent = 0;      ///< Of the far: |phi| < 1e-4 at the surface, a root that rounding makes or unmakes.
  int unexplained = 0;      ///< Of the far: neither.
  int normalsOff = 0;       ///< More than 1 degree from the oracle's, among the sought that are not far.
  int normalsOnCrease = 0;  ///< Of those: two cliques tie there, so the gradient jumps.
  double worst = 0.0;       ///< Largest distance among those not far, fractions of H.
  std::string firstFar;     ///< The first unexplained one, or else the first far one, in words.

  void add(const Tally& other);
  [[nodiscard]] double farShare() const { return sought > 0 ? static_cast<double>(far) / sought : 0.0; }
  [[nodiscard]] double normalsOffShare() const { return sought > 0 ? static_cast<double>(normalsOff) / sought : 0.0; }
  [[nodiscard]] std::string text() const;
};

/// Compares every `stride`-th vertex from `first` on. The oracle is posed already.
Tally compare(const Oracle& oracle, const Character& character, const Surface& surface, int stride, int first);

}  // namespace sinew::oracle
