// tests/support/characters/body_with_arms.cpp: a rounded body of cells with a hole and a fin.

#include "tests/support/characters/body_with_arms.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "tests/support/characters/character_parts.h"

namespace sinew::test {
namespace {

constexpr int kTop = 12;       ///< Top of the torso, in cells.
constexpr int kFinColumn = 2;  ///< Column of corners on the back.

/// Torso x 0..4, y 0..11; arms x -6..-1 and 5..10, y 8..9; all of them z 0..1.
std::set<Cell> cellsOfBody() {
  std::set<Cell> cells;
  for (int z = 0; z < 2; ++z) {
    for (int x = -6; x <= 10; ++x) {
      for (int y = 0; y < kTop; ++y) {
        const bool torso = x >= 0 && x <= 4;
        if (torso || y == 8 || y == 9) cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

void openNeck(const std::vector<Cell>& corners, std::vector<std::array<int, 4>>& quads) {
  std::erase_if(quads, [&](const std::array<int, 4>& quad) {
    return std::ranges::all_of(quad, [&](int corner) {
      const Cell& at = corners[static_cast<std::size_t>(corner)];
      return at[1] == kTop && at[0] >= 1 && at[0] <= 4;
    });
  });
}

void addFin(std::vector<Cell>& corners, std::vector<std::array<int, 4>>& quads) {
  const auto idOf = [&](const Cell& corner) {
    const auto found = std::ranges::find(corners, corner);
    const auto id = static_cast<int>(found - corners.begin());
    if (found == corners.end()) corners.push_back(corner);
    return id;
  };
  for (int y = 3; y < 8; ++y) {
    const int low = idOf({kFinColumn, y, 0});
    const int high = idOf({kFinColumn, y + 1, 0});
    quads.push_back({low, high, idOf({kFinColumn, y + 1, -1}), idOf({kFinColumn, y, -1})});
  }
}

/// Bones in order: hips, spine, arm L, forearm L, hand L, arm R, forearm R, hand R, head.
Weights weightsAt(const glm::vec3& p) {
  const float limb =
      glm::clamp((std::abs(p.x) - 0.24f) / 0.12f, 0.0f, 1.0f) * glm::clamp((p.y - 0.8f) / 0.15f, 0.0f, 1.0f);
  const float forearm = limb * glm::clamp((std::abs(p.x) - 0.6f) / 0.12f, 0.0f, 1.0f);
  const float spine = (1.0f - limb) * glm::clamp((p.y - 0.45f) / 0.4f, 0.0f, 1.0f);
  const int arm = p.x > 0.0f ? 2 : 5;
  Weights out;
  const auto add = [&](int binding, float weight) {
    if (weight > 0.0f) out.emplace_back(binding, weight);
  };
  add(0, 1.0f - limb - spine);
  add(1, spine);
  add(arm, limb - forearm);
  add(arm + 1, forearm);
  return out;
}

Skeleton bonesOfBody() {
  Skeleton skeleton;
  addBone(skeleton, "hips", -1, {0.0f, 0.1f, 0.0f});
  addBone(skeleton, "spine", 0, {0.0f, 0.65f, 0.0f});
  for (const float side : {1.0f, -1.0f}) {
    const std::string name = side > 0.0f ? " L" : " R";
    const int shoulder = static_cast<int>(skeleton.bones.size());
    addBone(skeleton, "arm" + name, 1, {0.3f * side, 1.08f, 0.0f});
    addBone(skeleton, "forearm" + name, shoulder, {0.66f * side, 1.08f, 0.0f});
    addBone(skeleton, "hand" + name, shoulder + 1, {0.98f * side, 1.08f, 0.0f});
  }
  addBone(skeleton, "head", 1, {0.0f, 1.45f, 0.0f});
  return skeleton;
}

}  // namespace

std::shared_ptr<const Character> makeBodyWithArms() {
  std::vector<Cell> corners;
  std::vector<std::array<int, 4>> quads;
  boundaryQuads(cellsOfBody(), corners, quads);
  openNeck(corners, quads);
  addFin(corners, quads);
  TriangleSoup soup;
  for (const glm::vec3& corner : rounded(corners, quads)) {
    const glm::vec3 p = (corner - glm::vec3(2.5f, 0.0f, 1.0f)) * glm::vec3(0.12f, 0.12f, 0.16f);
    addVertex(soup, p, {p.x, p.y}, weightsAt(p));
  }
  for (const auto& q : quads) addQuad(soup, q[0], q[1], q[2], q[3]);
  AnimationClip clip;
  clip.name = "reach";
  swing(clip, 1, {0, 1, 0}, 0.3f, -0.2f);
  swing(clip, 2, {0, 0, 1}, -1.35f, -0.6f);
  swing(clip, 3, {0, 1, 0.3f}, -2.0f, -0.4f);
  swing(clip, 5, {0, 0.2f, 1}, -0.9f, 0.7f);
  swing(clip, 6, {0, 1, 0}, 1.9f, 0.3f);
  return finish("body-with-arms", soup, bonesOfBody(), clip);
}

}  // namespace sinew::test
