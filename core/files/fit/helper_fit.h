// core/files/fit/helper_fit.h: rigid helper joints where skinning errs most (decomposition after Le and Deng 2012).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/files/fit/helper_motion.h"
#include "core/files/fit/poses.h"
#include "core/files/fit/weight_fit.h"

namespace sinew::exporting {

struct HelperTask {
  const Skeleton& skeleton;
  std::span<const glm::vec3> rest;                ///< [vertices] the exported bind pose.
  std::span<const std::array<int, 3>> triangles;  ///< Between them.
  std::span<const FitPose> poses;                 ///< All with as many matrices.
  std::span<const HelperJoint> lines;             ///< Joints of lines; matrices of poses: bindings, then these.
  double furtherShare = 1.0;                      ///< Weight of a further pose; others count 1.
  double height = 1.0;                            ///< H.
};

struct HelperResult {
  std::vector<bool> keptLines;       ///< [lines]
  std::vector<HelperJoint> helpers;  ///< Rigid ones.
  std::vector<FourWeights> weights;  ///< Bindings after the skeleton's are the lines kept, then the rigid helpers.
};

/// The best joints of lines and rigid helpers, at most `most`, and weights for all of them and the bindings. In further
/// poses rigid helpers stay at rest. @param start  [vertices] weights of bindings only
[[nodiscard]] HelperResult fitHelpers(const HelperTask& task, std::vector<FourWeights> start, int most,
                                      const StageProgress& progress);

}  // namespace sinew::exporting
