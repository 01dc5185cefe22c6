// app/viewport/render/thumbnails.cpp: pictures are scaled down, cached, and shown again.

#include "app/viewport/render/thumbnails.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <stb_image.h>

#include "app/document/view_files.h"
#include "app/viewport/render/picture_files.h"
#include "core/files/disk/atomic_file.h"

namespace sinew::app {
namespace {

constexpr std::uintmax_t kLargestFile = 1u << 18;
constexpr std::size_t kMostTextures = 600;

/// Mean of the pixels [low, high), opaque.
void writeMean(const Image& picture, const glm::ivec2& low, const glm::ivec2& high, std::vector<std::uint8_t>& rgba) {
  std::array<std::uint64_t, 3> sum{};
  for (int y = low.y; y < high.y; ++y) {
    for (int x = low.x; x < high.x; ++x) {
      const std::size_t at =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
      for (std::size_t c = 0; c < 3; ++c) sum[c] += picture.rgba[at + c];
    }
  }
  const auto count = static_cast<std::uint64_t>((high.x - low.x) * (high.y - low.y));
  for (const std::uint64_t each : sum) rgba.push_back(static_cast<std::uint8_t>((each + count / 2) / count));
  rgba.push_back(255);
}

GlTexture textureOf(const Image& image) {
  return uploadTexture(GL_RGBA8, image.width, image.height, image.rgba, false);
}

}  // namespace

Image thumbnailOf(const Image& picture) {
  const glm::ivec2 size = kThumbnailSize;
  const int width = std::min(picture.width, std::max(picture.height * size.x / size.y, 1));
  const int height = std::min(picture.height, std::max(picture.width * size.y / size.x, 1));
  const glm::ivec2 corner((picture.width - width) / 2, (picture.height - height) / 2);
  Image small{size.x, size.y, {}};
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::ivec2 low(x * width / size.x, y * height / size.y);
      const glm::ivec2 high((x + 1) * width / size.x, (y + 1) * height / size.y);
      writeMean(picture, corner + low, corner + glm::max(high, low + 1), small.rgba);
    }
  }
  return small;
}

std::optional<Image> readThumbnail(std::string_view png) {
  const auto* bytes = reinterpret_cast<const stbi_uc*>(png.data());
  const int length = static_cast<int>(png.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(bytes, length, &width, &height, &channels) == 0) return std::nullopt;
  if (width != kThumbnailSize.x || height != kThumbnailSize.y) return std::nullopt;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(bytes, length, &width, &height, &channels, 4), stbi_image_free);
  if (pixels == nullptr) return std::nullopt;
  const auto count = static_cast<std::ptrdiff_t>(4) * width * height;
  return Image{width, height, {pixels.get(), pixels.get() + count}};
}

void Thumbnails::keep(const std::filesystem::path& document, const Image& picture) {
  if (picture.width < kThumbnailSize.x || picture.height < kThumbnailSize.y) return;
  const Result<std::string> png = pngBytes(thumbnailOf(picture));
  if (png && keepThumbnail(folder_, document, png.value())) shown_.erase(document.string());
}

unsigned Thumbnails::texture(const std::filesystem::path& document, std::filesystem::file_time_type changed) {
  const auto found = shown_.find(document.string());
  if (found != shown_.end() && found->second.changed == changed) return found->second.texture.id();
  if (shown_.size() >= kMostTextures) shown_.clear();
  Shown& shown = shown_[document.string()];
  shown = {changed, {}};
  const Result<std::string> png = readWholeFile(thumbnailFile(folder_, document), kLargestFile);
  if (!png) return 0;
  if (const std::optional<Image> image = readThumbnail(png.value())) shown.texture = textureOf(*image);
  return shown.texture.id();
}

unsigned Thumbnails::texture(const std::string& key, const std::function<Image()>& draw) {
  if (const auto found = drawn_.find(key); found != drawn_.end()) return found->second.id();
  if (drawn_.size() >= kMostTextures) drawn_.clear();
  return drawn_.emplace(key, textureOf(draw())).first->second.id();
}

}  // namespace sinew::app
