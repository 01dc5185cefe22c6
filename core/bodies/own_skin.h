// core/bodies/own_skin.h: the skin that goes with one bone.
#pragma once

#include <optional>
#include <vector>

#include "core/bodies/skin_track.h"

namespace sinew {

/// A triangle, and a frame at its middle in the bind pose.
struct OwnTriangle {
  int triangle = 0;
  SkinFrame frame;
  float weight = 0.0f;  ///< Of the bone, the least of the corners'.
};

/// Triangles that a bone carries: those whose every corner has nearly as much of it as any has.
class OwnSkin {
 public:
  OwnSkin(const Character& character, int bone);

  [[nodiscard]] int bone() const { return bone_; }
  /// Empty: no skin follows the bone to speak of.
  [[nodiscard]] const std::vector<OwnTriangle>& firm() const { return firm_; }
  /// Mean of their middles.
  [[nodiscard]] const glm::vec3& middle() const { return middle_; }
  /// The nearest place to a point of the bind pose, also where the skin half follows other bones.
  [[nodiscard]] std::optional<SkinFrame> nearest(const glm::vec3& point) const;

 private:
  const Character& character_;
  int bone_;
  std::vector<OwnTriangle> half_;
  std::vector<OwnTriangle> firm_;
  glm::vec3 middle_{0.0f};
};

}  // namespace sinew
