// core/check/skin_sight.h: what of a surface an eye can see from anywhere outside of it.
#pragma once

#include "core/mesh/triangle_tree.h"
#include "sinew/smoothing/surface.h"

namespace sinew {

class SkinSight {
 public:
  /// All parts of it hide what is behind them.
  explicit SkinSight(const Surface& surface);

  /// Whether any of 256 directions leads away from a place without meeting the surface.
  /// @param normal  any length: directions below it do not count  @param off  distance along it to begin at
  [[nodiscard]] bool isSeen(const glm::vec3& place, const glm::vec3& normal, float off) const;

 private:
  TriangleTree tree_;
};

}  // namespace sinew
