// core/files/fit/rigid_motion.cpp: the largest eigenvector of a 4 x 4 matrix is the rotation.
#include "core/files/fit/rigid_motion.h"

#include "core/files/fit/own_eigen.h"

namespace sinew::exporting {

void RigidMotion::add(const glm::dvec3& from, const glm::dvec3& to, double weight) {
  weight_ += weight;
  from_ += weight * from;
  to_ += weight * to;
  const glm::dvec3 scaled = weight * to;
  products_[0] += from.x * scaled;
  products_[1] += from.y * scaled;
  products_[2] += from.z * scaled;
}

RigidMotion::Motion RigidMotion::best() const {
  if (!(weight_ > 0.0)) return {};
  const glm::dvec3 from = from_ / weight_;
  const glm::dvec3 to = to_ / weight_;
  // s(i, k): the sum of (from - mean)[i] * (to - mean)[k].
  const auto s = [&](int i, int k) { return products_[i][k] - from_[i] * to[k]; };
  Eigen::Matrix4d n;
  n << s(0, 0) + s(1, 1) + s(2, 2), s(1, 2) - s(2, 1), s(2, 0) - s(0, 2), s(0, 1) - s(1, 0),  //
      s(1, 2) - s(2, 1), s(0, 0) - s(1, 1) - s(2, 2), s(0, 1) + s(1, 0), s(2, 0) + s(0, 2),   //
      s(2, 0) - s(0, 2), s(0, 1) + s(1, 0), s(1, 1) - s(0, 0) - s(2, 2), s(1, 2) + s(2, 1),   //
      s(0, 1) - s(1, 0), s(2, 0) + s(0, 2), s(1, 2) + s(2, 1), s(2, 2) - s(0, 0) - s(1, 1);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(n);
  const Eigen::Vector4d q = solver.eigenvectors().col(3);
  Motion motion;
  motion.rotation = glm::normalize(glm::dquat(q[0], q[1], q[2], q[3]));
  if (motion.rotation.w < 0.0) motion.rotation = -motion.rotation;
  motion.translation = to - motion.rotation * from;
  return motion;
}

}  // namespace sinew::exporting
