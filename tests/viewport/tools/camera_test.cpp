// tests/viewport/tools/camera_test.cpp: camera invariants under any input.

#include "app/viewport/tools/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/rigs/random_rigs.h"

namespace sinew::app {
namespace {

using test::Random;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr glm::ivec2 kPicture{1000, 700};

Camera randomCamera(Random& random) {
  Camera camera;
  camera.characterHeight = random.chance(0.5f) ? 1.8f : 155.0f;
  const float h = camera.characterHeight;
  setScene(camera, {glm::vec3(-0.4f * h, 0.0f, -0.6f * h), glm::vec3(0.4f * h, h, 0.6f * h)}, h);
  camera.orthographic = random.chance(0.5f);
  camera.stand = {h * glm::vec3(random.uniform(-1, 1), random.uniform(0, 1), random.uniform(-1, 1)),
                  h * random.uniform(0.5f, 5.0f), random.uniform(-3.0f, 3.0f), random.uniform(-1.5f, 1.5f)};
  camera.stand.aim = 0.5f * glm::vec2(std::sin(9.0f * camera.stand.yaw), std::cos(7.0f * camera.stand.pitch));
  return camera;
}

glm::vec2 pixelOf(const Camera& camera, const glm::vec3& point) {
  return glm::vec2(viewOf(camera, kPicture).toPixel(point));
}

glm::vec2 pixelOfAim(const Camera& camera) {
  return 0.5f * glm::vec2(kPicture) * (1.0f + glm::vec2(1.0f, -1.0f) * camera.stand.aim);
}

/// Bounds of the box's corners in the picture: low x and y, high x and y, 0..1.
glm::vec4 placeOf(const Camera& camera, const Bounds& box) {
  glm::vec2 low(2.0f), high(-1.0f);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 point((corner & 1) ? box.low.x : box.high.x, (corner & 2) ? box.low.y : box.high.y,
                          (corner & 4) ? box.low.z : box.high.z);
    const glm::vec2 pixel = pixelOf(camera, point) / glm::vec2(kPicture);
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  return {low, high};
}

TEST(Camera, ZoomKeepsThePointUnderThePointer) {
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    Camera camera = randomCamera(random);
    const glm::vec2 pixel(random.uniform(50, 950), random.uniform(50, 650));
    const Ray ray = viewOf(camera, kPicture).rayThrough(pixel);
    const float depth = glm::length(camera.stand.target - ray.origin) * random.uniform(0.8f, 1.2f);
    const glm::vec3 point = ray.origin + depth * ray.direction;
    zoomToward(camera, random.uniform(-4, 4), pixel, kPicture, point);
    EXPECT_LT(glm::length(pixelOf(camera, point) - pixel), 0.1f) << i;
  }
}

TEST(Camera, ZoomWithoutAPointKeepsTheTargetPlane) {
  Random random(12);
  for (int i = 0; i < 100; ++i) {
    Camera camera = randomCamera(random);
    const glm::vec2 pixel(random.uniform(50, 950), random.uniform(50, 650));
    const View view = viewOf(camera, kPicture);
    const Ray ray = view.rayThrough(pixel);
    const glm::vec3 forward = view.forwardInWorld();
    const float depth = glm::dot(camera.stand.target - ray.origin, forward) / glm::dot(ray.direction, forward);
    const glm::vec3 point = ray.origin + depth * ray.direction;
    zoomToward(camera, 3.0f, pixel, kPicture, std::nullopt);
    EXPECT_LT(glm::length(pixelOf(camera, point) - pixel), 0.1f) << i;
  }
}

TEST(Camera, ZoomStopsAtItsLimitsAndStillKeepsThePoint) {
  Random random(13);
  Camera camera = randomCamera(random);
  for (int i = 0; i < 200; ++i) zoomToward(camera, 5.0f, {500, 350}, kPicture, camera.stand.target);
  EXPECT_FLOAT_EQ(camera.stand.distance, kNearestView * camera.characterHeight);
  for (int i = 0; i < 200; ++i) zoomToward(camera, -5.0f, {500, 350}, kPicture, camera.stand.target);
  EXPECT_FLOAT_EQ(camera.stand.distance, kFarthestView * camera.characterHeight);
}

TEST(Camera, PanKeepsTheTargetUnderThePointer) {
  Random random(14);
  for (int i = 0; i < 100; ++i) {
    Camera camera = randomCamera(random);
    const glm::vec3 grabbed = camera.stand.target;
    const glm::vec2 drag(random.uniform(-200, 200), random.uniform(-200, 200));
    const glm::vec2 before = pixelOf(camera, grabbed);
    pan(camera, drag, kPicture);
    EXPECT_LT(glm::length(pixelOf(camera, grabbed) - (before + drag)), 0.1f) << i;
  }
}

TEST(Camera, OrbitKeepsTheTargetAndNeverFlips) {
  Random random(15);
  Camera camera = randomCamera(random);
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 target = camera.stand.target;
    orbit(camera, {random.uniform(-300, 300), random.uniform(-600, 600)}, kPicture);
    const View view = viewOf(camera, kPicture);
    EXPECT_EQ(camera.stand.target, target);
    EXPECT_LT(glm::length(glm::vec2(view.toPixel(target)) - pixelOfAim(camera)), 0.05f);
    // World up never points down in the picture.
    EXPECT_GE(view.viewFromWorld[1][1], -1e-6f);
    EXPECT_LE(std::abs(camera.stand.pitch), 0.5f * kPi);
  }
}

TEST(Camera, OrbitTurnsTheSceneWithThePointer) {
  Camera camera;
  camera.stand = {glm::vec3(0.0f), 4.0f, 0.0f, 0.0f};
  const glm::vec3 nose(0.0f, 0.0f, 0.3f);  // Towards the eye.
  const glm::vec2 before = pixelOf(camera, nose);
  orbit(camera, {40, 30}, kPicture);
  EXPECT_GT(pixelOf(camera, nose).x, before.x + 1.0f);
  EXPECT_GT(pixelOf(camera, nose).y, before.y + 1.0f);
}

TEST(Camera, FramingIsTight) {
  Random random(16);
  for (int i = 0; i < 300; ++i) {
    Camera camera = randomCamera(random);
    const float h = camera.characterHeight;
    Bounds box;
    for (int k = 0; k < 2; ++k) {
      box.add(h * glm::vec3(random.uniform(-1, 1), random.uniform(0, 1), random.uniform(-1, 1)));
    }
    frameBounds(camera, box, kPicture, false);
    const View view = viewOf(camera, kPicture);
    glm::vec2 largest(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 point((corner & 1) ? box.low.x : box.high.x, (corner & 2) ? box.low.y : box.high.y,
                            (corner & 4) ? box.low.z : box.high.z);
      const glm::vec3 pixel = view.toPixel(point);
      EXPECT_TRUE(pixel.x >= 0 && pixel.x <= 1000 && pixel.y >= 0 && pixel.y <= 700) << i;
      EXPECT_LE(std::abs(pixel.z), 1.0f);
      largest = glm::max(largest, glm::abs(glm::vec2(pixel) / glm::vec2(kPicture) - 0.5f));
    }
    if (glm::length(box.extent()) > 0.3f * h) {
      EXPECT_GT(std::max(largest.x, largest.y), 0.3f) << "wastes the picture";
    }
  }
}

// Covered areas lie at the edges, like bars and lists, so that a part is free.
TEST(Camera, FramingAvoidsCoveredAreas) {
  Random random(18);
  for (int i = 0; i < 200; ++i) {
    Camera camera = randomCamera(random);
    const float h = camera.characterHeight;
    const Bounds box{h * glm::vec3(-random.uniform(0.1f, 1.0f), 0.0f, -random.uniform(0.1f, 1.0f)),
                     h * glm::vec3(random.uniform(0.1f, 1.0f), random.uniform(0.2f, 1.0f), 0.3f)};
    const std::vector<glm::vec4> covered{{0.0f, 0.0f, random.uniform(0.2f, 1.0f), random.uniform(0.05f, 0.3f)},
                                         {0.0f, 0.2f, random.uniform(0.05f, 0.3f), random.uniform(0.3f, 1.2f)},
                                         {random.uniform(0.7f, 0.95f), 0.1f, 1.0f, random.uniform(0.2f, 0.9f)}};
    frameBounds(camera, box, kPicture, false, covered);
    const glm::vec4 place = placeOf(camera, box);
    for (const glm::vec4& over : covered) {
      EXPECT_FALSE(place.x < over.z && over.x < place.z && place.y < over.w && over.y < place.w) << i;
    }
    EXPECT_TRUE(place.x >= 0.0f && place.y >= 0.0f && place.z <= 1.0f && place.w <= 1.0f) << i;
    EXPECT_EQ(camera.stand.target, box.center());
    // No free part shows it larger: compared with every one on a coarse grid.
    Camera other = camera;
    for (int cell = 0; cell < 10 * 10 * 10 * 10; ++cell) {
      const glm::vec4 part = 0.1f * glm::vec4(cell % 10, cell / 10 % 10, 1 + cell / 100 % 10, 1 + cell / 1000);
      if (part.z - part.x < kLeastPart || part.w - part.y < kLeastPart) continue;
      const auto lies = [&](const glm::vec4& over) {
        return part.x < over.z && over.x < part.z && part.y < over.w && over.y < part.w;
      };
      if (std::ranges::any_of(covered, lies)) continue;
      const std::vector<glm::vec4> rest{{0.0f, 0.0f, part.x, 1.0f},
                                        {part.z, 0.0f, 1.0f, 1.0f},
                                        {0.0f, 0.0f, 1.0f, part.y},
                                        {0.0f, part.w, 1.0f, 1.0f}};
      frameBounds(other, box, kPicture, false, rest);
      ASSERT_GE(other.stand.distance, camera.stand.distance * 0.999f / kAlmostAsLarge) << i << ", part " << cell;
    }
  }
}

TEST(Camera, FramingIgnoresAPanelThatLeavesNoRoomButAvoidsBars) {
  Camera camera;
  const glm::vec4 bar(0.0f, 0.0f, 1.0f, 0.2f);
  const std::vector<glm::vec4> covered{bar, {0.1f, 0.3f, 0.95f, 0.9f}};
  frameBounds(camera, camera.scene, kPicture, false, covered);
  EXPECT_GT(placeOf(camera, camera.scene).y, bar.w);
  Camera beside = camera;
  frameBounds(beside, camera.scene, kPicture, false, {&bar, 1});
  EXPECT_EQ(camera.stand.distance, beside.stand.distance);
}

TEST(Camera, FullyCoveredPictureIsFramedAsAWhole) {
  Camera camera;
  camera.stand.aim = {0.3f, 0.2f};
  const std::vector<glm::vec4> covered{{0.1f, 0.1f, 0.95f, 0.9f}};
  frameBounds(camera, camera.scene, kPicture, false, covered);
  EXPECT_EQ(camera.stand.aim, glm::vec2(0.0f));
}

TEST(Camera, FramingAPointKeepsADistance) {
  Camera camera;
  frameBounds(camera, {glm::vec3(1.0f), glm::vec3(1.0f)}, kPicture, false);
  EXPECT_GT(camera.stand.distance, 0.05f * camera.characterHeight);
  const CameraStand before = camera.stand;
  frameBounds(camera, Bounds{}, kPicture, false);
  EXPECT_EQ(camera.stand.distance, before.distance);
  EXPECT_EQ(camera.stand.target, before.target);
}

TEST(Camera, TransitionsMoveEvenlyToTheirEnd) {
  Random random(17);
  for (int i = 0; i < 50; ++i) {
    Camera camera = randomCamera(random);
    Camera direct = camera;
    const Bounds box{glm::vec3(-0.1f) * camera.characterHeight, glm::vec3(0.2f) * camera.characterHeight};
    frameBounds(direct, box, kPicture, false);
    const float start = glm::length(camera.stand.target - direct.stand.target);
    frameBounds(camera, box, kPicture, true);
    float before = start;
    int frames = 0;
    while (advance(camera, 0.016f)) {
      const float left = glm::length(camera.stand.target - direct.stand.target);
      EXPECT_LE(left, before * 1.0001f);
      before = left;
      ASSERT_LT(++frames, 20);
    }
    EXPECT_GE(frames, 5);
    EXPECT_EQ(camera.stand.target, direct.stand.target);
    EXPECT_EQ(camera.stand.distance, direct.stand.distance);
    EXPECT_EQ(camera.stand.aim, direct.stand.aim);
  }
}

TEST(Camera, InputEndsATransition) {
  Camera camera;
  showStandardView(camera, StandardView::kBack);
  EXPECT_TRUE(advance(camera, 0.05f));
  orbit(camera, {5, 0}, kPicture);
  EXPECT_FALSE(isMoving(camera));
}

TEST(Camera, StandardViewsLookAlongTheirAxes) {
  const std::array<std::pair<StandardView, glm::vec3>, 6> expected = {{{StandardView::kFront, {0, 0, -1}},
                                                                       {StandardView::kBack, {0, 0, 1}},
                                                                       {StandardView::kLeft, {-1, 0, 0}},
                                                                       {StandardView::kRight, {1, 0, 0}},
                                                                       {StandardView::kTop, {0, -1, 0}},
                                                                       {StandardView::kBottom, {0, 1, 0}}}};
  for (const auto& [which, forward] : expected) {
    Camera camera;
    showStandardView(camera, which);
    advance(camera, 1.0f);
    const View view = viewOf(camera, kPicture);
    EXPECT_LT(glm::length(view.forwardInWorld() - forward), 1e-5f);
    EXPECT_TRUE(isFinite(view.clipFromWorld()));
  }
}

TEST(Camera, TransitionRotatesTheShortWay) {
  Camera camera;
  camera.stand.yaw = -3.0f;
  showStandardView(camera, StandardView::kBack);  // Yaw pi, 0.14 away from -3.
  advance(camera, 0.075f);
  EXPECT_GT(std::abs(camera.stand.yaw), 2.9f);
}

TEST(Camera, DepthResolvesSmallAndLargeCharacters) {
  for (const float height : {0.02f, 1.8f, 155.0f}) {
    Camera camera;
    setScene(camera, {height * glm::vec3(-0.4f, 0.0f, -0.4f), height * glm::vec3(0.4f, 1.0f, 0.4f)}, height);
    frameBounds(camera, camera.scene, kPicture, false);
    const View view = viewOf(camera, kPicture);
    const glm::vec3 forward = view.forwardInWorld();
    const float near = view.toPixel(camera.stand.target).z;
    const float far = view.toPixel(camera.stand.target + 1e-3f * height * forward).z;
    // A thousandth of H is many steps of a 24-bit depth buffer.
    EXPECT_GT((far - near) * 0.5f * 16777216.0f, 50.0f) << height;
  }
}

}  // namespace
}  // namespace sinew::app
