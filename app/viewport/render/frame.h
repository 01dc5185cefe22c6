// app/viewport/render/frame.h: camera, light and background of one picture, for its drawers.
#pragma once

#include "app/document/picture_look.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {

/// Uniforms of shaders/lighting.glsl (std140). Linear colors.
struct LightBlock {
  glm::vec4 sky{0.0f};
  glm::vec4 floor{0.0f};  ///< Reflected by the ground.
  glm::vec4 keyColor{0.0f};
  glm::vec4 fillColor{0.0f};
  glm::vec4 rimColor{0.0f};
  glm::vec4 keyAim{0.0f};   ///< w 0: along the camera's right, towards the eye, up. w 1: a world direction, unit.
  glm::vec4 clayKey{0.0f};  ///< x right, y up, z to the eye; unit. Not used where keyAim.w is 1.
  glm::vec4 clayKeyColor{0.0f};
  glm::vec4 clayLow{0.0f};   ///< Ambient from below.
  glm::vec4 clayHigh{0.0f};  ///< Ambient from above.
  glm::vec4 clayFill{0.0f};
  glm::vec4 clayRimRight{0.0f};
  glm::vec4 clayRimLeft{0.0f};
  /// Wrap and softness of the key light, the least roughness it sees; w 1: the only light, without tone curve.
  glm::vec4 lamp{0.24f, 0.70f, 0.25f, 0.0f};
};
[[nodiscard]] const LightBlock& lightBlock(LightPreset light);

[[nodiscard]] glm::vec3 keyDirection(LightPreset light);  ///< World, unit, towards the light that casts the shadow.

enum class BackdropKind { kVignette, kVertical, kChecker };

struct BackdropStyle {
  BackdropKind kind = BackdropKind::kVignette;
  glm::vec3 low{0.0f};    ///< sRGB: at the rim, at the bottom, the dark squares.
  glm::vec3 high{0.0f};   ///< sRGB: in the middle, at the top, the light squares.
  float pool = 1.0f;      ///< Factor on the pool of light on the ground.
  float lineTone = 1.0f;  ///< Factor on the grid's colors: below 1 on light backgrounds.
  float lines = 1.0f;     ///< Factor on the opacity of the grid.
};
[[nodiscard]] const BackdropStyle& backdropStyle(Backdrop backdrop);

/// Uniforms of shaders/frame.glsl (std140).
struct FrameBlock {
  glm::mat4 clipFromWorld{1.0f};
  glm::mat4 viewFromWorld{1.0f};
  glm::vec4 eye{0.0f};       ///< World; w = 1 where orthographic.
  glm::vec4 forward{0.0f};   ///< World, unit.
  glm::vec4 picture{1.0f};   ///< Width and height in pixels, height of the character, height of the floor.
  glm::vec4 key{0.0f};       ///< World, unit, towards the light that casts the shadow.
  glm::vec4 occluded{0.0f};  ///< x 1: with an occlusion texture (ScreenOcclusion). y 1: part of a mean.
};

struct Frame {
  const Scene& scene;
  const View& view;
  const DisplaySettings& settings;
  float height = 1.0f;           ///< The character's, in the bind pose.
  float floor = 0.0f;            ///< Height of the ground.
  Bounds surfaceBounds;          ///< World; empty without a surface.
  glm::vec3 groundCenter{0.0f};  ///< World, center of the light on the floor.
};

/// Blending for premultiplied colors, alpha kept right for transparent pictures.
inline void blendPremultiplied() {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace sinew::app
