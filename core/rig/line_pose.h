// core/rig/line_pose.h: length, activation and deformation of muscle lines in a pose.
//
// A muscle line is a virtual bone: its deformation takes the world of the bind pose to that of the pose, as the motion
// of a bone, but stretches with the line and thickens as the line shortens. It is affine, so that ellipsoids stay
// ellipsoids. Formulas: docs/muscles.md.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "core/rig/line_rest.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/ellipsoid.h"

namespace sinew {

/// How far a new belly stands out of the skin, fraction of its half length.
inline constexpr float kBellyBulge = 0.22f;

/// A new belly on a line, from below the line to above the skin: y along the line, z outwards. World.
/// @param middle  on the line  @param along, out  unit, perpendicular
/// @param top  from the middle to the highest point  @param half  half length
[[nodiscard]] inline Placement bellyOnLine(const glm::vec3& middle, const glm::vec3& along, const glm::vec3& out,
                                           float top, float half) {
  constexpr float kThick = 0.55f;      // Half thickness, fraction of `top`.
  constexpr float kLeastThick = 0.2f;  // Fractions of the half length.
  constexpr float kMostThick = 0.5f;
  constexpr float kWide = 1.1f;  // Width over thickness.
  const float thick = std::clamp(kThick * top, kLeastThick * half, kMostThick * half);
  Placement belly;
  belly.center = middle + (top - thick) * out;
  belly.rotation = glm::normalize(glm::quat_cast(glm::mat3(glm::cross(along, out), along, out)));
  belly.radii = {kWide * thick, half, thick};
  return belly;
}

/// Rotation and scale of a bone since the bind pose.
struct BoneMotion {
  glm::dmat3 turn{1.0};  ///< World bind -> world now, the nearest rotation.
  double scale = 1.0;    ///< Cube root of the change of volume.
  bool moved = false;    ///< The bone's matrix differs from that of the bind pose.
  bool usable = true;    ///< False: the bone is flat or not finite, and `turn` is not valid.
};

/// The rotation is that of the polar decomposition, so that scale and shear do not affect it.
/// @param bind, inverseBind  bone -> world in the bind pose, and back.
[[nodiscard]] BoneMotion boneMotion(const glm::mat4& bind, const glm::mat4& inverseBind, const glm::mat4& now);

/// The rotation nearest to a matrix that is not flat (Higham's iteration), or to its negative if it is a reflection.
[[nodiscard]] glm::dmat3 nearestRotation(glm::dmat3 matrix);

struct PosedLine {
  glm::mat4 deformation{0.0f};  ///< World of the bind pose -> world now. Zeros: muscles on the line are invisible.
  glm::vec3 origin{0.0f};       ///< World, as the following.
  glm::vec3 via{0.0f};          ///< The middle of a line without via point.
  glm::vec3 insertion{0.0f};
  glm::vec3 height{0.0f, 0.0f, 1.0f};  ///< z of the line's frame, unit.
  float stretch = 1.0f;                ///< lambda: length / rest length.
  float bellyStretch = 1.0f;           ///< lambda_b: the same without the tendons.
  float activation = 0.0f;             ///< 0..1
  glm::vec3 aside{0.0f};               ///< World: shift of the deformation by the via point (core/rig/posed_rig.h).
  bool usable = false;                 ///< False: bones are missing or flat; other members are not valid.
};

/// Memory that is reused from pose to pose.
struct LineScratch {
  std::vector<std::optional<BoneMotion>> motions;  ///< [bones] that carry lines.
};

/// All lines of a rig in a pose, with Pose::flex. Allocates nothing once `scratch` and `out` have grown.
/// @param lines  [Rig::lines] on the same skeleton; nullopt gives a line that is not usable.
void poseLines(std::span<const std::optional<LineRest>> lines, const Skeleton& skeleton, const Pose& pose,
               LineScratch& scratch, std::vector<PosedLine>& out);

/// One line, with the same result. @param flex  Pose::flexOf() the line
[[nodiscard]] PosedLine posedLine(const LineRest& rest, const Skeleton& skeleton, const Pose& pose, float flex = 0.0f);

/// Bone space in the bind pose -> world now, for primitives on a bone and a line. @param line  -1: none
[[nodiscard]] glm::mat4 carrierInWorld(int bone, int line, const Skeleton& skeleton, const Pose& pose,
                                       std::span<const PosedLine> lines);

}  // namespace sinew
