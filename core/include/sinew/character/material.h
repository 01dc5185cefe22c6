// core/include/sinew/character/material.h: materials and textures of a character.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sinew/geometry/geometry.h"

namespace sinew {

enum class TextureWrap { kRepeat, kClampToEdge, kMirroredRepeat };

/// 8-bit RGBA image, top row first; width * height * 4 bytes. Colors are sRGB, other data is linear.
struct Texture {
  std::string name;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  std::vector<std::uint8_t> encoded;  ///< The original PNG, JPEG or WebP, for export.
  std::string mimeType;               ///< "image/png", "image/jpeg" or "image/webp".
  TextureWrap wrapU = TextureWrap::kRepeat;
  TextureWrap wrapV = TextureWrap::kRepeat;
  bool nearest = false;  ///< Magnify without smoothing.
};

enum class AlphaMode { kOpaque, kMask, kBlend };

/// A texture other than the base color, and its texture coordinates.
struct TextureMap {
  int texture = -1;                                                          ///< Index into Character::textures, or -1.
  std::array<glm::vec3, 2> place{{{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}};  ///< Rows: Wedge::uv and 1 -> u, v.

  friend bool operator==(const TextureMap&, const TextureMap&) = default;
};

/// glTF's metallic-roughness model (glTF 2.0, 3.9, B). Colors linear; base color: baseColor * texture * Wedge::color.
struct Material {
  std::string name;
  glm::vec4 baseColor{1.0f};
  int baseColorTexture = -1;  ///< Index into Character::textures, or -1.
  float metallic = 0.0f;      ///< 0..1
  float roughness = 1.0f;     ///< 0..1
  glm::vec3 emissive{0.0f};   ///< Times the strength; may be above 1.
  AlphaMode alphaMode = AlphaMode::kOpaque;
  float alphaCutoff = 0.5f;
  bool doubleSided = false;
  bool shownOpaque = false;  ///< Drawn as kOpaque, since its alpha would hide the whole character. Exports keep alpha.
  bool unlit = false;        ///< Shows the base color in any light.
  TextureMap metallicRoughnessMap{};  ///< Linear: green times roughness, blue times metallic.
  TextureMap normalMap{};             ///< Linear: 2 rgb - 1 along u, against v and along the normal.
  float normalScale = 1.0f;           ///< Factor on the first two.
  TextureMap occlusionMap{};          ///< Linear: red is the fraction of ambient light that arrives.
  float occlusionStrength = 1.0f;     ///< 0..1
  TextureMap emissiveMap{};           ///< sRGB, times emissive.
};

}  // namespace sinew
