// app/viewport/render/color_scales.cpp: the heat scale and the colors of triangle classes.
#include "app/viewport/render/color_scales.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>

#include "core/geometry/at.h"

namespace sinew::app {

// Colors of groups and territories.

namespace {

// Found by search: largest distance in Oklab, as seen by all and with red-green deficiencies (Machado 2009).
constexpr std::array<glm::vec3, kGroupColors> kColors{glm::vec3{0.32f, 0.67f, 0.96f}, glm::vec3{0.95f, 0.83f, 0.30f},
                                                      glm::vec3{0.80f, 0.23f, 0.42f}, glm::vec3{0.27f, 0.77f, 0.47f},
                                                      glm::vec3{0.86f, 0.71f, 0.79f}, glm::vec3{0.34f, 0.42f, 0.92f},
                                                      glm::vec3{0.63f, 0.54f, 0.14f}, glm::vec3{0.68f, 0.96f, 0.82f}};
constexpr glm::vec3 kNoGroup{0.58f, 0.61f, 0.66f};

}  // namespace

glm::vec3 groupColor(int slot) {
  assert(slot >= 0);
  const auto index = static_cast<std::size_t>(slot);
  const glm::vec3 base = kColors[index % kColors.size()];
  constexpr std::array kPale{0.0f, 0.38f, -0.34f, 0.6f, -0.52f};
  const float pale = kPale[(index / kColors.size()) % kPale.size()];
  return pale >= 0.0f ? glm::mix(base, glm::vec3(0.93f), pale) : base * (1.0f + pale);
}

int colorSlot(const Rig& rig, int group) {
  const GroupId id = at(rig.groups, group).id();
  return id ? static_cast<int>(id.value - 1) : group;
}

glm::vec3 groupColor(const Rig& rig, const std::string& group) {
  const int index = findGroup(rig, group);
  return index < 0 ? kNoGroup : groupColor(colorSlot(rig, index));
}

glm::vec3 toLinear(const glm::vec3& srgb) {
  const auto decode = [](float s) { return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f); };
  return {decode(srgb.r), decode(srgb.g), decode(srgb.b)};
}

namespace {

float decoded(float s) { return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f); }
float encoded(float l) { return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1.0f / 2.4f) - 0.055f; }

/// Lightness 0..1, chroma, hue in radians -> clamped sRGB.
glm::vec3 fromOklch(float lightness, float chroma, float hue) {
  const float a = chroma * std::cos(hue), b = chroma * std::sin(hue);
  const auto cubed = [](float x) { return x * x * x; };
  const float l = cubed(lightness + 0.3963377774f * a + 0.2158037573f * b);
  const float m = cubed(lightness - 0.1055613458f * a - 0.0638541728f * b);
  const float s = cubed(lightness - 0.0894841775f * a - 1.2914855480f * b);
  const glm::vec3 linear(4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s,
                         -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s,
                         -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s);
  return srgbFromLinear(glm::clamp(linear, glm::vec3(0.0f), glm::vec3(1.0f)));
}

constexpr float kMiddleLightness = 0.78f;
constexpr float kEndLightness = 0.44f;
constexpr float kMostChroma = 0.19f;
constexpr float kInwardsHue = 4.53f;   ///< Blue.
constexpr float kOutwardsHue = 0.60f;  ///< Vermilion.

std::array<glm::vec3, 9> makeHeatStops() {
  std::array<glm::vec3, 9> stops{};
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const float x = static_cast<float>(i) / 4.0f - 1.0f;
    const float far = std::abs(x);
    const float lightness = kMiddleLightness + (kEndLightness - kMiddleLightness) * far;
    // Chroma grows fast at first, so that small displacements are visible.
    const float chroma = kMostChroma * std::pow(far, 0.7f) + 0.004f;
    stops[i] = fromOklch(lightness, chroma, x < 0.0f ? kInwardsHue : kOutwardsHue);
  }
  return stops;
}

}  // namespace

glm::vec3 linearFromSrgb(const glm::vec3& srgb) { return {decoded(srgb.r), decoded(srgb.g), decoded(srgb.b)}; }
glm::vec3 srgbFromLinear(const glm::vec3& linear) { return {encoded(linear.r), encoded(linear.g), encoded(linear.b)}; }

const std::array<glm::vec3, 9>& heatStops() {
  static const std::array<glm::vec3, 9> stops = makeHeatStops();
  return stops;
}

glm::vec3 heatColor(float x) {
  const auto& stops = heatStops();
  if (x <= -1.0f) return stops.front();
  if (x >= 1.0f) return stops.back();
  const float at = (x * 0.5f + 0.5f) * static_cast<float>(stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return srgbFromLinear(
      glm::mix(linearFromSrgb(stops[low]), linearFromSrgb(stops[low + 1]), at - static_cast<float>(low)));
}

const std::array<ClassColor, 3>& classColors() {
  static const std::array<ClassColor, 3> colors{
      {{TriangleClass::kNormal, "Plain skin", "Triangles that no muscle reaches (normal)", {0.36f, 0.49f, 0.66f}},
       {TriangleClass::kStraddling,
        "At edges",
        "Triangles with some corners reached by muscles (straddling)",
        {0.85f, 0.71f, 0.42f}},
       {TriangleClass::kImplicit, "On muscles", "Triangles shaped by muscles (implicit)", {0.80f, 0.46f, 0.38f}}}};
  return colors;
}

const std::array<LayerColor, 3>& layerColors() {
  static const std::array<LayerColor, 3> colors{
      {{SkinLayer::kSkin, "Skin", "Shaped by muscles", fromOklch(0.74f, 0.13f, 0.60f)},
       {SkinLayer::kCloth, "Cloth", "Follows the skin under it", fromOklch(0.74f, 0.12f, 5.10f)},
       {SkinLayer::kRigid, "Rigid", "Not changed by muscles", fromOklch(0.74f, 0.12f, 2.55f)}}};
  return colors;
}

std::size_t zoneOf(TriangleClass kind, SkinLayer layer) {
  if (layer == SkinLayer::kSkin) return static_cast<std::size_t>(kind);
  return classColors().size() + static_cast<std::size_t>(layer) - 1;
}

glm::vec3 zoneColor(std::size_t zone) {
  const std::size_t classes = classColors().size();
  return zone < classes ? classColors()[zone].srgb : layerColors()[zone - classes + 1].srgb;
}

const LayerColor& layerColor(SkinLayer layer) { return layerColors()[static_cast<std::size_t>(layer)]; }

int levelShown(const Refinement& refinement, int triangle) {
  const auto pieces = static_cast<float>(refinement.refinedTriangles(triangle));
  return std::clamp(static_cast<int>(std::lround(std::sqrt(pieces))), 1, kMaxDepth);
}

float levelShade(int level) { return glm::mix(1.3f, 0.22f, std::log2(static_cast<float>(level)) / 4.0f); }

glm::vec3 fleshColor(float activation) {
  constexpr glm::vec3 kLoose{0.585f, 0.340f, 0.308f}, kFlexed{0.632f, 0.105f, 0.115f};
  return srgbFromLinear(glm::mix(linearFromSrgb(kLoose), linearFromSrgb(kFlexed), std::clamp(activation, 0.0f, 1.0f)));
}

}  // namespace sinew::app
