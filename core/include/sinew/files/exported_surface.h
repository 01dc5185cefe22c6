// core/include/sinew/files/exported_surface.h: where an exported file puts its vertices, as a program plays it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sinew/character/pose.h"
#include "sinew/geometry/geometry.h"

namespace sinew {

/// The joints, weights, keys and targets that an export has written, without the file.
class ExportedSurface {
 public:
  virtual ~ExportedSurface() = default;

  /// At any time of a clip, between keys as glTF says: linear. Joints without keys in the clip rest.
  /// @param pose  of the character's skeleton then  @param out  [vertices] world
  virtual void place(const Pose& pose, const std::string& clip, float time, std::vector<glm::vec3>& out) const = 0;

  std::vector<glm::vec3> rest;                ///< [vertices] bind pose, world. The live surface's first so many.
  std::vector<std::array<int, 3>> triangles;  ///< Between them.
  std::vector<float> largest;  ///< [vertices] largest distance to the live surface in the clips, percent of the height.
};

}  // namespace sinew
