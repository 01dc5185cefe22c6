// app/viewport/render/color_scales.h: colors that carry meaning; the picture and its legends share them.
#pragma once

#include <array>
#include <cstddef>

#include "sinew/geometry/geometry.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// Light as a screen encodes it, 0..1, and back. Components alike.
[[nodiscard]] glm::vec3 linearFromSrgb(const glm::vec3& srgb);
[[nodiscard]] glm::vec3 srgbFromLinear(const glm::vec3& linear);

/// Stops of the displacement scale, evenly spaced from -1 (pushed in by the range) over 0 (untouched) to +1 (lifted by
/// it). sRGB 0..1. Diverging: a light neutral in the middle, two hues that darken by even steps of lightness, so that
/// equal displacements look equally far (Oklab: B. Ottosson, "A perceptual color space for image processing", 2020).
[[nodiscard]] const std::array<glm::vec3, 9>& heatStops();

/// sRGB color at x, as the skin has it before light falls on it; x is clamped to -1..1. Between stops light is mixed.
[[nodiscard]] glm::vec3 heatColor(float x);

/// What a triangle class is called in the interface and shown in.
struct ClassColor {
  TriangleClass kind = TriangleClass::kNormal;
  const char* name = "";
  const char* hint = "";  ///< What it is, with the term.
  glm::vec3 srgb{0.0f};
};

/// By TriangleClass.
[[nodiscard]] const std::array<ClassColor, 3>& classColors();

/// What a part of the mesh is to the muscles, as the interface calls it and as it is tinted.
struct LayerColor {
  SkinLayer layer = SkinLayer::kSkin;
  const char* name = "";
  const char* hint = "";
  glm::vec3 srgb{0.0f};
};

/// By SkinLayer. Alike in lightness.
[[nodiscard]] const std::array<LayerColor, 3>& layerColors();
[[nodiscard]] const LayerColor& layerColor(SkinLayer layer);

/// What the picture of classes tells apart: the classes of skin, then cloth and rigid parts.
inline constexpr std::size_t kZones = 5;
[[nodiscard]] std::size_t zoneOf(TriangleClass kind, SkinLayer layer);
[[nodiscard]] glm::vec3 zoneColor(std::size_t zone);

/// Color of muscles from loose (0) to fully flexed (1), sRGB.
[[nodiscard]] glm::vec3 fleshColor(float activation);

/// Of adaptive detail, in the picture of classes: a control triangle is drawn darker the more pieces it is split into.
/// 1..16: about as many along each side.
[[nodiscard]] int levelShown(const Refinement& refinement, int triangle);
/// What a level multiplies the color of a class by, linear (shaders/surface.frag).
[[nodiscard]] float levelShade(int level);

}  // namespace sinew::app
