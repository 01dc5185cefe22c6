// app/bench/drawing.cpp: smooths and draws a clip off screen; smoothing is not timed.
#include "app/bench/drawing.h"

#include <vector>

#include "app/bench/measuring.h"
#include "app/platform/offscreen.h"
#include "app/render/framing.h"
#include "app/render/viewport.h"
#include "core/character/skinning.h"

namespace sinew::app {
namespace {

constexpr int kSamples = 4;
constexpr glm::ivec2 kSize{1280, 800};

}  // namespace

Result<DrawCost> measureDrawing(const BenchScene& scene, int rounds) {
  const Rig rig = rigAt(scene, kBenchDepth);
  Result<Smoother> smoother = preparedSmoother(scene, rig);
  if (!smoother) return smoother.error();
  const auto context = OffscreenContext::create();
  if (!context) return context.error();
  const auto viewport = Viewport::create(kSamples);
  if (!viewport) return viewport.error();
  viewport.value()->setCharacter(*scene.character);
  viewport.value()->setFinishFrames(true);
  const std::vector<Pose> poses = steadyFrames(*scene.character, rounds + 1, 1.0 / 60.0);
  SkinnedMesh skinned;
  skin(*scene.character, poses.front(), skinned);
  const View view = framedView(skinned.positions, 0.5f, 0.2f, kSize, false);
  const RigPoser poser(rig, *scene.character);
  std::vector<double> draw, upload;
  for (std::size_t p = 0; p < poses.size(); ++p) {  // The first picture makes programs and textures.
    Surface surface;
    smoother.value().smooth(poses[p], surface);
    Scene picture;
    picture.character = scene.character.get();
    picture.surface = &surface;
    picture.pose = &poses[p];
    picture.primitives = shapesOf(rig, poser.pose(poses[p]));
    viewport.value()->draw(picture, view, {});
    if (p == 0) continue;
    draw.push_back(viewport.value()->seconds().draw);
    upload.push_back(viewport.value()->seconds().upload);
  }
  return DrawCost{median(draw), median(upload)};
}

}  // namespace sinew::app
