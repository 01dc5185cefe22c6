// core/rig/line_rest.h: muscle lines in the bind pose, made once per edit; girth and activation; curves of tendons.
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

/// The part of girth() that does not depend on the pose.
struct GirthRest {
  double volume = 1.0;
  double least = 1.0;   ///< -ln of the stretch at which girth levels off when the belly shortens.
  double most = 1.0;    ///< ln of the stretch at which it levels off when the belly lengthens.
  double inBind = 0.0;  ///< Softened logarithm of the belly stretch in the bind pose.
};

[[nodiscard]] GirthRest girthRest(const LineSettings& settings);

/// Girth from belly stretch, both relative to the bind pose (omega; Scheepers' closed form if volume is 1).
[[nodiscard]] double girth(double bellyStretch, const GirthRest& rest);
[[nodiscard]] double bellyShare(const LineSettings& settings);  ///< Fraction of the rest length without tendons.
/// Belly stretch at a line's stretch; tendons keep their length.
[[nodiscard]] double bellyStretch(double stretch, const LineSettings& settings);
/// Activation at a line's stretch, 0..1. @param added  added to its base
[[nodiscard]] double activation(double stretch, const LineSettings& settings, double added);

/// World. Straight without a via point.
struct LinePath {
  glm::vec3 origin{0.0f};
  std::optional<glm::vec3> via;
  glm::vec3 insertion{0.0f};

  friend bool operator==(const LinePath&, const LinePath&) = default;
};

struct TendonPart {
  std::array<glm::vec3, 4> curve{};  ///< Cubic Bezier.
  glm::vec2 share{0.0f, 1.0f};       ///< Fractions of the tendon's length at its ends; 0 in the belly, 1 at the anchor.
};

/// A tendon from inside the end of its belly to an anchor.
struct Tendon {
  std::vector<TendonPart> parts;  ///< One, or two that meet smoothly at the via point.
  float length = 0.0f;            ///< Of straight segments through its ends and the via point.
  float side = 1.0f;              ///< End of the belly's y axis: +1, -1.
};

inline constexpr float kTendonStart = 0.8f;  ///< Start of a tendon on the belly's axis, fraction of the half length.

/// Tendons of one belly at the origin and at the insertion; none at an anchor in or beside the belly.
/// @param bellyInWorld  unit ball -> world, y along the fibres  @param bend  Shape::bend of the belly
[[nodiscard]] std::vector<Tendon> tendonsOf(const glm::mat4& bellyInWorld, const LinePath& line,
                                            const glm::vec2& bend = glm::vec2(0.0f));

/// Points of a smooth curve from origin to insertion, through the via point.
[[nodiscard]] std::vector<glm::vec3> pointsAlong(const LinePath& line);

/// An anchor resolved in a skeleton.
struct BonePoint {
  int bone = -1;
  glm::dvec3 inBone{0.0};
  glm::dvec3 inBind{0.0};  ///< World.
};

/// nullopt: the skeleton lacks the bone.
[[nodiscard]] std::optional<BonePoint> findPoint(const LineAnchor& anchor, const Skeleton& skeleton);
/// An anchor on a bone at a point of the bind pose, world.
[[nodiscard]] LineAnchor anchorOn(const Skeleton& skeleton, int bone, const glm::vec3& inBind);
[[nodiscard]] glm::dvec3 posedPoint(const BonePoint& point, const Pose& pose);  ///< World.

/// A line in the bind pose, relative to which poses are measured. Character units, world.
struct LineRest {
  LineSettings settings;
  BonePoint origin;
  BonePoint insertion;
  std::optional<BonePoint> via;
  double length = 0.0;                  ///< Through the via point.
  double bellyStretch = 1.0;            ///< lambda_b in the bind pose.
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< Unit, from origin to insertion.
  glm::dmat3 frame{1.0};                ///< Columns: width; direction; height, away from the bone.
  GirthRest girth;
  glm::dvec3 viaShift{0.0};  ///< Shift of the belly's middle from the straight line towards the via point.
  double height = 0.0;       ///< From the bone below the line up to its middle, at least 0.
  double depth = 0.0;        ///< From the line down to the center of growth: `pivot` times `height`.
  glm::dvec3 start{0.0};     ///< Fixed point of the belly's deformation, below its end at the origin.
};

/// Shift of a belly's middle from the straight line: that of a parabola between the belly's ends through the via point
/// if that is near the middle; less near the ends, down to the distance of the via point. World.
/// @param tendon, belly  lengths along the straight line, from the origin
[[nodiscard]] glm::dvec3 viaShift(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& via,
                                  double tendon, double belly);

inline constexpr float kShortestLine = 1e-3f;  ///< Shortest line, fraction of H.

/// Changes the settings of a line, with the same result as lineRest(), bit for bit.
void settle(LineRest& rest, const LineSettings& settings);

/// [Rig::lines] nullopt: see the errors of lineRest().
[[nodiscard]] std::vector<std::optional<LineRest>> lineRests(const Rig& rig, const Character& character);
/// Error: a bone is missing, or the line is too short; its subject is the line.
[[nodiscard]] Result<LineRest> lineRest(const MuscleLine& line, const Character& character);

}  // namespace sinew
