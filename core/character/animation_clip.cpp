// core/character/animation_clip.cpp: keyframe interpolation, glTF 2.0 appendix C.
#include "sinew/character/animation_clip.h"

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace sinew {
namespace {

constexpr float kMostPlayedWeight = 1000.0f;  // Splines may go far beyond their keys.

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

/// @param outTangent, inTangent  of the keys at u = 0 and u = 1, times the interval between them
template <class Value>
Value hermite(const Value& a, const Value& outTangent, const Value& b, const Value& inTangent, float u) {
  const float u2 = u * u;
  const float u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * a + (u3 - 2 * u2 + u) * outTangent + (-2 * u3 + 3 * u2) * b + (u3 - u2) * inTangent;
}

/// A time among keys: at key `k`, or at fraction `u` of the interval of `span` seconds to the next.
struct Moment {
  std::size_t k = 0;
  float u = 0.0f;
  float span = 0.0f;
  bool atKey = true;
};

Moment momentIn(const std::vector<float>& times, float time) {
  assert(!times.empty());
  const auto next = std::ranges::upper_bound(times, time);
  if (next == times.begin()) return {};
  const auto k = static_cast<std::size_t>(next - times.begin()) - 1;
  if (next == times.end()) return {.k = k};
  const float span = times[k + 1] - times[k];
  return {.k = k, .u = (time - times[k]) / span, .span = span, .atKey = false};
}

glm::vec4 between(const Channel& channel, std::size_t k, float u, float span) {
  switch (channel.interpolation) {
    case Interpolation::kStep:
      return keyValue(channel, k);
    case Interpolation::kCubicSpline:
      return hermite(keyValue(channel, k), channel.values[3 * k + 2] * span, keyValue(channel, k + 1),
                     channel.values[3 * (k + 1)] * span, u);
    case Interpolation::kLinear:
      break;
  }
  const glm::vec4 a = keyValue(channel, k);
  const glm::vec4 b = keyValue(channel, k + 1);
  if (channel.path != ChannelPath::kRotation) return a + (b - a) * u;
  return toVec(glm::slerp(toQuat(unitRotation(a)), toQuat(unitRotation(b)), u));  // The shorter arc, as in glTF.
}

}  // namespace

glm::vec4 sampleChannel(const Channel& channel, float time) {
  const auto [k, u, span, atKey] = momentIn(channel.times, time);
  const glm::vec4 value = atKey ? keyValue(channel, k) : between(channel, k, u, span);
  return channel.path == ChannelPath::kRotation ? unitRotation(value) : value;
}

void sampleMorphs(const MorphChannel& channel, float time, std::span<float> out) {
  const auto [k, u, span, atKey] = momentIn(channel.times, time);
  const auto targets = static_cast<std::size_t>(channel.targets);
  const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
  const std::size_t perKey = cubic ? 3 * targets : targets;
  const float* key = &channel.values[k * perKey];
  const float* value = cubic ? key + targets : key;
  for (std::size_t i = 0; i < targets; ++i) {
    const float a = value[i];
    float weight = a;
    if (!atKey && cubic) weight = hermite(a, value[targets + i] * span, value[perKey + i], key[perKey + i] * span, u);
    else if (!atKey && channel.interpolation == Interpolation::kLinear) weight = a + (value[perKey + i] - a) * u;
    out[i] = std::clamp(weight, -kMostPlayedWeight, kMostPlayedWeight);
  }
}

}  // namespace sinew
