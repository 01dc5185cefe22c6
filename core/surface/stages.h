// core/surface/stages.h: the stages of a surface in one pose, in this order.
#pragma once

#include <optional>

#include "core/surface/posed_field.h"
#include "core/surface/workspace.h"

namespace sinew {

/// The report without a pose: settings, sizes, counts of muscles.
[[nodiscard]] SmoothingReport reportOf(const Preparation& preparation);

/// Lays the curved patches, shades creased wedges and starts the report.
void layPatch(const Preparation& preparation, const PosedField& posed, Workspace& workspace, Surface& out);

/// Moves vertices onto the surface.  @param eye  as in Smoother::smooth
void project(const Preparation& preparation, const PosedField& posed, const Pose& pose,
             const std::optional<glm::vec3>& eye, Workspace& workspace, Surface& out);

/// Finds triangles moved by muscles. False: none that can fold or need new shading.
[[nodiscard]] bool findMoved(const Preparation& preparation, const PosedField& posed, Workspace& workspace,
                             const Surface& out);

/// Lowers heights that the posed skin cannot carry, filters those that the mesh cannot follow, then removes folds.
void unfold(const Preparation& preparation, const PosedField& posed, Workspace& workspace, Surface& out);

/// Moves cloth with the skin, which is finished except for normals. @param moved  result of findMoved()
void drape(const Preparation& preparation, bool moved, Workspace& workspace, Surface& out);

/// Makes normals for shading. @param moved  result of findMoved()
void shade(const Preparation& preparation, bool moved, Workspace& workspace, Surface& out);

}  // namespace sinew
