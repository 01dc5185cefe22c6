// tests/viewport/render/picking_test.cpp: picking agrees with the picture and with geometry.
#include "app/viewport/render/picking.h"

#include <optional>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/silhouette.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/oracle/shape.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::Image;
using app::PrimitiveShape;
using app::Ray;
using app::View;

/// A copy in which every control triangle has its own color: triangle t is drawn as t + 1 in base 40.
std::shared_ptr<Character> numbered(const Character& original) {
  auto character = std::make_shared<Character>(original);
  character->materials.clear();
  for (std::size_t t = 0; t < character->mesh.triangles.size(); ++t) {
    const int number = static_cast<int>(t) + 1;
    Material material;
    material.baseColor = {linearOf(6 * (number % 40)), linearOf(6 * (number / 40 % 40)), linearOf(6 * (number / 1600)),
                          1};
    character->materials.push_back(material);
    character->mesh.triangles[t].material = static_cast<int>(t);
  }
  return character;
}

/// Control triangle at a pixel, or -1.
int triangleShown(const Image& image, int x, int y) {
  const Pixel pixel = pixelAt(image, x, y);
  const auto digit = [](int value) { return (value + 3) / 6; };
  return pixel[3] == 0 ? -1 : digit(pixel[0]) + 40 * digit(pixel[1]) + 1600 * digit(pixel[2]) - 1;
}

TEST_F(Drawing, PickingAgreesWithThePictureAtEveryPixel) {
  const auto character = numbered(*makeTwoLegged());
  const Moment moment = bindMoment(character, 3);
  const auto viewport = viewportFor(*character);
  for (const bool orthographic : {false, true}) {
    const View view = app::framedView(boundsOf(moment.surface.positions), 0.7f, 0.4f, {150, 150}, orthographic);
    viewport->draw(sceneOf(*character, moment), view, bareColors());
    const Image image = viewport->readPixels();
    int checked = 0, hits = 0;
    for (int y = 1; y < 149; ++y) {
      for (int x = 1; x < 149; ++x) {
        const int shown = triangleShown(image, x, y);
        bool inside = true;  // Away from edges, where rounding may choose either side.
        for (int near = 0; near < 9; ++near)
          inside = inside && triangleShown(image, x + near % 3 - 1, y + near / 3 - 1) == shown;
        if (!inside) continue;
        const Ray ray = view.rayThrough({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
        const auto hit = app::pickSurface(ray, moment.surface, character->mesh, character->materials);
        ASSERT_EQ(hit ? hit->controlTriangle : -1, shown) << x << ' ' << y;
        ++checked;
        if (!hit) continue;
        ++hits;
        EXPECT_LT(glm::distance(glm::vec2(view.toPixel(hit->position)), glm::vec2(x, y) + 0.5f), 0.05f);
      }
    }
    EXPECT_GT(checked, 8000);
    EXPECT_GT(hits, 500);
  }
}

TEST(PickSurface, BarycentricsReproduceTheHit) {
  const auto character = makeTwoLegged();
  const Moment moment = bindMoment(character, 4, PatchKind::kFlat);
  const View view = app::framedView(boundsOf(moment.surface.positions), 0.5f, 0.2f, {200, 200}, false);
  int hits = 0;
  for (int i = 0; i < 40 * 40; ++i) {
    const Ray ray = view.rayThrough(5.0f * glm::vec2(i % 40, i / 40) + 0.37f);
    const auto hit = app::pickSurface(ray, moment.surface, character->mesh, character->materials);
    if (!hit) continue;
    ++hits;
    const auto& refined = moment.surface.refinement->triangles[static_cast<std::size_t>(hit->refinedTriangle)];
    const auto& control = character->mesh.triangles[static_cast<std::size_t>(hit->controlTriangle)].vertices;
    glm::vec3 onRefined(0.0f), onControl(0.0f);
    for (int corner = 0; corner < 3; ++corner) {
      const auto c = static_cast<std::size_t>(corner);
      onRefined += hit->barycentric[corner] * moment.surface.positions[static_cast<std::size_t>(refined[c])];
      onControl += hit->controlBarycentric[corner] * character->mesh.positions[static_cast<std::size_t>(control[c])];
    }
    EXPECT_LT(glm::distance(onRefined, hit->position), 1e-4f);
    EXPECT_LT(glm::distance(onControl, hit->position), 1e-4f);  // Flat patches: the surface is the control mesh.
    EXPECT_LT(glm::dot(hit->normal, ray.direction), 0.3f);
    EXPECT_NEAR(glm::length(hit->normal), 1.0f, 1e-4f);
  }
  EXPECT_GT(hits, 100);
}

TEST(PickSurface, BackSidesAreHitOnlyOnDoubleSidedMaterials) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 2, PatchKind::kFlat);
  const Ray ahead{{0.1f, 0.2f, 5}, {0, 0, -1}}, behind{{0.1f, 0.2f, -5}, {0, 0, 1}}, away{{0.1f, 0.2f, 5}, {0, 0, 1}};
  EXPECT_TRUE(app::pickSurface(ahead, moment.surface, quad->mesh, quad->materials));
  EXPECT_FALSE(app::pickSurface(behind, moment.surface, quad->mesh, quad->materials));
  EXPECT_FALSE(app::pickSurface(away, moment.surface, quad->mesh, quad->materials));
  quad->materials[0].doubleSided = true;
  EXPECT_TRUE(app::pickSurface(behind, moment.surface, quad->mesh, quad->materials));
}

TEST(CrossShell, MatchesASearchAlongTheRay) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  constexpr float kStep = 0.002f;
  int hits = 0;
  for (int trial = 0; trial < 1200; ++trial) {
    const glm::vec3 axis = glm::normalize(glm::vec3(any(random), any(random), 1.1f));
    glm::mat4 shell = glm::translate(glm::mat4(1), glm::vec3(any(random), any(random), any(random)));
    shell = glm::rotate(shell, 3.0f * any(random), axis);
    shell = glm::scale(shell, glm::vec3(0.6f + 0.4f * any(random), 0.4f, 0.7f + 0.5f * any(random)));
    const glm::vec3 origin = 6.0f * glm::normalize(glm::vec3(any(random), any(random), 1.2f));
    const Ray ray{origin, glm::normalize(glm::vec3(any(random), any(random), any(random)) - origin)};
    const glm::mat4 toBall = glm::inverse(shell);
    std::optional<float> enter;
    float leave = 0.0f;
    for (float t = 0.0f; t < 12.0f; t += kStep) {
      if (glm::length(glm::vec3(toBall * glm::vec4(ray.origin + t * ray.direction, 1))) > 1.0f) continue;
      if (!enter) enter = t;
      leave = t;
    }
    const auto span = app::crossShell(ray, shell);
    if (!enter) {
      EXPECT_TRUE(!span || span->leave - span->enter < kStep);  // At most a touch between two steps of the search.
      continue;
    }
    ++hits;
    ASSERT_TRUE(span);
    EXPECT_NEAR(span->enter, *enter, 1.5f * kStep);
    EXPECT_NEAR(span->leave, leave, 1.5f * kStep);
  }
  EXPECT_GT(hits, 100);
}

TEST(CrossShell, MatchesASearchAlongTheRayThroughShapes) {
  Random random(6);
  constexpr float kStep = 0.004f;
  int hits = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const glm::mat4 shell = glm::scale(glm::mat4_cast(random.rotation()), {0.4f, 1.0f, 0.5f});
    const Shape shape = randomShape(random, 1.5f);
    const glm::vec3 origin = random.rotation() * glm::vec3(0, 0, 5);
    const Ray ray{origin, glm::normalize(0.6f * (random.rotation() * glm::vec3(0, 1, 0)) - origin)};
    const glm::mat4 toShape = glm::inverse(shell);
    std::optional<float> enter;
    for (float t = 0.0f; t < 10.0f && !enter; t += kStep) {
      const glm::vec3 p(toShape * glm::vec4(ray.origin + t * ray.direction, 1));
      if (oracle::rho(shape, oracle::vec(p)) < 1.0) enter = t;
    }
    const auto span = app::crossShell(ray, shell, shape);
    if (!enter) {
      EXPECT_TRUE(!span || span->leave - span->enter < kStep);
      continue;
    }
    ++hits;
    ASSERT_TRUE(span);
    if (span->leave - span->enter > kStep) {
      EXPECT_NEAR(span->enter, *enter, 1.5f * kStep);
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(Silhouette, LiesOnTheShapeAndEnclosesIt) {
  Random random(7);
  app::View view;
  view.eyeInWorld = {0.3f, 0.5f, 6.0f};
  int checked = 0;
  for (int trial = 0; trial < 60; ++trial) {
    app::PrimitiveShape shape;
    shape.unitBallInWorld = glm::scale(glm::mat4_cast(random.rotation()), {0.4f, 1.0f, 0.5f});
    shape.shape = randomShape(random, 1.5f);
    if (shape.shape.isPlain()) continue;
    const Silhouette line = silhouetteOf(shape.shape, shape.unitBallInWorld, view.eyeInWorld, false);
    const glm::mat4 toShape = glm::inverse(shape.unitBallInWorld);
    const glm::vec3 eye(toShape * glm::vec4(view.eyeInWorld, 1));
    const UnitShape unit = unitShape(shape.shape, 1.0f);
    for (const glm::vec3& point : line) {
      const glm::vec3 p(toShape * glm::vec4(point, 1));
      EXPECT_NEAR(oracle::rho(shape.shape, oracle::vec(p)), 1.0, 0.05);
      const float across = glm::dot(glm::normalize(unit.rSquaredSlope(p)), glm::normalize(eye - p));
      EXPECT_NEAR(across, 0.0f, 0.3f) << "chords of a coarse grid";
      ++checked;
    }
  }
  EXPECT_GT(checked, 1000);
}

TEST(CrossShell, HandlesFlatDistantAndBehindShapes) {
  const glm::mat4 ball(1);
  EXPECT_FALSE(app::crossShell({{0, 5, 0}, {0, -1, 0}}, glm::scale(ball, glm::vec3(1, 0, 1))));
  EXPECT_FALSE(app::crossShell({{0, 5, 0}, {0, 1, 0}}, ball));
  const auto inside = app::crossShell({{0, 0.5f, 0}, {0, 1, 0}}, ball);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->enter, 0.0f);
  const Ray fromAfar{{0.9f, 0, 1e5f}, {0, 0, -1}};  // Distant origins must not miss.
  const auto far = app::crossShell(fromAfar, ball);
  ASSERT_TRUE(far);
  EXPECT_NEAR((fromAfar.origin + far->enter * fromAfar.direction).z, std::sqrt(1.0f - 0.81f), 0.02f);
}

TEST(PickBone, FindsTheBoneUnderThePixel) {
  const auto body = makeTwoLegged();
  const Pose pose = bindPose(body->skeleton);
  const View view = app::framedView(boundsOf(body->mesh.positions), 0.3f, 0.1f, {400, 400}, false);
  for (const BoneSegment& segment : boneSegments(body->skeleton, pose)) {
    const glm::vec3 middle = view.toPixel(glm::mix(segment.head, segment.tail, 0.5f));
    const auto hit = app::pickBone(glm::vec2(middle) + glm::vec2(1, 0), view, body->skeleton, pose, 4.0f);
    ASSERT_TRUE(hit);
    EXPECT_EQ(body->skeleton.bones[static_cast<std::size_t>(hit->bone)].name,
              body->skeleton.bones[static_cast<std::size_t>(segment.bone)].name);
    EXPECT_LE(hit->pixels, 1.5f);
  }
  for (std::size_t i = 0; i < body->skeleton.bones.size(); ++i) {  // At a joint: the bone that starts there.
    const auto hit =
        app::pickBone(glm::vec2(view.toPixel(glm::vec3(pose.boneInWorld[i][3]))), view, body->skeleton, pose, 4.0f);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->bone, static_cast<int>(i));
  }
  EXPECT_FALSE(app::pickBone({3, 3}, view, body->skeleton, pose, 4.0f));
}

}  // namespace
}  // namespace sinew::test
