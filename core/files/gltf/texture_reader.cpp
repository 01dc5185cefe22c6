// core/files/gltf/texture_reader.cpp: samplers, images, and what all images may take together.

#include "core/files/gltf/texture_reader.h"

#include "core/files/gltf/image.h"
#include "core/files/gltf/loose_values.h"
#include "core/geometry/at.h"

namespace sinew::gltf {
namespace {

constexpr std::size_t kMaxPixels = 96U << 20;         // of all textures: 384 MiB as RGBA
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

/// The WebP image where there is one: the other is for programs that cannot read it.
int sourceOf(const tinygltf::Texture& texture) {
  const auto* webp = findExtension(texture.extensions, "EXT_texture_webp");
  return webp && webp->Has("source") ? webp->Get("source").GetNumberAsInt() : texture.source;
}

}  // namespace

int TextureReader::read(int index) {
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

Texture TextureReader::readSampler(int index) const {
  Texture settings;
  if (index < 0) return settings;
  file_.expectSound(placeOf("samplers", toIndex(index)));
  const tinygltf::Sampler& sampler = file_.model().samplers[toIndex(index)];
  settings.wrapU = wrapOf(sampler.wrapS);
  settings.wrapV = wrapOf(sampler.wrapT);
  settings.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  return settings;
}

int TextureReader::decode(std::size_t image, Texture texture) {
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

}  // namespace sinew::gltf
