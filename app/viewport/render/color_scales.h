// app/viewport/render/color_scales.h: colors with a meaning, shared by the picture and its legends.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "app/viewport/render/scene.h"
#include "sinew/geometry/geometry.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

// Colors of groups and territories, in picture and panels.

/// The colors stay distinct with protanopia and deuteranopia, and from kTerritoryColor.
inline constexpr int kGroupColors = 8;

/// sRGB, 0..1. Paler and darker variants from kGroupColors on. @param slot  >= 0
[[nodiscard]] glm::vec3 groupColor(int slot);

/// The group's color slot, which it keeps for life. @param group  index into Rig::groups
[[nodiscard]] int colorSlot(const Rig& rig, int group);

[[nodiscard]] glm::vec3 groupColor(const Rig& rig, const std::string& group);  ///< sRGB; gray for an unknown group.

/// sRGB: the skin that a muscle may move, and its bones.
inline constexpr glm::vec3 kTerritoryColor{0.665f, 0.485f, 0.965f};

[[nodiscard]] glm::vec3 toLinear(const glm::vec3& srgb);  ///< sRGB -> linear.

// Linear colors of ellipsoids and their outlines.

/// Outline of one ellipsoid.
struct OutlineLook {
  glm::vec3 color{1.0f};
  float opacity = 1.0f;
  float width = 0.0f;   ///< Design pixels; 0: none.
  float dashes = 0.0f;  ///< Around the ellipsoid; 0: unbroken.
};

/// Its group's color; a selected one a little lighter.
[[nodiscard]] inline glm::vec3 shapeColor(const PrimitiveShape& shape) {
  return shape.selected ? glm::mix(shape.color, glm::vec3(1.0f), 0.12f) : shape.color;
}

/// Amber: selected, the active one brightest. Broken amber: its twin. White: hovered.
[[nodiscard]] inline OutlineLook outlineLook(const PrimitiveShape& shape) {
  if (shape.active) return {{1.00f, 0.66f, 0.10f}, 1.0f, 3.0f, 0.0f};
  if (shape.selected) return {{0.95f, 0.32f, 0.04f}, 1.0f, 2.2f, 0.0f};
  if (shape.hovered) return {{1.00f, 1.00f, 1.00f}, 0.72f, 1.8f, 0.0f};
  if (shape.twin) return {{1.00f, 0.60f, 0.12f}, 0.85f, 2.2f, 20.0f};
  return {};
}

// By component, 0..1.
[[nodiscard]] glm::vec3 linearFromSrgb(const glm::vec3& srgb);
[[nodiscard]] glm::vec3 srgbFromLinear(const glm::vec3& linear);

/// Stops of the displacement scale, sRGB, evenly spaced from -1 (inwards by the range) to +1 (outwards). A light
/// neutral between two hues that darken evenly, so that equal displacements look equal (Oklab: B. Ottosson, "A
/// perceptual color space for image processing", 2020).
[[nodiscard]] const std::array<glm::vec3, 9>& heatStops();

[[nodiscard]] glm::vec3 heatColor(float x);  ///< Unlit sRGB color at x, clamped to -1..1; interpolated in linear light.

/// Name and color of a triangle class in the interface.
struct ClassColor {
  TriangleClass kind = TriangleClass::kNormal;
  const char* name = "";
  const char* hint = "";  ///< With the term of the paper.
  glm::vec3 srgb{0.0f};
};

[[nodiscard]] const std::array<ClassColor, 3>& classColors();  ///< By TriangleClass.

/// Name and tint of a layer in the interface.
struct LayerColor {
  SkinLayer layer = SkinLayer::kSkin;
  const char* name = "";
  const char* hint = "";
  glm::vec3 srgb{0.0f};
};

[[nodiscard]] const std::array<LayerColor, 3>& layerColors();  ///< By SkinLayer, equal in lightness.
[[nodiscard]] const LayerColor& layerColor(SkinLayer layer);

// Colors of Shading::kClasses: the classes of skin, then cloth and rigid parts.
inline constexpr std::size_t kZones = 5;
[[nodiscard]] std::size_t zoneOf(TriangleClass kind, SkinLayer layer);
[[nodiscard]] glm::vec3 zoneColor(std::size_t zone);

[[nodiscard]] glm::vec3 fleshColor(float activation);  ///< Color of muscles from relaxed (0) to fully flexed (1), sRGB.

/// Subdivision level of a control triangle for Shading::kClasses, 1..16: about its pieces along each side.
[[nodiscard]] int levelShown(const Refinement& refinement, int triangle);
/// Linear factor on the color of a class; finer levels are darker (shaders/surface.frag).
[[nodiscard]] float levelShade(int level);

}  // namespace sinew::app
