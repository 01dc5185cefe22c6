// core/surface/projection/swell.h: the default mode: skin rises over the muscles along the rise direction.
// docs/design.md, Swell.
#pragma once

#include <algorithm>
#include <span>

#include "core/surface/projection/projection_scratch.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew {

// Heights where psi falls slowly, as below what hangs over the skin.
// Docs/design.md, Overhangs.

/// The root t of psi moves as fast as psi changes, over its slope: without limit where a dip of psi comes to 0, and it
/// leaps from there. The height is therefore the least of s + psi(s) / sigma on the way, 0 <= s <= t: no change of psi
/// moves it by more than 1 / sigma times as much. It is t wherever psi falls by sigma or more all the way.
///
/// The least is looked for at the ends of parts of the way that do not depend on the root, and inside a part at whose
/// ends the sum falls and rises. There steps go alternately to where the tangents at both ends meet, the place of a
/// kink between straight sides, and to the middle, without which a curved side would hold them up. The last one goes to
/// where false position finds the slope to be 0, the lowest point of a parabola. psi has a kink where one muscle's
/// field gives way to that of another one, which is not linked to it.
struct Overhang {
  /// sigma over the slope that the skin's own field would have on the skin, were the muscles' mean radius its width.
  static constexpr float kSlope = 0.5f;
  static constexpr float kPart = 0.25f;  ///< Fraction of the blend width h.
  static constexpr int kMostParts = 32;
  static constexpr int kNarrowings = 6;
};

/// An end of a part: where it is, and s + psi(s) / sigma there.
template <class Real>
struct PartEnd {
  Real at;
  Real sum;
  Real slope;
};

/// Where to look inside a part in which low.slope < 0 and high.slope > 0. @param step  from 0
template <class Real>
[[nodiscard]] Real lowestBetween(const PartEnd<Real>& low, const PartEnd<Real>& high, int step) {
  const Real length = high.at - low.at;
  if (step % 2 != 0 && step + 1 < Overhang::kNarrowings) return low.at + Real(0.5) * length;
  const Real turns = high.slope - low.slope;
  const Real to = step % 2 == 0 ? (high.slope * length + (low.sum - high.sum)) / turns : -low.slope * length / turns;
  return low.at + std::clamp(to, Real(0), length);
}

/// @param t  the root, > 0.  @param sigma  > 0.  @param part  length.  @param psi  (s) -> a value and a slope.
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

inline constexpr float kLeastAlong = 0.2f;  ///< Cosine of rise direction and normal below which slopes are not raised.

/// How the skin may rise in one pose.
struct RiseView {
  std::span<const glm::vec3> directions;  ///< [V'] world, unit, outward (rise_directions.h).
  std::span<const float> inverseLimits;   ///< [V'] 1/L, 0: none (rise_limits.h).
};

/// Constants of one character and rig.
struct SwellSettings {
  float iso = kDefaultIso;
  float blendWidth = 0.04f;  ///< h, world units: the most; a smaller muscle blends over its mean radius.
  ProjectionKind projection = ProjectionKind::kNewton;
  double tolerance = 1e-6;  ///< Tolerance of roots, world units.
};

/// Moves the surface's positions, which hold the patch, along the directions d to the first root of
/// f_skin(s) + F(p + s d) - T going outwards from s = 0; inwards where F(p) < 0, down to s = -r_T W at most.
/// A root beyond half the rise limit, or half of how far what the skin only touches may move it (inverseTouchLimit), is
/// drawn in below the limit (limitedRise).
/// Normals of moved vertices become the field's at the root: exact, and finer than the mesh can show
/// (shading_normals.h).
/// A vertex where F(p) = 0 is not touched. Fills displacement (s) and counts in the report.
void swell(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
           Surface& surface, ProjectionScratch& scratch);

/// The same for one vertex.
void swellVertex(const CarriedVertex& vertex, const FieldView& field, const SwellSettings& settings,
                 const RiseView& rise, Surface& surface, VertexScratch& scratch);

}  // namespace sinew
