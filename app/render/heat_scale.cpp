// app/render/heat_scale.cpp: a diverging scale, neutral grey in the middle so that the untouched skin recedes.
#include "app/render/heat_scale.h"

#include <algorithm>

namespace sinew::app {

const std::array<glm::vec3, 9>& heatStops() {
  static const std::array<glm::vec3, 9> stops{
      glm::vec3{0.47f, 0.86f, 1.00f}, glm::vec3{0.20f, 0.62f, 0.92f}, glm::vec3{0.16f, 0.40f, 0.72f},
      glm::vec3{0.40f, 0.50f, 0.66f}, glm::vec3{0.61f, 0.61f, 0.62f}, glm::vec3{0.76f, 0.43f, 0.43f},
      glm::vec3{0.85f, 0.30f, 0.25f}, glm::vec3{0.97f, 0.58f, 0.18f}, glm::vec3{1.00f, 0.90f, 0.45f}};
  return stops;
}

glm::vec3 heatColor(float x) {
  const auto& stops = heatStops();
  const float at = (std::clamp(x, -1.0f, 1.0f) * 0.5f + 0.5f) * static_cast<float>(stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return glm::mix(stops[low], stops[low + 1], at - static_cast<float>(low));
}

}  // namespace sinew::app
