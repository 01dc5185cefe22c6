// app/viewport/gpu/surface_parts.h: parts of the time that a surface takes on the graphics card.
#pragma once

#include <array>
#include <cstddef>
#include <numeric>

namespace sinew::app {

/// Compare StageSeconds of the processor.
enum class SurfacePart { kSkin, kPatch, kProject, kHeights, kFolds, kNormals, kDrawn };
inline constexpr std::size_t kSurfaceParts = static_cast<std::size_t>(SurfacePart::kDrawn) + 1;
[[nodiscard]] const char* nameOf(SurfacePart part);

using PartSeconds = std::array<double, kSurfaceParts>;  ///< Seconds by part.
[[nodiscard]] inline double total(const PartSeconds& seconds) {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

}  // namespace sinew::app
