// core/files/fit/helper_fit.h: rigid helper joints where joints and weights leave the most error: linear blend
// skinning decomposed, the character's own joints given (after Le and Deng 2012).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/files/fit/four_weights.h"
#include "core/files/fit/helper_motion.h"
#include "core/files/fit/poses.h"

namespace sinew::exporting {

/// What helpers are fitted to.
struct HelperTask {
  const Skeleton& skeleton;
  std::span<const glm::vec3> rest;                ///< [vertices] the bind pose that is exported.
  std::span<const std::array<int, 3>> triangles;  ///< Between them.
  std::span<const FitPose> poses;                 ///< All with as many matrices.
  std::span<const HelperJoint> lines;             ///< Their joints; matrices of poses: bindings, then these.
  double furtherShare = 1.0;                      ///< What a further pose counts, where any other counts 1.
  double height = 1.0;                            ///< H.
};

struct HelperResult {
  std::vector<bool> keptLines;       ///< [lines]
  std::vector<HelperJoint> helpers;  ///< Rigid ones.
  std::vector<FourWeights> weights;  ///< Bindings after the skeleton's are the lines kept, then the rigid helpers.
};

/// At most `most` joints, of lines and rigid ones, whatever serves best, and weights for all that there is. In further
/// poses a rigid helper stays at rest on its bone.
/// @param start  [vertices] weights of bindings alone
[[nodiscard]] HelperResult fitHelpers(const HelperTask& task, std::vector<FourWeights> start, int most,
                                      const StageProgress& progress);

}  // namespace sinew::exporting
