// tests/viewport/render/parts_test.cpp: a highlighted part is tinted where it is, visible or hidden, and nothing else
// is.
#include "app/viewport/render/color_scales.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::Image;
using app::LitPart;

constexpr int kPictureSize = 64;

/// The quad's triangle below its diagonal, and the one above it as a separate part.
std::shared_ptr<Character> quadOfTwoParts() {
  auto quad = makeQuad();
  quad->parts = {{"below", 0}, {"above", 0}};
  quad->mesh.triangles[1].part = 1;
  quad->materials[0].baseColor = glm::vec4(0.2f, 0.2f, 0.2f, 1.0f);
  return quad;
}

/// A large quad, and a small one in front of it (z > 0) or behind it as a separate part. @param tilt  its right edge is
/// that much nearer
std::shared_ptr<Character> quadAndSmallOne(float z, const glm::vec2& middle, float tilt = 0.0f) {
  TriangleSoup soup;
  soup.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
    soup.positions.emplace_back(middle + 0.4f * corner, z + 0.5f * tilt * (corner.x - 1.0f));
  }
  soup.uvs.assign(8, glm::vec2(0.5f));
  for (int i = 0; i <= 8; ++i) soup.influenceBegin.push_back(i);
  soup.influences.assign(8, {0, 1.0f});
  soup.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  soup.materials.assign(4, 0);
  auto character = makeQuad();
  character->mesh = weld(soup, 1e-6f);
  character->parts = {{"large", 0}, {"small", 0}};
  for (ControlTriangle& triangle : character->mesh.triangles) {
    const glm::vec3& corner = character->mesh.positions[static_cast<std::size_t>(triangle.vertices[0])];
    triangle.part = corner.z != 0.0f ? 1 : 0;
  }
  return character;
}

Image picture(const std::shared_ptr<Character>& character, app::Viewport& viewport, std::vector<LitPart> lit,
              const app::DisplaySettings& settings = bareColors(), std::vector<SkinLayer> layers = {}) {
  const Moment moment = bindMoment(character, 1, PatchKind::kFlat);
  app::Scene scene = sceneOf(*character, moment);
  scene.litParts = std::move(lit);
  scene.layers = std::move(layers);
  viewport.draw(scene, viewOfQuad(0.0f, kPictureSize), settings);
  return viewport.readPixels();
}

/// 1 below the quad's diagonal, 2 above it, 0 on it or outside.
int sideOf(int x, int y) {
  const float u = (static_cast<float>(x) + 0.5f - 16.0f) / 32.0f, v = (static_cast<float>(y) + 0.5f - 16.0f) / 32.0f;
  if (u < 0.1f || v < 0.1f || u > 0.9f || v > 0.9f || std::abs(1.0f - v - u) < 0.1f) return 0;
  return 1.0f - v < u ? 1 : 2;
}

TEST_F(Drawing, HighlightedPartIsTintedInItsLayerColor) {
  const auto quad = quadOfTwoParts();
  const auto viewport = viewportFor(*quad);
  const Image plain = picture(quad, *viewport, {});
  for (const SkinLayer layer : {SkinLayer::kSkin, SkinLayer::kCloth, SkinLayer::kRigid}) {
    const Image lit = picture(quad, *viewport, {{1, layer, true}});
    const glm::vec3 tint = app::linearFromSrgb(app::layerColor(layer).srgb);
    float share = -1.0f;
    for (int y = 0; y < kPictureSize; ++y) {
      for (int x = 0; x < kPictureSize; ++x) {
        if (sideOf(x, y) == 1) {
          EXPECT_EQ(pixelAt(lit, x, y), pixelAt(plain, x, y)) << x << ' ' << y;
        }
        if (sideOf(x, y) != 2) continue;
        const Pixel pixel = pixelAt(lit, x, y);
        for (int channel = 0; channel < 3; ++channel) {  // All channels have moved by the same fraction.
          const float from = linearOf(pixelAt(plain, x, y)[static_cast<std::size_t>(channel)]);
          const float way = tint[channel] - from;
          if (std::abs(way) < 0.25f) continue;  // Too few steps of 8 bits.
          const float gone = (linearOf(pixel[static_cast<std::size_t>(channel)]) - from) / way;
          if (share < 0.0f) share = gone;
          EXPECT_NEAR(gone, share, 0.04f) << x << ' ' << y << ' ' << channel;
        }
        EXPECT_EQ(pixel[3], 255);
      }
    }
    EXPECT_GT(share, 0.3f);
    EXPECT_LT(share, 0.8f);
  }
  EXPECT_EQ(picture(quad, *viewport, {}).rgba, plain.rgba);
}

TEST_F(Drawing, HoveredPartIsTintedMoreThanASelectedOne) {
  const auto quad = quadOfTwoParts();
  const auto viewport = viewportFor(*quad);
  const auto blueAt = [&](bool hovered) {
    return pixelAt(picture(quad, *viewport, {{1, SkinLayer::kCloth, hovered}}), 24, 24)[2];
  };
  EXPECT_GT(blueAt(true), blueAt(false) + 10);
}

TEST_F(Drawing, HighlightShowsThroughOnlyForFullyHiddenParts) {
  const auto behind = quadAndSmallOne(-0.5f, {0.0f, 0.0f});
  const auto viewport = viewportFor(*behind);
  const Image plain = picture(behind, *viewport, {});
  const Image lit = picture(behind, *viewport, {{1, SkinLayer::kRigid, true}});
  EXPECT_NE(pixelAt(lit, 32, 32), pixelAt(plain, 32, 32));
  EXPECT_EQ(pixelAt(lit, 18, 18), pixelAt(plain, 18, 18));
  // However steep and however near.
  const auto steep = quadAndSmallOne(-0.02f, {0.0f, 0.0f}, 1.6f);
  viewport->setCharacter(*steep);
  const Image through = picture(steep, *viewport, {{1, SkinLayer::kRigid, true}});
  EXPECT_EQ(pixelAt(through, 36, 32), pixelAt(lit, 32, 32));
  // Half of it is visible beside the large one: only that half is tinted.
  const auto beside = quadAndSmallOne(-0.5f, {1.05f, 0.0f});
  viewport->setCharacter(*beside);
  const Image out = picture(beside, *viewport, {});
  const Image half = picture(beside, *viewport, {{1, SkinLayer::kRigid, true}});
  EXPECT_NE(pixelAt(half, 51, 32), pixelAt(out, 51, 32));
  EXPECT_EQ(pixelAt(half, 45, 32), pixelAt(out, 45, 32));
}

TEST_F(Drawing, PartTintFollowsRefinement) {
  const auto quad = quadOfTwoParts();
  const auto viewport = viewportFor(*quad);
  for (const int depth : {1, 3}) {
    const Moment moment = bindMoment(quad, depth, PatchKind::kFlat);
    app::Scene scene = sceneOf(*quad, moment);
    viewport->draw(scene, viewOfQuad(0.0f, kPictureSize), bareColors());
    const Image plain = viewport->readPixels();
    scene.litParts = {{1, SkinLayer::kCloth, true}};
    viewport->draw(scene, viewOfQuad(0.0f, kPictureSize), bareColors());
    const Image lit = viewport->readPixels();
    EXPECT_NE(pixelAt(lit, 22, 24), pixelAt(plain, 22, 24));
    EXPECT_EQ(pixelAt(lit, 42, 40), pixelAt(plain, 42, 40));
  }
}

TEST_F(Drawing, ZonesDistinguishClothAndRigidPartsFromSkin) {
  const auto quad = quadOfTwoParts();
  const auto viewport = viewportFor(*quad);
  app::DisplaySettings settings = bareColors();
  settings.shading = app::Shading::kClasses;
  const auto zones = [&](std::vector<SkinLayer> layers) {
    return picture(quad, *viewport, {}, settings, std::move(layers));
  };
  const Image plain = zones({});
  EXPECT_EQ(zones({SkinLayer::kSkin, SkinLayer::kSkin}).rgba, plain.rgba);
  const Image cloth = zones({SkinLayer::kSkin, SkinLayer::kCloth});
  const Image rigid = zones({SkinLayer::kSkin, SkinLayer::kRigid});
  for (const Image& image : {cloth, rigid}) {
    EXPECT_EQ(pixelAt(image, 42, 40), pixelAt(plain, 42, 40));
    EXPECT_NE(pixelAt(image, 22, 24), pixelAt(plain, 22, 24));
  }
  EXPECT_NE(pixelAt(cloth, 22, 24), pixelAt(rigid, 22, 24));
}

TEST_F(Drawing, ZonesFollowLayersOnAnUnchangedSurface) {
  const auto quad = quadOfTwoParts();
  const auto viewport = viewportFor(*quad);
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  app::Scene scene = sceneOf(*quad, moment);
  scene.surfaceRevision = 1;
  app::DisplaySettings settings = bareColors();
  settings.shading = app::Shading::kClasses;
  const auto zones = [&] {
    viewport->draw(scene, viewOfQuad(0.0f, kPictureSize), settings);
    return viewport->readPixels().rgba;
  };
  const auto plain = zones();
  scene.layers = {SkinLayer::kSkin, SkinLayer::kRigid};
  EXPECT_NE(zones(), plain);
  scene.layers.clear();
  EXPECT_EQ(zones(), plain);
}

}  // namespace
}  // namespace sinew::test
