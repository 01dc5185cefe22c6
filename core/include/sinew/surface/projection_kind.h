// core/include/sinew/surface/projection_kind.h: methods to find the root along a ray.
#pragma once

#include <optional>
#include <string>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Surfaces are made by kNewton. The paper's binary search (4.2) and closed form (4.1) are for comparison.
enum class ProjectionKind { kNewton, kBisection, kAnalytic };

/// Names on the command line, in reports and in old rig files.
[[nodiscard]] const char* nameOf(ProjectionKind projection);
[[nodiscard]] std::optional<ProjectionKind> projectionKindNamed(const std::string& name);

}  // namespace sinew
