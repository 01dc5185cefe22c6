// app/panels/blending_layout.cpp: springs and repulsion.

#include "app/panels/blending_layout.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace sinew::app {
namespace {

constexpr int kBlendingLayoutSteps = 240;
constexpr float kGravity = 0.03f;  ///< A node; holds parts together that no link holds, against the push of all.
constexpr float kClosest = 0.62f;  ///< Fraction of kNodeSpacing: what two nodes keep in the end.
constexpr int kPartings = 60;
constexpr float kTau = 6.2831853f;

std::vector<glm::vec2> circle(int count) {
  std::vector<glm::vec2> places;
  const float around = kNodeSpacing / kTau * static_cast<float>(count);
  const float radius = count < 2 ? 0.0f : std::max(around, 0.6f * kNodeSpacing);
  for (int i = 0; i < count; ++i) {
    const float angle = kTau * static_cast<float>(i) / static_cast<float>(count) - 0.25f * kTau;
    places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return places;
}

/// Unit, from b to a; where they coincide, a direction of their own.
glm::vec2 apart(const glm::vec2& a, const glm::vec2& b, std::size_t salt) {
  const glm::vec2 way = a - b;
  const float length = glm::length(way);
  if (length > 1e-3f) return way / length;
  const float angle = 2.4f * static_cast<float>(salt + 1);
  return {std::cos(angle), std::sin(angle)};
}

void step(std::vector<glm::vec2>& places, std::span<const std::array<int, 2>> links, float longest) {
  std::vector<glm::vec2> push(places.size(), glm::vec2(0.0f));
  for (std::size_t i = 0; i < places.size(); ++i) {
    push[i] -= kGravity * static_cast<float>(places.size()) * places[i];
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const float distance = std::max(glm::length(places[i] - places[j]), 1.0f);
      const glm::vec2 way = apart(places[i], places[j], i) * (kNodeSpacing * kNodeSpacing / distance);
      push[i] += way;
      push[j] -= way;
    }
  }
  for (const auto& [a, b] : links) {
    if (a == b) continue;
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    const glm::vec2 way = places[i] - places[j];
    const glm::vec2 pull = way * (glm::length(way) / kNodeSpacing);
    push[i] -= pull;
    push[j] += pull;
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const float length = glm::length(push[i]);
    if (length > 0.0f) places[i] += push[i] * (std::min(length, longest) / length);
  }
}

/// Whatever the springs said, labels need room.
void partOverlaps(std::vector<glm::vec2>& places) {
  const float least = kClosest * kNodeSpacing;
  for (int round = 0; round < kPartings; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        const float lacking = least - glm::length(places[i] - places[j]);
        if (lacking <= 0.01f) continue;
        const glm::vec2 way = apart(places[i], places[j], i) * (0.5f * lacking);
        places[i] += way;
        places[j] -= way;
        moved = true;
      }
    }
    if (!moved) return;
  }
}

void center(std::vector<glm::vec2>& places) {
  glm::vec2 low = places.front();
  glm::vec2 high = low;
  for (const glm::vec2& place : places) {
    low = {std::min(low.x, place.x), std::min(low.y, place.y)};
    high = {std::max(high.x, place.x), std::max(high.y, place.y)};
  }
  for (glm::vec2& place : places) place -= 0.5f * (low + high);
}

}  // namespace

std::vector<glm::vec2> layoutGraph(int count, std::span<const std::array<int, 2>> links) {
  std::vector<glm::vec2> places = circle(count);
  if (count < 2) return places;
  for (int i = 0; i < kBlendingLayoutSteps; ++i) {
    const float left = 1.0f - static_cast<float>(i) / static_cast<float>(kBlendingLayoutSteps);
    step(places, links, 0.3f * kNodeSpacing * left + 0.2f);
  }
  partOverlaps(places);
  center(places);
  return places;
}

glm::vec2 freePlace(std::span<const glm::vec2> taken) {
  for (int i = 0;; ++i) {
    const float turn = 0.7f * std::sqrt(static_cast<float>(i)) * 2.4f;
    const float radius = 0.28f * kNodeSpacing * std::sqrt(static_cast<float>(i));
    const glm::vec2 place{radius * std::cos(turn), radius * std::sin(turn)};
    const bool free = std::ranges::all_of(
        taken, [&](const glm::vec2& other) { return glm::length(other - place) >= 0.8f * kNodeSpacing; });
    if (free) return place;
  }
}

}  // namespace sinew::app
