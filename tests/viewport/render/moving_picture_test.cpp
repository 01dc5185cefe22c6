// tests/viewport/render/moving_picture_test.cpp: a moving picture takes shortcuts that are invisible or only soften it.
#include <cstdlib>
#include <random>

#include "tests/support/characters/synthetic_characters.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::DisplaySettings;
using app::Image;
using app::Scene;
using app::View;

int worstDifference(const Image& a, const Image& b) {
  int worst = a.rgba.size() == b.rgba.size() ? 0 : 255;
  for (std::size_t i = 0; worst < 255 && i < a.rgba.size(); ++i) {
    worst = std::max(worst, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
  }
  return worst;
}

/// The surface moved, as by an animation.
Moment movedBy(const Moment& moment, const glm::vec3& by) {
  Moment moved = moment;
  for (glm::vec3& position : moved.surface.positions) position += by;
  return moved;
}

/// Scaled about its middle, so that the light on the floor stays. Enlarged, it reaches below the floor.
Moment scaledBy(const Moment& moment, float factor) {
  Moment scaled = moment;
  const glm::vec3 center = boundsOf(moment.surface.positions).center();
  for (glm::vec3& position : scaled.surface.positions) position = center + factor * (position - center);
  return scaled;
}

TEST_F(Drawing, CachedBackgroundIsPixelIdentical) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 3);
  const Bounds bounds = boundsOf(moment.surface.positions);
  for (const bool orthographic : {false, true}) {
    for (const float pitch : {0.5f, 0.05f, -0.4f}) {  // From above, along the floor and from below.
      const View view = app::framedView(bounds, 0.6f, pitch, {150, 110}, orthographic);
      for (const app::Backdrop backdrop : {app::Backdrop::kStudio, app::Backdrop::kChecker}) {
        DisplaySettings settings;
        settings.look.backdrop = backdrop;
        const auto keeping = viewportFor(*limb), plain = viewportFor(*limb);
        keeping->draw(sceneOf(*limb, moment), view, settings, 1.0f);
        for (const float factor : {1.0f, 1.6f, 0.7f, 1.2f}) {
          const Moment moved = scaledBy(moment, factor);
          plain->draw(sceneOf(*limb, moved), view, settings);
          keeping->draw(sceneOf(*limb, moved), view, settings, 1.0f);
          EXPECT_EQ(worstDifference(keeping->readPixels(), plain->readPixels()), 0)
              << orthographic << " " << pitch << " " << factor;
          if (factor == 0.7f) keeping->draw(sceneOf(*limb, moved), view, settings);  // A resting picture in between.
        }
      }
    }
  }
}

TEST_F(Drawing, HeldFloorLightIsUnnoticeableWhileTheCharacterSways) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 3);
  const View view = app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.4f, {150, 110}, false);
  const auto keeping = viewportFor(*limb), plain = viewportFor(*limb);
  keeping->draw(sceneOf(*limb, moment), view, {}, 1.0f);
  for (const float sway : {0.02f, 0.059f, -0.059f, 0.2f}) {
    const Moment moved = movedBy(moment, {sway * limb->height, 0.0f, 0.0f});
    keeping->draw(sceneOf(*limb, moved), view, {}, 1.0f);
    plain->draw(sceneOf(*limb, moved), view, {});
    EXPECT_LE(worstDifference(keeping->readPixels(), plain->readPixels()), 4) << sway;
  }
}

/// Remains of the previous picture outside the character are erased.
TEST_F(Drawing, MovedCharacterLeavesNoTrace) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 2);
  const View view = app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.4f, {161, 117}, false, 0.3f);
  const auto keeping = viewportFor(*limb);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> size(0.4f, 1.4f);
  for (int i = 0; i < 12; ++i) {
    const Moment moved = scaledBy(moment, size(random));  // The cached background does not change.
    keeping->draw(sceneOf(*limb, moved), view, {}, 1.0f);
    const auto fresh = viewportFor(*limb);
    fresh->draw(sceneOf(*limb, moved), view, {});
    EXPECT_LE(worstDifference(keeping->readPixels(), fresh->readPixels()), 4) << i;
  }
}

TEST_F(Drawing, RestingPictureAfterMovementIsPixelIdentical) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 3);
  const Moment other = movedBy(moment, {0.02f * limb->height, 0.0f, 0.0f});
  const View view = app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.2f, {161, 121}, false);
  DisplaySettings settings;
  settings.wire = true;
  const auto moving = viewportFor(*limb), resting = viewportFor(*limb);
  resting->draw(sceneOf(*limb, moment), view, settings);
  for (const float scale : {1.0f, 0.72f, 0.44f}) {
    moving->draw(sceneOf(*limb, other), view, settings, scale);
    const Image small = moving->readPixels();
    EXPECT_EQ(small.width, static_cast<int>(std::lround(161.0f * scale)));
    EXPECT_EQ(small.height, static_cast<int>(std::lround(121.0f * scale)));
    moving->draw(sceneOf(*limb, moment), view, settings);
    EXPECT_EQ(moving->readPixels().rgba, resting->readPixels().rgba) << scale;
    while (!moving->isRefined()) moving->refine(sceneOf(*limb, moment), view, settings);
    const Image refined = moving->readPixels();
    moving->draw(sceneOf(*limb, moment), view, settings);
    const auto fresh = viewportFor(*limb);
    fresh->draw(sceneOf(*limb, moment), view, settings);
    while (!fresh->isRefined()) fresh->refine(sceneOf(*limb, moment), view, settings);
    EXPECT_EQ(refined.rgba, fresh->readPixels().rgba) << scale;
  }
}

TEST_F(Drawing, ReducedResolutionKeepsTheLineWidth) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  Scene scene = sceneOf(*quad, moment);
  scene.segments = {{{-0.9f, 0.0f, 0.1f}, {0.9f, 0.0f, 0.1f}, app::SegmentClass::kFound}};
  DisplaySettings settings = bareColors();
  settings.surface = false;
  settings.lineScale = 6.0f;
  const auto viewport = viewportFor(*quad);
  const View view = viewOfQuad(0.0f, 200);
  const auto widthAlong = [&](std::optional<float> scale) {
    viewport->draw(scene, view, settings, scale);
    const Image image = viewport->readPixels();
    double covered = 0.0;
    for (int y = 0; y < image.height; ++y) covered += pixelAt(image, image.width / 2, y)[3] / 255.0;
    return covered / static_cast<double>(scale.value_or(1.0f));
  };
  const double whole = widthAlong(std::nullopt);
  EXPECT_GT(whole, 5.0);
  EXPECT_NEAR(widthAlong(0.5f), whole, 1.2);
}

}  // namespace
}  // namespace sinew::test
