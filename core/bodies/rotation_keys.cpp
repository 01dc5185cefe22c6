// core/bodies/rotation_keys.cpp: keys copied where one channel turns, sampled where several do.
#include "core/bodies/rotation_keys.h"

#include <algorithm>
#include <cmath>

#include "core/bodies/common_stance.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr double kMostSampled = 200'000.0;  ///< Keys that a stretch of time is cut into.

glm::dquat quatOf(const glm::vec4& v) {
  return {static_cast<double>(v.w), static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

glm::vec4 vecOf(const glm::dquat& q) {
  return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)};
}

glm::dquat unitOr(const glm::dquat& q) {
  const double length = glm::length(q);
  return length > 0.0 && std::isfinite(length) ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

/// Shorter ways between keys, and the same sign from one to the next.
void alignSigns(Channel& channel) {
  for (std::size_t i = 1; i < channel.values.size(); ++i) {
    if (glm::dot(channel.values[i - 1], channel.values[i]) < 0.0f) channel.values[i] = -channel.values[i];
  }
}

}  // namespace

std::vector<float> refinedTimes(std::vector<float> times) {
  if (times.size() < 2) return times;
  const double length = static_cast<double>(times.back()) - static_cast<double>(times.front());
  if (!(length / kSampledFrame < kMostSampled)) return times;
  std::vector<float> fine;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const auto from = static_cast<double>(times[i]);
    const double span = static_cast<double>(times[i + 1]) - from;
    const auto parts = static_cast<int>(std::ceil(span / kSampledFrame - 1e-3));
    fine.push_back(times[i]);
    for (int part = 1; part < parts; ++part) {
      const auto time = static_cast<float>(from + span * part / parts);
      if (time > fine.back() && time < times[i + 1]) fine.push_back(time);
    }
  }
  fine.push_back(times.back());
  return fine;
}

ClipTurns::ClipTurns(const Skeleton& skeleton, const AnimationClip& clip)
    : skeleton_(skeleton), channels_(3 * skeleton.nodes.size(), nullptr) {
  for (const Channel& channel : clip.channels) {
    const Channel*& place = channels_[3 * toIndex(channel.node) + static_cast<std::size_t>(channel.path)];
    if (place == nullptr && !at(skeleton.nodes, channel.node).rest.matrix) place = &channel;
  }
}

const Channel* ClipTurns::channel(int node, ChannelPath path) const {
  return channels_[3 * toIndex(node) + static_cast<std::size_t>(path)];
}

glm::dquat ClipTurns::turn(int node, float time) const {
  if (const Channel* turning = channel(node, ChannelPath::kRotation)) return quatOf(sampleChannel(*turning, time));
  const LocalTransform& rest = at(skeleton_.nodes, node).rest;
  return rest.matrix ? rotationIn(*rest.matrix) : unitOr(glm::dquat(rest.rotation));
}

bool ClipTurns::chain(int above, int node, std::vector<int>& nodes) const {
  nodes.clear();
  int next = node;
  for (; next >= 0 && next != above; next = at(skeleton_.nodes, next).parent) nodes.push_back(next);
  std::ranges::reverse(nodes);
  return next == above;
}

std::vector<float> ClipTurns::timesOf(std::span<const int> nodes, bool fine) const {
  std::vector<float> times;
  for (const int node : nodes) {
    for (std::size_t path = 0; path < 3; ++path) {
      const Channel* one = channels_[3 * toIndex(node) + path];
      if (one != nullptr) times.insert(times.end(), one->times.begin(), one->times.end());
    }
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  if (times.empty()) times.push_back(0.0f);
  return fine ? refinedTimes(std::move(times)) : times;
}

Channel ClipTurns::between(int above, int node, const glm::dquat& left, const glm::dquat& right, double& budget) const {
  Channel made;
  made.path = ChannelPath::kRotation;
  std::vector<int> nodes;
  const bool below = chain(above, node, nodes);
  std::vector<int> turning;
  for (const int one : nodes) {
    if (channel(one, ChannelPath::kRotation) != nullptr) turning.push_back(one);
  }
  const auto product = [&](std::span<const int> some, float time) {
    glm::dquat all(1.0, 0.0, 0.0, 0.0);
    for (const int one : some) all = all * turn(one, time);
    return all;
  };
  if (below && turning.size() <= 1) {
    const Channel* keys = turning.empty() ? nullptr : channel(turning.front(), ChannelPath::kRotation);
    const auto own = turning.empty() ? nodes.end() : std::ranges::find(nodes, turning.front());
    const glm::dquat front = left * product({nodes.begin(), own}, 0.0f);
    const glm::dquat behind =
        (own == nodes.end() ? glm::dquat(1.0, 0.0, 0.0, 0.0) : product({std::next(own), nodes.end()}, 0.0f)) * right;
    if (keys == nullptr) {
      made.times = {0.0f};
      made.values = {vecOf(unitOr(front * behind))};
      return made;
    }
    made.interpolation = keys->interpolation;
    made.times = keys->times;
    for (const glm::vec4& value : keys->values) made.values.push_back(vecOf(front * quatOf(value) * behind));
    return made;
  }
  std::vector<int> others;
  if (!below) {
    (void)chain(-1, node, nodes);
    (void)chain(-1, above, others);
  }
  std::vector<int> all = nodes;
  all.insert(all.end(), others.begin(), others.end());
  const std::vector<float> times = timesOf(all, true);
  budget -= static_cast<double>(times.size()) * static_cast<double>(all.size());
  if (budget < 0.0) return made;
  made.times = times;
  for (const float time : times) {
    made.values.push_back(vecOf(unitOr(left * glm::conjugate(product(others, time)) * product(nodes, time) * right)));
  }
  alignSigns(made);
  return made;
}

}  // namespace sinew
