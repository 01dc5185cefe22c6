// tests/viewport/render/png_test.cpp: written images read back.

#include "app/viewport/render/picture_files.h"

#include <cstring>

#include <gtest/gtest.h>
#include <stb_image.h>

namespace sinew::test {
namespace {

app::Image gradient(int alpha) {
  app::Image image{37, 21, {}};
  for (int i = 0; i < 37 * 21; ++i) {
    for (const int value : {i % 256, i / 3 % 256, 255 - i % 256, alpha})
      image.rgba.push_back(static_cast<std::uint8_t>(value));
  }
  return image;
}

TEST(Png, RoundTrips) {
  for (const int alpha : {255, 90}) {
    const app::Image image = gradient(alpha);
    const auto bytes = app::pngBytes(image);
    ASSERT_TRUE(bytes.ok());
    int width = 0, height = 0, channels = 0;
    stbi_uc* read = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes->data()),
                                          static_cast<int>(bytes->size()), &width, &height, &channels, 4);
    ASSERT_NE(read, nullptr);
    EXPECT_EQ(width, 37);
    EXPECT_EQ(height, 21);
    EXPECT_EQ(channels, alpha == 255 ? 3 : 4);
    EXPECT_EQ(std::memcmp(read, image.rgba.data(), image.rgba.size()), 0);
    stbi_image_free(read);
  }
}

}  // namespace
}  // namespace sinew::test
