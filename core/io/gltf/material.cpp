// core/io/gltf/material.cpp: the part of glTF's materials that Sinew draws.

#include "core/io/gltf/material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/at.h"
#include "core/io/gltf/image.h"

namespace sinew::gltf {
namespace {

constexpr std::size_t kMaxPixels = 96U << 20;         // of all textures: 384 MiB as RGBA
constexpr std::size_t kMaxEncodedBytes = 256U << 20;  // kept for export

float unit(double number) { return static_cast<float>(std::clamp(number, 0.0, 1.0)); }

TextureWrap wrapOf(int mode) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return TextureWrap::kClampToEdge;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return TextureWrap::kMirroredRepeat;
    default:
      return TextureWrap::kRepeat;
  }
}

// tinygltf keeps extensions as loose values; the guard has seen to their types.

const tinygltf::Value* find(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

double number(const tinygltf::Value& object, const char* key, double fallback) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

template <std::size_t N>
void numbers(const tinygltf::Value& object, const char* key, std::array<double, N>& out) {
  for (std::size_t i = 0; object.Has(key) && i < N; ++i) {
    out[i] = object.Get(key).Get(static_cast<int>(i)).GetNumberAsDouble();
  }
}

/// Rotation about the origin, counter-clockwise in uv, then offset (KHR_texture_transform).
void readTransform(const tinygltf::Value& from, UvSource& uv) {
  std::array<double, 2> offset{0.0, 0.0};
  std::array<double, 2> scale{1.0, 1.0};
  numbers(from, "offset", offset);
  numbers(from, "scale", scale);
  const double angle = number(from, "rotation", 0.0);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  uv.transform = {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]};
  if (from.Has("texCoord")) uv.set = from.Get("texCoord").GetNumberAsInt();
}

class MaterialReader {
 public:
  MaterialReader(File& file, Notes& notes) : file_(file), notes_(notes) {}

  Materials run() && {
    for (std::size_t i = 0; i < file_.model().materials.size(); ++i) read(i);
    return std::move(result_);
  }

 private:
  void read(std::size_t index) {
    const std::string place = placeOf("materials", index);
    file_.expectSound(place);
    const tinygltf::Material& from = file_.model().materials[index];
    Material material;
    UvSource uv;
    material.name = from.name.empty() ? "material " + std::to_string(index) : from.name;
    if (const auto* glossiness = find(from.extensions, "KHR_materials_pbrSpecularGlossiness")) {
      readGlossiness(*glossiness, material, uv);
    } else {
      file_.expectSound(place + ".pbrMetallicRoughness");
      readMetallic(from.pbrMetallicRoughness, material, uv);
    }
    if (find(from.extensions, "KHR_materials_unlit")) {
      material.metallic = 0.0f;
      material.roughness = 1.0f;
    }
    if (from.emissiveTexture.index >= 0) notes_.add("emissive textures are ignored: these materials do not glow");
    else
      for (int i = 0; i < 3; ++i) material.emissive[i] = unit(at(from.emissiveFactor, i));
    readAlpha(from, place, material);
    material.doubleSided = from.doubleSided;
    if (from.normalTexture.index >= 0) notes_.add("normal textures are ignored: fine relief is not shown");
    if (from.occlusionTexture.index >= 0) notes_.add("occlusion textures are ignored: crevices are not darkened");
    result_.materials.push_back(std::move(material));
    result_.uvSources.push_back(uv);
  }

  void readMetallic(const tinygltf::PbrMetallicRoughness& pbr, Material& material, UvSource& uv) {
    for (int i = 0; i < 4; ++i) material.baseColor[i] = unit(at(pbr.baseColorFactor, i));
    material.metallic = unit(pbr.metallicFactor);
    material.roughness = unit(pbr.roughnessFactor);
    const tinygltf::TextureInfo& texture = pbr.baseColorTexture;
    if (texture.index >= 0) {
      uv.set = texture.texCoord;
      if (const auto* transform = find(texture.extensions, "KHR_texture_transform")) readTransform(*transform, uv);
      material.baseColorTexture = readTexture(texture.index);
    }
    if (pbr.metallicRoughnessTexture.index >= 0) {
      // The factors only scale the texture; alone they would turn skin into chrome.
      material.metallic = 0.0f;
      notes_.add("metallic-roughness textures are ignored: these materials look non-metallic");
    }
  }

  void readGlossiness(const tinygltf::Value& glossiness, Material& material, UvSource& uv) {
    std::array<double, 4> color{1.0, 1.0, 1.0, 1.0};
    numbers(glossiness, "diffuseFactor", color);
    for (int i = 0; i < 4; ++i) material.baseColor[i] = unit(at(color, i));
    material.metallic = 0.0f;
    material.roughness = 1.0f - unit(number(glossiness, "glossinessFactor", 1.0));
    if (const tinygltf::Value& texture = glossiness.Get("diffuseTexture"); texture.IsObject()) {
      uv.set = static_cast<int>(number(texture, "texCoord", 0.0));
      const tinygltf::Value& extensions = texture.Get("extensions");
      if (extensions.Has("KHR_texture_transform")) readTransform(extensions.Get("KHR_texture_transform"), uv);
      material.baseColorTexture = readTexture(texture.Get("index").GetNumberAsInt());
    }
    if (glossiness.Has("specularGlossinessTexture")) {
      material.roughness = 1.0f;
      notes_.add("specular-glossiness textures are ignored: gloss is the same all over");
    }
  }

  static void readAlpha(const tinygltf::Material& from, const std::string& place, Material& material) {
    if (from.alphaMode == "MASK") material.alphaMode = AlphaMode::kMask;
    else if (from.alphaMode == "BLEND") material.alphaMode = AlphaMode::kBlend;
    else if (from.alphaMode != "OPAQUE") refuse(place + ".alphaMode", "expected OPAQUE, MASK or BLEND");
    material.alphaCutoff = unit(from.alphaCutoff);
  }

  /// Index into the result's textures, or -1.
  int readTexture(int index) {
    const std::string place = placeOf("textures", toIndex(index));
    file_.expectSound(place);
    const tinygltf::Texture& texture = file_.model().textures[toIndex(index)];
    const int source = sourceOf(texture);
    if (source < 0) {
      notes_.add(place + " has no PNG, JPEG or WebP source and is ignored: the material is drawn without");
      return -1;
    }
    const Texture settings = readSampler(texture.sampler);
    const auto key = std::tuple(source, settings.wrapU, settings.wrapV, settings.nearest);
    const auto known = known_.find(key);
    return known != known_.end() ? known->second : known_[key] = makeTexture(toIndex(source), settings);
  }

  /// The WebP image where there is one: the other is for programs that cannot read it.
  static int sourceOf(const tinygltf::Texture& texture) {
    const auto* webp = find(texture.extensions, "EXT_texture_webp");
    return webp && webp->Has("source") ? webp->Get("source").GetNumberAsInt() : texture.source;
  }

  Texture readSampler(int index) const {
    Texture settings;
    if (index < 0) return settings;
    file_.expectSound(placeOf("samplers", toIndex(index)));
    const tinygltf::Sampler& sampler = file_.model().samplers[toIndex(index)];
    settings.wrapU = wrapOf(sampler.wrapS);
    settings.wrapV = wrapOf(sampler.wrapT);
    settings.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    return settings;
  }

  int makeTexture(std::size_t index, Texture texture) {
    const auto leaveOut = [&](const std::string& why) {
      notes_.add(placeOf("images", index) + ": " + why + "; it is ignored: the material is drawn without");
      return -1;
    };
    Result<EncodedImage> encoded = file_.encodedImage(index);
    if (!encoded) return leaveOut(encoded.error().reason);
    const Bytes bytes = encoded->bytes;
    if (bytes.size() > kMaxEncodedBytes - encodedBytes_) return leaveOut("the images are too large together");
    Result<Image> image = decodeImage(bytes, kMaxPixels - pixels_);
    if (!image) return leaveOut(image.error().reason);
    texture.name = file_.model().images[index].name;
    if (texture.name.empty()) texture.name = "image " + std::to_string(index);
    texture.width = image->width;
    texture.height = image->height;
    texture.rgba = std::move(image.value().rgba);
    texture.mimeType = image->mimeType;
    texture.encoded.assign(bytes.begin(), bytes.end());
    pixels_ += texture.rgba.size() / 4;
    encodedBytes_ += texture.encoded.size();
    result_.textures.push_back(std::move(texture));
    return static_cast<int>(result_.textures.size()) - 1;
  }

  File& file_;
  Notes& notes_;
  std::map<std::tuple<int, TextureWrap, TextureWrap, bool>, int> known_;
  std::size_t pixels_ = 0;
  std::size_t encodedBytes_ = 0;
  Materials result_;
};

}  // namespace

glm::vec2 UvSource::apply(double u, double v) const {
  return {static_cast<float>(transform[0] * u + transform[1] * v + transform[2]),
          static_cast<float>(transform[3] * u + transform[4] * v + transform[5])};
}

Materials readMaterials(File& file, Notes& notes) { return MaterialReader(file, notes).run(); }

}  // namespace sinew::gltf
