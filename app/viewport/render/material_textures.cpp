// app/viewport/render/material_textures.cpp: uploading and binding textures.
#include "app/viewport/render/material_textures.h"

#include <algorithm>
#include <array>

namespace sinew::app {
namespace {

GLint glWrapOf(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::kClampToEdge:
      return GL_CLAMP_TO_EDGE;
    case TextureWrap::kMirroredRepeat:
      return GL_MIRRORED_REPEAT;
    case TextureWrap::kRepeat:
      break;
  }
  return GL_REPEAT;
}

GlTexture uploadImage(const Texture& image, GLenum format) {
  GlTexture texture = uploadTexture(format, image.width, image.height, image.rgba, true);
  const GLuint id = texture.id();
  glTextureParameteri(id, GL_TEXTURE_WRAP_S, glWrapOf(image.wrapU));
  glTextureParameteri(id, GL_TEXTURE_WRAP_T, glWrapOf(image.wrapV));
  if (image.nearest) glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  // On the processor, anisotropic filtering costs more than all other shading.
  if (!isSoftwareRenderer() && (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") ||
                                epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic"))) {
    GLfloat most = 1.0f;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    glTextureParameterf(id, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(most, 8.0f));
  }
  return texture;
}

}  // namespace

MaterialTextures::MaterialTextures() {
  Texture white;
  white.width = white.height = 1;
  white.rgba = {255, 255, 255, 255};
  white_ = uploadImage(white, GL_SRGB8_ALPHA8);
}

void MaterialTextures::upload(const Character& character, int texture, GLenum format, Uploaded& to) {
  const auto index = static_cast<std::size_t>(texture);
  if (texture < 0 || index >= character.textures.size() || to.contains(texture)) return;
  const Texture& image = character.textures[index];
  const bool whole =
      image.width > 0 && image.height > 0 &&
      image.rgba.size() >= 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (whole) to.emplace(texture, uploadImage(image, format));
}

void MaterialTextures::set(const Character& character) {
  colors_.clear();
  values_.clear();
  for (const Material& material : character.materials) {
    for (const int color : {material.baseColorTexture, material.emissiveMap.texture}) {
      upload(character, color, GL_SRGB8_ALPHA8, colors_);
    }
    for (const TextureMap* map : {&material.normalMap, &material.metallicRoughnessMap, &material.occlusionMap}) {
      upload(character, map->texture, GL_RGBA8, values_);
    }
  }
}

MapSet MaterialTextures::mapsOf(const Material& material, const DisplaySettings& settings) const {
  const bool embossed = values_.contains(material.normalMap.texture) && !material.unlit;
  if (settings.shading == Shading::kClay) return embossed && settings.relief ? kNormalBit : 0;
  if (settings.shading != Shading::kTextured || material.unlit || !settings.lighting) return 0;
  MapSet maps = embossed ? kNormalBit : 0;
  const TextureMap& rough = material.metallicRoughnessMap;
  if (values_.contains(rough.texture)) maps |= kRoughnessBit;
  if (values_.contains(material.occlusionMap.texture)) {
    maps |= (maps & kRoughnessBit) != 0 && rough == material.occlusionMap ? kSharedBit : kOcclusionBit;
  }
  if (colors_.contains(material.emissiveMap.texture)) maps |= kEmissiveBit;
  return maps;
}

void MaterialTextures::bindBase(const Material& material) const {
  const auto found = colors_.find(material.baseColorTexture);
  glBindTextureUnit(0, found != colors_.end() ? found->second.id() : white_.id());
}

void MaterialTextures::bindMaps(const GlProgram& program, const Material& material, MapSet maps) const {
  if (maps == 0) return;
  struct Use {
    const TextureMap& map;
    MapSet bit;
    const Uploaded& from;
  };
  const std::array<Use, 4> uses{{{material.normalMap, kNormalBit, values_},
                                 {material.metallicRoughnessMap, kRoughnessBit, values_},
                                 {material.occlusionMap, kOcclusionBit, values_},
                                 {material.emissiveMap, kEmissiveBit, colors_}}};
  std::array<glm::vec4, 8> places{};
  for (std::size_t i = 0; i < uses.size(); ++i) {
    places[2 * i] = glm::vec4(uses[i].map.place[0], 0.0f);
    places[2 * i + 1] = glm::vec4(uses[i].map.place[1], 0.0f);
    if ((maps & uses[i].bit) != 0) {
      glBindTextureUnit(static_cast<GLuint>(i + 1), uses[i].from.at(uses[i].map.texture).id());
    }
  }
  program.set("mapPlaces", std::span<const glm::vec4>(places));
  program.set("mapStrengths", glm::vec2(material.normalScale, material.occlusionStrength));
}

}  // namespace sinew::app
