// core/rig/field.h: the field F of posed primitives, with its gradient.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/rig/blending_graph.h"
#include "core/rig/group_blend.h"
#include "sinew/geometry/ellipsoid.h"

namespace sinew {

/// A primitive resolved for the field (core/rig/attachment.h).
struct FieldPrimitive {
  int bone = 0;
  int sign = 1;              ///< +1 adds, -1 carves.
  Placement placement;       ///< Bone space.
  float reach = 1.4142135f;  ///< k > 1.
  float strength = 1.0f;     ///< sign * amount * s, s from strengthFor(iso, reach).
  int group = 0;
};

struct PosedPrimitive {
  UnitBallMap influence;  ///< r < 1 exactly where f_i != 0.
  float strength = 1.0f;
  float meanRadius = 0.0f;  ///< World; radius of the ball with the visible ellipsoid's volume.
  float groove = 0.0f;      ///< kappa, 0..2: how soft a groove it has beside muscles of other cliques.
};

[[nodiscard]] inline bool haveSoftGrooves(std::span<const PosedPrimitive> primitives) {
  return std::ranges::any_of(primitives, [](const PosedPrimitive& one) { return one.groove > 0.0f; });
}

/// A primitive at one place of the skin.
struct Candidate {
  int primitive = 0;
  float weight = 1.0f;  ///< Territory weight there, m_i (docs/design.md), 0..1.
  int slot = 0;         ///< Its group, numbered among those present there.
};

/// F and grad F at one point.
struct FieldSample {
  float value = 0.0f;
  glm::vec3 gradient{0.0f};  ///< Per character unit, world space.
};

/// With crisp grooves, difference to the highest clique below which another counts in the gradient, the more the nearer
/// it is; if there are several, the one that changes the gradient most. Otherwise rounding would decide on the line
/// between mirrored muscles, where the sums of both sides are equal.
inline constexpr float kTie = 1e-4f;

/// Memory that is reused from point to point. One per thread.
struct FieldScratch {
  std::vector<FieldSample> ofSlot;
  std::vector<FieldSample> softness;  ///< Of each slot: the same parts, each times its kappa.
  std::vector<FieldSample> ofClique;
  GroupBlend blend;
};

/// @param carrier  bone space -> world.  @param grooves  width of grooves, world units, 0: crisp
[[nodiscard]] PosedPrimitive posedPrimitive(const FieldPrimitive& primitive, const glm::mat4& carrier, float grooves);
/// All primitives on their bones. @param boneInWorld  [bones]
void poseField(std::span<const FieldPrimitive> primitives, std::span<const glm::mat4> boneInWorld, float grooves,
               std::vector<PosedPrimitive>& out);

/// F(x) = max over cliques of the sum of its positive m_i f_i, plus the sum of all carving m_i f_i (<= 0). Carves are
/// outside the maximum, since inside any unlinked group would undo a carve by max(..., 0), and culling would change
/// values. Without carves, or with all groups linked, it makes no difference. With soft grooves the maximum is over
/// shares of the cliques (core/rig/group_blend.h). Of several levels the maxima's mean counts. docs/design.md.
[[nodiscard]] FieldSample sampleField(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                                      CliqueLevelsView levels, const glm::vec3& point, FieldScratch& scratch);
/// For single points.
[[nodiscard]] FieldSample sampleField(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                                      CliqueLevelsView levels, const glm::vec3& point);

/// How much of each candidate counts at a point: d F / d (m_i f_i), 0..1.  @param out [candidates]
void fieldShares(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                 CliqueLevelsView levels, const glm::vec3& point, FieldScratch& scratch, std::vector<float>& out);

}  // namespace sinew
