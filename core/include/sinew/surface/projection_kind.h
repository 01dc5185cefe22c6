// core/include/sinew/surface/projection_kind.h: the ways to find the root along a ray.
#pragma once

#include <optional>
#include <string>

#include "sinew/geometry/same_version.h"

namespace sinew {

/// The surface is found by kNewton. The paper's binary search (4.2) and closed form (4.1) are there to compare.
enum class ProjectionKind { kNewton, kBisection, kAnalytic };

/// As on the command line, in reports and in rig files of old.
[[nodiscard]] const char* nameOf(ProjectionKind projection);
[[nodiscard]] std::optional<ProjectionKind> projectionKindNamed(const std::string& name);

}  // namespace sinew
