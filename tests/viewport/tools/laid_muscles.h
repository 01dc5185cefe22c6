// tests/viewport/tools/laid_muscles.h: muscles laid by the add-muscle tool with its defaults.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/viewport/tools/limb_scene.h"

namespace sinew::test {

/// A place on the skin for a muscle.
struct LayingSpot {
  glm::vec3 point{0.0f};  ///< Bind pose.
  glm::vec3 normal{0.0f};
  glm::vec3 along{0.0f};  ///< Unit: the bone's direction, in the tangent plane.
  float room = 0.0f;      ///< Length that a designer would draw there: the bone's, limited by the flesh.
};

inline float distanceToSegment(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 ab = b - a;
  const float t = std::clamp(glm::dot(p - a, ab) / std::max(glm::dot(ab, ab), 1e-20f), 0.0f, 1.0f);
  return glm::distance(p, a + t * ab);
}

/// Vertices with flesh below them, far apart from each other, in descending order of room.
inline std::vector<LayingSpot> layingSpots(const Character& character, int count) {
  std::vector<LayingSpot> all;
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    const auto influences = character.mesh.influencesOf(static_cast<int>(v));
    const Influence most = *std::ranges::max_element(influences, {}, &Influence::weight);
    const Bone& bone =
        character.skeleton
            .bones[static_cast<std::size_t>(character.skeleton.bindings[static_cast<std::size_t>(most.binding)].bone)];
    const glm::vec3 joint(bone.bindInWorld[3]);
    const glm::vec3 axis = glm::mat3(bone.bindInWorld) * bone.tip;
    LayingSpot spot{character.mesh.positions[v], character.mesh.normals[v], {}, 0.0f};
    const float thickness = distanceToSegment(spot.point, joint, joint + axis);
    spot.room = std::min(glm::length(axis), 3.0f * thickness);
    const glm::vec3 flat = axis - glm::dot(axis, spot.normal) * spot.normal;
    // Trunk and limbs: not the head, hands and feet that end the skeleton, nor the ends of a bone.
    if (bone.children.empty() || glm::length(flat) < 0.5f * glm::length(axis) || spot.room < 0.06f * character.height) {
      continue;
    }
    spot.along = glm::normalize(flat);
    all.push_back(spot);
  }
  std::vector<LayingSpot> spots;
  std::vector<float> gaps(all.size(), 1e30f);
  while (static_cast<int>(spots.size()) < count && !all.empty()) {
    const auto next = static_cast<std::size_t>(std::ranges::max_element(gaps) - gaps.begin());
    spots.push_back(all[next]);
    for (std::size_t i = 0; i < all.size(); ++i) {
      gaps[i] = std::min(gaps[i], glm::distance(all[i].point, all[next].point));
    }
  }
  std::ranges::stable_sort(spots, std::ranges::greater{}, &LayingSpot::room);
  return spots;
}

/// `count` muscles over trunk and limbs, from 0.25 H where there is most room to 0.06 H: for each, looks at its spot,
/// presses on the skin and drags along the bone.
inline Rig layMuscles(const std::shared_ptr<const Character>& character, int count = 16) {
  LimbScene scene(character);
  setTool(scene.tools, app::ToolKind::kAddMuscle);
  const std::vector<LayingSpot> spots = layingSpots(*character, count + 8);
  const float height = character->height;
  int laid = 0;
  for (const LayingSpot& spot : spots) {
    if (laid == count) break;
    const float share = static_cast<float>(laid) / static_cast<float>(count - 1);
    const float length = std::min(spot.room, height * 0.25f * std::pow(0.06f / 0.25f, share));
    scene.tools.camera.stand.target = spot.point;
    scene.tools.camera.stand.distance = 1.5f * height;
    scene.tools.camera.stand.yaw = std::atan2(spot.normal.x, spot.normal.z);
    scene.tools.camera.stand.pitch = std::asin(std::clamp(spot.normal.y, -0.99f, 0.99f));
    const app::View view = app::viewOf(scene.tools.camera, LimbScene::kSize);
    const glm::vec2 from(view.toPixel(spot.point - 0.5f * length * spot.along));
    const glm::vec2 to(view.toPixel(spot.point + 0.5f * length * spot.along));
    scene.move(from);
    if (!scene.tools.hover.skin || glm::distance(scene.tools.hover.pointInWorld, spot.point) > length) continue;
    scene.press(from);
    for (int i = 1; i <= 4; ++i) scene.drag(glm::mix(from, to, 0.25f * static_cast<float>(i)));
    scene.release(to);
    if (static_cast<int>(scene.document.rig().primitives.size()) > laid) ++laid;
  }
  return scene.document.rig();
}

}  // namespace sinew::test
