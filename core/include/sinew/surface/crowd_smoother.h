// core/include/sinew/surface/crowd_smoother.h: smooths many poses of one character and rig at once, on all cores.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "sinew/geometry/result.h"
#include "sinew/surface/smoother.h"

namespace sinew {

/// A Smoother for many poses: instances of a crowd, or frames of a clip. Needs memory per thread, not per pose. All
/// surfaces share one Refinement and are those of a Smoother, to the bit, with any number of threads (threads.h).
class CrowdSmoother {
 public:
  explicit CrowdSmoother(std::shared_ptr<const Character> character);
  ~CrowdSmoother();
  CrowdSmoother(CrowdSmoother&&) noexcept;
  CrowdSmoother& operator=(CrowdSmoother&&) noexcept;

  /// See Smoother::prepare().
  [[nodiscard]] Result<void> prepare(const Rig& rig, std::span<const int> hidden = {}, const Region& region = {});

  /// Fills out[i] for poses[i]. prepare() must have succeeded once. Reuses the output's memory. Several threads may
  /// call it at once, each with its own output; none while prepare() runs.
  /// False: some poses are refused (see sinew/character/pose_check.h); their surfaces stay as they are.
  /// @param out  as many as poses
  bool smooth(std::span<const Pose> poses, std::span<Surface> out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew
