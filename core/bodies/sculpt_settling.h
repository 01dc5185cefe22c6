// core/bodies/sculpt_settling.h: the steps of a fit to a sculpt: residuals, equations, damping.
#pragma once

#include <span>
#include <vector>

#include "core/bodies/fit_equations.h"
#include "core/bodies/fit_muscles.h"
#include "core/bodies/height_model.h"
#include "core/bodies/sculpt_heights.h"

namespace sinew {

/// What is left between heights and a sculpt: at points, and of differences along edges, which see ridges.
class SculptResiduals {
 public:
  /// @param height  H
  SculptResiduals(const SkinPoints& points, const SculptHeights& sculpt, float height);

  [[nodiscard]] double cost(std::span<const float> heights) const;
  /// Of the sculpt itself.
  [[nodiscard]] double wholeCost() const { return whole_; }
  void addTo(FitEquations& equations, std::span<const ResidualRow> rows, std::span<const float> heights) const;
  [[nodiscard]] double left(std::size_t point, std::span<const float> heights) const;  ///< Weighted by nothing.
  [[nodiscard]] double area(std::size_t point) const { return areas_[point]; }         ///< 0 where nothing is compared.

 private:
  [[nodiscard]] double sumOfSquares(std::span<const float> heights, bool asDifferences) const;

  const SkinPoints& points_;
  const SculptHeights& sculpt_;
  std::vector<double> areas_;   ///< [P]
  std::vector<double> along_;   ///< [P] cosine of rise direction and normal.
  std::vector<double> ofEdge_;  ///< [edges] weight; 0: an end is not known.
  double whole_ = 0.0;
};

/// A way from a rig to one whose skin is nearer to a sculpt.
class SculptSettling {
 public:
  /// @param model, residuals, muscles  must outlive the use. `model` stands at `rig`.  @param hold  see
  /// SculptFitOptions
  SculptSettling(HeightModel& model, const SculptResiduals& residuals, const FitMuscles& muscles, Rig rig, float hold);

  [[nodiscard]] const Rig& rig() const { return rig_; }
  /// One step that lowers the cost. False: there is none, or it would be of no use.
  [[nodiscard]] bool step();

 private:
  [[nodiscard]] double cost(const Rig& rig) const;
  [[nodiscard]] FitEquations equations() const;

  HeightModel& model_;
  const SculptResiduals& residuals_;
  const FitMuscles& muscles_;
  Rig rig_;
  double pull_;  ///< Square of the weight of drift.
  double damping_ = 1e-2;
  double cost_ = 0.0;
};

}  // namespace sinew
