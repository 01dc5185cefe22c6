// core/rig/tendons.h: the curves of tendons and muscle lines as they are drawn.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sinew {

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

}  // namespace sinew
