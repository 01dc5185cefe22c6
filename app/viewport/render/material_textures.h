// app/viewport/render/material_textures.h: the character's textures on the graphics processor, and which of them a
// picture needs.
#pragma once

#include <map>

#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/scene.h"

namespace sinew::app {

/// Maps of a material that a program reads, as bits.
using MapSet = unsigned;
inline constexpr MapSet kNormalBit = 1, kRoughnessBit = 2, kOcclusionBit = 4, kEmissiveBit = 8;
/// The occlusion is in the roughness map, read once.
inline constexpr MapSet kSharedBit = 16;

class MaterialTextures {
 public:
  MaterialTextures();

  /// With mipmaps; colors are decoded from sRGB when they are read, all else is taken as it is.
  void set(const Character& character);
  /// Those that the textured shading, or clay with its relief, has of this material.
  [[nodiscard]] MapSet mapsOf(const Material& material, const DisplaySettings& settings) const;
  /// On unit 0; white where the material has none.
  void bindBase(const Material& material) const;
  /// On units 1 to 4, with what shaders/surface.frag wants to know of them.
  void bindMaps(const GlProgram& program, const Material& material, MapSet maps) const;

 private:
  /// By index in Character::textures. An image may be in both, if it is used so.
  using Uploaded = std::map<int, GlTexture>;
  static void upload(const Character& character, int texture, GLenum format, Uploaded& to);

  GlTexture white_;
  Uploaded colors_, values_;
};

}  // namespace sinew::app
