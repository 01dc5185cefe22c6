// core/surface/smooth.h: the pipeline: a preparation, a posed rig and scratch memory make a surface.
#pragma once

#include <optional>

#include "core/surface/posed_field.h"
#include "core/surface/workspace.h"

namespace sinew {

/// What one thread keeps from pose to pose.
struct SmoothingMemory {
  PosedField posed;
  Workspace workspace;
};

/// Skin, patch, project, remove folds, lay cloth over, shading normals. Threads may share the preparation, each with
/// memory of its own.
/// @param rig  posed by preparation->poser in this pose.  @param eye  as in Smoother::smooth
/// @param posingSeconds  what posing the rig took: counted with the skin
void smooth(const std::shared_ptr<const Preparation>& preparation, const PosedRig& rig, const Pose& pose,
            const std::optional<glm::vec3>& eye, SmoothingMemory& memory, Surface& out, double posingSeconds = 0.0);

}  // namespace sinew
