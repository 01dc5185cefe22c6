// app/viewport/render/frame.cpp: light presets and backgrounds as tables.
#include "app/viewport/render/frame.h"

#include <array>
#include <cstddef>

#include <glm/geometric.hpp>

namespace sinew::app {
namespace {

const glm::vec3 kWhiteLamp = glm::normalize(glm::vec3(-0.5f, 0.6f, 0.8f));
const glm::vec3 kSun = glm::normalize(glm::vec3(-0.62f, 0.86f, 0.58f));

/// Key, fill and rim light follow the camera.
LightBlock studio() {
  LightBlock light;
  light.sky = {0.315f, 0.345f, 0.395f, 0.0f};
  light.floor = {0.150f, 0.128f, 0.110f, 0.0f};
  light.keyColor = {1.56f, 1.45f, 1.30f, 0.0f};
  light.fillColor = {0.150f, 0.170f, 0.205f, 0.0f};
  light.rimColor = {0.50f, 0.58f, 0.70f, 0.0f};
  light.keyAim = {-0.72f, 0.58f, 0.90f, 0.0f};
  light.clayKey = {-0.52f, 0.60f, 0.608f, 0.0f};
  light.clayKeyColor = {1.62f, 1.49f, 1.29f, 0.0f};
  light.clayLow = {0.118f, 0.088f, 0.084f, 0.0f};
  light.clayHigh = {0.230f, 0.238f, 0.262f, 0.0f};
  light.clayFill = {0.115f, 0.132f, 0.172f, 0.0f};
  light.clayRimRight = {0.58f, 0.66f, 0.78f, 0.0f};
  light.clayRimLeft = {0.30f, 0.25f, 0.22f, 0.0f};
  return light;
}

/// A fixed sun under a blue sky.
LightBlock outdoor() {
  LightBlock light;
  light.sky = {0.34f, 0.48f, 0.74f, 0.0f};
  light.floor = {0.200f, 0.165f, 0.110f, 0.0f};
  light.keyColor = {1.95f, 1.68f, 1.22f, 0.0f};
  light.fillColor = {0.06f, 0.075f, 0.10f, 0.0f};
  light.rimColor = {0.34f, 0.42f, 0.56f, 0.0f};
  light.keyAim = glm::vec4(kSun, 1.0f);
  light.clayKey = {-0.52f, 0.60f, 0.608f, 0.0f};
  light.clayKeyColor = {1.68f, 1.46f, 1.10f, 0.0f};
  light.clayLow = {0.180f, 0.145f, 0.105f, 0.0f};
  light.clayHigh = {0.26f, 0.37f, 0.56f, 0.0f};
  light.clayFill = {0.05f, 0.065f, 0.09f, 0.0f};
  light.clayRimRight = {0.28f, 0.34f, 0.44f, 0.0f};
  light.clayRimLeft = {0.24f, 0.24f, 0.26f, 0.0f};
  return light;
}

/// Two lamps behind the character and little light in front.
LightBlock rim() {
  LightBlock light;
  light.sky = {0.085f, 0.095f, 0.120f, 0.0f};
  light.floor = {0.040f, 0.035f, 0.034f, 0.0f};
  light.keyColor = {0.26f, 0.24f, 0.22f, 0.0f};
  light.fillColor = {0.050f, 0.060f, 0.080f, 0.0f};
  light.rimColor = {6.6f, 7.0f, 7.6f, 0.0f};
  light.keyAim = {-0.72f, 0.58f, 0.90f, 0.0f};
  light.clayKey = {-0.52f, 0.60f, 0.608f, 0.0f};
  light.clayKeyColor = {0.30f, 0.27f, 0.24f, 0.0f};
  light.clayLow = {0.045f, 0.038f, 0.038f, 0.0f};
  light.clayHigh = {0.090f, 0.096f, 0.115f, 0.0f};
  light.clayFill = {0.040f, 0.048f, 0.066f, 0.0f};
  light.clayRimRight = {2.5f, 2.8f, 3.3f, 0.0f};
  light.clayRimLeft = {2.1f, 1.75f, 1.45f, 0.0f};
  return light;
}

/// A distant lamp that makes a facing white diffuse surface exactly white, to compare materials with other programs.
LightBlock whiteLamp() {
  LightBlock light;
  light.keyColor = glm::vec4(1.0f, 1.0f, 1.0f, 0.0f);
  light.keyAim = glm::vec4(kWhiteLamp, 1.0f);
  light.clayKey = {-0.52f, 0.60f, 0.608f, 0.0f};
  light.clayKeyColor = {1.6f, 1.6f, 1.6f, 0.0f};
  light.lamp = {0.0f, 0.0f, 0.045f, 1.0f};  // A mirror needs a lamp of some size.
  return light;
}

}  // namespace

const LightBlock& lightBlock(LightPreset light) {
  static const std::array kBlocks{studio(), outdoor(), rim(), whiteLamp()};
  return kBlocks[static_cast<std::size_t>(light)];
}

glm::vec3 keyDirection(LightPreset light) {
  if (light == LightPreset::kWhite) return kWhiteLamp;
  // Indoors high above a character that looks along +Z, a little in front.
  return light == LightPreset::kOutdoor ? kSun : glm::normalize(glm::vec3(-0.20f, 1.0f, 0.26f));
}

const BackdropStyle& backdropStyle(Backdrop backdrop) {
  static const std::array<BackdropStyle, kBackdropNames.size()> kStyles{{
      {BackdropKind::kVignette, {0.128f, 0.133f, 0.142f}, {0.300f, 0.309f, 0.325f}, 1.0f, 1.0f, 1.0f},
      {BackdropKind::kVignette, {0.102f, 0.104f, 0.110f}, {0.102f, 0.104f, 0.110f}, 0.0f, 0.55f, 1.0f},
      {BackdropKind::kVignette, {0.427f, 0.431f, 0.439f}, {0.427f, 0.431f, 0.439f}, 0.0f, 0.16f, 0.9f},
      {BackdropKind::kVignette, {0.808f, 0.812f, 0.820f}, {0.808f, 0.812f, 0.820f}, 0.0f, 0.55f, 1.0f},
      {BackdropKind::kVertical, {0.190f, 0.198f, 0.212f}, {0.560f, 0.590f, 0.625f}, 0.0f, 1.0f, 1.0f},
      {BackdropKind::kChecker, {0.345f, 0.345f, 0.345f}, {0.440f, 0.440f, 0.440f}, 0.0f, 0.16f, 0.9f},
  }};
  return kStyles[static_cast<std::size_t>(backdrop)];
}

}  // namespace sinew::app
