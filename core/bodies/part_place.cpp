// core/bodies/part_place.cpp: the level of the axis on which a point lies, then its angle there.
#include "core/bodies/part_place.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr float kDegrees = 180.0f / std::numbers::pi_v<float>;
constexpr float kSearchedAround = 0.3f;  ///< Way along the axis on both sides of the nearest point, in its length.
constexpr int kHalvings = 40;            ///< To the last bit.

/// The way along an axis whose level a point lies at: the root of dot(point - axis(u), direction(u)) next to the
/// nearest point of the axis.
float wayAlong(const PartAxis& axis, const glm::vec3& point) {
  const auto level = [&](float u) { return glm::dot(point - axis.point(u), axis.direction(u)); };
  float nearest = 0.0f;
  float least = std::numeric_limits<float>::max();
  float done = 0.0f;
  for (std::size_t i = 0; i + 1 < axis.points.size(); ++i) {
    const glm::vec3 way = axis.points[i + 1] - axis.points[i];
    const float square = glm::dot(way, way);
    float share = square > 0.0f ? glm::dot(point - axis.points[i], way) / square : 0.0f;
    share = std::clamp(share, i == 0 ? -1.0f : 0.0f, i + 2 == axis.points.size() ? 2.0f : 1.0f);
    const float distance = glm::distance(point, axis.points[i] + share * way);
    if (distance < least) {
      least = distance;
      nearest = (done + share * std::sqrt(square)) / axis.length;
    }
    done += std::sqrt(square);
  }
  float low = nearest - kSearchedAround;
  float high = nearest + kSearchedAround;
  if (level(low) < 0.0f || level(high) > 0.0f) return nearest;
  for (int i = 0; i < kHalvings; ++i) {
    const float middle = 0.5f * (low + high);
    (level(middle) > 0.0f ? low : high) = middle;
  }
  return 0.5f * (low + high);
}

}  // namespace

PartPlace placeAt(const PartAxis& axis, const glm::vec3& point, float leastAway) {
  PartPlace place;
  place.u = wayAlong(axis, point);
  const glm::vec3 off = glm::transpose(axesAt(axis, place.u, 0.0f)) * (point - axis.point(place.u));
  place.away = glm::length(glm::vec2(off));
  place.beside = off.z;
  if (place.away > leastAway) place.angle = kDegrees * std::atan2(off.y, off.x);
  return place;
}

glm::mat3 axesAt(const PartAxis& axis, float u, float angle) {
  return {axis.radial(u, angle), axis.radial(u, angle + 90.0f), axis.direction(u)};
}

}  // namespace sinew
