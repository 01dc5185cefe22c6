// core/rig/line_rest.h: a muscle line in the bind pose: what its poses are measured against. Made once per edit.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/muscle_line.h"
#include "sinew/rig/rig.h"

namespace sinew {

// How a muscle answers to the length of its line.

/// What of the girth does not depend on the pose.
struct GirthRest {
  double volume = 1.0;
  double least = 1.0;   ///< -ln of the stretch towards which girth levels off when the belly shortens.
  double most = 1.0;    ///< ln of that when it lengthens.
  double inBind = 0.0;  ///< Softened logarithm of the belly stretch in the bind pose.
};

[[nodiscard]] GirthRest girthRest(const LineSettings& settings);

/// Girth from belly stretch, both against the bind pose (omega; Scheepers' closed form where volume is 1).
[[nodiscard]] double girth(double bellyStretch, const GirthRest& rest);
/// What tendons leave of the rest length.
[[nodiscard]] double bellyShare(const LineSettings& settings);
/// Belly stretch of a line's stretch: tendons keep their length.
[[nodiscard]] double bellyStretch(double stretch, const LineSettings& settings);
/// Activation of a line's stretch, 0..1. @param added  to its base
[[nodiscard]] double activation(double stretch, const LineSettings& settings, double added);

// The curves of tendons and muscle lines as they are drawn.

/// World. A line without a via point is straight.
struct LinePath {
  glm::vec3 origin{0.0f};
  std::optional<glm::vec3> via;
  glm::vec3 insertion{0.0f};

  friend bool operator==(const LinePath&, const LinePath&) = default;
};

/// A cubic Bezier curve, a part of a tendon.
struct TendonPart {
  std::array<glm::vec3, 4> curve{};
  glm::vec2 share{0.0f, 1.0f};  ///< Part of the tendon's length at both ends; 0 in the belly, 1 at the anchor.
};

/// A tendon from inside the end of its belly to an anchor.
struct Tendon {
  std::vector<TendonPart> parts;  ///< One, or two that meet in the via point with one direction.
  float length = 0.0f;            ///< Sum of straight segments through its ends and the via point.
  float side = 1.0f;              ///< Which end of the belly's y axis: +1, -1.
};

/// Where a tendon begins, of the belly's half length from its middle.
inline constexpr float kTendonStart = 0.8f;

/// Those of one belly: at the origin, at the insertion. None at an anchor that lies in the belly or beside it.
/// @param bellyInWorld  unit ball -> world, y along the fibres
/// @param bend  Shape::bend of the belly
[[nodiscard]] std::vector<Tendon> tendonsOf(const glm::mat4& bellyInWorld, const LinePath& line,
                                            const glm::vec2& bend = glm::vec2(0.0f));

/// Points from origin to insertion, through the via point as a soft curve.
[[nodiscard]] std::vector<glm::vec3> pointsAlong(const LinePath& line);

/// A point that rides a bone, found in a skeleton.
struct BonePoint {
  int bone = -1;
  glm::dvec3 inBone{0.0};
  glm::dvec3 inBind{0.0};  ///< World.
};

/// nullopt: the skeleton lacks the bone.
[[nodiscard]] std::optional<BonePoint> findPoint(const LineAnchor& anchor, const Skeleton& skeleton);
/// A point of the bind pose, world, that rides a bone from now on.
[[nodiscard]] LineAnchor anchorOn(const Skeleton& skeleton, int bone, const glm::vec3& inBind);
/// World.
[[nodiscard]] glm::dvec3 posedPoint(const BonePoint& point, const Pose& pose);

/// Lengths in character units, world of the bind pose.
struct LineRest {
  LineSettings settings;
  BonePoint origin;
  BonePoint insertion;
  std::optional<BonePoint> via;
  double length = 0.0;                  ///< Over the via point.
  double bellyStretch = 1.0;            ///< lambda_b in the bind pose.
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< Unit, from the origin straight to the insertion.
  glm::dmat3 frame{1.0};                ///< Columns, world: width; along, the direction; height, away from the bone.
  GirthRest girth;
  glm::dvec3 viaShift{0.0};  ///< How far the belly's middle is moved out of the straight line towards the via point.
  double height = 0.0;       ///< From the bone under the line up to its middle, at least 0.
  double depth = 0.0;        ///< From the line down to what its girth grows from, times `pivot`.
  glm::dvec3 start{0.0};     ///< What the belly's deformation keeps: under its end at the origin.
};

/// How far the middle of a belly lies beside the straight line: over the belly's middle as far as a parabola from
/// belly end to belly end through the via point; towards its ends less, in the end as far as the
/// via point lies. World.
/// @param tendon, belly  lengths along the straight line, from the origin
[[nodiscard]] glm::dvec3 viaShift(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& via,
                                  double tendon, double belly);

/// Shortest line, of H.
inline constexpr float kShortestLine = 1e-3f;

/// The same line with other settings: all that follows from them, bit for bit as lineRest would make it.
void settle(LineRest& rest, const LineSettings& settings);

/// Each of the rig's lines on a character, nullopt where a bone is missing or the line is too short.
[[nodiscard]] std::vector<std::optional<LineRest>> lineRests(const Rig& rig, const Character& character);
/// Error: a bone is missing, or the line is too short; subject is the line.
[[nodiscard]] Result<LineRest> lineRest(const MuscleLine& line, const Character& character);

}  // namespace sinew
