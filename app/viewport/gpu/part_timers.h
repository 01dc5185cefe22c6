// app/viewport/gpu/part_timers.h: how long the card takes for each part of a surface, by its own clock.
#pragma once

#include <optional>
#include <vector>

#include "app/viewport/gpu/surface_parts.h"
#include "app/viewport/render/gl_objects.h"

namespace sinew::app {

/// Time stamps between the parts of one surface.
class PartTimers {
 public:
  PartTimers();
  void begin();
  void end(SurfacePart part);
  /// Waits for the card.
  [[nodiscard]] PartSeconds seconds() const;
  /// nullopt: the card is not done, or has not begun.
  [[nodiscard]] std::optional<PartSeconds> secondsIfDone() const;

 private:
  std::vector<GlQuery> stamps_;  ///< [kSurfaceParts + 1]
  bool begun_ = false;
};

}  // namespace sinew::app
