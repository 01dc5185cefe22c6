// tests/viewport/render/color_scales_test.cpp: displacement colors are perceptually even; class colors are
// distinguishable.
#include "app/viewport/render/color_scales.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew::test {
namespace {

/// CIE lightness 0..100, computed independently.
float lightness(const glm::vec3& srgb) {
  const glm::vec3 linear = app::linearFromSrgb(srgb);
  const float y = 0.2126f * linear.r + 0.7152f * linear.g + 0.0722f * linear.b;
  return y > 0.008856f ? 116.0f * std::cbrt(y) - 16.0f : 903.3f * y;
}

TEST(HeatScale, PassesThroughItsStopsContinuously) {
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

TEST(HeatScale, DarkensEvenlyFromANeutralMiddle) {
  const glm::vec3 middle = app::heatColor(0.0f);
  EXPECT_LT(std::max({middle.r, middle.g, middle.b}) - std::min({middle.r, middle.g, middle.b}), 0.04f);
  for (const float side : {-1.0f, 1.0f}) {
    const float whole = lightness(middle) - lightness(app::heatColor(side));
    EXPECT_GT(whole, 25.0f);
    for (int i = 0; i < 8; ++i) {
      const float x = side * static_cast<float>(i) / 8.0f;
      const float step = lightness(app::heatColor(x)) - lightness(app::heatColor(x + side / 8.0f));
      EXPECT_GT(step, 0.4f * whole / 8.0f) << x;
      EXPECT_LT(step, 2.0f * whole / 8.0f) << x;
    }
  }
  // Equal displacements outwards and inwards are equally light, and warm or cold.
  for (const float x : {0.25f, 0.5f, 1.0f}) {
    EXPECT_NEAR(lightness(app::heatColor(x)), lightness(app::heatColor(-x)), 6.0f);
    EXPECT_GT(app::heatColor(x).r, app::heatColor(x).b + 0.05f);
    EXPECT_GT(app::heatColor(-x).b, app::heatColor(-x).r + 0.05f);
  }
}

TEST(Srgb, DecodingAndEncodingAreInverse) {
  for (int i = 0; i <= 255; ++i) {
    const glm::vec3 s(static_cast<float>(i) / 255.0f);
    EXPECT_LT(glm::distance(app::srgbFromLinear(app::linearFromSrgb(s)), s), 1e-5f);
  }
  EXPECT_NEAR(app::linearFromSrgb(glm::vec3(0.5f)).r, 0.21404f, 1e-4f);
}

TEST(ClassColors, FollowTheOrderOfClassesAndAreDistinct) {
  const auto& colors = app::classColors();
  for (std::size_t i = 0; i < colors.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(colors[i].kind), i);
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(glm::distance(colors[i].srgb, colors[j].srgb), 0.2f);
  }
}

TEST(ZoneColors, DistinguishClassesAndLayers) {
  for (std::size_t i = 0; i < app::kZones; ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(glm::distance(app::zoneColor(i), app::zoneColor(j)), 0.2f) << i << j;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto kind = static_cast<TriangleClass>(i);
    EXPECT_EQ(app::zoneOf(kind, SkinLayer::kSkin), i);
    EXPECT_EQ(app::zoneColor(app::zoneOf(kind, SkinLayer::kCloth)), app::layerColor(SkinLayer::kCloth).srgb);
    EXPECT_EQ(app::zoneColor(app::zoneOf(kind, SkinLayer::kRigid)), app::layerColor(SkinLayer::kRigid).srgb);
    EXPECT_EQ(app::layerColors()[i].layer, static_cast<SkinLayer>(i));
  }
}

}  // namespace
}  // namespace sinew::test
