// core/smoothing/sampling.h: the surface at points of the control mesh, before any stage that needs neighbors.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/smoothing/posed_field.h"
#include "core/smoothing/workspace.h"

namespace sinew {

/// Skin, patch and projection at given points, pose after pose.
class SurfaceSampler {
 public:
  /// @param next  attached, with its candidates; the rest is made for the points
  /// @param skipped [V+E+T] 1: the carrier's points are left on their patches
  SurfaceSampler(const Preparation& next, Refinement points, std::vector<std::uint8_t> skipped);

  /// Valid until the next call.
  [[nodiscard]] const Surface& sample(const Pose& pose);

 private:
  std::shared_ptr<const Preparation> preparation_;
  std::vector<std::uint8_t> skipped_;
  PosedRig rig_;
  PosedField posed_;
  Workspace workspace_;
  Surface surface_;
};

}  // namespace sinew
