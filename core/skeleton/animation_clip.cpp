// core/skeleton/animation_clip.cpp: keyframe interpolation, glTF 2.0 appendix C.
#include "sinew/skeleton/animation_clip.h"

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sinew {
namespace {

glm::quat toQuat(const glm::vec4& v) { return glm::quat(v.w, v.x, v.y, v.z); }
glm::vec4 toVec(const glm::quat& q) { return glm::vec4(q.x, q.y, q.z, q.w); }

glm::vec4 unitRotation(const glm::vec4& v) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
}

/// Key value k, without the tangents of a cubic channel.
glm::vec4 keyValue(const Channel& channel, std::size_t k) {
  return channel.interpolation == Interpolation::kCubicSpline ? channel.values[3 * k + 1] : channel.values[k];
}

glm::vec4 hermite(const Channel& channel, std::size_t k, float u, float span) {
  const glm::vec4 outTangent = channel.values[3 * k + 2] * span;
  const glm::vec4 inTangent = channel.values[3 * (k + 1)] * span;
  const float u2 = u * u;
  const float u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * keyValue(channel, k) + (u3 - 2 * u2 + u) * outTangent +
         (-2 * u3 + 3 * u2) * keyValue(channel, k + 1) + (u3 - u2) * inTangent;
}

glm::vec4 between(const Channel& channel, std::size_t k, float u, float span) {
  switch (channel.interpolation) {
    case Interpolation::kStep:
      return keyValue(channel, k);
    case Interpolation::kCubicSpline:
      return hermite(channel, k, u, span);
    case Interpolation::kLinear:
      break;
  }
  const glm::vec4 a = keyValue(channel, k);
  const glm::vec4 b = keyValue(channel, k + 1);
  if (channel.path != ChannelPath::kRotation) return a + (b - a) * u;
  return toVec(glm::slerp(toQuat(unitRotation(a)), toQuat(unitRotation(b)), u));  // shorter arc, as glTF asks
}

}  // namespace

glm::vec4 sampleChannel(const Channel& channel, float time) {
  assert(!channel.times.empty());
  const auto next = std::ranges::upper_bound(channel.times, time);
  glm::vec4 value;
  if (next == channel.times.begin()) {
    value = keyValue(channel, 0);
  } else if (next == channel.times.end()) {
    value = keyValue(channel, channel.times.size() - 1);
  } else {
    const auto k = static_cast<std::size_t>(next - channel.times.begin()) - 1;
    const float span = channel.times[k + 1] - channel.times[k];
    value = between(channel, k, (time - channel.times[k]) / span, span);
  }
  return channel.path == ChannelPath::kRotation ? unitRotation(value) : value;
}

}  // namespace sinew
