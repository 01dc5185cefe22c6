// app/viewport/render/frame.h: what the drawers share while one picture is made.
#pragma once

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/lights.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"

namespace sinew::app {

/// As shaders/frame.glsl lays it out (std140).
struct FrameBlock {
  glm::mat4 clipFromWorld{1.0f};
  glm::mat4 viewFromWorld{1.0f};
  glm::vec4 eye{0.0f};       ///< World; w = 1 where orthographic.
  glm::vec4 forward{0.0f};   ///< World, unit.
  glm::vec4 picture{1.0f};   ///< Width and height in pixels, height of the character, height of the floor.
  glm::vec4 key{0.0f};       ///< World, unit, towards the light that casts the shadow.
  glm::vec4 occluded{0.0f};  ///< x: 1: there is an occlusion texture (ScreenOcclusion). y: 1: one of a mean.
};

/// One picture in the making.
struct Frame {
  const Scene& scene;
  const View& view;
  const DisplaySettings& settings;
  float height = 1.0f;           ///< The character's, in the bind pose.
  float floor = 0.0f;            ///< Height of the ground.
  Bounds surfaceBounds;          ///< World; empty without a surface.
  glm::vec3 groundCenter{0.0f};  ///< World: of the light on the floor.
};

/// Blending for premultiplied colors, alpha kept right for transparent pictures.
inline void blendPremultiplied() {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace sinew::app
