// app/viewport/render/lights.h: the numbers behind the light presets and the backgrounds.
#pragma once

#include "app/document/picture_look.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {

/// As shaders/lighting.glsl lays it out (std140). Colors are linear.
struct LightBlock {
  glm::vec4 sky{0.0f};
  glm::vec4 floor{0.0f};  ///< What the ground reflects.
  glm::vec4 keyColor{0.0f};
  glm::vec4 fillColor{0.0f};
  glm::vec4 rimColor{0.0f};
  glm::vec4 keyAim{0.0f};   ///< w 0: along the camera's right, towards the eye, up. w 1: a world direction, unit.
  glm::vec4 clayKey{0.0f};  ///< As seen: x right, y up, z to the eye. Unit; not used where keyAim.w is 1.
  glm::vec4 clayKeyColor{0.0f};
  glm::vec4 clayLow{0.0f};   ///< Around, from below.
  glm::vec4 clayHigh{0.0f};  ///< ... and from above.
  glm::vec4 clayFill{0.0f};
  glm::vec4 clayRimRight{0.0f};
  glm::vec4 clayRimLeft{0.0f};
  /// How far the key light reaches round, how softly it ends, the least roughness it sees; w 1: it is all the light,
  /// and the picture shows it without tone curve.
  glm::vec4 lamp{0.24f, 0.70f, 0.25f, 0.0f};
};
[[nodiscard]] const LightBlock& lightBlock(LightPreset light);

/// World, unit, towards the light that casts the shadow.
[[nodiscard]] glm::vec3 keyDirection(LightPreset light);

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

}  // namespace sinew::app
