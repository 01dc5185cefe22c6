// tests/support/characters/synthetic_characters.cpp: triangle soups, chains of bones and sine-like clips.

#include "tests/support/characters/synthetic_characters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include <glm/gtc/constants.hpp>

#include "tests/support/characters/character_parts.h"

namespace sinew::test {
namespace {

/// Weights of the chain's bones along it: a smooth step of the given width at every joint except the first.
Weights chainWeights(float along, const std::vector<float>& joints, float width) {
  Weights out;
  float rest = 1.0f;
  for (std::size_t i = joints.size(); i-- > 0;) {
    const float step = i == 0 ? 1.0f : glm::clamp((along - joints[i]) / width + 0.5f, 0.0f, 1.0f);
    if (rest * step > 1e-4f) out.emplace_back(static_cast<int>(i), rest * step);
    rest *= 1.0f - step;
  }
  std::sort(out.begin(), out.end());
  float sum = 0.0f;
  for (const auto& entry : out) sum += entry.second;
  for (auto& entry : out) entry.second /= sum;
  return out;
}

Skeleton chain(const std::vector<std::string>& names, const std::vector<float>& heights) {
  Skeleton skeleton;
  for (std::size_t i = 0; i < names.size(); ++i) {
    addBone(skeleton, names[i], static_cast<int>(i) - 1, {0.0f, heights[i], 0.0f});
  }
  return skeleton;
}

/// Surface of revolution about Y through the profile (radius, height), poles at both ends, outside out. `seam` repeats
/// the first column with u = 1 and gives the pole triangles texture coordinates of their own.
TriangleSoup revolve(const std::vector<glm::vec2>& profile, int columns, bool seam, const std::vector<float>& joints,
                     float width) {
  TriangleSoup soup;
  const int rings = static_cast<int>(profile.size()) - 2;
  const int stride = seam ? columns + 1 : columns;
  const auto at = [&](int ring, int column) {
    const glm::vec2 p = profile[static_cast<std::size_t>(ring)];
    const float angle = glm::two_pi<float>() * static_cast<float>(column % columns) / static_cast<float>(columns);
    return glm::vec3(p.x * std::sin(angle), p.y, p.x * std::cos(angle));
  };
  const auto weightsAt = [&](int ring) {
    return chainWeights(profile[static_cast<std::size_t>(ring)].y, joints, width);
  };
  for (int ring = 1; ring <= rings; ++ring) {
    for (int c = 0; c < stride; ++c) {
      const glm::vec2 uv(static_cast<float>(c) / static_cast<float>(columns),
                         static_cast<float>(ring) / static_cast<float>(rings + 1));
      addVertex(soup, at(ring, c), uv, weightsAt(ring));
    }
  }
  const auto id = [&](int ring, int c) { return (ring - 1) * stride + (seam ? c : c % columns); };
  for (int ring = 1; ring < rings; ++ring) {
    for (int c = 0; c < columns; ++c) addQuad(soup, id(ring, c), id(ring, c + 1), id(ring + 1, c + 1), id(ring + 1, c));
  }
  for (const bool top : {false, true}) {
    const int ring = top ? rings : 1;
    const int pole =
        addVertex(soup, at(top ? rings + 1 : 0, 0), {0.5f, top ? 1.0f : 0.0f}, weightsAt(top ? rings + 1 : 0));
    for (int c = 0; c < columns; ++c) {
      int a = id(ring, c);
      int b = id(ring, c + 1);
      if (seam) {  // The caps have texture coordinates of their own.
        a = addVertex(soup, at(ring, c), {at(ring, c).x, at(ring, c).z}, weightsAt(ring));
        b = addVertex(soup, at(ring, c + 1), {at(ring, c + 1).x, at(ring, c + 1).z}, weightsAt(ring));
      }
      top ? addTriangle(soup, a, b, pole) : addTriangle(soup, b, a, pole);
    }
  }
  return soup;
}

}  // namespace

std::shared_ptr<const Character> makeLimb() {
  constexpr float kRadius = 0.3f;
  std::vector<glm::vec2> profile;
  for (int i = 0; i <= 4; ++i) {
    const float angle = glm::half_pi<float>() * static_cast<float>(i) / 4.0f;
    profile.emplace_back(kRadius * std::sin(angle), kRadius * (1.0f - std::cos(angle)));
  }
  for (int i = 1; i < 7; ++i) profile.emplace_back(kRadius, 0.3f + 0.2f * static_cast<float>(i));
  for (int i = 4; i >= 0; --i) {
    const float angle = glm::half_pi<float>() * static_cast<float>(i) / 4.0f;
    profile.emplace_back(kRadius * std::sin(angle), 2.0f - kRadius * (1.0f - std::cos(angle)));
  }
  const std::vector<float> joints{0.1f, 0.7f, 1.3f};
  AnimationClip clip;
  clip.name = "bend";
  swing(clip, 0, {0, 1, 0}, 0.4f, -0.3f);
  swing(clip, 1, {1, 0, 0.2f}, 0.9f, -0.6f);
  swing(clip, 2, {1, 0.3f, 0}, 1.1f, -0.8f);
  return finish("limb", revolve(profile, 10, false, joints, 0.5f), chain({"root", "middle", "end"}, joints), clip);
}

std::shared_ptr<const Character> makeTube() {
  std::vector<glm::vec2> profile{{0.0f, 0.0f}};
  for (int i = 0; i <= 6; ++i)
    profile.emplace_back(0.25f + 0.03f * static_cast<float>(i % 3), 0.2f * static_cast<float>(i));
  profile.emplace_back(0.0f, 1.2f);
  AnimationClip clip;
  clip.name = "bend";
  swing(clip, 1, {0.3f, 0, 1}, 1.0f, -1.0f);
  const std::vector<float> joints{0.05f, 0.6f};
  return finish("tube", revolve(profile, 9, true, joints, 0.4f), chain({"root", "end"}, joints), clip);
}

std::shared_ptr<const Character> makeCube() {
  TriangleSoup soup;
  const std::vector<float> joints{0.0f, 0.5f};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p(corner & 1, (corner >> 1) & 1, corner >> 2);
    addVertex(soup, p, {p.x + 2.0f * p.z, p.y}, {{corner >> 1 & 1, 1.0f}});
  }
  const std::array<std::array<int, 4>, 6> faces{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& [a, b, c, d] : faces) addQuad(soup, a, b, c, d);
  AnimationClip clip;
  clip.name = "bend";
  swing(clip, 1, {0.3f, 0.2f, 1}, 1.0f, -1.0f);
  return finish("cube", soup, chain({"root", "end"}, joints), clip);
}

std::shared_ptr<const Character> makeStrip() {
  TriangleSoup soup;
  constexpr int kColumns = 3;
  constexpr int kRows = 8;
  const std::vector<float> joints{0.0f, 1.0f};
  for (int r = 0; r <= kRows; ++r) {
    for (int c = 0; c <= kColumns; ++c) {
      const float y = 0.25f * static_cast<float>(r);
      addVertex(soup, {0.25f * static_cast<float>(c) - 0.375f, y, 0.0f},
                {static_cast<float>(c) / kColumns, static_cast<float>(r) / kRows}, chainWeights(y, joints, 0.6f));
    }
  }
  const auto id = [](int r, int c) { return r * (kColumns + 1) + c; };
  for (int r = 0; r < kRows; ++r) {
    for (int c = 0; c < kColumns; ++c) addQuad(soup, id(r, c), id(r, c + 1), id(r + 1, c + 1), id(r + 1, c));
  }
  AnimationClip clip;
  clip.name = "bend";
  swing(clip, 1, {1, 0, 0}, 1.2f, -1.2f);
  return finish("strip", soup, chain({"root", "end"}, joints), clip);
}

namespace {

/// Torso x 0..6, y 8..13; legs x 0..1 and 5..6, y 0..7; all of them z 0..1. In cells.
std::set<Cell> bodyCells() {
  std::set<Cell> cells;
  for (int z = 0; z < 2; ++z) {
    for (int x = 0; x < 7; ++x) {
      for (int y = 0; y < 14; ++y) {
        if (y >= 8 || x <= 1 || x >= 5) cells.insert({x, y, z});
      }
    }
  }
  return cells;
}

/// Bones in order: hips, spine, leg L, shin L, leg R, shin R.
Weights bodyWeights(const glm::vec3& p) {
  const float torso = glm::clamp((p.y - 0.85f) / 0.2f, 0.0f, 1.0f);
  const float spine = torso * glm::clamp((p.y - 1.15f) / 0.3f, 0.0f, 1.0f);
  const float shin = glm::clamp((0.55f - p.y) / 0.2f, 0.0f, 1.0f);
  const int leg = p.x > 0.0f ? 2 : 4;
  Weights out;
  const auto add = [&](int binding, float weight) {
    if (weight > 0.0f) out.emplace_back(binding, weight);
  };
  add(0, torso - spine);
  add(1, spine);
  add(leg, (1.0f - torso) * (1.0f - shin));
  add(leg + 1, (1.0f - torso) * shin);
  return out;
}

}  // namespace

std::shared_ptr<const Character> makeTwoLegged() {
  std::vector<Cell> corners;
  std::vector<std::array<int, 4>> quads;
  boundaryQuads(bodyCells(), corners, quads);
  TriangleSoup soup;
  for (const glm::vec3& corner : rounded(corners, quads)) {
    const glm::vec3 p = (corner - glm::vec3(3.5f, 0.0f, 1.0f)) * glm::vec3(0.12f, 0.12f, 0.16f);
    addVertex(soup, p, {p.x, p.y}, bodyWeights(p));
  }
  for (const auto& q : quads) addQuad(soup, q[0], q[1], q[2], q[3]);

  Skeleton skeleton;
  addBone(skeleton, "hips", -1, {0.0f, 1.0f, 0.0f});
  addBone(skeleton, "spine", 0, {0.0f, 1.25f, 0.0f});
  addBone(skeleton, "leg L", 0, {0.3f, 0.95f, 0.0f});
  addBone(skeleton, "shin L", 2, {0.3f, 0.5f, 0.0f});
  addBone(skeleton, "leg R", 0, {-0.3f, 0.95f, 0.0f});
  addBone(skeleton, "shin R", 4, {-0.3f, 0.5f, 0.0f});
  AnimationClip clip;
  clip.name = "cross";
  swing(clip, 2, {0.2f, 0, 1}, -0.7f, -0.2f);
  swing(clip, 4, {-0.2f, 0, 1}, 0.7f, 0.3f);
  swing(clip, 3, {1, 0, 0}, 0.5f, -0.2f);
  swing(clip, 1, {0, 1, 0}, 0.4f, -0.4f);
  return finish("two-legged", soup, std::move(skeleton), clip);
}

}  // namespace sinew::test
