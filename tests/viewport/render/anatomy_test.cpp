// tests/viewport/render/anatomy_test.cpp: muscle bellies are red, tendons pale, and the skin is glass with an outline.
#include "app/viewport/render/muscle_drawer.h"

#include <cmath>
#include <cstdlib>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/characters/synthetic_characters.h"
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

/// Muscles behind a white square seen from the front, orthographic: one unit is 40 pixels.
class Anatomy : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    if (IsSkipped()) return;
    quad_ = makeQuad();
    moment_ = bindMoment(quad_, 1, PatchKind::kFlat);
    viewport_ = viewportFor(*quad_);
    view_ = viewOf(kSize);
    settings_ = bareColors();
    settings_.lighting = true;
    settings_.anatomy = true;
    settings_.surface = false;
  }
  void TearDown() override {
    viewport_.reset();
    Drawing::TearDown();
  }

  static View viewOf(int size) {
    return app::framedView(Bounds{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}, 0.0f, 0.0f, {size, size}, true, 0.25f);
  }
  /// A spindle with these half axes.
  static PrimitiveShape muscle(const glm::vec3& radii, const glm::vec3& at = glm::vec3(0.0f, 0.0f, -1.0f)) {
    PrimitiveShape shape;
    shape.radii = radii;
    shape.unitBallInWorld = glm::scale(glm::translate(glm::mat4(1), at), radii);
    return shape;
  }
  static PrimitiveShape onLine(float activation) {
    PrimitiveShape shape = muscle({0.3f, 0.6f, 0.3f});
    shape.line = app::ShapeLine{{{0, -1.6f, -1}, std::nullopt, {0, 1.6f, -1}}, activation, 1.0f};
    return shape;
  }
  Image draw(const std::vector<PrimitiveShape>& shapes) {
    Scene scene = sceneOf(*quad_, moment_);
    scene.primitives = shapes;
    viewport_->draw(scene, view_, settings_);
    return viewport_->readPixels();
  }
  /// Mean of 5 x 5 pixels around a point of the picture plane, linear light.
  static glm::vec3 colorAt(const Image& image, float x, float y) {
    const int column = kMiddle + static_cast<int>(std::lround(40.0f * x)),
              row = kMiddle - static_cast<int>(std::lround(40.0f * y));
    glm::vec3 sum(0.0f);
    for (int j = -2; j <= 2; ++j) {
      for (int i = -2; i <= 2; ++i) {
        const Pixel pixel = pixelAt(image, column + i, row + j);
        sum += glm::vec3(linearOf(pixel[0]), linearOf(pixel[1]), linearOf(pixel[2]));
      }
    }
    return sum / 25.0f;
  }
  static float redness(const glm::vec3& color) { return color.r / std::max(color.g, 1e-4f); }

  std::shared_ptr<Character> quad_;
  Moment moment_;
  std::unique_ptr<app::Viewport> viewport_;
  View view_;
  DisplaySettings settings_;
};

TEST_F(Anatomy, FleshIsRedWithPaleEnds) {
  for (const bool lying : {false, true}) {  // The fibres run along the longest radius, whichever that is.
    const Image image = draw({muscle(lying ? glm::vec3(0.9f, 0.3f, 0.3f) : glm::vec3(0.3f, 0.9f, 0.3f))});
    const auto at = [&](float along) { return lying ? colorAt(image, along, 0.0f) : colorAt(image, 0.0f, along); };
    EXPECT_GT(redness(at(0.0f)), 2.5f) << lying;
    EXPECT_GT(redness(at(0.5f)), 2.5f) << lying;
    for (const float pole : {-0.85f, 0.85f}) EXPECT_LT(redness(at(pole)), 1.7f) << lying << ' ' << pole;
  }
}

TEST_F(Anatomy, FlexedMusclesAreMoreSaturated) {
  float before = 0.0f;
  for (const float activation : {0.0f, 0.5f, 1.0f}) {
    const float now = redness(colorAt(draw({onLine(activation)}), 0.0f, 0.1f));
    EXPECT_GT(now, 1.15f * before) << activation;
    before = now;
  }
}

TEST_F(Anatomy, TendonsRunFromTheBellyToTheAnchors) {
  const Image with = draw({onLine(0.0f)}), without = draw({muscle({0.3f, 0.6f, 0.3f})});
  for (const float y : {-1.4f, -0.9f, 0.9f, 1.4f}) {
    const int row = kMiddle - static_cast<int>(std::lround(40.0f * y));
    // The cord is about a pixel wide, and its middle lies between two.
    const Pixel left = pixelAt(with, kMiddle - 1, row), right = pixelAt(with, kMiddle, row);
    const Pixel& pixel = left[3] > right[3] ? left : right;
    EXPECT_EQ(pixel[3], 255) << y;
    EXPECT_LT(redness({linearOf(pixel[0]), linearOf(pixel[1]), linearOf(pixel[2])}), 1.6f) << y;
    EXPECT_EQ(pixelAt(without, kMiddle - 1, row)[3] + pixelAt(without, kMiddle, row)[3], 0) << y;
  }
  EXPECT_EQ(pixelAt(with, kMiddle, kMiddle - 68)[3], 0) << "beyond the anchor";
}

TEST_F(Anatomy, TendonBendsThroughTheViaPoint) {
  PrimitiveShape shape = onLine(0.0f);
  shape.line->path.via = glm::vec3(0.35f, 1.1f, -1.0f);
  const Image bent = draw({shape}), straight = draw({onLine(0.0f)});
  const int x = kMiddle + 14, y = kMiddle - 44;
  EXPECT_EQ(pixelAt(bent, x, y)[3], 255);
  EXPECT_EQ(pixelAt(straight, x, y)[3], 0);
  EXPECT_EQ(pixelAt(bent, kMiddle, y)[3], 0);
}

TEST_F(Anatomy, BelliesOfSheetsHaveFibresAlongTheStripAndTendonsAtItsEnds) {
  PrimitiveShape belly = onLine(0.0f);
  belly.sheet = 0;
  belly.tendons = {true, false};
  const Image first = draw({belly});
  const auto cord = [](const Image& image, float y) {
    const int row = kMiddle - static_cast<int>(std::lround(40.0f * y));
    return std::max(pixelAt(image, kMiddle - 1, row)[3], pixelAt(image, kMiddle, row)[3]);
  };
  EXPECT_EQ(cord(first, -1.4f), 255) << "towards the origin";
  EXPECT_EQ(cord(first, 1.4f), 0);
  // A wide belly is pale at the ends of the strip, not at its sides.
  PrimitiveShape wide = muscle({0.9f, 0.5f, 0.3f});
  EXPECT_LT(redness(colorAt(draw({wide}), 0.85f, 0.0f)), 1.7f);
  wide.sheet = 0;
  EXPECT_GT(redness(colorAt(draw({wide}), 0.85f, 0.0f)), 2.0f);
}

TEST_F(Anatomy, ShapesAreDrawnExactly) {
  PrimitiveShape shape = muscle({0.4f, 0.9f, 0.3f});
  const Image plain = draw({shape});
  shape.shape.core = 0.6f;
  const Image straight = draw({shape});
  shape.shape = {};
  shape.shape.bend = {0.9f, 0.0f};
  const Image bent = draw({shape});
  const auto covered = [](const Image& image, float x, float y) {
    const int column = kMiddle + static_cast<int>(std::lround(40.0f * x));
    return pixelAt(image, column, kMiddle - static_cast<int>(std::lround(40.0f * y)))[3] > 0;
  };
  EXPECT_FALSE(covered(plain, 0.35f, 0.6f));
  EXPECT_TRUE(covered(straight, 0.35f, 0.5f));
  EXPECT_FALSE(covered(plain, 0.65f, 0.0f));
  EXPECT_TRUE(covered(bent, 0.65f, 0.0f));
  EXPECT_GT(redness(colorAt(bent, 0.36f, 0.0f)), 2.5f);
}

TEST_F(Anatomy, CarvesAreDarkAndTranslucent) {
  PrimitiveShape carve = muscle({0.5f, 0.5f, 0.5f}, {0, 0, -0.5f});
  carve.sign = -1;
  const PrimitiveShape flesh = muscle({0.6f, 0.9f, 0.3f}, {0, 0, -1.5f});
  const glm::vec3 behind = colorAt(draw({flesh}), 0.0f, 0.1f), through = colorAt(draw({flesh, carve}), 0.0f, 0.1f);
  EXPECT_LT(through.r, 0.8f * behind.r);
  EXPECT_GT(through.r, 0.2f * behind.r);
  const Pixel alone = pixelAt(draw({carve}), kMiddle, kMiddle);
  EXPECT_GT(alone[3], 40);
  EXPECT_LT(alone[3], 250);
  EXPECT_LT(redness({linearOf(alone[0]), linearOf(alone[1]), linearOf(alone[2])}), 2.0f);
}

TEST_F(Anatomy, FibresMoveAndStretchWithTheMuscle) {
  const auto row = [](const Image& image, int from) {
    std::vector<int> values;
    for (int x = -20; x <= 20; ++x) values.push_back(pixelAt(image, from + x, kMiddle)[0]);
    return values;
  };
  const auto difference = [](const std::vector<int>& a, const std::vector<int>& b) {
    int sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return static_cast<float>(sum) / static_cast<float>(a.size());
  };
  const glm::vec3 radii(0.8f, 1.2f, 0.8f);
  const std::vector<int> still = row(draw({muscle(radii)}), kMiddle);
  const float pixel = view_.unitsPerPixelAt(glm::vec3(0.0f));
  const std::vector<int> moved = row(draw({muscle(radii, {10.0f * pixel, 0.0f, -1.0f})}), kMiddle + 10);
  EXPECT_LT(difference(still, moved), 1.5f) << "but for the dither";
  PrimitiveShape stretched = muscle(radii);
  stretched.unitBallInWorld[1] *= 1.3f;
  EXPECT_LT(difference(still, row(draw({stretched}), kMiddle)), 1.5f);
  PrimitiveShape turned = muscle(radii);
  turned.unitBallInWorld = glm::rotate(turned.unitBallInWorld, 0.12f, glm::vec3(0, 1, 0));
  EXPECT_GT(difference(still, row(draw({turned}), kMiddle)), 4.0f) << "there are fibres to be seen";
}

TEST_F(Anatomy, DistantFibresFadeIntoTheirMean) {
  const glm::vec3 radii(0.8f, 1.2f, 0.8f);
  // Deviation of neighboring pixels from smooth shading: mean second difference along the middle row.
  const auto roughness = [&](int size) {
    view_ = viewOf(size);
    const Image image = draw({muscle(radii)});
    const int reach = size / 10;
    int sum = 0;
    for (int x = -reach; x <= reach; ++x) {
      const auto red = [&](int at) { return pixelAt(image, size / 2 + at, size / 2)[0]; };
      sum += std::abs(red(x - 1) - 2 * red(x) + red(x + 1));
    }
    return static_cast<float>(sum) / static_cast<float>(2 * reach + 1);
  };
  EXPECT_GT(roughness(640), 3.0f) << "from near they are there";
  EXPECT_LT(roughness(40), 3.0f);
}

TEST_F(Anatomy, GlassRangesFromSkinToClear) {
  settings_.surface = true;
  int before = 256;
  for (const float glass : {0.0f, 0.3f, 0.6f, 1.0f}) {
    settings_.glass = glass;
    const int alpha = pixelAt(draw({}), kMiddle, kMiddle)[3];
    EXPECT_LT(alpha, before) << glass;
    EXPECT_EQ(alpha == 255, glass == 0.0f) << glass;
    before = alpha;
  }
  EXPECT_LT(before, 40);
  settings_.glass = 0.0f;
  EXPECT_LT(redness(colorAt(draw({muscle({0.5f, 0.9f, 0.3f})}), 0, 0)), 1.3f) << "skin hides what lies under it";
}

TEST_F(Drawing, GlassKeepsTheSkinOutline) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 4);
  const View view = app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.2f, {240, 180}, false);
  const auto viewport = viewportFor(*limb);
  DisplaySettings settings = bareColors();
  settings.lighting = true;
  viewport->draw(sceneOf(*limb, moment), view, settings);
  const Image skin = viewport->readPixels();
  settings.anatomy = true;
  viewport->draw(sceneOf(*limb, moment), view, settings);
  const Image glass = viewport->readPixels();
  int outline = 0, strong = 0, inside = 0, clear = 0;
  for (int y = 3; y < 177; ++y) {
    for (int x = 3; x < 237; ++x) {
      const auto covered = [&](int i, int j) { return pixelAt(skin, x + i, y + j)[3] > 0; };
      if (!covered(0, 0)) {
        EXPECT_EQ(pixelAt(glass, x, y)[3], 0);
        continue;
      }
      const bool edge = !covered(1, 0) || !covered(-1, 0) || !covered(0, 1) || !covered(0, -1);
      const bool deep = covered(3, 0) && covered(-3, 0) && covered(0, 3) && covered(0, -3);
      const int alpha = pixelAt(glass, x, y)[3];
      outline += edge ? 1 : 0;
      strong += edge && alpha > 80 ? 1 : 0;
      inside += deep ? 1 : 0;
      clear += deep && alpha < 80 ? 1 : 0;
    }
  }
  EXPECT_GT(outline, 200);
  EXPECT_GT(strong, outline * 7 / 10);
  EXPECT_GT(clear, inside / 2);
}

TEST_F(Drawing, AnatomyDoesNotAffectOtherPictures) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 3);
  const View view = app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.2f, {120, 90}, false);
  Scene scene = sceneOf(*limb, moment);
  scene.skinnedControlPositions = limb->mesh.positions;
  scene.primitives.emplace_back();
  scene.primitives.back().unitBallInWorld = glm::mat4(0.3f);
  scene.primitives.back().unitBallInWorld[3] = {0.1f, 0.8f, 0.2f, 1.0f};
  scene.primitives.back().selected = true;
  scene.primitives.push_back(scene.primitives.back());
  scene.primitives.back().sign = -1;
  const auto viewport = viewportFor(*limb, 4);
  DisplaySettings usual;
  usual.skeleton = usual.primitives = usual.influence = usual.wire = usual.controlMesh = true;
  const auto picture = [&](const DisplaySettings& settings) {
    viewport->draw(scene, view, settings);
    while (viewport->samplesTaken() < 4) viewport->refine(scene, view, settings);  // The first averaged picture.
    return viewport->readPixels().rgba;
  };
  const std::vector<std::uint8_t> before = picture(usual);
  DisplaySettings anatomy = usual;
  anatomy.anatomy = true;
  const std::vector<std::uint8_t> flesh = picture(anatomy);
  EXPECT_NE(flesh, before);
  EXPECT_EQ(picture(anatomy), flesh);
  EXPECT_EQ(picture(usual), before);
  anatomy.wire = false;
  EXPECT_NE(picture(anatomy), flesh) << "glass has edges too";
}

}  // namespace
}  // namespace sinew::test
