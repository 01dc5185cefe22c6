// tests/viewport/render/shells_test.cpp: muscle shells show their position, kind and state.

#include "app/viewport/render/color_scales.h"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::DisplaySettings;
using app::Image;
using app::PrimitiveShape;
using app::Scene;
using app::View;

constexpr int kSize = 160;
constexpr int kMiddle = kSize / 2;

/// A white square in the plane z = 0, seen from the front, and one ball.
class Shells : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    if (IsSkipped()) return;
    quad_ = makeQuad();
    moment_ = bindMoment(quad_, 1, PatchKind::kFlat);
    viewport_ = viewportFor(*quad_);
    view_ = viewOfQuad(0.0f, kSize);
    settings_ = bareColors();
    settings_.primitives = true;
  }
  void TearDown() override {
    viewport_.reset();
    Drawing::TearDown();
  }

  static PrimitiveShape ballAt(float z, float radius) {
    PrimitiveShape shape;
    shape.unitBallInWorld = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, 0, z)), glm::vec3(radius));
    return shape;
  }
  Image draw(const std::vector<PrimitiveShape>& shapes) {
    Scene scene = sceneOf(*quad_, moment_);
    scene.primitives = shapes;
    viewport_->draw(scene, view_, settings_);
    return viewport_->readPixels();
  }
  static int brightness(const Image& image, int x, int y) {
    const Pixel pixel = pixelAt(image, x, y);
    return pixel[0] + pixel[1] + pixel[2];
  }
  static int change(const Image& a, const Image& b, int x, int y) {
    const Pixel p = pixelAt(a, x, y), q = pixelAt(b, x, y);
    return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]);
  }
  /// Mean change over a square beside the rings, which cross in the middle.
  static float fillOf(const Image& with, const Image& without) {
    int sum = 0;
    for (int y = 3; y < 9; ++y) {
      for (int x = 3; x < 9; ++x) sum += change(with, without, kMiddle + x, kMiddle + y);
    }
    return static_cast<float>(sum) / 36.0f;
  }

  std::shared_ptr<Character> quad_;
  Moment moment_;
  std::unique_ptr<app::Viewport> viewport_;
  View view_;
  DisplaySettings settings_;
};

TEST_F(Shells, ShellsFadeWithDepthUnderTheSkin) {
  const Image without = draw({});
  const float inFront = fillOf(draw({ballAt(0.6f, 0.4f)}), without);
  const float under = fillOf(draw({ballAt(-0.42f, 0.4f)}), without);
  const float deep = fillOf(draw({ballAt(-0.9f, 0.4f)}), without);
  EXPECT_GT(inFront, 1.3f * under);
  EXPECT_GT(under, 1.2f * deep);
  EXPECT_GT(deep, 2.0f) << "and are seen all the same";
}

TEST_F(Shells, LineMarksTheIntersectionWithTheSkin) {
  const float radius = 0.6f, depth = 0.35f;
  const Image image = draw({ballAt(-depth, radius)});
  const float circle = std::sqrt(radius * radius - depth * depth) / view_.unitsPerPixelAt(glm::vec3(0));
  int lined = 0, places = 0;
  for (int i = 0; i < 40; ++i) {
    // Between the rings, whose circles lie along both axes.
    const float angle = 2.0f * std::numbers::pi_v<float> * (static_cast<float>(i) + 0.5f) / 40.0f;
    const glm::vec2 out(std::cos(angle), std::sin(angle));
    if (std::min(std::abs(out.x), std::abs(out.y)) < 0.2f) continue;
    const auto at = [&](float from) {
      const glm::vec2 p = glm::vec2(kMiddle) + (circle + from) * out;
      return brightness(image, static_cast<int>(p.x), static_cast<int>(p.y));
    };
    int darkest = 1 << 20;
    for (const float from : {-1.0f, -0.5f, 0.0f, 0.5f, 1.0f}) darkest = std::min(darkest, at(from));
    ++places;
    lined += darkest + 60 < std::min(at(-4.0f), at(4.0f)) ? 1 : 0;
  }
  EXPECT_GE(lined, 9 * places / 10) << "of " << places;
}

TEST_F(Shells, TangentSkinHasNoIntersectionLine) {
  // So large that it passes through the square at less than four degrees, on a circle in the middle of the picture.
  const Image image = draw({ballAt(-4.99f, 5.0f)});
  for (int y = -20; y <= 20; ++y) {
    for (int x = -20; x <= 20; ++x) EXPECT_GT(brightness(image, kMiddle + x, kMiddle + y), 200) << x << ' ' << y;
  }
}

TEST_F(Shells, CarvesAreStriped) {
  const auto spread = [&](int sign) {
    PrimitiveShape ball = ballAt(0.6f, 0.6f);
    ball.sign = sign;
    const Image image = draw({ball});
    int least = 1 << 20, most = 0;
    for (int i = 4; i < 16; ++i) {
      least = std::min(least, brightness(image, kMiddle + i, kMiddle + 5));
      most = std::max(most, brightness(image, kMiddle + i, kMiddle + 5));
    }
    return most - least;
  };
  EXPECT_GT(spread(-1), 60);
  EXPECT_GT(spread(-1), 2 * spread(1));
}

TEST_F(Shells, EveryStateHasADistinctOutline) {
  std::vector<PrimitiveShape> states(5, ballAt(0.6f, 0.5f));
  states[1].hovered = true;
  states[2].twin = true;
  states[3].selected = true;
  states[4].selected = states[4].active = true;
  std::vector<Image> images;
  for (const PrimitiveShape& state : states) images.push_back(draw({state}));
  for (std::size_t i = 0; i < images.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      int differing = 0;
      for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) differing += change(images[i], images[j], x, y) > 40 ? 1 : 0;
      }
      EXPECT_GT(differing, 60) << i << ' ' << j;
    }
  }
}

TEST_F(Shells, OnlyTheTwinHasADashedOutline) {
  settings_.primitives = settings_.surface = false;
  const auto gaps = [&](bool twin) {
    PrimitiveShape ball = ballAt(0.0f, 0.9f);
    (twin ? ball.twin : ball.selected) = true;
    const Image image = draw({ball});
    // Radius of the outline: where something is drawn along most of the circle.
    int best = 0, runs = 0;
    for (float radius = 20.0f; radius < 60.0f; radius += 0.5f) {
      int drawn = 0, starts = 0;
      bool before = false;
      for (int i = 0; i < 720; ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / 720.0f;
        const bool here = pixelAt(image, kMiddle + static_cast<int>(std::lround(radius * std::cos(angle) - 0.5f)),
                                  kMiddle + static_cast<int>(std::lround(radius * std::sin(angle) - 0.5f)))[3] > 100;
        drawn += here ? 1 : 0;
        starts += here && !before ? 1 : 0;
        before = here;
      }
      if (drawn > best) best = drawn, runs = starts;
    }
    EXPECT_GT(best, 200);
    return runs;
  };
  EXPECT_LE(gaps(false), 1);
  EXPECT_GT(gaps(true), 10);
}

}  // namespace
}  // namespace sinew::test
