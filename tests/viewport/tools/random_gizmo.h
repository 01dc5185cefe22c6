// tests/viewport/tools/random_gizmo.h: gizmos on random bones under random cameras.
#pragma once

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "app/viewport/tools/camera.h"
#include "app/viewport/tools/gizmo.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {

enum class BoneScale { kEven, kMirrored, kUneven };

/// A placement on a bone in front of a camera.
struct GizmoScene {
  app::GizmoContext context;
  Placement placement;

  [[nodiscard]] glm::vec3 originInWorld() const {
    return glm::vec3(context.boneInWorld * glm::vec4(placement.center, 1.0f));
  }
};

inline glm::mat4 randomBone(Random& random, BoneScale kind, float height) {
  constexpr std::array<float, 3> sizes = {1.0f, 100.0f, 0.01f};
  const float size = sizes[static_cast<std::size_t>(random.below(3))];
  const glm::vec3 place(random.uniform(-0.3f, 0.3f), random.uniform(0.2f, 0.8f), random.uniform(-0.3f, 0.3f));
  glm::mat4 bone = glm::translate(glm::mat4(1.0f), height * place);
  if (kind == BoneScale::kUneven) {
    // Uneven scale of the parent under a rotated child shears the child's axes.
    bone *= glm::mat4_cast(random.rotation());
    bone = glm::scale(bone, glm::vec3(random.uniform(0.7f, 1.4f), random.uniform(0.7f, 1.4f), 1.0f));
  }
  bone *= glm::mat4_cast(random.rotation());
  if (kind == BoneScale::kMirrored) bone = glm::scale(bone, glm::vec3(-1.0f, 1.0f, 1.0f));
  return glm::scale(bone, glm::vec3(size));
}

inline GizmoScene randomGizmo(Random& random, BoneScale kind) {
  GizmoScene scene;
  const float height = random.chance(0.5f) ? 1.8f : 155.0f;
  const glm::mat4 bone = randomBone(random, kind, height);
  const float worldPerUnit = std::cbrt(std::abs(glm::determinant(glm::mat3(bone))));
  const auto within = [&](float low, float high) {
    return glm::vec3(random.uniform(low, high), random.uniform(low, high), random.uniform(low, high));
  };
  scene.placement.center = within(-0.1f, 0.1f) * height / worldPerUnit;
  scene.placement.rotation = random.rotation();
  scene.placement.radii = within(0.04f, 0.25f) * height / worldPerUnit;

  app::Camera camera;
  camera.characterHeight = height;
  camera.scene = {glm::vec3(-0.5f * height, 0.0f, -0.5f * height), glm::vec3(0.5f * height, height, 0.5f * height)};
  camera.orthographic = random.chance(0.3f);
  camera.stand.target = height * glm::vec3(random.uniform(-0.2f, 0.2f), random.uniform(0.3f, 0.7f), 0.0f);
  camera.stand.distance = height * random.uniform(1.2f, 4.0f);
  camera.stand.yaw = random.uniform(-3.1f, 3.1f);
  camera.stand.pitch = random.uniform(-1.5f, 1.5f);
  scene.context = {app::viewOf(camera, {1280, 800}), bone, height, random.chance(0.3f) ? 2.0f : 1.0f};
  return scene;
}

/// From the front, a little from the right and above: all axes are well spread. H = 1.8, unscaled bone.
inline GizmoScene plainGizmo() {
  GizmoScene scene;
  app::Camera camera;
  camera.stand = {glm::vec3(0.0f, 0.9f, 0.0f), 3.0f, 0.7f, 0.5f};
  scene.placement.center = {0.0f, 0.9f, 0.0f};
  scene.placement.radii = {0.45f, 0.40f, 0.42f};
  scene.context = {app::viewOf(camera, {1280, 800}), glm::mat4(1.0f), 1.8f, 1.0f};
  return scene;
}

inline app::ViewportInput pointerAt(const glm::vec2& pixel) {
  app::ViewportInput input;
  input.mouse = pixel;
  input.buttons[0].down = true;
  return input;
}

inline app::ViewportInput releasedAt(const glm::vec2& pixel) {
  app::ViewportInput input;
  input.mouse = pixel;
  input.buttons[0].released = true;
  return input;
}

inline glm::vec2 pixelOf(const app::View& view, const glm::vec3& point) { return glm::vec2(view.toPixel(point)); }

}  // namespace sinew::test
