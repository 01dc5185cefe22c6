// core/geometry/smoothstep.h: a step without corners.
#pragma once

#include <algorithm>

namespace sinew {

/// 0 up to `from`, 1 from `to` on, between them 3 t^2 - 2 t^3. from < to.
[[nodiscard]] inline float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace sinew
