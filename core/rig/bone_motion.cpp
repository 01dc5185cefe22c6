// core/rig/bone_motion.cpp: polar decomposition of a bone's motion.
#include "core/rig/bone_motion.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/flatness.h"
#include "sinew/geometry/geometry.h"

namespace sinew {
namespace {

double farthest(const glm::dmat3& a, const glm::dmat3& b) {
  double most = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) most = std::max(most, std::abs(a[column][row] - b[column][row]));
  }
  return most;
}

}  // namespace

glm::dmat3 nearestRotation(glm::dmat3 matrix) {
  const double determinant = glm::determinant(matrix);
  matrix *= 1.0 / std::cbrt(determinant);  // Also turns over what was turned over.
  constexpr int kMostRounds = 60;          // About seven for a bone; scale of a million to one takes thirty.
  for (int round = 0; round < kMostRounds; ++round) {
    const glm::dmat3 next = 0.5 * (matrix + glm::inverse(glm::transpose(matrix)));
    const double step = farthest(next, matrix);
    matrix = next;
    if (step < 1e-14) break;
  }
  return matrix;
}

BoneMotion boneMotion(const glm::mat4& bind, const glm::mat4& inverseBind, const glm::mat4& now) {
  BoneMotion motion;
  if (now == bind) return motion;
  motion.moved = true;
  const glm::dmat3 linear = glm::dmat3(glm::dmat4(now)) * glm::dmat3(glm::dmat4(inverseBind));
  if (!isFinite(now) || isFlat(linear)) {
    motion.usable = false;
    return motion;
  }
  motion.scale = std::cbrt(std::abs(glm::determinant(linear)));
  motion.turn = nearestRotation(linear);
  return motion;
}

}  // namespace sinew
