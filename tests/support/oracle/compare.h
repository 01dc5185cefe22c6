// tests/support/oracle/compare.h: comparison of a surface with the oracle, with a readable tally.
#pragma once

#include <string>

#include "sinew/surface/surface.h"
#include "tests/support/oracle/finish.h"
#include "tests/support/oracle/oracle.h"

namespace sinew::oracle {

/// Stages of a surface: the finisher's input, and its result.
struct Stages {
  const Surface& patch;  ///< Without muscles.
  const Surface& raw;    ///< Projected, before folds and shading.
  Finished finished;

  Stages(const Oracle& oracle, const Surface& bindPatch, const Surface& patchOf, const Surface& rawOf)
      : patch(patchOf),
        raw(rawOf),
        finished(oracle.standsAsProjected() ? unfinished(rawOf)
                                            : finish(oracle.mesh(), bindPatch, patchOf, rawOf, oracle.swells())) {}
};

/// Result of comparing some vertices. "Far": more than 1e-4 H from the oracle. Vertices moved by folds are compared
/// with the oracle before, and with the finisher after that.
struct Tally {
  int compared = 0;
  int sought = 0;            ///< The oracle looked for a root there.
  int far = 0;               ///< Sought ones away from the oracle's surface.
  int rough = 0;             ///< Sought ones that are not far, but more than 1e-5 H away.
  int farUnsought = 0;       ///< The same among the others, where the surface must be the patch.
  int anotherRoot = 0;       ///< Far ones whose surface lies on a later root of the same ray.
  int nearTangent = 0;       ///< Far ones with |phi| < 1e-4 at the surface, a root that rounding makes or unmakes.
  int unexplained = 0;       ///< Far ones of neither kind.
  int guarded = 0;           ///< The finisher moves it out of a fold.
  int guardOff = 0;          ///< Guarded ones more than 1e-4 H from the finisher's position.
  int shadingOff = 0;        ///< Vertices whose normal is more than 1 degree from the finisher's.
  int inGrooves = 0;         ///< Vertices in soft grooves.
  int whereGroovesMeet = 0;  ///< Those between more than two groups.
  int normalsOff = 0;        ///< Field normals more than 1 degree from the oracle's, among the sought that are not far.
  int normalsOnCrease = 0;   ///< Those where two cliques tie, so the gradient jumps.
  double worstShading = 0.0;  ///< Degrees: largest angle of the surface's normal to the finisher's.
  double worst = 0.0;         ///< Largest distance among those not far, fractions of H.
  std::string firstFar;       ///< The first unexplained one, or else the first far one, in words.
  std::string firstOff;       ///< The first vertex whose guard, shading or field normal is off.

  void add(const Tally& other);
  [[nodiscard]] double farShare() const { return sought > 0 ? static_cast<double>(far) / sought : 0.0; }
  [[nodiscard]] double roughShare() const { return sought > 0 ? static_cast<double>(rough) / sought : 0.0; }
  [[nodiscard]] double normalsOffShare() const { return sought > 0 ? static_cast<double>(normalsOff) / sought : 0.0; }
  [[nodiscard]] std::string text() const;
};

/// Compares every `stride`-th vertex from `first` on. The oracle is posed already; the stages are of the same pose.
Tally compare(const Oracle& oracle, const Character& character, const Stages& stages, const Surface& surface,
              int stride, int first);

}  // namespace sinew::oracle
