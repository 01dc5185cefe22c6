// core/bodies/fit_muscles.cpp: steps of unknowns, their limits, and mirror images.
#include "core/bodies/fit_muscles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"
#include "core/rig/twins.h"

namespace sinew {
namespace {

// Fractions of H, radians, logarithms.
constexpr std::array<double, 4> kDriftUnits{0.03, 0.6, 0.5, 0.5};  ///< Center, rotation, radii, amount.
constexpr std::array<double, 4> kLongestStep{0.01, 0.4, 0.3, 0.3};
constexpr std::array<double, 4> kFarthest{0.08, 1.05, 1.1, 1.6};
constexpr double kLeastFitRadius = 0.004;
constexpr double kMostFitRadius = 0.14;
constexpr float kLeastFitAmount = 0.05f;
constexpr float kInPlane = 1e-3f;

std::size_t kindOf(std::size_t number) { return number < 3 ? 0 : number < 6 ? 1 : number < 9 ? 2 : 3; }

glm::dvec3 shortened(const glm::dvec3& v, double most) {
  const double length = glm::length(v);
  return length > most ? v * (most / length) : v;
}

glm::dvec3 rotationVector(glm::dquat q) {
  if (q.w < 0.0) q = -q;
  const glm::dvec3 axis(q.x, q.y, q.z);
  const double sine = glm::length(axis);
  return sine > 1e-12 ? axis * (2.0 * std::atan2(sine, q.w) / sine) : 2.0 * axis;
}

glm::dquat rotationBy(const glm::dvec3& v) {
  const double angle = glm::length(v);
  return angle > 1e-12 ? glm::angleAxis(angle, v / angle) : glm::dquat(1.0, 0.5 * v.x, 0.5 * v.y, 0.5 * v.z);
}

/// From the follower's rotation about its own axes to the leader's: both are images of each other up to signs of axes.
glm::vec3 turnSigns(const glm::dmat3& leaderInWorld, const glm::dmat3& followerInWorld, const glm::dmat3& reflection) {
  glm::vec3 signs(1.0f);
  for (int i = 0; i < 3; ++i)
    signs[i] = glm::dot(reflection * leaderInWorld[i], followerInWorld[i]) < 0.0 ? -1.0f : 1.0f;
  return signs.x * signs.y * signs.z * signs;
}

}  // namespace

FitMuscles::FitMuscles(const Rig& rig, const Character& character, const MirrorPlan* plan)
    : plan_(plan), height_(static_cast<double>(character.height)) {
  if (plan) {
    const glm::dvec3& n = plan->plane.normal;
    reflection_ = glm::dmat3(1.0) - 2.0 * glm::outerProduct(n, n);
  }
  unknownOf_.assign(rig.primitives.size(), -1);
  isFollower_.assign(rig.primitives.size(), false);
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& primitive = rig.primitives[i];
    const auto bone = character.skeleton.findBone(primitive.bone);
    if (isFollower_[i] || !bone || !primitive.animated.empty() || !(primitive.amount > 0.0f)) continue;
    FitMuscle muscle;
    muscle.leader = static_cast<int>(i);
    muscle.carrier = glm::dmat3(glm::mat3(at(character.skeleton.bones, *bone).bindInWorld));
    muscle.scale = std::cbrt(std::abs(glm::determinant(muscle.carrier)));
    if (!(muscle.scale > 0.0)) continue;
    muscle.start = primitive.placement;
    muscle.startAmount = primitive.amount;
    const int twin = plan ? twinOf(rig, muscle.leader) : -1;
    if (twin >= 0 && at(rig.primitives, twin).animated.empty() && mirroredPrimitive(*plan, primitive)) {
      const Primitive& other = at(rig.primitives, twin);
      const auto otherBone = character.skeleton.findBone(other.bone);
      if (otherBone) {
        const glm::dmat3 own = muscle.carrier * glm::dmat3(glm::mat3_cast(primitive.placement.rotation));
        const glm::dmat3 image = glm::dmat3(glm::mat3(at(character.skeleton.bones, *otherBone).bindInWorld)) *
                                 glm::dmat3(glm::mat3_cast(other.placement.rotation));
        muscle.turns = turnSigns(own, image, reflection_);
        muscle.follower = twin;
        at(unknownOf_, twin) = static_cast<int>(muscles_.size());
        isFollower_[toIndex(twin)] = true;
      }
    } else if (twin < 0 && plan) {
      muscle.staysInPlane = liesInPlane(*plan, primitive, kInPlane);
    }
    unknownOf_[i] = static_cast<int>(muscles_.size());
    muscles_.push_back(muscle);
  }
}

ResidualRow FitMuscles::rowOf(std::span<const HeightChange> changes) const {
  ResidualRow row;
  for (const HeightChange& change : changes) {
    const int unknown = unknownOf(change.primitive);
    if (unknown < 0) continue;
    UnknownChange own{unknown, change.by};
    const FitMuscle& muscle = at(muscles_, unknown);
    if (change.primitive == muscle.follower) {
      const glm::vec3 center = glm::mat3(reflection_) * glm::vec3(own.by[0], own.by[1], own.by[2]);
      for (int k = 0; k < 3; ++k) {
        own.by[static_cast<std::size_t>(k)] = center[k];
        own.by[static_cast<std::size_t>(3 + k)] *= muscle.turns[k];
      }
    }
    row = sumOfRows(row, 1.0f, {own});
  }
  return row;
}

std::vector<double> FitMuscles::drift(const Rig& rig) const {
  std::vector<double> out;
  for (const FitMuscle& muscle : muscles_) {
    const Primitive& now = at(rig.primitives, muscle.leader);
    const glm::dvec3 moved = muscle.carrier * glm::dvec3(now.placement.center - muscle.start.center);
    const glm::dvec3 turned =
        rotationVector(glm::inverse(glm::dquat(muscle.start.rotation)) * glm::dquat(now.placement.rotation));
    const glm::dvec3 grown = glm::log(glm::dvec3(now.placement.radii) / glm::dvec3(muscle.start.radii));
    for (int k = 0; k < 3; ++k) out.push_back(moved[k] / (kDriftUnits[0] * height_));
    for (int k = 0; k < 3; ++k) out.push_back(turned[k] / kDriftUnits[1]);
    for (int k = 0; k < 3; ++k) out.push_back(grown[k] / kDriftUnits[2]);
    out.push_back(std::log(static_cast<double>(now.amount / muscle.startAmount)) / kDriftUnits[3]);
    for (std::size_t k = out.size() - kFitNumbers; k < out.size(); ++k) out[k] *= static_cast<double>(muscle.hold);
  }
  return out;
}

std::vector<double> FitMuscles::driftRates() const {
  std::vector<double> out;
  for (const FitMuscle& muscle : muscles_) {
    for (std::size_t k = 0; k < kFitNumbers; ++k) {
      const double unit = kDriftUnits[kindOf(k)] * (kindOf(k) == 0 ? height_ : 1.0);
      out.push_back(static_cast<double>(muscle.hold) / unit);
    }
  }
  return out;
}

Rig FitMuscles::moved(Rig rig, std::span<const double> step) const {
  for (std::size_t u = 0; u < muscles_.size(); ++u) {
    const FitMuscle& muscle = muscles_[u];
    Primitive& now = at(rig.primitives, muscle.leader);
    Placement& placement = now.placement;
    const std::span<const double> own = step.subspan(u * kFitNumbers, kFitNumbers);
    const glm::dvec3 start = muscle.carrier * glm::dvec3(muscle.start.center);
    glm::dvec3 way = muscle.carrier * glm::dvec3(placement.center) - start;
    way += shortened({own[0], own[1], own[2]}, kLongestStep[0] * height_);
    way = shortened(way, kFarthest[0] * height_);
    placement.center = glm::vec3(glm::inverse(muscle.carrier) * (start + way));
    const glm::dquat startTurn(muscle.start.rotation);
    const glm::dquat turn =
        glm::dquat(placement.rotation) * rotationBy(shortened({own[3], own[4], own[5]}, kLongestStep[1]));
    const glm::dvec3 whole = shortened(rotationVector(glm::inverse(startTurn) * turn), kFarthest[1]);
    placement.rotation = glm::quat(glm::normalize(startTurn * rotationBy(whole)));
    for (int k = 0; k < 3; ++k) {
      const double began = static_cast<double>(muscle.start.radii[k]);
      const double least =
          std::min(began, std::max(began / std::exp(kFarthest[2]), kLeastFitRadius * height_ / muscle.scale));
      const double most =
          std::max(began, std::min(began * std::exp(kFarthest[2]), kMostFitRadius * height_ / muscle.scale));
      const double grown = std::clamp(own[static_cast<std::size_t>(6 + k)], -kLongestStep[2], kLongestStep[2]);
      placement.radii[k] =
          static_cast<float>(std::clamp(static_cast<double>(placement.radii[k]) * std::exp(grown), least, most));
    }
    const double stronger = std::exp(std::clamp(own[9], -kLongestStep[3], kLongestStep[3]));
    now.amount = std::clamp(now.amount * static_cast<float>(stronger), std::min(kLeastFitAmount, muscle.startAmount),
                            std::max(kMostAmount, muscle.startAmount));
    follow(rig, muscle);
  }
  return rig;
}

void FitMuscles::follow(Rig& rig, const FitMuscle& muscle) const {
  Primitive& leader = at(rig.primitives, muscle.leader);
  if (muscle.staysInPlane) {
    if (const auto snapped = snappedToPlane(*plan_, leader, 1.0f)) leader.placement = *snapped;
  }
  if (muscle.follower < 0) return;
  const auto image = mirroredPrimitive(*plan_, leader);
  if (!image) return;
  at(rig.primitives, muscle.follower).placement = image->placement;
  at(rig.primitives, muscle.follower).amount = leader.amount;
}

void FitMuscles::restore(Rig& rig, std::size_t unknown) const {
  const FitMuscle& muscle = muscles_[unknown];
  at(rig.primitives, muscle.leader).placement = muscle.start;
  at(rig.primitives, muscle.leader).amount = muscle.startAmount;
  follow(rig, muscle);
}

}  // namespace sinew
