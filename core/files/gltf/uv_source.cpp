// core/files/gltf/uv_source.cpp: transforms of texture coordinates, and from one to another.

#include "core/files/gltf/uv_source.h"

#include <algorithm>
#include <cmath>

#include "core/files/gltf/loose_values.h"

namespace sinew::gltf {

glm::vec2 UvSource::apply(double u, double v) const {
  return {static_cast<float>(transform[0] * u + transform[1] * v + transform[2]),
          static_cast<float>(transform[3] * u + transform[4] * v + transform[5])};
}

/// Rotation about the origin, counter-clockwise in uv, then offset (KHR_texture_transform).
UvSource uvSourceOf(int set, const tinygltf::Value* transform) {
  UvSource uv{.set = set};
  if (transform == nullptr) return uv;
  std::array<double, 2> offset{0.0, 0.0};
  std::array<double, 2> scale{1.0, 1.0};
  looseNumbers(*transform, "offset", offset);
  looseNumbers(*transform, "scale", scale);
  const double angle = looseNumber(*transform, "rotation", 0.0);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  uv.transform = {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]};
  if (transform->Has("texCoord")) uv.set = transform->Get("texCoord").GetNumberAsInt();
  return uv;
}

std::optional<std::array<glm::vec3, 2>> placeFrom(const UvSource& from, const UvSource& to) {
  if (from.set != to.set) return std::nullopt;
  if (from.transform == to.transform) return TextureMap{}.place;
  const auto& [a, b, c, d, e, f] = from.transform;
  const double determinant = a * e - b * d;
  std::array<glm::vec3, 2> place{};
  for (std::size_t row = 0; row < 2; ++row) {
    const double x = to.transform[3 * row], y = to.transform[3 * row + 1];
    const double u = (x * e - y * d) / determinant;
    const double v = (y * a - x * b) / determinant;
    place[row] = glm::vec3(u, v, to.transform[3 * row + 2] - u * c - v * f);
    if (!std::isfinite(place[row].x + place[row].y + place[row].z)) return std::nullopt;
  }
  return place;
}

}  // namespace sinew::gltf
