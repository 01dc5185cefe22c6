// core/files/gltf/material.cpp: decoding PNG, JPEG and WebP; metallic-roughness materials (glTF 2.0, 3.9).
#include "core/files/gltf/material.h"

#include <cmath>
#include <map>
#include <memory>
#include <tuple>
#include <utility>

#include <stb_image.h>
#include <webp/decode.h>

#include "core/geometry/at.h"

namespace sinew::gltf {

// Images.

namespace {

/// Width and height of a still WebP image; nullopt if damaged or animated.
std::optional<std::pair<int, int>> webpSize(std::span<const std::uint8_t> bytes) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK || features.has_animation != 0) {
    return std::nullopt;
  }
  return std::pair(features.width, features.height);
}

/// RGBA pixels; empty if damaged. The size has been checked.
std::vector<std::uint8_t> webpPixels(std::span<const std::uint8_t> bytes) {
  const auto size = webpSize(bytes);
  if (!size) return {};
  std::vector<std::uint8_t> rgba(4 * toIndex(size->first) * toIndex(size->second));
  const bool whole =
      WebPDecodeRGBAInto(bytes.data(), bytes.size(), rgba.data(), rgba.size(), 4 * size->first) != nullptr;
  return whole ? rgba : std::vector<std::uint8_t>();
}

constexpr std::uint64_t kMaxDeflateRatio = 1032;  ///< Largest compression ratio of deflate.
/// Compressed pixels that unpack to no more than this need no test.
constexpr std::uint64_t kHarmlessBytes = 256U << 20;
constexpr int kMaxScans = 200;  ///< Each scan of a progressive JPEG visits the whole image; encoders write about ten.

std::uint32_t bigEndian(Bytes bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) << 24 | static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 8 | static_cast<std::uint32_t>(bytes[at + 3]);
}

/// All IDAT data of a PNG.
std::string pngPixelData(Bytes png) {
  std::string data;
  for (std::size_t at = 8; at + 12 <= png.size();) {
    const std::size_t length = bigEndian(png, at);
    if (length > png.size() - at - 12) break;
    if (startsWith(png.subspan(at + 4), "IDAT")) data.append(reinterpret_cast<const char*>(&png[at + 8]), length);
    at += 12 + length;
  }
  return data;
}

/// Whether the pixels unpack to no more than the dimensions allow, which stb_image does not check.
bool unpacksWithin(Bytes png, int width, int height) {
  const std::string data = pngPixelData(png);
  if (data.size() * kMaxDeflateRatio <= kHarmlessBytes) return true;
  constexpr std::size_t kMaxPixelBytes = 8;  // four channels of 16 bits
  // Interlacing adds a filter byte a row to each of seven passes.
  const std::size_t most = toIndex(width) * toIndex(height) * kMaxPixelBytes + 16 * toIndex(height) + 1024;
  const auto room = std::make_unique_for_overwrite<char[]>(most);
  return stbi_zlib_decode_buffer(room.get(), static_cast<int>(most), data.data(), static_cast<int>(data.size())) >= 0;
}

int countScans(Bytes jpeg) {
  int scans = 0;
  for (std::size_t i = 0; i + 1 < jpeg.size(); ++i) {
    if (jpeg[i] == 0xff && jpeg[i + 1] == 0xda) ++scans;
  }
  return scans;
}

/// Error: reason only.
Result<void> checkSize(const Image& image, std::size_t maxPixels) {
  if (image.width <= 0 || image.height <= 0 || image.width > kMaxImageSide || image.height > kMaxImageSide) {
    return errorAt("", "the image is " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                           " pixels; at most 8192 x 8192 are read");
  }
  if (toIndex(image.width) * toIndex(image.height) <= maxPixels) return {};
  return errorAt("", "the file's images have too many pixels together");
}

Result<Image> decodeWebp(Bytes encoded, std::size_t maxPixels) {
  const auto size = webpSize(encoded);
  if (!size) return errorAt("", "damaged image: no WebP, or one that moves");
  Image image{.width = size->first, .height = size->second, .rgba = {}, .mimeType = "image/webp"};
  if (auto bearable = checkSize(image, maxPixels); !bearable) return bearable.error();
  image.rgba = webpPixels(encoded);
  if (image.rgba.empty()) return errorAt("", "damaged image: its WebP data cannot be decoded");
  return image;
}

}  // namespace

Result<Image> decodeImage(Bytes encoded, std::size_t maxPixels) {
  const bool png = startsWith(encoded, "\x89PNG\r\n\x1a\n");
  const bool jpeg = startsWith(encoded, "\xff\xd8\xff");
  if (encoded.size() > 0x40000000) return errorAt("", "the image file is larger than 1 GiB");
  if (isWebp(encoded)) return decodeWebp(encoded, maxPixels);
  if (!png && !jpeg) return errorAt("", "not a PNG, JPEG or WebP image");
  const auto length = static_cast<int>(encoded.size());

  Image image;
  int channels = 0;
  if (stbi_info_from_memory(encoded.data(), length, &image.width, &image.height, &channels) == 0) {
    return errorAt("", std::string("damaged image: ") + stbi_failure_reason());
  }
  if (auto bearable = checkSize(image, maxPixels); !bearable) return bearable.error();
  const std::size_t pixels = toIndex(image.width) * toIndex(image.height);
  if (png && !unpacksWithin(encoded, image.width, image.height)) {
    return errorAt("", "damaged image: it unpacks to more than its dimensions");
  }
  if (jpeg && countScans(encoded) > kMaxScans) return errorAt("", "a JPEG with more than 200 scans");

  const std::unique_ptr<stbi_uc, void (*)(void*)> decoded(
      stbi_load_from_memory(encoded.data(), length, &image.width, &image.height, &channels, 4), stbi_image_free);
  if (!decoded) return errorAt("", std::string("damaged image: ") + stbi_failure_reason());
  image.rgba.assign(decoded.get(), decoded.get() + 4 * pixels);
  image.mimeType = png ? "image/png" : "image/jpeg";
  return image;
}

// Materials.

namespace {

constexpr std::size_t kMaxPixels = 96U << 20;         // of all textures: 384 MiB of RGBA
constexpr std::size_t kMaxEncodedBytes = 256U << 20;  // kept for export

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

/// Prefers the WebP image: the other is a fallback.
int sourceOf(const tinygltf::Texture& texture) {
  const auto* webp = findExtension(texture.extensions, "EXT_texture_webp");
  return webp && webp->Has("source") ? webp->Get("source").GetNumberAsInt() : texture.source;
}

/// Decodes textures when they are first asked for, within one budget for all.
class TextureReader {
 public:
  TextureReader(File& file, Notes& notes) : file_(file), notes_(notes) {}

  /// Index into take(); -1: unreadable, which is noted. Refuses an unsound texture and a uri outside the folder.
  int read(int index) {
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
    return known != known_.end() ? known->second : known_[key] = decode(toIndex(source), settings);
  }

  [[nodiscard]] std::vector<Texture> take() && { return std::move(textures_); }

 private:
  [[nodiscard]] Texture readSampler(int index) const {
    Texture settings;
    if (index < 0) return settings;
    file_.expectSound(placeOf("samplers", toIndex(index)));
    const tinygltf::Sampler& sampler = file_.model().samplers[toIndex(index)];
    settings.wrapU = wrapOf(sampler.wrapS);
    settings.wrapV = wrapOf(sampler.wrapT);
    settings.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    return settings;
  }

  int decode(std::size_t image, Texture texture) {
    const auto leaveOut = [&](const std::string& why) {
      notes_.add(placeOf("images", image) + ": " + why + "; it is ignored: the material is drawn without");
      return -1;
    };
    Result<EncodedImage> encoded = file_.encodedImage(image);
    if (!encoded) return leaveOut(encoded.error().reason);
    const Bytes bytes = encoded->bytes;
    if (bytes.size() > kMaxEncodedBytes - encodedBytes_) return leaveOut("the images are too large together");
    Result<Image> decoded = decodeImage(bytes, kMaxPixels - pixels_);
    if (!decoded) return leaveOut(decoded.error().reason);
    texture.name = file_.model().images[image].name;
    if (texture.name.empty()) texture.name = "image " + std::to_string(image);
    texture.width = decoded->width;
    texture.height = decoded->height;
    texture.rgba = std::move(decoded.value().rgba);
    texture.mimeType = decoded->mimeType;
    texture.encoded.assign(bytes.begin(), bytes.end());
    pixels_ += texture.rgba.size() / 4;
    encodedBytes_ += texture.encoded.size();
    textures_.push_back(std::move(texture));
    return static_cast<int>(textures_.size()) - 1;
  }

  File& file_;
  Notes& notes_;
  std::map<std::tuple<int, TextureWrap, TextureWrap, bool>, int> known_;
  std::size_t pixels_ = 0;
  std::size_t encodedBytes_ = 0;
  std::vector<Texture> textures_;
};

/// Rotation about the origin, counter-clockwise in uv, then offset. @param transform  KHR_texture_transform, or null
UvSource uvSourceOf(int set, const tinygltf::Value* transform) {
  UvSource uv{.set = set};
  if (transform == nullptr) return uv;
  std::array<double, 2> offset{0.0, 0.0};
  std::array<double, 2> scale{1.0, 1.0};
  looseNumbers(*transform, "offset", offset);
  looseNumbers(*transform, "scale", scale);
  const double angle = looseNumber(*transform, "rotation", 0.0);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  uv.transform = {c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1]};
  if (transform->Has("texCoord")) uv.set = transform->Get("texCoord").GetNumberAsInt();
  return uv;
}

/// Map from the coordinates of `from` to those of `to`, as TextureMap::place. nullopt: other set, or singular `from`.
std::optional<std::array<glm::vec3, 2>> placeFrom(const UvSource& from, const UvSource& to) {
  if (from.set != to.set) return std::nullopt;
  if (from.transform == to.transform) return TextureMap{}.place;
  const auto& [a, b, c, d, e, f] = from.transform;
  const double determinant = a * e - b * d;
  std::array<glm::vec3, 2> place{};
  for (std::size_t row = 0; row < 2; ++row) {
    const double x = to.transform[3 * row], y = to.transform[3 * row + 1];
    const double u = (x * e - y * d) / determinant;
    const double v = (y * a - x * b) / determinant;
    place[row] = glm::vec3(u, v, to.transform[3 * row + 2] - u * c - v * f);
    if (!std::isfinite(place[row].x + place[row].y + place[row].z)) return std::nullopt;
  }
  return place;
}

constexpr double kMaxGlow = 1e4;  // KHR_materials_emissive_strength: more is just white

float unit(double number) { return static_cast<float>(std::clamp(number, 0.0, 1.0)); }

/// A map of a material, before its image is read.
struct NamedMap {
  TextureMap Material::*map = nullptr;
  int texture = -1;
  UvSource uv;
};

class MaterialReader {
 public:
  MaterialReader(File& file, Notes& notes, Images images)
      : file_(file), notes_(notes), images_(images), textures_(file, notes) {}

  /// Reads base colors first: they matter most if there are too many images.
  Materials run() && {
    for (std::size_t i = 0; i < file_.model().materials.size(); ++i) read(i);
    if (images_ == Images::kRead) {
      for (std::size_t i = 0; i < result_.materials.size(); ++i) {
        for (const NamedMap& named : maps_[i]) readMap(named, result_.uvSources[i], result_.materials[i]);
        settle(maps_[i], result_.materials[i]);
      }
    }
    result_.textures = std::move(textures_).take();
    return std::move(result_);
  }

 private:
  void read(std::size_t index) {
    const std::string place = placeOf("materials", index);
    file_.expectSound(place);
    const tinygltf::Material& from = file_.model().materials[index];
    Material material;
    std::optional<UvSource> uv;
    std::vector<NamedMap> maps;
    material.name = from.name.empty() ? "material " + std::to_string(index) : from.name;
    if (const auto* glossiness = findExtension(from.extensions, "KHR_materials_pbrSpecularGlossiness")) {
      readGlossiness(*glossiness, material, uv);
    } else {
      file_.expectSound(place + ".pbrMetallicRoughness");
      readMetallic(from.pbrMetallicRoughness, material, uv, maps);
    }
    readEmissive(from, material, maps);
    readRelief(from, material, maps);
    if (findExtension(from.extensions, "KHR_materials_unlit")) {
      material.unlit = true;
      material.metallic = 0.0f;
      material.roughness = 1.0f;
      maps.clear();
    }
    readAlpha(from, place, material);
    material.doubleSided = from.doubleSided;
    if (!uv && !maps.empty()) uv = maps.front().uv;
    result_.materials.push_back(std::move(material));
    result_.uvSources.push_back(uv.value_or(UvSource{}));
    maps_.push_back(std::move(maps));
  }

  void readMetallic(const tinygltf::PbrMetallicRoughness& pbr, Material& material, std::optional<UvSource>& uv,
                    std::vector<NamedMap>& maps) {
    for (int i = 0; i < 4; ++i) material.baseColor[i] = unit(at(pbr.baseColorFactor, i));
    material.metallic = unit(pbr.metallicFactor);
    material.roughness = unit(pbr.roughnessFactor);
    if (pbr.baseColorTexture.index >= 0) {
      uv = uvOf(pbr.baseColorTexture);
      material.baseColorTexture = readTexture(pbr.baseColorTexture.index);
    }
    addMap(&Material::metallicRoughnessMap, pbr.metallicRoughnessTexture, maps);
  }

  void readGlossiness(const tinygltf::Value& glossiness, Material& material, std::optional<UvSource>& uv) {
    std::array<double, 4> color{1.0, 1.0, 1.0, 1.0};
    looseNumbers(glossiness, "diffuseFactor", color);
    for (int i = 0; i < 4; ++i) material.baseColor[i] = unit(at(color, i));
    material.metallic = 0.0f;
    material.roughness = 1.0f - unit(looseNumber(glossiness, "glossinessFactor", 1.0));
    if (const tinygltf::Value& texture = glossiness.Get("diffuseTexture"); texture.IsObject()) {
      const tinygltf::Value& extensions = texture.Get("extensions");
      const bool placed = extensions.Has("KHR_texture_transform");
      uv = uvSourceOf(static_cast<int>(looseNumber(texture, "texCoord", 0.0)),
                      placed ? &extensions.Get("KHR_texture_transform") : nullptr);
      material.baseColorTexture = readTexture(texture.Get("index").GetNumberAsInt());
    }
    if (glossiness.Has("specularGlossinessTexture")) {
      material.roughness = 1.0f;
      notes_.add("specular-glossiness textures are ignored: gloss is the same all over");
    }
  }

  static void readEmissive(const tinygltf::Material& from, Material& material, std::vector<NamedMap>& maps) {
    double strength = 1.0;
    if (const auto* glow = findExtension(from.extensions, "KHR_materials_emissive_strength")) {
      strength = std::clamp(looseNumber(*glow, "emissiveStrength", 1.0), 0.0, kMaxGlow);
    }
    for (int i = 0; i < 3; ++i) {
      material.emissive[i] = unit(at(from.emissiveFactor, i)) * static_cast<float>(strength);
    }
    addMap(&Material::emissiveMap, from.emissiveTexture, maps);
  }

  static void readRelief(const tinygltf::Material& from, Material& material, std::vector<NamedMap>& maps) {
    constexpr double kMaxScale = 1e4;
    material.normalScale = static_cast<float>(std::clamp(from.normalTexture.scale, -kMaxScale, kMaxScale));
    material.occlusionStrength = unit(from.occlusionTexture.strength);
    addMap(&Material::normalMap, from.normalTexture, maps);
    addMap(&Material::occlusionMap, from.occlusionTexture, maps);
  }

  static void readAlpha(const tinygltf::Material& from, const std::string& place, Material& material) {
    if (from.alphaMode == "MASK") material.alphaMode = AlphaMode::kMask;
    else if (from.alphaMode == "BLEND") material.alphaMode = AlphaMode::kBlend;
    else if (from.alphaMode != "OPAQUE") refuse(place + ".alphaMode", "expected OPAQUE, MASK or BLEND");
    material.alphaCutoff = unit(from.alphaCutoff);
  }

  /// @param info  one of tinygltf's three kinds
  template <class Info>
  static UvSource uvOf(const Info& info) {
    return uvSourceOf(info.texCoord, findExtension(info.extensions, "KHR_texture_transform"));
  }

  template <class Info>
  static void addMap(TextureMap Material::*map, const Info& info, std::vector<NamedMap>& maps) {
    if (info.index >= 0) maps.push_back({map, info.index, uvOf(info)});
  }

  int readTexture(int index) { return images_ == Images::kRead ? textures_.read(index) : -1; }

  void readMap(const NamedMap& named, const UvSource& surface, Material& material) {
    const auto place = placeFrom(surface, named.uv);
    if (!place) {
      notes_.add(
          "maps with other texture coordinates than their material's first are ignored: the material is drawn without");
      return;
    }
    material.*named.map = {readTexture(named.texture), *place};
  }

  /// Resets factors of missing maps: unscaled they would turn skin into chrome or a lamp.
  static void settle(const std::vector<NamedMap>& named, Material& material) {
    for (const NamedMap& each : named) {
      if ((material.*each.map).texture >= 0) continue;
      if (each.map == &Material::metallicRoughnessMap) material.metallic = 0.0f;
      if (each.map == &Material::emissiveMap) material.emissive = glm::vec3(0.0f);
    }
  }

  File& file_;
  Notes& notes_;
  Images images_;
  TextureReader textures_;
  std::vector<std::vector<NamedMap>> maps_;  // [materials]
  Materials result_;
};

}  // namespace

glm::vec2 UvSource::apply(double u, double v) const {
  return {static_cast<float>(transform[0] * u + transform[1] * v + transform[2]),
          static_cast<float>(transform[3] * u + transform[4] * v + transform[5])};
}

Materials readMaterials(File& file, Notes& notes, Images images) { return MaterialReader(file, notes, images).run(); }

}  // namespace sinew::gltf
