// core/surface/projection/swell.h: the default mode: skin rises over the muscles. docs/design.md, Swell.
#pragma once

#include <algorithm>
#include <span>

#include "core/surface/projection/projection_scratch.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew {

/// Heights below overhangs, where psi falls slowly (docs/design.md, Overhangs). When psi changes, its root t moves by
/// the change over the derivative of psi: without limit where a minimum of psi reaches 0, from where it leaps. So the
/// height is the least of s + psi(s) / sigma for 0 <= s <= t: no change of psi moves it by more than 1 / sigma times as
/// much. It is t if psi falls by at least sigma all the way.
///
/// The least is sought at the ends of parts of [0, t] that do not depend on the root, and inside a part if the sum
/// falls at its start and rises at its end. Steps there alternate between the intersection of the tangents at both
/// ends, which finds a kink between straight sides, and the middle, since a curved side would stall the former. The
/// last step goes to the zero of the derivative by false position, the lowest point of a parabola. psi has a kink where
/// the field of one muscle gives way to that of another that is not linked to it.
struct Overhang {
  /// sigma over the derivative on the skin of the skin's own field if its width were the muscles' mean radius.
  static constexpr float kSlope = 0.5f;
  static constexpr float kPart = 0.25f;  ///< Fraction of the blend width h.
  static constexpr int kMostParts = 32;
  static constexpr int kNarrowings = 6;
};

/// An end of a part: s, and s + psi(s) / sigma with its derivative there.
template <class Real>
struct PartEnd {
  Real at;
  Real sum;
  Real slope;
};

/// Next s to try inside a part with low.slope < 0 and high.slope > 0. @param step  from 0
template <class Real>
[[nodiscard]] Real lowestBetween(const PartEnd<Real>& low, const PartEnd<Real>& high, int step) {
  const Real length = high.at - low.at;
  if (step % 2 != 0 && step + 1 < Overhang::kNarrowings) return low.at + Real(0.5) * length;
  const Real turns = high.slope - low.slope;
  const Real to = step % 2 == 0 ? (high.slope * length + (low.sum - high.sum)) / turns : -low.slope * length / turns;
  return low.at + std::clamp(to, Real(0), length);
}

/// @param t  the root, > 0.  @param sigma  > 0.  @param part  length.  @param psi  (s) -> value and derivative.
template <class Real, class Psi>
[[nodiscard]] Real heightBelowOverhangs(Real t, Real sigma, Real part, const Psi& psi) {
  const auto endAt = [&](Real s) {
    const auto here = psi(s);
    return PartEnd<Real>{s, s + here.value / sigma, Real(1) + here.slope / sigma};
  };
  PartEnd<Real> from = endAt(Real(0));
  Real height = std::min(t, from.sum);
  for (int i = 0; i < Overhang::kMostParts && Real(i) * part < t; ++i) {
    const PartEnd<Real> to = endAt(std::min(Real(i + 1) * part, t));
    if (to.at < t) height = std::min(height, to.sum);
    PartEnd<Real> low = from;
    PartEnd<Real> high = to;
    for (int k = 0; k < Overhang::kNarrowings && low.slope < Real(0) && high.slope > Real(0); ++k) {
      const PartEnd<Real> inside = endAt(lowestBetween(low, high, k));
      height = std::min(height, inside.sum);
      (inside.slope < Real(0) ? low : high) = inside;
    }
    from = to;
  }
  return std::max(height, Real(0));
}

inline constexpr float kLeastAlong = 0.2f;  ///< Cosine of rise direction and normal that divides slopes, at the least.

struct RiseView {
  std::span<const glm::vec3> directions;  ///< [V'] world, unit, outward (rise.h).
  std::span<const float> inverseLimits;   ///< [V'] 1/L, 0: none (rise.h).
};

/// Constants of one character and rig.
struct SwellSettings {
  float iso = kDefaultIso;
  float blendWidth = 0.04f;  ///< Largest h, world units; a smaller muscle blends over its mean radius.
  ProjectionKind projection = ProjectionKind::kNewton;
  double tolerance = 1e-6;  ///< Tolerance of roots, world units.
};

/// Moves positions from the patch along the directions d to the first root of f_skin(s) + F(p + s d) - T, outwards from
/// s = 0; inwards where F(p) < 0, down to s = -r_T W at most. A root beyond half the rise limit, or half of
/// inverseTouchLimit(), is drawn in below that limit (limitedRise). Moved vertices get the field's normal at the root:
/// exact, and finer than the mesh can show (shading_normals.h). Vertices with F(p) = 0 stay. Fills displacement (s) and
/// the counts of the report.
void swell(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
           Surface& surface, ProjectionScratch& scratch);

void swellVertex(const CarriedVertex& vertex, const FieldView& field, const SwellSettings& settings,
                 const RiseView& rise, Surface& surface, VertexScratch& scratch);

}  // namespace sinew
