// app/render/skin/seen_triangles.cpp: vertices in pixels, then triangles block by block, then closed up.
#include "app/render/skin/seen_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/at.h"
#include "core/base/parallel.h"

namespace sinew::app {
namespace {

constexpr std::size_t kBlock = 4096;
constexpr float kRounding = 1.0f / 64.0f;  ///< Pixels: more than what OpenGL moves vertices by when it rounds them.

/// Whether pixels' centers lie between the least and the largest of three numbers.
bool holdsCenter(float a, float b, float c, float size) {
  const float least = std::clamp(std::min({a, b, c}) - kRounding, -0.5f, size + 0.5f);
  const float most = std::clamp(std::max({a, b, c}) + kRounding, -0.5f, size + 0.5f);
  return static_cast<int>(least + 0.5f) < static_cast<int>(most + 0.5f);
}

/// Whether corners are turned to the eye or nearly along its rays.
bool mayFace(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const glm::vec2 u = b - a;
  const glm::vec2 v = c - a;
  const float lengths = std::abs(u.x) + std::abs(u.y) + std::abs(v.x) + std::abs(v.y);
  return !(u.x * v.y - u.y * v.x < -kRounding * (2.0f * lengths + 1.0f));
}

bool leavesTrace(const std::array<int, 3>& t, std::span<const glm::vec2> pixels, const glm::vec2& size, bool backs) {
  const glm::vec2& a = at(pixels, t[0]);
  const glm::vec2& b = at(pixels, t[1]);
  const glm::vec2& c = at(pixels, t[2]);
  if (std::isnan(a.x + b.x + c.x)) return true;
  return (backs || mayFace(a, b, c)) && holdsCenter(a.x, b.x, c.x, size.x) && holdsCenter(a.y, b.y, c.y, size.y);
}

}  // namespace

void SeenTriangles::place(std::span<const glm::vec3> positions, const glm::mat4& clipFromWorld, const glm::vec2& size) {
  pixels_.resize(positions.size());
  const glm::vec2 half = 0.5f * size;
  forEachIndex(positions.size(), kBlock, [&](std::size_t i) {
    const glm::vec4 clip = clipFromWorld * glm::vec4(positions[i], 1.0f);
    const float per = clip.w > 0.0f ? 1.0f / clip.w : std::numeric_limits<float>::quiet_NaN();
    pixels_[i] = half + half * (per * glm::vec2(clip));
  });
}

void SeenTriangles::findIn(const Input& input, const Range& range, bool keepsBacks, const glm::vec2& size) {
  const auto first = static_cast<std::size_t>(range.firstTriangle);
  const std::size_t last = first + static_cast<std::size_t>(range.triangles);
  blocks_.clear();
  for (std::size_t i = first; i < last; i += kBlock) blocks_.push_back({i, std::min(i + kBlock, last)});
  forEachIndex(blocks_.size(), 1, [&](std::size_t b) {
    Block& block = blocks_[b];
    std::size_t next = block.begin;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto triangle = static_cast<std::size_t>(input.order[i]);
      if (!leavesTrace(input.refinement.triangles[triangle], pixels_, size, keepsBacks)) continue;
      triangles_[next++] = input.refinement.drawTriangles[triangle];
    }
    block.kept = next - block.begin;
  });
}

void SeenTriangles::find(const Input& input, const glm::mat4& clipFromWorld, const glm::ivec2& size) {
  place(input.positions, clipFromWorld, glm::vec2(size));
  triangles_.resize(input.order.size());
  ranges_.assign(input.ranges.begin(), input.ranges.end());
  auto next = triangles_.begin();
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    findIn(input, input.ranges[r], input.keepsBacks[r] != 0, glm::vec2(size));
    const auto start = next;
    for (const Block& block : blocks_) {
      const auto begin = triangles_.begin() + static_cast<std::ptrdiff_t>(block.begin);
      next = std::copy(begin, begin + static_cast<std::ptrdiff_t>(block.kept), next);
    }
    ranges_[r].firstTriangle = static_cast<int>(start - triangles_.begin());
    ranges_[r].triangles = static_cast<int>(next - start);
  }
  triangles_.erase(next, triangles_.end());
}

}  // namespace sinew::app
