// core/include/sinew/rig/line_anchor.h: a point on a bone.
#pragma once

#include <string>

#include "sinew/geometry/geometry.h"

namespace sinew {

/// A point attached to a bone.
struct LineAnchor {
  std::string bone;       ///< Name or path (Skeleton::findBone).
  glm::vec3 point{0.0f};  ///< Bone space.
  std::string unknownKeys;

  friend bool operator==(const LineAnchor&, const LineAnchor&) = default;
};

}  // namespace sinew
