// app/document/detail_override.h: detail that is asked for in place of a rig's.
#pragma once

#include <optional>

#include "sinew/rig/rig.h"

namespace sinew::app {

struct DetailOverride {
  std::optional<int> depth{};        ///< 1..kMaxDepth; means uniform detail.
  std::optional<DetailKind> kind{};  ///< In place of the rig's, and of what the other two mean.
  std::optional<float> tolerance{};  ///< kLeastTolerance..kMostTolerance; means adaptive detail.

  friend bool operator==(const DetailOverride&, const DetailOverride&) = default;

  /// What is asked for no longer follows the size on screen.
  void apply(SmoothingSettings& smoothing) const {
    if (depth) smoothing.depth = *depth;
    if (tolerance) smoothing.tolerance = *tolerance;
    if (depth) smoothing.detail = DetailKind::kUniform;
    else if (tolerance) smoothing.detail = DetailKind::kAdaptive;
    smoothing.detail = kind.value_or(smoothing.detail);
    if (depth || tolerance) smoothing.autoDepth = false;
  }
};

}  // namespace sinew::app
