// core/rig/bone_motion.h: how far a bone has turned and grown since the bind pose.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace sinew {

struct BoneMotion {
  glm::dmat3 turn{1.0};  ///< World bind -> world now, the rotation nearest to the bone's motion.
  double scale = 1.0;    ///< Cube root of the volume's growth.
  bool moved = false;    ///< The bone's matrix is not that of the bind pose, bit for bit.
  bool usable = true;    ///< False where the bone is flattened or not finite: `turn` is none then.
};

/// The rotation is that of the polar decomposition, so that scale and shear do not turn it.
/// @param bind, inverseBind  bone -> world in the bind pose, and back.
[[nodiscard]] BoneMotion boneMotion(const glm::mat4& bind, const glm::mat4& inverseBind, const glm::mat4& now);

/// The rotation nearest to a matrix that is not flat (Higham's iteration). If it turns space over, the
/// rotation nearest to its negative.
[[nodiscard]] glm::dmat3 nearestRotation(glm::dmat3 matrix);

}  // namespace sinew
