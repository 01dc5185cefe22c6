// tests/viewport/render/beside_test.cpp: a second surface beside the first is drawn as if it were alone.
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::Image;

constexpr int kSide = 96;

/// The quad and another one beside it with a different displacement.
struct Pair {
  std::shared_ptr<Character> quad = makeQuad();
  Moment first = bindMoment(quad, 2, PatchKind::kFlat);
  Surface second = first.surface;

  Pair() {
    const std::size_t count = second.positions.size();
    first.surface.displacement.assign(count, 0.01f);
    second.displacement.assign(count, 0.05f);
    for (glm::vec3& point : second.positions) point += glm::vec3(2.5f, 0.3f, 0.0f);
  }
  [[nodiscard]] Image picture(app::Viewport& viewport, const Surface& surface, const Surface* beside,
                              const app::DisplaySettings& settings) const {
    app::Scene scene = sceneOf(*quad, first);
    scene.surface = &surface;
    scene.beside = beside;
    const Bounds all{glm::vec3(-1.2f, -1.2f, 0.0f), glm::vec3(3.7f, 1.5f, 0.0f)};
    viewport.draw(scene, app::framedView(all, 0.1f, 0.1f, {kSide, kSide}, false, 0.05f), settings);
    return viewport.readPixels();
  }
};

TEST_F(Drawing, SecondSurfaceIsDrawnAsIfAlone) {
  const Pair pair;
  const auto viewport = viewportFor(*pair.quad);
  for (const app::Shading shading : {app::Shading::kTextured, app::Shading::kClay, app::Shading::kHeat}) {
    for (const bool wire : {false, true}) {
      app::DisplaySettings settings = bareColors();
      settings.shading = shading;
      settings.wire = wire;
      settings.lighting = true;
      const Image left = pair.picture(*viewport, pair.first.surface, nullptr, settings);
      const Image right = pair.picture(*viewport, pair.second, nullptr, settings);
      const Image both = pair.picture(*viewport, pair.first.surface, &pair.second, settings);
      int ofLeft = 0, ofRight = 0;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          const Pixel a = pixelAt(left, x, y), b = pixelAt(right, x, y);
          ofLeft += a[3] > 0;
          ofRight += b[3] > 0;
          ASSERT_FALSE(a[3] > 0 && b[3] > 0) << "they do not overlap";
          EXPECT_EQ(pixelAt(both, x, y), a[3] > 0 ? a : b) << x << ", " << y;
        }
      }
      EXPECT_GT(ofLeft, 300);
      EXPECT_GT(ofRight, 300);
    }
  }
}

TEST_F(Drawing, RemovedSecondSurfaceLeavesNoTrace) {
  const Pair pair;
  const auto viewport = viewportFor(*pair.quad);
  const app::DisplaySettings settings = bareColors();
  const Image alone = pair.picture(*viewport, pair.first.surface, nullptr, settings);
  EXPECT_NE(pair.picture(*viewport, pair.first.surface, &pair.second, settings).rgba, alone.rgba);
  EXPECT_EQ(pair.picture(*viewport, pair.first.surface, nullptr, settings).rgba, alone.rgba);
}

TEST_F(Drawing, BothSurfacesCastShadows) {
  const Pair pair;
  const auto viewport = viewportFor(*pair.quad);
  app::DisplaySettings settings;
  settings.shading = app::Shading::kClay;
  settings.surface = false;  // Floor only: shadows are cast anyway.
  const Image none = pair.picture(*viewport, pair.first.surface, nullptr, settings);
  const Image both = pair.picture(*viewport, pair.first.surface, &pair.second, settings);
  int darker = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = kSide / 2; x < kSide; ++x) darker += pixelAt(both, x, y)[1] < pixelAt(none, x, y)[1];
  }
  EXPECT_GT(darker, 20) << "under the second";
}

}  // namespace
}  // namespace sinew::test
