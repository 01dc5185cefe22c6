// tests/viewport/render/arrival_test.cpp: alpha and vertex colors in the picture, and the same alpha in the shadow.
#include "tests/support/characters/synthetic_characters.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::DisplaySettings;
using app::Image;
using app::Shading;
using app::View;

/// The body is in the middle of the picture, its shadow below it.
struct Arrival {
  Image whole;  ///< With ground, as the editor shows it.
  Image floor;  ///< Floor and shadow only.
};

View viewOf(const Surface& surface) {
  return app::framedView(boundsOf(surface.positions), 0.4f, 0.5f, {120, 120}, false, 0.4f);
}

Arrival arrivalOf(const std::shared_ptr<const Character>& character, app::Viewport& viewport, int depth,
                  Shading shading = Shading::kTextured) {
  const Moment moment = bindMoment(character, depth);
  DisplaySettings settings;
  settings.shading = shading;
  Arrival result;
  viewport.draw(sceneOf(*character, moment), viewOf(moment.surface), settings);
  result.whole = viewport.readPixels();
  settings.surface = false;
  viewport.draw(sceneOf(*character, moment), viewOf(moment.surface), settings);
  result.floor = viewport.readPixels();
  return result;
}

/// Sum over the picture of how much darker it is than another one.
double darkerBy(const Image& image, const Image& than) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i) sum += std::max(than.rgba[i] - image.rgba[i], 0);
  return sum;
}

/// Equal except for rounding.
void expectAlike(const Image& a, const Image& b, const char* what) {
  ASSERT_EQ(a.rgba.size(), b.rgba.size());
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
  EXPECT_LE(most, 1) << what;
}

std::shared_ptr<Character> limbWith(AlphaMode mode, float alpha) {
  auto limb = std::make_shared<Character>(*makeLimb());
  limb->materials[0].alphaMode = mode;
  limb->materials[0].baseColor.a = alpha;
  return limb;
}

class AlphaAndVertexColors : public Drawing {
 protected:
  static Arrival arrival(const std::shared_ptr<const Character>& character, int depth,
                         Shading shading = Shading::kTextured) {
    return arrivalOf(character, *viewportFor(*character), depth, shading);
  }
};

// Depth 1 and 3: on the CPU, the second's shadow is cast by control triangles.
TEST_F(AlphaAndVertexColors, HiddenCharacterShownOpaqueLooksOpaque) {
  for (const int depth : {1, 3}) {
    const Arrival opaque = arrival(limbWith(AlphaMode::kOpaque, 0.0f), depth);
    for (const AlphaMode mode : {AlphaMode::kMask, AlphaMode::kBlend}) {
      const auto limb = limbWith(mode, 0.0f);
      limb->materials[0].shownOpaque = true;
      const Arrival shown = arrival(limb, depth);
      EXPECT_EQ(shown.whole.rgba, opaque.whole.rgba);
      EXPECT_EQ(shown.floor.rgba, opaque.floor.rgba);
      limb->materials[0].shownOpaque = false;
      const Arrival hidden = arrival(limb, depth);
      expectAlike(hidden.whole, hidden.floor, "nothing is seen of it");
      EXPECT_GT(darkerBy(opaque.floor, hidden.floor), 2000.0) << "the opaque one casts a shadow";
    }
  }
}

TEST_F(AlphaAndVertexColors, ShadowFollowsTheOpacity) {
  for (const int depth : {1, 3}) {
    const Arrival none = arrival(limbWith(AlphaMode::kBlend, 0.0f), depth);
    double last = 0.0;
    for (const float alpha : {0.25f, 0.5f, 1.0f}) {
      const double dark = darkerBy(arrival(limbWith(AlphaMode::kBlend, alpha), depth).floor, none.floor);
      EXPECT_GT(dark, 1.2 * last) << alpha;
      last = dark;
    }
    // Full alpha is opaque; a cutoff is all or nothing.
    const Arrival opaque = arrival(limbWith(AlphaMode::kOpaque, 1.0f), depth);
    expectAlike(arrival(limbWith(AlphaMode::kBlend, 1.0f), depth).floor, opaque.floor, "blend, alpha 1");
    expectAlike(arrival(limbWith(AlphaMode::kMask, 0.5f), depth).floor, opaque.floor, "mask at its cutoff");
    EXPECT_EQ(arrival(limbWith(AlphaMode::kMask, 0.49f), depth).floor.rgba, none.floor.rgba);
  }
}

// A texture with holes: they appear in picture and shadow. Clay shows no texture, and no holes.
TEST_F(AlphaAndVertexColors, CutOutsAppearInTheShadow) {
  auto limb = limbWith(AlphaMode::kMask, 1.0f);
  Texture half;
  half.width = half.height = 1;
  half.rgba = {255, 255, 255, 0};
  limb->textures = {half};
  auto parts = std::make_shared<Character>(*limb);
  parts->materials.push_back(parts->materials[0]);
  parts->materials[1].baseColorTexture = 0;
  const float middle = boundsOf(parts->mesh.positions).center().x;
  for (ControlTriangle& triangle : parts->mesh.triangles) {
    if (parts->mesh.positions[static_cast<std::size_t>(triangle.vertices[0])].x > middle) triangle.material = 1;
  }
  for (const int depth : {1, 3}) {
    const Arrival whole = arrival(limb, depth), cut = arrival(parts, depth);
    EXPECT_NE(cut.whole.rgba, whole.whole.rgba);
    EXPECT_GT(darkerBy(whole.floor, cut.floor), 500.0);
    EXPECT_EQ(darkerBy(cut.floor, whole.floor), 0.0);
    EXPECT_EQ(arrival(parts, depth, Shading::kClay).whole.rgba, arrival(limb, depth, Shading::kClay).whole.rgba);
  }
}

TEST_F(AlphaAndVertexColors, VertexAlphaAffectsPictureAndShadow) {
  for (const AlphaMode mode : {AlphaMode::kMask, AlphaMode::kBlend}) {
    const auto limb = limbWith(mode, 1.0f);
    for (Wedge& wedge : limb->mesh.wedges) wedge.color.a = 0.0f;
    const Arrival hidden = arrival(limb, 3);
    expectAlike(hidden.whole, arrival(limbWith(AlphaMode::kBlend, 0.0f), 3).whole, "vertex alpha 0");
    limb->materials[0].alphaMode = AlphaMode::kOpaque;
    EXPECT_EQ(arrival(limb, 3).floor.rgba, arrival(limbWith(AlphaMode::kOpaque, 1.0f), 3).floor.rgba);
  }
}

// Unlit, the picture is the product of the three in linear light.
TEST_F(AlphaAndVertexColors, VertexColorsMultiplyTheBaseColor) {
  for (const bool wire : {false, true}) {
    const auto quad = makeQuad();
    quad->materials[0].baseColor = {0.5f, 1.0f, 0.25f, 1.0f};
    quad->materials[0].baseColorTexture = 0;
    Texture texture;
    texture.width = texture.height = 1;
    texture.rgba = {188, 128, 255, 255};
    quad->textures = {texture};
    for (Wedge& wedge : quad->mesh.wedges) wedge.color = {0.6f, 0.3f, 0.9f, 1.0f};
    const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
    DisplaySettings settings = bareColors();
    settings.wire = wire;
    const auto viewport = viewportFor(*quad);
    viewport->draw(sceneOf(*quad, moment), viewOfQuad(), settings);
    const Pixel pixel = pixelAt(viewport->readPixels(), 24, 44);
    EXPECT_NEAR(linearOf(pixel[0]), 0.5f * linearOf(188) * 0.6f, 0.006f);
    EXPECT_NEAR(linearOf(pixel[1]), 1.0f * linearOf(128) * 0.3f, 0.006f);
    EXPECT_NEAR(linearOf(pixel[2]), 0.25f * 1.0f * 0.9f, 0.006f);
    EXPECT_EQ(pixel[3], 255);
  }
}

TEST_F(AlphaAndVertexColors, VertexColorsAreInterpolated) {
  const auto quad = makeQuad();
  for (Wedge& wedge : quad->mesh.wedges) wedge.color.r = wedge.uv.x;  // 0 at the left, 1 at the right.
  for (const int depth : {1, 4}) {
    const Moment moment = bindMoment(quad, depth, PatchKind::kFlat);
    const auto viewport = viewportFor(*quad);
    viewport->draw(sceneOf(*quad, moment), viewOfQuad(), bareColors());
    const Image image = viewport->readPixels();
    const int left = 18, right = 45;
    const float across = static_cast<float>(right - left);
    const float from = linearOf(pixelAt(image, left, 32)[0]), to = linearOf(pixelAt(image, right, 32)[0]);
    EXPECT_GT(to - from, 0.6f);
    for (int x = left; x <= right; ++x) {
      EXPECT_NEAR(linearOf(pixelAt(image, x, 32)[0]), from + (to - from) * static_cast<float>(x - left) / across,
                  0.012f)
          << x << ", depth " << depth;
      EXPECT_EQ(pixelAt(image, x, 32)[1], 255);
    }
  }
}

// Meshes without colors, with colors, without: nothing is kept from the previous one.
TEST_F(AlphaAndVertexColors, NewCharacterHasItsOwnColors) {
  const auto plain = makeQuad(), painted = makeQuad();
  for (Wedge& wedge : painted->mesh.wedges) wedge.color = {1.0f, 0.0f, 0.0f, 1.0f};
  const auto viewport = viewportFor(*plain);
  EXPECT_EQ(pixelAt(drawBare(plain, *viewport, viewOfQuad()), 32, 32), (Pixel{255, 255, 255, 255}));
  viewport->setCharacter(*painted);
  EXPECT_EQ(pixelAt(drawBare(painted, *viewport, viewOfQuad()), 32, 32), (Pixel{255, 0, 0, 255}));
  viewport->setCharacter(*plain);
  EXPECT_EQ(pixelAt(drawBare(plain, *viewport, viewOfQuad()), 32, 32), (Pixel{255, 255, 255, 255}));
}

}  // namespace
}  // namespace sinew::test
