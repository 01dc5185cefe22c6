// core/surface/roots/ray_field.h: the field along a ray, piecewise polynomial (paper 4.1), and its first root.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/rig/field.h"
#include "core/surface/roots/polynomial.h"
#include "core/surface/roots/shaped_ray.h"
#include "core/surface/roots/soft_fall.h"
#include "sinew/surface/projection_kind.h"

namespace sinew {

/// One potential along a ray: r^2(t) = a t^2 + 2 b t + c; f(t) = factor (1 - r^2)^2 for enter < t < leave, else 0.
struct RayTerm {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double factor = 0.0;  ///< sign * s_i * m_i
  double enter = 0.0;
  double leave = 0.0;
  double groove = 0.0;   ///< PosedPrimitive::groove
  int slot = kEverySum;  ///< Group slot, or kEverySum: part of every clique's sum (the skin, carves).
  bool goesOn = false;   ///< Another term of the same primitive begins at `leave`, which belongs to it.
  int shaped = -1;       ///< Index into RayField::shaped(), whose r^2 replaces a, b, c; or -1.

  static constexpr int kEverySum = kInEveryClique;

  [[nodiscard]] double rSquared(double t) const { return (a * t + 2.0 * b) * t + c; }
};

/// phi on one interval of a ray.
template <class Polynomial>
struct PolynomialSums {
  std::vector<Polynomial> ofSlot;
  std::vector<Polynomial> sums;  ///< One per clique of the only level.
};

/// Memory reused from ray to ray, so that nothing is allocated; carries nothing over. One per thread.
struct RayScratch {
  std::vector<ValueAndSlope> ofSlot;
  std::vector<ValueAndSlope> softness;
  GroupBlend blend;
  SoftFallScratch soft;
  std::vector<double> breakpoints;
  PolynomialSums<Quartic> quartics;
  PolynomialSums<Bernstein> polynomials;  ///< On intervals with a term of higher degree.
};

/// phi(t) = skin(t) + F(p + t d) - T. Refilled from ray to ray, so that nothing is allocated.
class RayField {
 public:
  void reset(double iso, CliqueLevelsView levels);  ///< Removes all terms. @param levels  must outlive the use.
  /// Adds a primitive if the ray meets its influence at some t > 0 (or >= 0 inside). Distances along the ray are in
  /// world units. @param weight  m_i.  @param direction  unit.
  void addPrimitive(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                    const glm::vec3& direction);
  void addTerm(const RayTerm& term) {
    terms_.push_back(term);
    isSoft_ = isSoft_ || (term.groove > 0.0 && term.slot != RayTerm::kEverySum && !levels_.empty());
  }

  [[nodiscard]] bool empty() const { return terms_.empty(); }
  [[nodiscard]] std::span<const RayTerm> terms() const { return terms_; }
  [[nodiscard]] std::span<const ShapedRay> shaped() const { return shaped_; }
  [[nodiscard]] CliqueLevelsView levels() const { return levels_; }
  [[nodiscard]] double iso() const { return iso_; }
  /// phi is the maximum of polynomials, one per clique: no groove is soft, and no groups are linked in part.
  [[nodiscard]] bool isMaximum() const { return !isSoft_ && levels_.size() < 2; }

  /// phi and its derivative: with crisp grooves of the clique with the largest sum.
  [[nodiscard]] ValueAndSlope sample(double t, RayScratch& scratch) const;
  /// Where phi changes its formula in (begin, end), sorted, with begin and end. Stored in scratch.breakpoints.
  [[nodiscard]] std::span<const double> breakpoints(double begin, double end, RayScratch& scratch) const;
  [[nodiscard]] double lastLeave() const;  ///< phi is -T beyond this t.

 private:
  void addShaped(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                 const glm::vec3& direction);
  [[nodiscard]] ValueAndSlope sampleTerm(const RayTerm& term, double t) const;
  [[nodiscard]] ValueAndSlope sampleShaped(const RayTerm& term, double t) const;
  // Of the sums in scratch.ofSlot, and scratch.softness.
  [[nodiscard]] static ValueAndSlope highest(const CliqueLists& cliques, const RayScratch& scratch);
  [[nodiscard]] static ValueAndSlope softest(const CliqueLists& cliques, RayScratch& scratch);

  std::vector<RayTerm> terms_;
  std::vector<ShapedRay> shaped_;
  CliqueLevelsView levels_;
  double iso_ = 0.25;
  bool isSoft_ = false;
};

/// First t in [begin, end] where phi, positive at `begin` or not as `fromPositive` has it, changes its sign. A touch
/// does not count; phi(begin) = 0 gives `begin`; nullopt: no change. Methods agree to `tolerance` where the root is
/// unique (docs/design.md, Projection; paper 4):
/// - newton: phi is a quartic in Bernstein form between breakpoints, or of degree 6, 8 or 10 with shaped primitives;
///   roots are isolated by its sign changes (Descartes' rule), then found by Newton steps kept inside the bracket;
/// - analytic (paper 4.1): the first root of the same quartics in closed form (Ferrari); above degree 4 as newton;
/// - bisection (paper 4.2): the same brackets, each around one root, then 8 halvings and one secant step.
///   The paper halves [anchor, vertex] itself; in a tangle that misses the first root, or a close pair of roots.
/// Otherwise (isMaximum()) an interval is halved until bounds from the same polynomials prove that phi keeps its sign
/// or only falls; then all methods take Newton steps, or `bisection` its halvings. The caller knows the sign at
/// `begin`: where phi is nearly 0, rounding could decide it differently here.
/// @param tolerance world units, > 0.
[[nodiscard]] std::optional<double> firstChange(const RayField& field, double begin, double end, bool fromPositive,
                                                ProjectionKind method, double tolerance, RayScratch& scratch);

}  // namespace sinew
