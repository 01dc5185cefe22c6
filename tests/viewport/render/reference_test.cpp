// tests/viewport/render/reference_test.cpp: reference pictures stand where they should, and hide no more than they
// should.

#include "app/viewport/render/reference_picture.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/viewport/render/picture_files.h"
#include "core/files/disk/atomic_file.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::Image;
using app::ReferencePicture;
using app::ReferencePlane;
using app::ReferenceSide;
using app::View;

/// Red at the top left, green at the top right, blue at the bottom left, white at the bottom right.
std::shared_ptr<const Image> corners(int width = 8, int height = 8) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int quarter = (2 * x >= width ? 1 : 0) + (2 * y >= height ? 2 : 0);
      const std::array<std::array<int, 3>, 4> colors{{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}}};
      for (const int value : colors[static_cast<std::size_t>(quarter)]) {
        image.rgba.push_back(static_cast<std::uint8_t>(value));
      }
      image.rgba.push_back(255);
    }
  }
  return std::make_shared<const Image>(std::move(image));
}

ReferencePicture pictureOf(std::shared_ptr<const Image> pixels) {
  ReferencePicture picture;
  picture.file = "/picture.png";
  picture.pixels = std::move(pixels);
  picture.opacity = 1.0f;
  return picture;
}

struct Look {
  ReferenceSide side;
  float yaw, pitch;
};
constexpr float kQuarter = 1.57079633f;
constexpr std::array<Look, 5> kLooks{{{ReferenceSide::kFront, 0.0f, 0.0f},
                                      {ReferenceSide::kBack, 2.0f * kQuarter, 0.0f},
                                      {ReferenceSide::kLeft, kQuarter, 0.0f},
                                      {ReferenceSide::kRight, -kQuarter, 0.0f},
                                      {ReferenceSide::kTop, 0.0f, kQuarter}}};

// Orthographic, from its side, the body's rectangle in the picture gives the expected place.
TEST(ReferencePicture, MatchesTheBodySeenFromItsSide) {
  Random random(5);
  for (int round = 0; round < 50; ++round) {
    const Bounds body{glm::vec3(-random.uniform(0.2f, 1.0f), random.uniform(-0.5f, 0.5f), -random.uniform(0.2f, 1.0f)),
                      glm::vec3(random.uniform(0.2f, 1.0f), random.uniform(0.8f, 2.0f), random.uniform(0.2f, 1.0f))};
    const float height = random.uniform(0.5f, 2.0f);
    for (const Look& look : kLooks) {
      ReferencePicture picture = pictureOf(corners(6, 3));
      picture.inside = random.chance(0.5f);
      picture.scale = random.uniform(0.5f, 2.0f);
      picture.offset = {random.uniform(-0.3f, 0.3f), random.uniform(-0.3f, 0.3f)};
      const ReferencePlane plane = app::referencePlane(look.side, picture, body, height);
      const View view = app::framedView(body, look.yaw, look.pitch, {1000, 1000}, true);
      const float pixels = 1.0f / view.unitsPerPixelAt(body.center());
      glm::vec2 low(1e9f), high(-1e9f);
      for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) ? body.low.x : body.high.x, (corner & 2) ? body.low.y : body.high.y,
                              (corner & 4) ? body.low.z : body.high.z);
        low = glm::min(low, glm::vec2(view.toPixel(point)));
        high = glm::max(high, glm::vec2(view.toPixel(point)));
      }
      const auto at = [&](float x, float y) {
        return glm::vec2(view.toPixel(glm::vec3(plane.squareInWorld * glm::vec4(x, y, 0.0f, 1.0f))));
      };
      const glm::vec2 topLeft = at(-0.5f, 0.5f), bottomRight = at(0.5f, -0.5f);
      const float tall = picture.scale * (high.y - low.y);
      EXPECT_NEAR(bottomRight.y - topLeft.y, tall, 0.01f * tall);
      EXPECT_NEAR(bottomRight.x - topLeft.x, 2.0f * tall, 0.02f * tall);
      const glm::vec2 moved = height * pixels * glm::vec2(picture.offset.x, -picture.offset.y);
      EXPECT_NEAR(0.5f * (topLeft.x + bottomRight.x), 0.5f * (low.x + high.x) + moved.x, 0.5f);
      if (look.side == ReferenceSide::kTop) {
        EXPECT_NEAR(0.5f * (topLeft.y + bottomRight.y), 0.5f * (low.y + high.y) + moved.y, 0.5f);
      } else {
        EXPECT_NEAR(bottomRight.y, high.y + moved.y, 0.5f) << "it stands on the floor";
      }
      const glm::vec3 normal(plane.squareInWorld[2]);
      EXPECT_NEAR(glm::dot(normal, -view.forwardInWorld()), 1.0f, 1e-5f);
      // Behind: no corner of the body is beyond it. Through the middle: half of them are.
      int beyond = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 point((corner & 1) ? body.low.x : body.high.x, (corner & 2) ? body.low.y : body.high.y,
                              (corner & 4) ? body.low.z : body.high.z);
        beyond += glm::dot(normal, point - glm::vec3(plane.squareInWorld[3])) < 0.0f ? 1 : 0;
      }
      EXPECT_EQ(beyond, picture.inside ? 4 : 0);
    }
  }
}

/// The quad with a picture twice as high behind it.
app::Scene sceneWith(const Character& character, const Moment& moment, ReferencePicture picture) {
  app::Scene scene = sceneOf(character, moment);
  picture.scale = 2.0f;
  picture.offset.y = -0.5f;
  const Bounds body = boundsOf(character.mesh.positions);
  scene.references = {app::referencePlane(ReferenceSide::kFront, picture, body, character.height)};
  return scene;
}

TEST_F(Drawing, ReferenceStandsUprightBehindTheBodyWithExactColors) {
  const auto quad = makeQuad();
  const auto viewport = viewportFor(*quad);
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const View view = app::framedView(Bounds{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)}, 0, 0, {64, 64}, true, 0.25f);
  viewport->draw(sceneWith(*quad, moment, pictureOf(corners())), view, bareColors());
  const Image image = viewport->readPixels();
  EXPECT_EQ(pixelAt(image, 8, 8), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(pixelAt(image, 55, 8), (Pixel{0, 255, 0, 255}));
  EXPECT_EQ(pixelAt(image, 8, 55), (Pixel{0, 0, 255, 255}));
  EXPECT_EQ(pixelAt(image, 55, 55), (Pixel{255, 255, 255, 255}));
  viewport->draw(sceneOf(*quad, moment), view, bareColors());
  const Image without = viewport->readPixels();
  EXPECT_EQ(pixelAt(image, 32, 30), pixelAt(without, 32, 30)) << "the body stands before it";
  EXPECT_EQ(pixelAt(without, 8, 8)[3], 0) << "and leaves nothing behind";
}

TEST_F(Drawing, ReferenceIsVisibleFromTheFrontWithItsOpacity) {
  const auto quad = makeQuad();
  const auto viewport = viewportFor(*quad);
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const Bounds box{glm::vec3(-1, -1, 0), glm::vec3(1, 1, 0)};
  ReferencePicture picture = pictureOf(corners());
  viewport->draw(sceneWith(*quad, moment, picture), app::framedView(box, 3.14159265f, 0, {64, 64}, true, 0.25f),
                 bareColors());
  EXPECT_EQ(pixelAt(viewport->readPixels(), 8, 8)[3], 0) << "from behind";
  picture.opacity = 0.25f;
  viewport->draw(sceneWith(*quad, moment, picture), app::framedView(box, 0, 0, {64, 64}, true, 0.25f), bareColors());
  EXPECT_NEAR(pixelAt(viewport->readPixels(), 8, 8)[3], 64, 1);
  EXPECT_NEAR(pixelAt(viewport->readPixels(), 8, 8)[0], 255, 1);
}

TEST_F(Drawing, ReferenceThroughTheBodyHidesOnlyTheFarHalf) {
  const auto quad = makeQuad();
  const auto viewport = viewportFor(*quad);
  Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const View view = app::framedView(Bounds{glm::vec3(-1, -1, -1), glm::vec3(1, 1, 1)}, 0, 0, {64, 64}, true, 0.25f);
  ReferencePicture picture = pictureOf(corners());
  picture.inside = true;
  const Bounds body{glm::vec3(-1, -1, -1), glm::vec3(1, 1, 0)};
  const auto colorAt = [&](float z) {
    for (glm::vec3& position : moment.surface.positions) position.z = z;
    app::Scene scene = sceneOf(*quad, moment);
    scene.references = {app::referencePlane(ReferenceSide::kFront, picture, body, 2.0f)};
    viewport->draw(scene, view, bareColors());
    return pixelAt(viewport->readPixels(), 24, 24);
  };
  EXPECT_NE(colorAt(0.0f), (Pixel{255, 0, 0, 255})) << "before the picture";
  EXPECT_EQ(colorAt(-0.9f), (Pixel{255, 0, 0, 255})) << "behind it";
}

TEST(ReferencePicture, IsReadWithinLimits) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "picture.png";
  ASSERT_TRUE(writeFileAtomically(file, app::pngBytes(*corners(6, 3)).value()));
  const Result<Image> read = app::readReference(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->rgba, corners(6, 3)->rgba);
  ASSERT_TRUE(writeFileAtomically(file, app::pngBytes(*corners(8000, 4)).value()));
  const Result<Image> large = app::readReference(file);
  ASSERT_TRUE(large);
  EXPECT_EQ(large->width, 4000);
  EXPECT_EQ(large->height, 2);
  EXPECT_EQ(large->rgba.size(), 4u * 4000u * 2u);
  EXPECT_EQ(large->rgba[0], 255);
  EXPECT_EQ(large->rgba[1], 0);
  ASSERT_TRUE(writeFileAtomically(file, app::pngBytes(*corners(9000, 2)).value()));
  EXPECT_FALSE(app::readReference(file)) << "wider than a texture may be";
  ASSERT_TRUE(writeFileAtomically(file, "\x89PNG\r\n\x1a\n and no more"));
  const Result<Image> damaged = app::readReference(file);
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().file, file.string());
  EXPECT_EQ(damaged.error().text().find('\n'), std::string::npos);
  EXPECT_FALSE(app::readReference(folder.path() / "missing.png"));
  EXPECT_FALSE(app::readReference(folder.path()));
}

TEST(ReferencePicture, RoundTripsThroughTheViewFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "side.png";
  ASSERT_TRUE(writeFileAtomically(file, app::pngBytes(*corners()).value()));
  app::ReferencePictures pictures;
  ReferencePicture& side = pictures[2];
  side = pictureOf(corners());
  side.file = file;
  side.shown = false;
  side.inside = true;
  side.opacity = 0.25f;
  side.scale = 1.5f;
  side.offset = {-0.5f, 0.125f};
  pictures[4] = pictureOf(nullptr);
  pictures[4].file = folder.path() / "gone.png";
  std::vector<Error> missing;
  const app::ReferencePictures back = app::referencesFromJson(app::referencesToJson(pictures), missing);
  ASSERT_TRUE(back[2].pixels);
  EXPECT_EQ(back[2].pixels->rgba, corners()->rgba);
  EXPECT_EQ(std::tie(back[2].file, back[2].shown, back[2].inside, back[2].opacity, back[2].scale, back[2].offset),
            std::tie(side.file, side.shown, side.inside, side.opacity, side.scale, side.offset));
  EXPECT_EQ(missing.size(), 1u);
  EXPECT_EQ(back[4].file, pictures[4].file) << "it may be there the next time";
  EXPECT_FALSE(back[4].pixels);
  EXPECT_TRUE(back[0].file.empty());
}

TEST(ReferencePicture, InvalidValuesBecomeDefaults) {
  for (const char* text :
       {"null", "7", "[7, null, {}]", "[{\"side\": \"inside\", \"file\": \"/x.png\"}]",
        "[{\"side\": \"front\", \"file\": \"x.png\"}]", "[{\"side\": \"front\", \"file\": 7, \"offset\": [1]}]"}) {
    std::vector<Error> missing;
    const app::ReferencePictures read = app::referencesFromJson(Json::parse(text).value(), missing);
    for (const ReferencePicture& picture : read) EXPECT_TRUE(picture.file.empty()) << text;
    EXPECT_TRUE(missing.empty()) << text;
  }
  std::vector<Error> missing;
  const app::ReferencePictures read = app::referencesFromJson(
      Json::parse("[{\"side\": \"front\", \"file\": \"/nothing/x.png\", \"opacity\": 7, \"scale\": -1, "
                  "\"offset\": [\"a\", 1e9]}]")
          .value(),
      missing);
  EXPECT_EQ(read[0].opacity, ReferencePicture{}.opacity);
  EXPECT_EQ(read[0].scale, 1.0f);
  EXPECT_EQ(read[0].offset, glm::vec2(0.0f));
}

}  // namespace
}  // namespace sinew::test
