// app/viewport/tools/free_parts.cpp: a rectangle that cannot be larger has its sides on the edges of what is covered.

#include "app/viewport/tools/free_parts.h"

#include <algorithm>

namespace sinew::app {
namespace {

std::vector<float> sidesOf(std::span<const glm::vec4> covered, int axis) {
  std::vector<float> sides{0.0f, 1.0f};
  for (const glm::vec4& part : covered) {
    for (const float side : {part[axis], part[axis + 2]}) {
      if (side > 0.0f && side < 1.0f) sides.push_back(side);
    }
  }
  std::ranges::sort(sides);
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

float areaOf(const glm::vec4& part) { return (part.z - part.x) * (part.w - part.y); }

bool overlap(const glm::vec4& a, const glm::vec4& b) { return a.x < b.z && b.x < a.z && a.y < b.w && b.y < a.w; }

}  // namespace

std::vector<glm::vec4> freeParts(std::span<const glm::vec4> covered) {
  const std::vector<float> across = sidesOf(covered, 0);
  const std::vector<float> down = sidesOf(covered, 1);
  std::vector<glm::vec4> parts;
  for (std::size_t left = 0; left < across.size(); ++left) {
    for (std::size_t right = left + 1; right < across.size(); ++right) {
      if (across[right] - across[left] < kLeastPart) continue;
      for (std::size_t top = 0; top < down.size(); ++top) {
        for (std::size_t bottom = top + 1; bottom < down.size(); ++bottom) {
          if (down[bottom] - down[top] < kLeastPart) continue;
          const glm::vec4 part(across[left], down[top], across[right], down[bottom]);
          if (std::ranges::none_of(covered, [&](const glm::vec4& over) { return overlap(part, over); })) {
            parts.push_back(part);
          }
        }
      }
    }
  }
  if (!parts.empty()) return parts;
  // A panel as large as this is there for a while; bars stay.
  std::vector<glm::vec4> fewer(covered.begin(), covered.end());
  fewer.erase(std::ranges::max_element(fewer, {}, areaOf));
  return freeParts(fewer);
}

}  // namespace sinew::app
