// core/include/sinew/files/exported_surface.h: plays the vertices of an exported file.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "sinew/character/pose.h"
#include "sinew/geometry/geometry.h"

namespace sinew {

/// The joints, weights, keys and targets of an export, without the file.
class ExportedSurface {
 public:
  virtual ~ExportedSurface() = default;

  /// Positions at any time of a clip, linear between keys as in glTF. Joints without keys in the clip are at rest.
  /// @param pose  of the character's skeleton at that time  @param out  [vertices] world
  virtual void place(const Pose& pose, const std::string& clip, float time, std::vector<glm::vec3>& out) const = 0;

  std::vector<glm::vec3> rest;  ///< [vertices] bind pose, world; the first vertices of the live surface.
  std::vector<std::array<int, 3>> triangles;
  std::vector<float> largest;  ///< [vertices] largest distance to the live surface in the clips, percent of the height.
};

}  // namespace sinew
