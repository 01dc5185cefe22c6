// app/viewport/render/view.cpp: points to pixels and back.
#include "app/viewport/render/view.h"

#include <algorithm>

namespace sinew::app {

glm::vec3 View::toPixel(const glm::vec3& pointInWorld) const {
  const glm::vec4 clip = clipFromWorld() * glm::vec4(pointInWorld, 1.0f);
  const glm::vec2 half = 0.5f * glm::vec2(size);
  if (clip.w <= 0.0f) {
    // Behind the eye: kept on its own side of the picture (not mirrored), beyond the depth range.
    const float w = std::max(-clip.w, 1e-6f);
    return {half.x * (1.0f + clip.x / w), half.y * (1.0f - clip.y / w), 2.0f};
  }
  const glm::vec3 device = glm::vec3(clip) / clip.w;
  return {half.x * (1.0f + device.x), half.y * (1.0f - device.y), device.z};
}

Ray View::rayThrough(const glm::vec2& pixel) const {
  const glm::vec2 device(2.0f * pixel.x / static_cast<float>(size.x) - 1.0f,
                         1.0f - 2.0f * pixel.y / static_cast<float>(size.y));
  // Through the projection's own terms, not its inverse: exact enough for far planes thousands of near planes away.
  const glm::mat4& p = clipFromView;
  const glm::mat3 worldFromView = glm::transpose(glm::mat3(viewFromWorld));
  const glm::vec3 viewOrigin = -(worldFromView * glm::vec3(viewFromWorld[3]));
  if (orthographic) {
    const glm::vec3 near((device.x - p[3][0]) / p[0][0], (device.y - p[3][1]) / p[1][1], (-1.0f - p[3][2]) / p[2][2]);
    return {viewOrigin + worldFromView * near, -worldFromView[2]};
  }
  const glm::vec3 direction((device.x + p[2][0]) / p[0][0], (device.y + p[2][1]) / p[1][1], -1.0f);
  return {viewOrigin, glm::normalize(worldFromView * direction)};
}

float View::unitsPerPixelAt(const glm::vec3& pointInWorld) const {
  const float w = (clipFromWorld() * glm::vec4(pointInWorld, 1.0f)).w;
  return 2.0f * std::max(w, 1e-6f) / (clipFromView[1][1] * static_cast<float>(size.y));
}

glm::vec3 View::forwardInWorld() const { return -glm::vec3(glm::transpose(glm::mat3(viewFromWorld))[2]); }

glm::vec3 View::facingPoint() const {
  return orthographic ? eyeInWorld - forwardInWorld() * (1e7f / clipFromView[1][1]) : eyeInWorld;
}

}  // namespace sinew::app
