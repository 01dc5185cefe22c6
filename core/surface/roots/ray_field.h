// core/surface/roots/ray_field.h: the field along a ray: each ellipsoid a quadratic in t (paper 4.1), each shaped
// primitive a few polynomials.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/rig/field.h"
#include "core/surface/roots/polynomial.h"
#include "core/surface/roots/shaped_ray.h"
#include "sinew/surface/projection_kind.h"

namespace sinew {

/// One potential along a ray: r^2(t) = a t^2 + 2 b t + c, f(t) = factor (1 - r^2)^2 for enter < t < leave, else 0.
struct RayTerm {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double factor = 0.0;  ///< sign * s_i * m_i
  double enter = 0.0;
  double leave = 0.0;
  int slot = kEverySum;  ///< Group slot, or kEverySum: counts in every clique (the skin, carves).
  bool goesOn = false;   ///< Another term of the same primitive begins at `leave` and owns that place.
  int shaped = -1;       ///< Index into RayField::shaped(), whose r^2 is meant instead of a, b, c; or -1.

  static constexpr int kEverySum = -1;

  [[nodiscard]] double rSquared(double t) const { return (a * t + 2.0 * b) * t + c; }
};

/// Value and derivative at one t.
struct RaySample {
  double value = 0.0;
  double slope = 0.0;
};

/// phi on one stretch of a ray.
template <class Polynomial>
struct PolynomialSums {
  std::vector<Polynomial> ofSlot;
  std::vector<Polynomial> sums;  ///< One per clique.
};

/// Memory that is reused from ray to ray, so that nothing is allocated. Its contents carry nothing from one call to the
/// next. One a thread.
struct RayScratch {
  std::vector<RaySample> ofSlot;
  std::vector<double> breakpoints;
  PolynomialSums<Quartic> quartics;
  PolynomialSums<Bernstein> polynomials;  ///< On stretches with a term of higher degree.
};

/// phi(t) = skin(t) + F(p + t d) - T. Kept and refilled from ray to ray, so that nothing is allocated.
class RayField {
 public:
  /// Forgets all terms. @param cliques must outlive the use.
  void reset(double iso, const CliqueLists& cliques);
  /// Adds a primitive if the ray meets its influence at some t > 0 (or >= 0 inside). weight = m_i.
  /// Distances along the ray in world units; direction unit.
  void addPrimitive(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                    const glm::vec3& direction);
  void addTerm(const RayTerm& term) { terms_.push_back(term); }

  [[nodiscard]] bool empty() const { return terms_.empty(); }
  [[nodiscard]] std::span<const RayTerm> terms() const { return terms_; }
  [[nodiscard]] std::span<const ShapedRay> shaped() const { return shaped_; }
  [[nodiscard]] const CliqueLists& cliques() const { return *cliques_; }
  [[nodiscard]] double iso() const { return iso_; }

  /// phi and its derivative (of the winning clique).
  [[nodiscard]] RaySample sample(double t, RayScratch& scratch) const;
  /// Where phi changes its formula within (begin, end), sorted, with begin and end. In scratch.breakpoints.
  [[nodiscard]] std::span<const double> breakpoints(double begin, double end, RayScratch& scratch) const;
  /// Beyond this t only -T is left.
  [[nodiscard]] double lastLeave() const;

 private:
  void addShaped(const PosedPrimitive& primitive, float weight, int slot, const glm::vec3& origin,
                 const glm::vec3& direction);
  [[nodiscard]] RaySample sampleTerm(const RayTerm& term, double t) const;
  [[nodiscard]] RaySample sampleShaped(const RayTerm& term, double t) const;

  std::vector<RayTerm> terms_;
  std::vector<ShapedRay> shaped_;
  const CliqueLists* cliques_ = nullptr;
  double iso_ = 0.25;
};

// The first root of phi along a ray, by three methods.
// Docs/design.md, Projection; paper 4.

/// First t in [begin, end] where phi, taken to be positive at `begin` (or not), changes to the other sign; a touch does
/// not count, and phi(begin) = 0 gives `begin`. nullopt: it keeps its sign. Methods agree to `tolerance` where the root
/// is unique:
/// - newton: phi is a quartic in Bernstein form between breakpoints, or of degree 6, 8 or 10 with shaped primitives;
///   roots are isolated by its sign changes (Descartes' rule), then found by Newton steps kept inside the bracket;
/// - analytic (paper 4.1): the same quartics, roots in closed form (Ferrari), the first taken; above degree 4 as
/// newton;
/// - bisection (paper 4.2): the same brackets, each around one root, then 8 halvings and one secant step.
///   The paper halves [anchor, vertex] as it is; in a tangle that misses the first root, or a close pair of roots.
/// The sign is the caller's to know: where phi is all but 0, rounding would decide it anew, and differently.
/// @param tolerance world units, > 0.
[[nodiscard]] std::optional<double> firstChange(const RayField& field, double begin, double end, bool fromPositive,
                                                ProjectionKind method, double tolerance, RayScratch& scratch);

}  // namespace sinew
