// core/files/fit/rigid_motion.h: the rotation and translation that bring points nearest to others.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace sinew::exporting {

/// Sums over pairs of points, from which the best rigid motion follows (Horn 1987, closed form with quaternions).
class RigidMotion {
 public:
  void add(const glm::dvec3& from, const glm::dvec3& to, double weight);
  [[nodiscard]] double weight() const { return weight_; }

  struct Motion {
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< Unit; p -> rotation * p + translation.
    glm::dvec3 translation{0.0};
  };
  /// The least sum of weight * |motion(from) - to|^2. Identity where nothing was added.
  [[nodiscard]] Motion best() const;

 private:
  double weight_ = 0.0;
  glm::dvec3 from_{0.0};
  glm::dvec3 to_{0.0};
  glm::dmat3 products_{0.0};  // Column i: sum of from[i] * to.
};

}  // namespace sinew::exporting
