// tests/viewport/render/viewport_test.cpp: pictures have the expected content, and are repeatable.
#include "app/viewport/render/viewport.h"

#include <cstdlib>

#include "app/viewport/render/picking.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::DisplaySettings;
using app::Image;
using app::Scene;
using app::Shading;
using app::View;

/// Texture of a single color.
Texture plainTexture(int red, int green, int blue, int alpha) {
  Texture texture;
  texture.width = texture.height = 4;
  for (int i = 0; i < 16; ++i) {
    for (const int value : {red, green, blue, alpha}) texture.rgba.push_back(static_cast<std::uint8_t>(value));
  }
  return texture;
}

View viewOf(const Moment& moment, bool orthographic = false) {
  return app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.2f, {160, 120}, orthographic);
}

TEST_F(Drawing, TextureColorsAreReproduced) {
  const auto quad = makeQuad();
  quad->materials[0].baseColorTexture = 0;
  for (const int samples : {1, 4}) {
    for (const int gray : {1, 12, 55, 128, 188, 254}) {
      quad->textures = {plainTexture(gray, 255 - gray, 128, 255)};
      const auto viewport = viewportFor(*quad, samples);
      const Pixel pixel = pixelAt(drawBare(quad, *viewport, viewOfQuad()), 32, 32);
      EXPECT_NEAR(pixel[0], gray, 1);
      EXPECT_NEAR(pixel[1], 255 - gray, 1);
      EXPECT_NEAR(pixel[2], 128, 1);
      EXPECT_EQ(pixel[3], 255);
    }
  }
}

TEST_F(Drawing, TexturesAreUpright) {
  const auto quad = makeQuad();
  quad->materials[0].baseColorTexture = 0;
  Texture corners = plainTexture(0, 0, 0, 255);
  corners.nearest = true;
  const auto paint = [&](std::size_t x, std::size_t y, std::size_t channel) {
    corners.rgba[4 * (4 * y + x) + channel] = 255;
  };
  paint(0, 0, 0);  // Red at the top left, green at the top right, blue at the bottom left.
  paint(3, 0, 1);
  paint(0, 3, 2);
  quad->textures = {corners};
  const auto viewport = viewportFor(*quad);
  const Image image = drawBare(quad, *viewport, viewOfQuad());
  EXPECT_EQ(pixelAt(image, 18, 18), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(pixelAt(image, 45, 18), (Pixel{0, 255, 0, 255}));
  EXPECT_EQ(pixelAt(image, 18, 45), (Pixel{0, 0, 255, 255}));
  EXPECT_EQ(pixelAt(image, 45, 45), (Pixel{0, 0, 0, 255}));
}

TEST_F(Drawing, BackFacesAreVisibleOnlyOnDoubleSidedMaterials) {
  const auto quad = makeQuad();
  const float behind = 3.14159265f;
  EXPECT_EQ(pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad()), 32, 32)[3], 255);
  EXPECT_EQ(pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad(behind)), 32, 32)[3], 0);
  quad->materials[0].doubleSided = true;
  EXPECT_EQ(pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad(behind)), 32, 32)[3], 255);
}

TEST_F(Drawing, AlphaModesMaskAndBlend) {
  const auto quad = makeQuad();
  quad->materials[0].baseColor = {1, 1, 1, 0.5f};
  EXPECT_EQ(pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad()), 32, 32), (Pixel{255, 255, 255, 255}));
  quad->materials[0].alphaMode = AlphaMode::kBlend;
  const Pixel blended = pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad()), 32, 32);
  EXPECT_NEAR(blended[3], 128, 1);
  EXPECT_NEAR(blended[0], 255, 1);
  quad->materials[0].alphaMode = AlphaMode::kMask;
  quad->materials[0].alphaCutoff = 0.6f;
  EXPECT_EQ(pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad()), 32, 32)[3], 0);
  quad->materials[0].alphaCutoff = 0.4f;
  EXPECT_EQ(pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad()), 32, 32)[3], 255);
}

TEST_F(Drawing, MultisamplingSoftensEdgesWithoutDarkening) {
  const auto quad = makeQuad();
  const View view =
      app::framedView(Bounds{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}, 0.4f, 0.3f, {64, 64}, false, 0.2f);
  const auto partial = [&](int samples) {
    int count = 0;
    const Image image = drawBare(quad, *viewportFor(*quad, samples), view);
    for (std::size_t at = 0; at < image.rgba.size(); at += 4) {
      if (image.rgba[at + 3] == 0) continue;
      EXPECT_GE(image.rgba[at], 253);  // White stays white however little of the pixel it covers.
      count += image.rgba[at + 3] < 255 ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(partial(1), 0);
  EXPECT_GT(partial(4), 20);
}

TEST_F(Drawing, RepeatedPictureIsIdentical) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 4);
  DisplaySettings all;
  all.wire = all.controlMesh = all.skeleton = all.primitives = all.influence = true;
  Scene scene = sceneOf(*limb, moment);
  scene.skinnedControlPositions = limb->mesh.positions;
  scene.primitives.emplace_back();
  scene.primitives.back().unitBallInWorld = glm::mat4(0.3f);
  scene.primitives.back().unitBallInWorld[3] = {0.1f, 0.8f, 0.2f, 1.0f};
  const auto first = viewportFor(*limb, 4);
  first->draw(scene, viewOf(moment), all);
  const Image once = first->readPixels();
  first->draw(scene, viewOf(moment), all);
  EXPECT_EQ(first->readPixels().rgba, once.rgba);
  const auto second = viewportFor(*limb, 4);
  second->draw(scene, viewOf(moment), all);
  EXPECT_EQ(second->readPixels().rgba, once.rgba);
}

TEST_F(Drawing, EverySettingChangesThePicture) {
  const auto limb = makeLimb();
  const Moment moment = bindMoment(limb, 3);
  Scene scene = sceneOf(*limb, moment);
  scene.skinnedControlPositions = limb->mesh.positions;
  scene.primitives.emplace_back();
  scene.primitives.back().unitBallInWorld = glm::mat4(0.4f);
  scene.primitives.back().unitBallInWorld[3] = {0.3f, 1.0f, 0.0f, 1.0f};
  const auto viewport = viewportFor(*limb);
  const auto picture = [&](const Scene& shown, const DisplaySettings& settings) {
    viewport->draw(shown, viewOf(moment), settings);
    return viewport->readPixels().rgba;
  };
  const std::vector<std::uint8_t> plain = picture(scene, {});
  for (bool DisplaySettings::*on : {&DisplaySettings::wire, &DisplaySettings::controlMesh, &DisplaySettings::skeleton,
                                    &DisplaySettings::primitives, &DisplaySettings::influence}) {
    DisplaySettings settings;
    settings.*on = true;
    EXPECT_NE(picture(scene, settings), plain);
  }
  for (bool DisplaySettings::*off : {&DisplaySettings::surface, &DisplaySettings::ground, &DisplaySettings::background,
                                     &DisplaySettings::lighting}) {
    DisplaySettings settings;
    settings.*off = false;
    EXPECT_NE(picture(scene, settings), plain);
  }
  for (const Shading shading : {Shading::kClay, Shading::kClasses, Shading::kHeat}) {
    DisplaySettings settings;
    settings.shading = shading;
    EXPECT_NE(picture(scene, settings), plain);
  }
  DisplaySettings marks;
  marks.skeleton = marks.primitives = true;
  const std::vector<std::uint8_t> unmarked = picture(scene, marks);
  Scene selected = scene;
  selected.selectedBone = 1;
  EXPECT_NE(picture(selected, marks), unmarked);
  selected = scene;
  selected.primitives[0].selected = true;
  EXPECT_NE(picture(selected, marks), unmarked);
  selected.primitives[0].selected = false;
  selected.primitives[0].sign = -1;
  EXPECT_NE(picture(selected, marks), unmarked);
}

TEST_F(Drawing, ClassColorsMatchTheirTriangles) {
  // Two materials, so that triangles are drawn in another order than stored.
  const auto quad = makeQuad();
  quad->materials.emplace_back();
  quad->mesh.triangles[0].material = 1;
  Moment moment = bindMoment(quad, 2, PatchKind::kFlat);
  moment.surface.classes = {TriangleClass::kImplicit, TriangleClass::kNormal};
  DisplaySettings settings = bareColors();
  settings.shading = Shading::kClasses;
  const auto viewport = viewportFor(*quad);
  viewport->draw(sceneOf(*quad, moment), viewOfQuad(), settings);
  const Image image = viewport->readPixels();
  const Pixel lowerRight = pixelAt(image, 42, 44), upperLeft = pixelAt(image, 20, 22);
  EXPECT_GT(lowerRight[0], lowerRight[2] + 40);  // Triangle 0: implicit, reddish.
  EXPECT_GT(upperLeft[2], upperLeft[0] + 40);    // Triangle 1: normal, bluish.
}

TEST_F(Drawing, NewDepthAndNewSizeTakeEffect) {
  const auto limb = makeLimb();
  const auto viewport = viewportFor(*limb);
  const Moment coarse = bindMoment(limb, 1), fine = bindMoment(limb, 5);
  viewport->draw(sceneOf(*limb, coarse), viewOf(coarse), bareColors());
  viewport->draw(sceneOf(*limb, fine), viewOf(coarse), bareColors());
  const Image after = viewport->readPixels();
  const auto fresh = viewportFor(*limb);
  fresh->draw(sceneOf(*limb, fine), viewOf(coarse), bareColors());
  EXPECT_EQ(after.rgba, fresh->readPixels().rgba);
  View small = viewOf(coarse);
  small.size = {40, 30};
  viewport->draw(sceneOf(*limb, fine), small, {});
  EXPECT_EQ(viewport->readPixels().width, 40);
  EXPECT_EQ(viewport->readPixels().rgba.size(), 40u * 30u * 4u);
}

TEST_F(Drawing, SceneWithoutASurfaceIsDrawn) {
  const auto limb = makeLimb();
  const Pose pose = bindPose(limb->skeleton);
  Scene scene;
  scene.character = limb.get();
  scene.pose = &pose;
  DisplaySettings settings;
  settings.skeleton = true;
  settings.background = settings.ground = false;
  const auto viewport = viewportFor(*limb);
  viewport->draw(scene, app::framedView(boundsOf(limb->mesh.positions), 0, 0, {64, 64}, true), settings);
  EXPECT_TRUE(std::ranges::any_of(viewport->readPixels().rgba, [](std::uint8_t value) { return value > 0; }));
}

TEST_F(Drawing, BrokenShaderIsNamedInOneLine) {
  const TemporaryFolder folder;
  folder.write("shaders/blur.frag", "#version 450 core\nvoid main() { nonsense; }\n");
  ASSERT_EQ(::setenv("SINEW_DATA_DIR", folder.path().c_str(), 1), 0);
  const auto made = app::Viewport::create(1);
  ::unsetenv("SINEW_DATA_DIR");
  ASSERT_FALSE(made.ok());
  EXPECT_NE(made.error().text().find("blur.frag"), std::string::npos);
  EXPECT_NE(made.error().text().find("nonsense"), std::string::npos);
  EXPECT_EQ(made.error().text().find('\n'), std::string::npos);
}

}  // namespace
}  // namespace sinew::test
