// app/render/png.cpp: encoding through stb.
#include "app/render/png.h"

#include <cassert>
#include <cstdint>
#include <vector>

#include <stb_image_write.h>

namespace sinew::app {
namespace {

void append(void* bytes, void* data, int size) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

bool isOpaque(const Image& image) {
  for (std::size_t at = 3; at < image.rgba.size(); at += 4) {
    if (image.rgba[at] != 255) return false;
  }
  return true;
}

}  // namespace

Result<std::string> pngBytes(const Image& image) {
  assert(image.rgba.size() == 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  const int channels = isOpaque(image) ? 3 : 4;
  std::vector<std::uint8_t> packed;
  if (channels == 3) {
    packed.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
      packed.insert(packed.end(), {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]});
    }
  }
  const std::uint8_t* pixels = channels == 3 ? packed.data() : image.rgba.data();
  std::string bytes;
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, channels, pixels, image.width * channels) ==
      0) {
    return Error{"", "", "the picture could not be encoded as PNG"};
  }
  return bytes;
}

}  // namespace sinew::app
