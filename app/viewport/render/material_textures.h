// app/viewport/render/material_textures.h: the character's textures on the graphics card.
#pragma once

#include <map>

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/scene.h"

namespace sinew::app {

using MapSet = unsigned;  ///< Bits of the maps that a program reads.
inline constexpr MapSet kNormalBit = 1, kRoughnessBit = 2, kOcclusionBit = 4, kEmissiveBit = 8;
inline constexpr MapSet kSharedBit = 16;  ///< Occlusion is in the roughness map, read once.

class MaterialTextures {
 public:
  MaterialTextures();

  void set(const Character& character);  ///< With mipmaps. Colors are decoded from sRGB when read, others not.
  /// Maps of a material that textured shading, or clay with relief, uses.
  [[nodiscard]] MapSet mapsOf(const Material& material, const DisplaySettings& settings) const;
  void bindBase(const Material& material) const;  ///< On unit 0; white where the material has none.
  /// On units 1 to 4, with their uniforms of shaders/surface.frag.
  void bindMaps(const GlProgram& program, const Material& material, MapSet maps) const;

 private:
  using Uploaded = std::map<int, GlTexture>;  ///< By index in Character::textures. An image may be in both.
  static void upload(const Character& character, int texture, GLenum format, Uploaded& to);

  GlTexture white_;
  Uploaded colors_, values_;
};

}  // namespace sinew::app
