// app/viewport/render/seen_triangles.cpp: vertices in pixels, then triangles, listed by several threads.
#include "app/viewport/render/seen_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_access.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {
namespace {

constexpr std::size_t kBlock = 4096;
constexpr float kPixelMargin = 1.0f / 16.0f;  ///< Pixels by which a corner may lie elsewhere for OpenGL: half for its
                                              ///< steps, 1/16 at most, half for what floats of two programs differ by.

/// By how much two sums of the same terms may differ, at w = 1.
float roundingOf(std::span<const glm::vec3> positions, const glm::mat4& clipFromWorld) {
  glm::vec3 farthest(0.0f);
  const Bounds bounds = boundsOf(positions);
  if (!bounds.isEmpty()) farthest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
  float largest = 0.0f;
  for (const glm::length_t row : {0, 1, 3}) {
    largest = std::max(largest, glm::dot(glm::abs(glm::row(clipFromWorld, row)), glm::vec4(farthest, 1.0f)));
  }
  return 4.0f * std::numeric_limits<float>::epsilon() * largest;
}

/// Whether pixels' centers lie between the least and the largest of three numbers.
bool holdsCenter(float a, float b, float c, float size) {
  const float least = std::clamp(std::min({a, b, c}) - kPixelMargin, -0.5f, size + 0.5f);
  const float most = std::clamp(std::max({a, b, c}) + kPixelMargin, -0.5f, size + 0.5f);
  return static_cast<int>(least + 0.5f) < static_cast<int>(most + 0.5f);
}

/// Whether corners are turned to the eye or nearly along its rays.
bool mayFace(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const glm::vec2 u = b - a;
  const glm::vec2 v = c - a;
  const float lengths = std::abs(u.x) + std::abs(u.y) + std::abs(v.x) + std::abs(v.y);
  return !(u.x * v.y - u.y * v.x < -kPixelMargin * (2.0f * lengths + 1.0f));
}

}  // namespace

void SeenTriangles::place(std::span<const glm::vec3> positions, const glm::mat4& clipFromWorld, const glm::vec2& size) {
  pixels_.resize(positions.size());
  const glm::vec2 half = 0.5f * size;
  const float rounding = std::max(half.x, half.y) * roundingOf(positions, clipFromWorld);
  forEachIndex(positions.size(), kBlock, [&](std::size_t i) {
    const glm::vec4 clip = clipFromWorld * glm::vec4(positions[i], 1.0f);
    const float per = 1.0f / clip.w;
    const glm::vec2 device = per * glm::vec2(clip);
    const float off = rounding * per * (1.0f + std::abs(device.x) + std::abs(device.y));
    const bool isSure = clip.w > 0.0f && clip.z > -clip.w && off < 0.5f * kPixelMargin;
    pixels_[i] = isSure ? half + half * device : glm::vec2(std::numeric_limits<float>::quiet_NaN());
  });
}

bool SeenTriangles::leavesTrace(const std::array<int, 3>& triangle, const glm::vec2& size, bool keepsBack) const {
  const glm::vec2& a = at(pixels_, triangle[0]);
  const glm::vec2& b = at(pixels_, triangle[1]);
  const glm::vec2& c = at(pixels_, triangle[2]);
  if (std::isnan(a.x + b.x + c.x)) return true;
  return (keepsBack || mayFace(a, b, c)) && holdsCenter(a.x, b.x, c.x, size.x) && holdsCenter(a.y, b.y, c.y, size.y);
}

void SeenTriangles::find(const Input& input, const glm::mat4& clipFromWorld, const glm::ivec2& size) {
  place(input.positions, clipFromWorld, glm::vec2(size));
  triangles_.resize(input.order.size());
  ranges_.assign(input.ranges.begin(), input.ranges.end());
  std::size_t listed = 0;
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    Range& range = ranges_[r];
    const auto own = input.order.subspan(toIndex(range.firstTriangle), toIndex(range.triangles));
    const auto list = [&](std::size_t begin, std::size_t end, Corners* out) {
      std::size_t count = 0;
      for (const int triangle : own.subspan(begin, end - begin)) {
        if (!leavesTrace(at(input.refinement.triangles, triangle), glm::vec2(size), input.keepsBacks[r] != 0)) continue;
        out[count++] = at(input.refinement.drawTriangles, triangle);
      }
      return count;
    };
    range.firstTriangle = static_cast<int>(listed);
    range.triangles = static_cast<int>(listInBlocks(own.size(), kBlock, triangles_.data() + listed, list));
    listed += toIndex(range.triangles);
  }
  triangles_.resize(listed);
}

}  // namespace sinew::app
