// core/surface/stages.h: what happens to a surface in one pose, in this order.
#pragma once

#include <optional>

#include "core/surface/posed_field.h"
#include "core/surface/workspace.h"

namespace sinew {

/// What a report says before any pose: settings, sizes, counts of muscles.
[[nodiscard]] SmoothingReport reportOf(const Preparation& preparation);

/// The curved patches, shading normals of creased wedges, and a report with what the preparation knows.
void layPatch(const Preparation& preparation, const PosedField& posed, Workspace& workspace, Surface& out);

/// Vertices onto the surface. @param eye  world; control triangles that it cannot see stay on their patches
void project(const Preparation& preparation, const PosedField& posed, const Pose& pose,
             const std::optional<glm::vec3>& eye, Workspace& workspace, Surface& out);

/// Finds what muscles have moved. False: nothing that can fold or has to be shaded anew.
[[nodiscard]] bool findMoved(const Preparation& preparation, const PosedField& posed, Workspace& workspace,
                             const Surface& out);

/// Lowers heights that the posed skin cannot carry, filters those that the mesh cannot follow, then takes folds out.
void unfold(const Preparation& preparation, const PosedField& posed, Workspace& workspace, Surface& out);

/// Cloth follows the skin, which is done but for its normals. @param moved  as findMoved() says
void drape(const Preparation& preparation, bool moved, Workspace& workspace, Surface& out);

/// Normals for shading. @param moved  as findMoved() says
void shade(const Preparation& preparation, bool moved, Workspace& workspace, Surface& out);

}  // namespace sinew
