// core/export/fit/error_meter.h: root mean square, 99.9 percentile and maximum of many distances, in constant memory.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/export/skinned_export.h"

namespace sinew::exporting {

/// Distances are counted in classes 1/1024 of an octave wide. The order in which they come does not matter but to the
/// last bits of the sum.
class ErrorMeter {
 public:
  /// @param height  H: distances are given in percent of it
  explicit ErrorMeter(double height) : scale_(100.0 / height), counts_(kClasses, 0) {}

  void add(double distance);
  /// The poses that the distances are of; only counted.
  void addPose() { ++poses_; }
  [[nodiscard]] ErrorFigures figures() const;

 private:
  static constexpr std::size_t kClasses = std::size_t{1} << 18U;  ///< A float's exponent and ten bits more.

  double scale_ = 1.0;
  double squares_ = 0.0;
  double largest_ = 0.0;
  std::uint64_t count_ = 0;
  int poses_ = 0;
  std::vector<std::uint64_t> counts_;
};

}  // namespace sinew::exporting
