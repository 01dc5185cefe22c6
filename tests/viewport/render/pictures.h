// tests/viewport/render/pictures.h: an OpenGL context, small characters to draw, and pixel statistics.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "app/ui/offscreen.h"
#include "app/viewport/render/view.h"
#include "app/viewport/render/viewport.h"
#include "core/geometry/weld.h"
#include "sinew/character/pose.h"
#include "sinew/surface/refinement.h"
#include "sinew/surface/smoother.h"

namespace sinew::test {

/// Tests that draw: one context for each test; skipped without one.
class Drawing : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = app::OffscreenContext::create();
    if (!made) GTEST_SKIP() << "left out: " << made.error().text();
    context_ = std::move(made).value();
  }

  void TearDown() override {
    if (context_ != nullptr) {
      EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
  }

  static std::unique_ptr<app::Viewport> viewportFor(const Character& character, int samples = 1) {
    auto made = app::Viewport::create(samples);
    if (!made) {
      ADD_FAILURE() << made.error().text();
      return nullptr;
    }
    std::unique_ptr<app::Viewport> viewport = std::move(made).value();
    viewport->setCharacter(character);
    return viewport;
  }

 private:
  std::unique_ptr<app::OffscreenContext> context_;
};

struct Moment {
  Pose pose;
  Surface surface;
};

inline Moment bindMoment(const std::shared_ptr<const Character>& character, int depth,
                         PatchKind patch = PatchKind::kPn) {
  Moment moment{bindPose(character->skeleton), {}};
  Rig rig;
  rig.smoothing.depth = depth;
  rig.smoothing.patch = patch;
  Smoother smoother(character);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok());
  if (prepared) smoother.smooth(moment.pose, moment.surface);
  return moment;
}

inline app::Scene sceneOf(const Character& character, const Moment& moment) {
  app::Scene scene;
  scene.character = &character;
  scene.surface = &moment.surface;
  scene.pose = &moment.pose;
  return scene;
}

/// Plain colors on an empty background, so that tests can predict them.
inline app::DisplaySettings bareColors() {
  app::DisplaySettings settings;
  settings.ground = false;
  settings.background = false;
  settings.lighting = false;
  return settings;
}

inline float linearOf(int srgb) {
  const float s = static_cast<float>(srgb) / 255.0f;
  return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}

using Pixel = std::array<int, 4>;
inline Pixel pixelAt(const app::Image& image, int x, int y) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

/// Square from -1 to 1 in the XY plane, facing +Z, one bone; uv (0, 0) at its top left corner as glTF counts them.
inline std::shared_ptr<Character> makeQuad() {
  TriangleSoup soup;
  soup.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  soup.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  soup.influenceBegin = {0, 1, 2, 3, 4};
  soup.influences = {{0, 1.0f}, {0, 1.0f}, {0, 1.0f}, {0, 1.0f}};
  soup.triangles = {{0, 1, 2}, {0, 2, 3}};
  soup.materials = {0, 0};
  auto character = std::make_shared<Character>();
  character->mesh = weld(soup, 1e-6f);
  Bone bone;
  bone.name = "only";
  character->skeleton.bones.push_back(bone);
  character->skeleton.nodes.emplace_back();
  character->skeleton.bindings.push_back({0, glm::mat4(1.0f)});
  finishBones(character->skeleton);
  character->materials.emplace_back();
  character->height = 2.0f;
  return character;
}

/// The quad from straight ahead (or behind), filling the middle half of the picture.
inline app::View viewOfQuad(float yaw = 0.0f, int size = 64) {
  return app::framedView(Bounds{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}, yaw, 0.0f, {size, size}, false, 0.25f);
}

inline app::Image drawBare(const std::shared_ptr<Character>& character, app::Viewport& viewport,
                           const app::View& view) {
  const Moment moment = bindMoment(character, 1, PatchKind::kFlat);
  viewport.draw(sceneOf(*character, moment), view, bareColors());
  return viewport.readPixels();
}

}  // namespace sinew::test
