// core/files/gltf/image.cpp: stb_image and libwebp, guarded against images made to exhaust memory or time.
#include "core/files/gltf/image.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <stb_image.h>
#include <webp/decode.h>

#include "core/files/gltf/image_bytes.h"
#include "core/geometry/at.h"

namespace sinew::gltf {
namespace {

// WebP -> RGBA.
// Libwebp's simple decoder, into memory of the size that its header tells.

/// Width and height of a still image; nothing where the header is damaged or the image moves.
std::optional<std::pair<int, int>> webpSize(std::span<const std::uint8_t> bytes) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK || features.has_animation != 0) {
    return std::nullopt;
  }
  return std::pair(features.width, features.height);
}

/// Its pixels, 4 bytes each; empty where it is damaged. The size has been found to be bearable.
std::vector<std::uint8_t> webpPixels(std::span<const std::uint8_t> bytes) {
  const auto size = webpSize(bytes);
  if (!size) return {};
  std::vector<std::uint8_t> rgba(4 * toIndex(size->first) * toIndex(size->second));
  const bool whole =
      WebPDecodeRGBAInto(bytes.data(), bytes.size(), rgba.data(), rgba.size(), 4 * size->first) != nullptr;
  return whole ? rgba : std::vector<std::uint8_t>();
}

/// Deflate shrinks at most this much.
constexpr std::uint64_t kMaxDeflateRatio = 1032;
/// Compressed pixels that cannot unpack to more than this need no trial.
constexpr std::uint64_t kHarmlessBytes = 256U << 20;
/// Each scan of a progressive JPEG is a pass over the whole image; encoders write about ten.
constexpr int kMaxScans = 200;

std::uint32_t bigEndian(Bytes bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at]) << 24 | static_cast<std::uint32_t>(bytes[at + 1]) << 16 |
         static_cast<std::uint32_t>(bytes[at + 2]) << 8 | static_cast<std::uint32_t>(bytes[at + 3]);
}

/// All IDAT data of a PNG in one piece.
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

/// Whether the pixels unpack to no more than the image's dimensions allow; stb_image itself would go on unpacking.
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

}  // namespace sinew::gltf
