// tests/viewport/render/refine_test.cpp: a resting picture becomes smooth, stays in place, and follows its settings.

#include <cmath>
#include <set>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/gl_objects.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::Backdrop;
using app::DisplaySettings;
using app::Image;
using app::LightPreset;
using app::Scene;
using app::View;

View viewOf(const Moment& moment, bool orthographic = false) {
  return app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.2f, {160, 120}, orthographic);
}

int refineAll(app::Viewport& viewport, const Scene& scene, const View& view, const DisplaySettings& settings) {
  int shown = 0, calls = 0;
  while (!viewport.isRefined() && ++calls < 100) shown += viewport.refine(scene, view, settings) ? 1 : 0;
  EXPECT_EQ(calls, app::kMeanSamples);
  return shown;
}

double meanDifference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int{a.rgba[i]} - int{b.rgba[i]});
  return sum / static_cast<double>(a.rgba.size());
}

double meanLight(const Image& image) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i] + image.rgba[i + 1] + image.rgba[i + 2];
  return sum / static_cast<double>(image.rgba.size());
}

int partlyCovered(const Image& image) {
  int count = 0;
  for (std::size_t at = 3; at < image.rgba.size(); at += 4) {
    count += image.rgba[at] > 0 && image.rgba[at] < 255 ? 1 : 0;
  }
  return count;
}

TEST(SampleOffsets, CoverThePixelEvenly) {
  for (const int count : {4, 16}) {
    const int side = count == 4 ? 2 : 4;
    std::set<std::pair<int, int>> cells;
    glm::vec2 sum(0.0f);
    for (int i = 0; i < count; ++i) {
      const glm::vec2 at = app::sampleOffset(i);
      EXPECT_TRUE(std::abs(at.x) <= 0.5f && std::abs(at.y) <= 0.5f);
      sum += at;
      cells.insert({static_cast<int>((at.x + 0.5f) * static_cast<float>(side)),
                    static_cast<int>((at.y + 0.5f) * static_cast<float>(side))});
    }
    EXPECT_EQ(cells.size(), static_cast<std::size_t>(count)) << "one in each cell";
    EXPECT_LT(glm::length(sum / static_cast<float>(count)), count == 16 ? 1e-6f : 0.15f) << "the picture stays";
  }
}

TEST_F(Drawing, RefinedPictureHasSmoothEdgesInPlace) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const Scene scene = sceneOf(*quad, moment);
  for (const bool orthographic : {false, true}) {
    const View view =
        app::framedView(Bounds{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}, 0.4f, 0.3f, {64, 64}, orthographic, 0.2f);
    const auto viewport = viewportFor(*quad, 1);
    viewport->draw(scene, view, bareColors());
    EXPECT_EQ(viewport->samplesTaken(), 0);
    const Image rough = viewport->readPixels();
    EXPECT_EQ(partlyCovered(rough), 0);
    EXPECT_EQ(refineAll(*viewport, scene, view, bareColors()), 2) << "after four samples, and after all";
    const Image smooth = viewport->readPixels();
    EXPECT_GT(partlyCovered(smooth), 40);
    EXPECT_FALSE(viewport->refine(scene, view, bareColors())) << "it is done";
    // Independent reference: a picture nine times as large, each 3x3 pixels averaged.
    View large = view;
    large.size = {576, 576};
    viewport->draw(scene, large, bareColors());
    const Image fine = viewport->readPixels();
    double worst = 0.0, sum = 0.0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        double alpha = 0.0;
        for (int v = 0; v < 9; ++v) {
          for (int u = 0; u < 9; ++u) alpha += pixelAt(fine, 9 * x + u, 9 * y + v)[3] / 81.0;
        }
        const double off = std::abs(alpha - pixelAt(smooth, x, y)[3]);
        worst = std::max(worst, off);
        sum += off;
      }
    }
    EXPECT_LT(worst, 255.0 * 0.13);  // Sixteen samples resolve a straight edge to within two of them.
    EXPECT_LT(sum / (64.0 * 64.0), 0.6);
  }
}

TEST_F(Drawing, RefinedPictureApproachesManySamples) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 4);
  const Scene scene = sceneOf(*limb, moment);
  DisplaySettings settings;
  settings.ground = false;  // Its lines are antialiased on their own, and samples soften them.
  const auto many = viewportFor(*limb, 4), one = viewportFor(*limb, 1);
  many->draw(scene, viewOf(moment), settings);
  one->draw(scene, viewOf(moment), settings);
  const double before = meanDifference(one->readPixels(), many->readPixels());
  refineAll(*one, scene, viewOf(moment), settings);
  const double after = meanDifference(one->readPixels(), many->readPixels());
  EXPECT_LT(after, 0.8);
  EXPECT_LT(after, before);
}

TEST_F(Drawing, RefinementIsRepeatableAndRestartsWithEachDraw) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 3);
  const Scene scene = sceneOf(*limb, moment);
  DisplaySettings settings;
  settings.look.occlusion = true;
  const auto viewport = viewportFor(*limb, 1);
  viewport->draw(scene, viewOf(moment), settings);
  const Image moving = viewport->readPixels();
  refineAll(*viewport, scene, viewOf(moment), settings);
  const Image once = viewport->readPixels();
  viewport->draw(scene, viewOf(moment), settings);
  EXPECT_EQ(viewport->samplesTaken(), 0);
  EXPECT_EQ(viewport->readPixels().rgba, moving.rgba) << "a move shows at once";
  for (int i = 0; i < 7; ++i) viewport->refine(scene, viewOf(moment), settings);
  viewport->draw(scene, viewOf(moment), settings);
  refineAll(*viewport, scene, viewOf(moment), settings);
  EXPECT_EQ(viewport->readPixels().rgba, once.rgba);
}

TEST_F(Drawing, OcclusionDarkensAndNeverLightens) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 4);
  const Scene scene = sceneOf(*limb, moment);
  for (const bool orthographic : {false, true}) {
    DisplaySettings settings;
    settings.shading = app::Shading::kClay;
    settings.ground = false;
    const auto viewport = viewportFor(*limb, 1);
    const View view = viewOf(moment, orthographic);
    viewport->draw(scene, view, settings);
    refineAll(*viewport, scene, view, settings);
    const Image plain = viewport->readPixels();
    settings.look.occlusion = true;
    viewport->draw(scene, view, settings);
    refineAll(*viewport, scene, view, settings);
    const Image occluded = viewport->readPixels();
    for (std::size_t i = 0; i < plain.rgba.size(); ++i) ASSERT_LE(occluded.rgba[i], plain.rgba[i] + 2) << i;
    EXPECT_LE(meanLight(occluded), meanLight(plain));
    EXPECT_EQ(pixelAt(occluded, 2, 2), pixelAt(plain, 2, 2)) << "the background is left alone";
  }
}

/// Two squares that nearly meet at a right angle along x = 0, so that each keeps its own normals: floor and wall.
std::shared_ptr<Character> makeCorner() {
  auto character = makeQuad();
  TriangleSoup soup;
  soup.positions = {{0, 0, 1},       {2, 0, 1},        {2, 0, -1},       {0, 0, -1},
                    {-0.002f, 0, 1}, {-0.002f, 0, -1}, {-0.002f, 2, -1}, {-0.002f, 2, 1}};
  soup.uvs.assign(8, glm::vec2(0.0f));
  soup.influenceBegin = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  soup.influences.assign(8, {0, 1.0f});
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  soup.materials = {0, 0, 0, 0};
  character->mesh = weld(soup, 1e-6f);
  character->materials[0].doubleSided = true;
  return character;
}

TEST_F(Drawing, OcclusionIsStrongestInTheCorner) {
  const auto corner = makeCorner();
  const Moment moment = bindMoment(corner, 1, PatchKind::kFlat);
  const Scene scene = sceneOf(*corner, moment);
  DisplaySettings settings;
  settings.shading = app::Shading::kClay;
  settings.ground = settings.background = false;
  const View view = app::framedView(Bounds{glm::vec3(0, 0, -1), glm::vec3(2, 2, 1)}, 1.2f, 0.5f, {200, 200}, false);
  const auto viewport = viewportFor(*corner, 1);
  const auto light = [&](bool occlusion, const glm::vec3& place) {
    settings.look.occlusion = occlusion;
    viewport->draw(scene, view, settings);
    refineAll(*viewport, scene, view, settings);
    const glm::vec2 at(view.toPixel(place));
    return pixelAt(viewport->readPixels(), static_cast<int>(at.x), static_cast<int>(at.y))[1];
  };
  const auto lost = [&](const glm::vec3& place) { return light(false, place) - light(true, place); };
  EXPECT_GT(lost({0.06f, 0.0f, 0.0f}), 4);
  EXPECT_LE(lost({1.4f, 0.0f, 0.0f}), 1) << "far from the wall nothing is lost";
  EXPECT_GT(lost({0.06f, 0.0f, 0.0f}), lost({0.12f, 0.0f, 0.0f}) - 1);
}

TEST_F(Drawing, LightsAndBackgroundsAreDistinct) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 3);
  const Scene scene = sceneOf(*limb, moment);
  const auto viewport = viewportFor(*limb, 1);
  const auto picture = [&](const DisplaySettings& settings) {
    viewport->draw(scene, viewOf(moment), settings);
    return viewport->readPixels();
  };
  for (const app::Shading shading : {app::Shading::kTextured, app::Shading::kClay}) {
    std::set<std::vector<std::uint8_t>> seen;
    for (const LightPreset light : {LightPreset::kStudio, LightPreset::kOutdoor, LightPreset::kRim}) {
      DisplaySettings settings;
      settings.shading = shading;
      settings.look.light = light;
      settings.background = settings.ground = false;
      const Image image = picture(settings);
      seen.insert(image.rgba);
      int blown = 0, covered = 0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        covered += image.rgba[i + 3] > 0 ? 1 : 0;
        blown += image.rgba[i + 3] > 0 && image.rgba[i] > 253 && image.rgba[i + 1] > 253 ? 1 : 0;
      }
      EXPECT_LT(blown, covered / 10) << "highlights keep their shape: " << nameOf(light);
    }
    EXPECT_EQ(seen.size(), 3u);
  }
  std::set<std::vector<std::uint8_t>> seen;
  for (std::size_t i = 0; i < app::kBackdropNames.size(); ++i) {
    DisplaySettings settings;
    settings.look.backdrop = static_cast<Backdrop>(i);
    seen.insert(picture(settings).rgba);
    settings.background = false;
    EXPECT_EQ(pixelAt(picture(settings), 1, 1)[3], 0) << "a transparent picture has no background";
  }
  EXPECT_EQ(seen.size(), app::kBackdropNames.size());
}

TEST_F(Drawing, FlatBackgroundsAreOneColor) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad, 1);
  for (const Backdrop backdrop : {Backdrop::kDark, Backdrop::kMid, Backdrop::kLight}) {
    DisplaySettings settings;
    settings.surface = settings.ground = false;
    settings.look.backdrop = backdrop;
    viewport->draw(sceneOf(*quad, moment), viewOfQuad(), settings);
    const Image image = viewport->readPixels();
    for (int y = 0; y < 64; y += 9) {
      for (int x = 0; x < 64; x += 9) {
        const Pixel pixel = pixelAt(image, x, y);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(pixel[c], pixelAt(image, 0, 0)[c], 1);
        EXPECT_NEAR(pixel[0], 255.0f * app::backdropStyle(backdrop).low.x, 1.1);
      }
    }
  }
}

TEST(PictureLooks, NamesRoundTrip) {
  for (const char* name : app::kLightNames) EXPECT_STREQ(nameOf(*app::lightNamed(name)), name);
  for (const char* name : app::kBackdropNames) EXPECT_STREQ(nameOf(*app::backdropNamed(name)), name);
  EXPECT_FALSE(app::lightNamed("moon").has_value());
  EXPECT_FALSE(app::backdropNamed("").has_value());
}

}  // namespace
}  // namespace sinew::test
