// app/gpu/part_timers.h: how long the card takes for each part of a surface, by its own clock.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "app/gpu/stages.h"

namespace sinew::app {

/// Seconds by part.
using PartSeconds = std::array<double, kSurfaceParts>;
[[nodiscard]] double total(const PartSeconds& seconds);

/// Time stamps between the parts of one surface.
class PartTimers {
 public:
  PartTimers();
  void begin();
  void end(SurfacePart part);
  /// Waits for the card.
  [[nodiscard]] PartSeconds seconds() const;

 private:
  std::vector<GlQuery> stamps_;  ///< [kSurfaceParts + 1]
};

}  // namespace sinew::app
