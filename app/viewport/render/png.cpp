// app/viewport/render/png.cpp: encoding through libspng.
#include "app/viewport/render/png.h"

#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include <spng.h>

namespace sinew::app {
namespace {

// A fifth of the time of the strongest compression, for pictures a fifth larger.
constexpr int kCompressionLevel = 1;

struct FreeContext {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
struct FreeBytes {
  void operator()(void* bytes) const { std::free(bytes); }
};

bool isOpaque(const Image& image) {
  for (std::size_t at = 3; at < image.rgba.size(); at += 4) {
    if (image.rgba[at] != 255) return false;
  }
  return true;
}

std::vector<std::uint8_t> withoutAlpha(const std::vector<std::uint8_t>& rgba) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t at = 0; at < rgba.size(); at += 4) {
    rgb.insert(rgb.end(), {rgba[at], rgba[at + 1], rgba[at + 2]});
  }
  return rgb;
}

}  // namespace

Result<std::string> pngBytes(const Image& image) {
  assert(image.rgba.size() == 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  const bool opaque = isOpaque(image);
  const std::vector<std::uint8_t> rgb = opaque ? withoutAlpha(image.rgba) : std::vector<std::uint8_t>{};
  const std::vector<std::uint8_t>& pixels = opaque ? rgb : image.rgba;

  const std::unique_ptr<spng_ctx, FreeContext> context(spng_ctx_new(SPNG_CTX_ENCODER));
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 8;
  header.color_type = opaque ? SPNG_COLOR_TYPE_TRUECOLOR : SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  int error = context ? SPNG_OK : SPNG_EMEM;
  const auto then = [&error](int status) { error = error == SPNG_OK ? status : error; };
  if (context) {
    then(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
    then(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, kCompressionLevel));
    then(spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB));
    then(spng_set_ihdr(context.get(), &header));
  }
  if (error == SPNG_OK) {
    then(spng_encode_image(context.get(), pixels.data(), pixels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE));
  }
  std::size_t size = 0;
  std::unique_ptr<void, FreeBytes> bytes;
  if (error == SPNG_OK) bytes.reset(spng_get_png_buffer(context.get(), &size, &error));
  if (!bytes) return Error{"", "", std::string("the picture could not be encoded as PNG: ") + spng_strerror(error)};
  return std::string(static_cast<const char*>(bytes.get()), size);
}

}  // namespace sinew::app
