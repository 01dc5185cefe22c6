// tests/viewport/render/materials_test.cpp: pictures of materials match an independent implementation of the
// specification.
#include <functional>

#include "tests/viewport/render/brdf_oracle.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::DisplaySettings;
using app::Image;
using app::LightPreset;
using app::Shading;
using app::View;

const glm::dvec3 kWhiteLight = glm::normalize(glm::dvec3(-0.5, 0.6, 0.8));

/// @param at  u and v of the pixel's middle, 0..1 -> its color
Texture paintedTexture(int side, const std::function<std::array<int, 3>(double, double)>& at) {
  Texture texture;
  texture.width = texture.height = side;
  texture.wrapU = texture.wrapV = TextureWrap::kClampToEdge;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      for (const int channel : at((x + 0.5) / side, (y + 0.5) / side)) {
        texture.rgba.push_back(static_cast<std::uint8_t>(channel));
      }
      texture.rgba.push_back(255);
    }
  }
  return texture;
}

Texture evenTexture(int red, int green, int blue) {
  return paintedTexture(4, [&](double, double) { return std::array{red, green, blue}; });
}

DisplaySettings lit(LightPreset light) {
  DisplaySettings settings = bareColors();
  settings.lighting = true;
  settings.look.light = light;
  return settings;
}

Image drawQuad(const std::shared_ptr<Character>& quad, const DisplaySettings& settings, const View& view = viewOfQuad(),
               int samples = 1) {
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  auto made = app::Viewport::create(samples);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
  if (!made) return {};
  made.value()->setCharacter(*quad);
  made.value()->draw(sceneOf(*quad, moment), view, settings);
  return made.value()->readPixels();
}

/// Color of a pixel of the quad according to the oracle.
glm::dvec3 expectedAt(const OracleMaterial& material, const View& view, int x, int y, const glm::dvec3& n) {
  const app::Ray ray = view.rayThrough(glm::vec2(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f));
  const glm::dvec3 color = appendixB(material, n, -glm::normalize(glm::dvec3(ray.direction)), kWhiteLight);
  return {srgbOf(color.r), srgbOf(color.g), srgbOf(color.b)};
}

void expectNear(const Pixel& pixel, const glm::dvec3& expected, double within, const std::string& what) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(pixel[static_cast<std::size_t>(c)], expected[c], within) << what << ", channel " << c;
  }
}

double meanOff(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
  return sum / static_cast<double>(std::max<std::size_t>(a.rgba.size(), 1));
}

/// Center of the light's reflection: view angles at which the quad mirrors the lamp.
constexpr float kMirrorYaw = 0.5586f, kMirrorPitch = -0.5663f;

TEST_F(Drawing, WhiteLightMatchesGltfAppendixB) {
  const auto quad = makeQuad();
  const glm::dvec3 n(0.0, 0.0, 1.0);
  int bright = 0;
  for (const auto& [yaw, pitch] : {std::pair{0.0f, 0.0f}, {kMirrorYaw, kMirrorPitch}, {1.2f, -0.1f}, {-0.9f, 0.7f}}) {
    const View view =
        app::framedView(Bounds{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}, yaw, pitch, {64, 64}, false, 0.25f);
    for (const double metallic : {0.0, 0.5, 1.0}) {
      for (const double roughness : {0.1, 0.3, 0.6, 1.0}) {
        const OracleMaterial material{{0.7, 0.25, 0.04}, metallic, roughness};
        quad->materials[0].baseColor = glm::vec4(glm::vec3(material.baseColor), 1.0f);
        quad->materials[0].metallic = static_cast<float>(metallic);
        quad->materials[0].roughness = static_cast<float>(roughness);
        const Image image = drawQuad(quad, lit(LightPreset::kWhite), view);
        for (const auto& [x, y] : {std::pair{32, 32}, {30, 34}, {33, 30}}) {
          const glm::dvec3 expected = expectedAt(material, view, x, y, n);
          bright += expected.r > 200 ? 1 : 0;
          // A sharp highlight changes by more than one step within a pixel.
          expectNear(pixelAt(image, x, y), expected, roughness < 0.2 ? 2.0 : 1.0,
                     "metallic " + std::to_string(metallic) + " roughness " + std::to_string(roughness) + " yaw " +
                         std::to_string(yaw));
        }
      }
    }
  }
  EXPECT_GT(bright, 10) << "the highlight was seen";
}

TEST_F(Drawing, BlackShowsOnlyItsHighlight) {
  const auto quad = makeQuad();
  Material& black = quad->materials[0];
  black.baseColor = {0, 0, 0, 1};
  black.roughness = 0.5f;
  const View mirror = app::framedView(Bounds{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}, kMirrorYaw, kMirrorPitch,
                                      {64, 64}, false, 0.25f);
  const int dielectric = pixelAt(drawQuad(quad, lit(LightPreset::kWhite), mirror), 32, 32)[0];
  EXPECT_GT(dielectric, 40);
  EXPECT_LT(pixelAt(drawQuad(quad, lit(LightPreset::kWhite)), 32, 32)[0], dielectric / 2);
  black.metallic = 1.0f;
  const Pixel metal = pixelAt(drawQuad(quad, lit(LightPreset::kWhite), mirror), 32, 32);
  EXPECT_LT(metal[0], dielectric / 2) << "nothing mirrors but its rim";
  expectNear(metal, expectedAt({glm::dvec3(0.0), 1.0, 0.5}, mirror, 32, 32, {0.0, 0.0, 1.0}), 1.0, "black metal");
}

TEST_F(Drawing, ConstantMapEqualsItsFactors) {
  const auto mapped = makeQuad(), plain = makeQuad();
  mapped->textures = {evenTexture(7, 128, 64)};
  mapped->materials[0].metallicRoughnessMap.texture = 0;
  mapped->materials[0].metallic = plain->materials[0].metallic = 0.8f;
  mapped->materials[0].roughness = plain->materials[0].roughness = 0.9f;
  plain->materials[0].metallic *= 64.0f / 255.0f;
  plain->materials[0].roughness *= 128.0f / 255.0f;
  for (const LightPreset light : {LightPreset::kWhite, LightPreset::kStudio}) {
    EXPECT_LE(meanOff(drawQuad(mapped, lit(light)), drawQuad(plain, lit(light))), 0.05);
  }
}

/// One image as color and as data: decoded from sRGB only as color.
TEST_F(Drawing, OneImageCanHoldColorAndData) {
  const auto quad = makeQuad(), apart = makeQuad();
  quad->textures = {evenTexture(90, 140, 200)};
  apart->textures = {evenTexture(90, 140, 200), evenTexture(90, 140, 200), evenTexture(90, 140, 200)};
  for (const auto& character : {quad, apart}) {
    Material& material = character->materials[0];
    const int last = static_cast<int>(character->textures.size()) - 1;
    material.baseColorTexture = 0;
    material.metallic = 0.6f;
    material.metallicRoughnessMap.texture = std::min(1, last);
    material.occlusionMap.texture = std::min(2, last);
  }
  for (const LightPreset light : {LightPreset::kWhite, LightPreset::kStudio}) {
    EXPECT_EQ(drawQuad(quad, lit(light)).rgba, drawQuad(apart, lit(light)).rgba);
  }
}

TEST_F(Drawing, FlatNormalMapChangesNothing) {
  const auto quad = makeQuad();
  const Image without = drawQuad(quad, lit(LightPreset::kWhite));
  quad->textures = {evenTexture(128, 128, 255)};
  quad->materials[0].normalMap.texture = 0;
  EXPECT_LE(meanOff(drawQuad(quad, lit(LightPreset::kWhite)), without), 0.6) << "128 is not quite the middle";
}

TEST_F(Drawing, NormalMapsFollowTheTextureAxes) {
  const glm::dvec3 texel(170.0 / 127.5 - 1.0, 160.0 / 127.5 - 1.0, 220.0 / 127.5 - 1.0);
  const OracleMaterial material{{0.6, 0.6, 0.6}, 0.0, 0.6};
  const auto expectTurned = [&](const std::shared_ptr<Character>& quad, const glm::dvec3& n, const std::string& what,
                                const View& view = viewOfQuad()) {
    quad->textures = {evenTexture(170, 160, 220)};
    quad->materials[0].baseColor = {0.6f, 0.6f, 0.6f, 1.0f};
    quad->materials[0].roughness = 0.6f;
    quad->materials[0].normalMap.texture = 0;
    const Image image = drawQuad(quad, lit(LightPreset::kWhite), view);
    expectNear(pixelAt(image, 32, 32), expectedAt(material, view, 32, 32, glm::normalize(n)), 1.0, what);
  };
  // The quad's u runs along x, its v down.
  expectTurned(makeQuad(), texel, "upright");
  auto quad = makeQuad();
  quad->materials[0].normalScale = 0.4f;
  expectTurned(quad, texel * glm::dvec3(0.4, 0.4, 1.0), "scaled");
  quad = makeQuad();
  for (Wedge& wedge : quad->mesh.wedges) wedge.uv.x = 1.0f - wedge.uv.x;
  expectTurned(quad, texel * glm::dvec3(-1.0, 1.0, 1.0), "mirrored");
  quad = makeQuad();
  for (Wedge& wedge : quad->mesh.wedges) wedge.uv = {wedge.uv.y, 1.0f - wedge.uv.x};
  expectTurned(quad, {texel.y, -texel.x, texel.z}, "turned: u goes down, v to the left");
  quad = makeQuad();
  for (Wedge& wedge : quad->mesh.wedges) wedge.uv *= glm::vec2(7.0f, 0.01f);
  expectTurned(quad, texel, "stretched");
  quad = makeQuad();
  for (Wedge& wedge : quad->mesh.wedges) wedge.uv.x += 0.5f * wedge.uv.y;
  expectTurned(quad, texel, "slanted: the axes are square");
  for (const glm::vec2& kept : {glm::vec2(0.0f), glm::vec2(1.0f, 0.0f), glm::vec2(0.0f, 1.0f)}) {
    quad = makeQuad();
    for (Wedge& wedge : quad->mesh.wedges) wedge.uv *= kept;
    expectTurned(quad, {0.0, 0.0, 1.0}, "without an area the map has no direction");
  }
  quad = makeQuad();
  quad->materials[0].doubleSided = true;
  const double size = glm::length(texel);
  // Seen from behind, relief is inverted. The lamp is in front: rotate the quad instead.
  for (glm::vec3& position : quad->mesh.positions) position *= glm::vec3(-1.0f, 1.0f, -1.0f);
  for (glm::vec3& normal : quad->mesh.normals) normal = -normal;
  for (Wedge& wedge : quad->mesh.wedges) wedge.normal = -wedge.normal;
  expectTurned(quad, glm::dvec3(texel.x, -texel.y, texel.z) / size, "from behind");
}

TEST_F(Drawing, ClayHasReliefOnlyIfEnabled) {
  const auto quad = makeQuad();
  DisplaySettings clay = lit(LightPreset::kStudio);
  clay.shading = Shading::kClay;
  const Image plain = drawQuad(quad, clay);
  quad->textures = {evenTexture(170, 160, 220)};
  quad->materials[0].normalMap.texture = 0;
  quad->materials[0].metallicRoughnessMap.texture = 0;
  quad->materials[0].emissiveMap.texture = 0;
  quad->materials[0].emissive = glm::vec3(1.0f);
  EXPECT_EQ(drawQuad(quad, clay).rgba, plain.rgba);
  clay.relief = true;
  EXPECT_NE(drawQuad(quad, clay).rgba, plain.rgba);
  quad->textures = {evenTexture(128, 128, 255)};
  EXPECT_LE(meanOff(drawQuad(quad, clay), plain), 0.6);
}

TEST_F(Drawing, OcclusionMapDimsOnlyAmbientLight) {
  const auto quad = makeQuad();
  const Image white = drawQuad(quad, lit(LightPreset::kWhite)), studio = drawQuad(quad, lit(LightPreset::kStudio));
  quad->textures = {evenTexture(51, 255, 255)};
  quad->materials[0].occlusionMap.texture = 0;
  EXPECT_EQ(drawQuad(quad, lit(LightPreset::kWhite)).rgba, white.rgba) << "a lamp's light arrives whole";
  const int open = pixelAt(studio, 32, 32)[1];
  const int dark = pixelAt(drawQuad(quad, lit(LightPreset::kStudio)), 32, 32)[1];
  quad->materials[0].occlusionStrength = 0.5f;
  const int half = pixelAt(drawQuad(quad, lit(LightPreset::kStudio)), 32, 32)[1];
  quad->materials[0].occlusionStrength = 0.0f;
  const int none = pixelAt(drawQuad(quad, lit(LightPreset::kStudio)), 32, 32)[1];
  EXPECT_LT(dark + 3, half);
  EXPECT_LT(half + 3, open);
  EXPECT_EQ(none, open);
}

TEST_F(Drawing, EmissionIsAdded) {
  const auto quad = makeQuad();
  quad->materials[0].baseColor = {0.2f, 0.2f, 0.2f, 1.0f};
  const Pixel without = pixelAt(drawQuad(quad, lit(LightPreset::kWhite)), 32, 32);
  quad->textures = {evenTexture(188, 255, 0)};
  quad->materials[0].emissive = {0.5f, 0.25f, 1.0f};
  quad->materials[0].emissiveMap.texture = 0;
  const Pixel with = pixelAt(drawQuad(quad, lit(LightPreset::kWhite)), 32, 32);
  const std::array<double, 3> added{0.5 * static_cast<double>(linearOf(188)), 0.25, 0.0};
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(with[c], srgbOf(static_cast<double>(linearOf(without[c])) + added[c]), 1.5);
  }
}

TEST_F(Drawing, UnlitShowsTheBaseColorInAnyLight) {
  const auto quad = makeQuad();
  quad->textures = {evenTexture(200, 90, 31)};
  quad->materials[0].baseColorTexture = 0;
  quad->materials[0].unlit = true;
  quad->materials[0].normalMap.texture = quad->materials[0].emissiveMap.texture = 0;
  for (const LightPreset light :
       {LightPreset::kWhite, LightPreset::kStudio, LightPreset::kOutdoor, LightPreset::kRim}) {
    EXPECT_EQ(pixelAt(drawQuad(quad, lit(light)), 32, 32), (Pixel{200, 90, 31, 255}));
  }
}

TEST_F(Drawing, TextureTransformEqualsTransformedCoordinates) {
  const auto spots = [](double u, double v) {
    return std::array{static_cast<int>(255 * u), static_cast<int>(255 * v), u > 0.5 ? 255 : 0};
  };
  const std::array<glm::vec3, 2> place{{{0.3f, 0.5f, 0.1f}, {-0.4f, 0.2f, 0.6f}}};
  const auto placed = makeQuad(), moved = makeQuad();
  for (Wedge& wedge : moved->mesh.wedges) {
    wedge.uv = {glm::dot(place[0], glm::vec3(wedge.uv, 1.0f)), glm::dot(place[1], glm::vec3(wedge.uv, 1.0f))};
  }
  for (TextureMap Material::*map :
       {&Material::metallicRoughnessMap, &Material::occlusionMap, &Material::emissiveMap, &Material::normalMap}) {
    for (const auto& quad : {placed, moved}) {
      quad->textures = {paintedTexture(64, spots)};
      quad->materials[0] = {};
      quad->materials[0].metallic = 1.0f;
      quad->materials[0].emissive = glm::vec3(0.3f);
      (quad->materials[0].*map).texture = 0;
    }
    (placed->materials[0].*map).place = place;
    const Image one = drawQuad(placed, lit(LightPreset::kStudio)), other = drawQuad(moved, lit(LightPreset::kStudio));
    EXPECT_LE(meanOff(one, other), 0.05);
    placed->materials[0].*map = {.texture = 0};
    EXPECT_GT(meanOff(drawQuad(placed, lit(LightPreset::kStudio)), other), 0.3) << "the place counts";
  }
}

/// Alpha comes from the base color alone, whatever other maps a masked or blended material has.
TEST_F(Drawing, MapsDoNotAffectAlphaModes) {
  const auto quad = makeQuad();
  Texture holes = paintedTexture(64, [](double, double) { return std::array{255, 255, 255}; });
  for (std::size_t i = 0; i < 64 * 64; ++i) holes.rgba[4 * i + 3] = i % 64 < 32 ? 102 : 255;
  quad->textures = {holes, evenTexture(200, 128, 255)};
  Material& material = quad->materials[0];
  material.baseColorTexture = 0;
  material.normalMap.texture = material.metallicRoughnessMap.texture = material.emissiveMap.texture = 1;
  const auto alphas = [&](AlphaMode mode, float cutoff) {
    material.alphaMode = mode;
    material.alphaCutoff = cutoff;
    const Image image = drawQuad(quad, lit(LightPreset::kStudio));
    return std::pair{pixelAt(image, 22, 32)[3], pixelAt(image, 42, 32)[3]};
  };
  EXPECT_EQ(alphas(AlphaMode::kOpaque, 0.5f), std::pair(255, 255));
  EXPECT_EQ(alphas(AlphaMode::kMask, 0.5f), std::pair(0, 255));
  EXPECT_EQ(alphas(AlphaMode::kMask, 0.3f), std::pair(255, 255));
  const auto blended = alphas(AlphaMode::kBlend, 0.5f);
  EXPECT_NEAR(blended.first, 102, 1);
  EXPECT_EQ(blended.second, 255);
}

}  // namespace
}  // namespace sinew::test
