// core/rig/line_pose.h: muscle lines in a pose: how long, how hard, and what they make of their bellies.
//
// A muscle line is a virtual bone: its deformation takes the bind pose's world to the posed one, as a bone's motion
// does, but stretches with the line and thickens as the line shortens. It is affine, so that an ellipsoid on it stays
// one. Formulas: docs/muscles.md.
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

// The muscle that a line gets where none was drawn: from under the line to over the skin.

/// How far it stands out of the skin, of its half length.
inline constexpr float kBellyBulge = 0.22f;

/// Its long axis (y) lies along the line, its height (z) points out. World.
/// @param middle  on the line  @param along, out  unit, square to each other
/// @param top  from the middle to the highest point  @param half  half its length
[[nodiscard]] inline Placement bellyOnLine(const glm::vec3& middle, const glm::vec3& along, const glm::vec3& out,
                                           float top, float half) {
  constexpr float kThick = 0.55f;      // Half thickness, of `top`.
  constexpr float kLeastThick = 0.2f;  // Of the half length.
  constexpr float kMostThick = 0.5f;
  constexpr float kWide = 1.1f;  // Width over thickness.
  const float thick = std::clamp(kThick * top, kLeastThick * half, kMostThick * half);
  Placement belly;
  belly.center = middle + (top - thick) * out;
  belly.rotation = glm::normalize(glm::quat_cast(glm::mat3(glm::cross(along, out), along, out)));
  belly.radii = {kWide * thick, half, thick};
  return belly;
}

// How far a bone has turned and grown since the bind pose.

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

struct PosedLine {
  glm::mat4 deformation{0.0f};  ///< World of the bind pose -> world now. Zeros: nothing on the line is to be seen.
  glm::vec3 origin{0.0f};       ///< World, as all that follows.
  glm::vec3 via{0.0f};          ///< The middle of the line where it has none.
  glm::vec3 insertion{0.0f};
  glm::vec3 height{0.0f, 0.0f, 1.0f};  ///< Unit: z of the line's frame.
  float stretch = 1.0f;                ///< lambda: length / rest length.
  float bellyStretch = 1.0f;           ///< lambda_b: the same of what is not tendon.
  float activation = 0.0f;             ///< 0..1
  glm::vec3 aside{0.0f};               ///< World: what the via point adds to the deformation's shift (via_bend.h).
  bool usable = false;                 ///< False: missing or flattened bones; the rest is not to be read.
};

/// Memory that is reused from pose to pose.
struct LineScratch {
  std::vector<std::optional<BoneMotion>> motions;  ///< [bones] those that lines ride.
};

/// All lines of a rig in a pose; flexed by Pose::flex. Allocates nothing once `scratch` and `out` have grown.
/// @param lines  [Rig::lines] on the same skeleton; nullopt where there is no line, which is not usable.
void poseLines(std::span<const std::optional<LineRest>> lines, const Skeleton& skeleton, const Pose& pose,
               LineScratch& scratch, std::vector<PosedLine>& out);

/// One line, for those who need no more; the same numbers. @param flex  Pose::flexOf it
[[nodiscard]] PosedLine posedLine(const LineRest& rest, const Skeleton& skeleton, const Pose& pose, float flex = 0.0f);

/// What a primitive rides: its bone's space in the bind pose -> world now.
/// @param line  of the primitive, or -1
[[nodiscard]] glm::mat4 carrierInWorld(int bone, int line, const Skeleton& skeleton, const Pose& pose,
                                       std::span<const PosedLine> lines);

}  // namespace sinew
