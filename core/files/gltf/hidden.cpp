// core/files/gltf/hidden.cpp: the largest alpha of each material, and what is hidden by it.

#include "core/files/gltf/hidden.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "core/geometry/at.h"

namespace sinew::gltf {
namespace {

/// Less than this rounds to nothing in a picture of 8 bits.
constexpr float kLeastShown = 0.5f / 255.0f;

/// [materials] the largest alpha of the vertex colors; nullopt: no triangle uses the material.
std::vector<std::optional<float>> vertexAlphas(const Character& character) {
  std::vector<std::optional<float>> largest(character.materials.size());
  for (const ControlTriangle& triangle : character.mesh.triangles) {
    std::optional<float>& own = at(largest, triangle.material);
    for (const int wedge : triangle.wedges) {
      own = std::max(own.value_or(0.0f), at(character.mesh.wedges, wedge).color.a);
    }
  }
  return largest;
}

/// Largest alpha, 0..1.
float textureAlpha(const Texture& texture) {
  std::uint8_t largest = 0;
  for (std::size_t i = 3; i < texture.rgba.size() && largest < 255; i += 4) {
    largest = std::max(largest, texture.rgba[i]);
  }
  return static_cast<float>(largest) / 255.0f;
}

bool hides(const Material& material, float alpha) {
  if (material.alphaMode == AlphaMode::kMask) return alpha < material.alphaCutoff;
  return material.alphaMode == AlphaMode::kBlend && alpha < kLeastShown;
}

std::string shortText(float number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 3).ptr;
  return {text.data(), end};
}

std::string noteOf(const Material& material, float alpha) {
  std::string note = "material \"" + material.name + "\": its alpha of ";
  note += (alpha > 0.0f ? "at most " : "") + shortText(alpha);
  if (material.alphaMode == AlphaMode::kMask) note += " (cutoff " + shortText(material.alphaCutoff) + ')';
  return note + " would hide the whole character; shown opaque";
}

/// Looks at each texture once, and only if asked for.
class TextureAlphas {
 public:
  explicit TextureAlphas(const std::vector<Texture>& textures) : textures_(textures), known_(textures.size()) {}

  float of(const Material& material) {
    if (material.baseColorTexture < 0) return 1.0f;
    std::optional<float>& known = at(known_, material.baseColorTexture);
    if (!known) known = textureAlpha(at(textures_, material.baseColorTexture));
    return *known;
  }

 private:
  const std::vector<Texture>& textures_;
  std::vector<std::optional<float>> known_;
};

}  // namespace

void showHiddenCharacter(Character& character, Notes& notes) {
  const std::vector<std::optional<float>> vertexAlpha = vertexAlphas(character);
  std::vector<float> alphas(character.materials.size(), 1.0f);
  TextureAlphas textureAlphas(character.textures);
  for (std::size_t m = 0; m < alphas.size(); ++m) {
    const Material& material = character.materials[m];
    if (!vertexAlpha[m]) continue;
    if (material.alphaMode == AlphaMode::kOpaque) return;
    alphas[m] = material.baseColor.a * *vertexAlpha[m];
    if (!hides(material, alphas[m])) alphas[m] *= textureAlphas.of(material);
    if (!hides(material, alphas[m])) return;
  }
  for (std::size_t m = 0; m < alphas.size(); ++m) {
    if (!vertexAlpha[m]) continue;
    character.materials[m].shownOpaque = true;
    notes.add(noteOf(character.materials[m], alphas[m]));
  }
}

}  // namespace sinew::gltf
