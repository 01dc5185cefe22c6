// tests/support/surface/vector_agreement.h: the vector path of projection held to the scalar one.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/geometry/instruction_set.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {

inline constexpr double kAgreement = 1e-4;  ///< Fraction of H that docs/design.md promises.
inline constexpr double kAim = 1e-6;

struct Agreement {
  int projected = 0;
  int uncertified = 0;
  int far = 0;         ///< Beyond kAgreement.
  int beyondAim = 0;   ///< Beyond kAim.
  double worst = 0.0;  ///< Fraction of H.
  double worstNormal = 0.0;

  [[nodiscard]] double uncertifiedShare() const {
    return static_cast<double>(uncertified) / static_cast<double>(std::max(projected, 1));
  }
};

/// By one instruction set.
[[nodiscard]] Surface surfaceBy(InstructionSet set, Projected& projected, const Pose& pose);

/// Compares the poses' surfaces by the chosen set with the scalar ones.
void addAgreement(const Character& character, const Rig& rig, const std::vector<Pose>& poses, Agreement& out);

void print(const std::string& what, const Agreement& seen);

}  // namespace sinew::test
