// core/surface/sampling.h: the surface at points of the control mesh, before any stage that needs neighbors.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/surface/posed_field.h"
#include "core/surface/sampled_part.h"
#include "core/surface/workspace.h"

namespace sinew {

/// Skin, patch and projection at given points, pose after pose.
class SurfaceSampler {
 public:
  /// @param points  of the part's mesh
  SurfaceSampler(const SampledPart& part, Refinement points);

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
