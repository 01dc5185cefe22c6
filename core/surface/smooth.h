// core/surface/smooth.h: the pipeline from a preparation and a posed rig to a surface.
#pragma once

#include <optional>

#include "core/surface/posed_field.h"
#include "core/surface/workspace.h"

namespace sinew {

/// Memory of one thread, reused from pose to pose.
struct SmoothingMemory {
  PosedField posed;
  Workspace workspace;
};

/// Skin, patch, projection, folds, cloth, shading normals. Threads may share the preparation, but not the memory.
/// @param rig  posed by preparation->poser in this pose.  @param eye  as in Smoother::smooth
/// @param posingSeconds  time to pose the rig, added to that of the skin
void smooth(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, const Pose& pose,
            const std::optional<glm::vec3>& eye, SmoothingMemory& memory, Surface& out, double posingSeconds = 0.0);

}  // namespace sinew
