// tests/viewport/render/culling_test.cpp: pictures with and without culled triangles are equal, pixel for pixel.
#include <cstdio>

#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/eyes.h"
#include "tests/viewport/render/pictures.h"

#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"

namespace sinew::test {
namespace {

constexpr int kDirections = 24;
constexpr glm::ivec2 kSize{180, 180};

struct Counts {
  int pictures = 0;
  int differing = 0;
  long long pixels = 0;
  long long culled = 0;
  long long triangles = 0;
};

/// Near, far and orthographic views from all sides.
std::vector<app::View> viewsOf(const Bounds& bounds) {
  std::vector<app::View> views;
  const float reach = 0.5f * glm::length(bounds.high - bounds.low);
  for (const glm::vec3& direction : spreadDirections(kDirections)) {
    const float yaw = std::atan2(direction.x, direction.z);
    const float pitch = std::asin(direction.y);
    views.push_back(app::orbitView(bounds.center(), yaw, pitch, 1.6f * reach, kSize, false, reach));
    views.push_back(app::orbitView(bounds.center(), yaw, pitch, 6.0f * reach, kSize, false, reach));
    views.push_back(app::orbitView(bounds.center(), yaw, pitch, 3.5f * reach, kSize, true, reach));
  }
  return views;
}

long long differingPixels(const app::Image& a, const app::Image& b) {
  long long count = 0;
  for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
    if (!std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i])) ++count;
  }
  return count;
}

Counts countsOf(const TrialScene& scene, const Rig& rig, app::Viewport& viewport) {
  Counts counts;
  Smoother smoother(scene.character);
  EXPECT_TRUE(smoother.prepare(rig).ok());
  Moment whole{spreadPoses(*scene.character, 1).back(), {}};
  Moment culled{whole.pose, {}};
  smoother.smooth(whole.pose, whole.surface);
  app::DisplaySettings display;
  display.ground = false;
  for (const app::View& view : viewsOf(boundsOf(whole.surface.positions))) {
    smoother.smooth(culled.pose, culled.surface, view.facingPoint());
    viewport.draw(sceneOf(*scene.character, whole), view, display);
    const app::Image expected = viewport.readPixels();
    viewport.draw(sceneOf(*scene.character, culled), view, display);
    const long long pixels = differingPixels(expected, viewport.readPixels());
    ++counts.pictures;
    counts.pixels += pixels;
    counts.differing += pixels > 0 ? 1 : 0;
    counts.culled += culled.surface.report.culledTriangles;
    counts.triangles += static_cast<long long>(scene.character->mesh.triangles.size());
  }
  return counts;
}

TrialScene demoScene() {
  const std::filesystem::path file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json";
  const auto rig = loadRig(file);
  EXPECT_TRUE(rig.ok());
  const auto character = importGltf(characterPath(rig.value(), file));
  EXPECT_TRUE(character.ok());
  return {"demo", character.value(), rig.value()};
}

TEST_F(Drawing, CullingChangesNoPixel) {
  std::vector<TrialScene> scenes = trialScenes();
  scenes.push_back(demoScene());
  std::printf("  %-11s %-8s %9s %8s %10s %8s\n", "scene", "mode", "pictures", "culled", "differing", "pixels");
  for (const TrialScene& trial : scenes) {
    const TrialScene scene = oneSided(trial);
    const auto viewport = viewportFor(*scene.character);
    for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
      const Counts counts = countsOf(scene, withMode(scene.rig, mode), *viewport);
      const double share = static_cast<double>(counts.culled) / static_cast<double>(counts.triangles);
      std::printf("  %-11s %-8s %9d %7.1f%% %10d %8lld\n", scene.name.c_str(), nameOf(mode), counts.pictures,
                  100.0 * share, counts.differing, counts.pixels);
      std::fflush(stdout);
      const std::string what = scene.name + ", " + nameOf(mode);
      EXPECT_EQ(counts.pixels, 0) << what;
      EXPECT_GT(share, leastCulled(scene)) << what;
    }
  }
}

TEST_F(Drawing, CulledSurfaceCastsAWholeShadow) {
  const TrialScene scene = demoScene();
  const auto viewport = viewportFor(*scene.character);
  Smoother smoother(scene.character);
  ASSERT_TRUE(smoother.prepare(Rig{}).ok());
  Moment whole{bindPose(scene.character->skeleton), {}};
  Moment culled{whole.pose, {}};
  smoother.smooth(whole.pose, whole.surface);
  const app::View view = app::framedView(boundsOf(whole.surface.positions), 0.6f, 0.5f, kSize, false, 0.25f);
  smoother.smooth(culled.pose, culled.surface, view.facingPoint());
  ASSERT_GT(culled.surface.report.culledTriangles, 0);
  viewport->draw(sceneOf(*scene.character, whole), view, {});
  const app::Image expected = viewport->readPixels();
  viewport->draw(sceneOf(*scene.character, culled), view, {});
  EXPECT_EQ(differingPixels(expected, viewport->readPixels()), 0);
  viewport->draw(sceneOf(*scene.character, whole), view, {});
  EXPECT_EQ(differingPixels(expected, viewport->readPixels()), 0);
}

}  // namespace
}  // namespace sinew::test
