// tests/render/png_test.cpp: what is written reads back.
#include "app/render/png.h"

#include <cstring>

#include <gtest/gtest.h>
#include <stb/stb_image.h>

#include "app/render/heat_scale.h"

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

TEST(Png, ReadsBackAsItWas) {
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

TEST(HeatScale, RunsThroughItsStopsWithoutJumps) {
  const auto& stops = app::heatStops();
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const float x = 2.0f * static_cast<float>(i) / static_cast<float>(stops.size() - 1) - 1.0f;
    EXPECT_LT(glm::distance(app::heatColor(x), stops[i]), 1e-5f);
  }
  EXPECT_EQ(app::heatColor(-7.0f), stops.front());
  EXPECT_EQ(app::heatColor(7.0f), stops.back());
  for (float x = -1.0f; x < 1.0f; x += 0.001f)
    EXPECT_LT(glm::distance(app::heatColor(x), app::heatColor(x + 0.001f)), 0.005f);
}

}  // namespace
}  // namespace sinew::test
