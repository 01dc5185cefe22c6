// tests/viewport/render/marks_test.cpp: outlines, territory and segments appear where they should and nowhere else.

#include <algorithm>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "app/viewport/render/overlay_drawers.h"
#include "app/viewport/render/picking.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::DisplaySettings;
using app::Image;
using app::PrimitiveShape;
using app::Scene;
using app::SceneSegment;
using app::SegmentClass;
using app::View;

constexpr glm::ivec2 kMarkSize{120, 100};

/// Shows only the scene's marks.
DisplaySettings marksAlone() {
  DisplaySettings settings = bareColors();
  settings.surface = false;
  return settings;
}

bool differ(const Image& a, const Image& b, int x, int y) { return pixelAt(a, x, y) != pixelAt(b, x, y); }

PrimitiveShape anyEllipsoid(std::mt19937& random) {
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  PrimitiveShape shape;
  const glm::mat4 at = glm::translate(glm::mat4(1), 0.3f * glm::vec3(any(random), any(random), any(random)));
  const glm::vec3 axis = glm::normalize(glm::vec3(any(random), any(random), 1.2f));
  shape.unitBallInWorld = glm::scale(glm::rotate(at, 3.0f * any(random), axis),
                                     glm::vec3(0.5f + 0.2f * any(random), 0.45f + 0.2f * any(random), 0.5f));
  return shape;
}

/// Whether the ray through a pixel hits the ellipsoid.
bool covers(const PrimitiveShape& shape, const View& view, int x, int y) {
  const auto sight = view.rayThrough({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f});
  return app::crossShell(sight, shape.unitBallInWorld).has_value();
}

/// Covered and uncovered pixels lie within `reach` pixels.
bool nearTheEdge(const PrimitiveShape& shape, const View& view, int x, int y, int reach) {
  const bool here = covers(shape, view, x, y);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if (covers(shape, view, x + dx, y + dy) != here) return true;
    }
  }
  return false;
}

TEST_F(Drawing, OutlineFollowsTheSilhouette) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  std::mt19937 random(4);
  for (int trial = 0; trial < 6; ++trial) {
    Scene scene = sceneOf(*quad, moment);
    scene.primitives = {anyEllipsoid(random)};
    const View view = app::framedView(Bounds{glm::vec3(-1), glm::vec3(1)}, 0.5f * static_cast<float>(trial), 0.3f,
                                      kMarkSize, trial % 2 == 0);
    viewport->draw(scene, view, marksAlone());
    const Image plain = viewport->readPixels();
    scene.primitives[0].selected = true;
    viewport->draw(scene, view, marksAlone());
    const Image marked = viewport->readPixels();
    int changed = 0;
    for (int y = 4; y < kMarkSize.y - 4; ++y) {
      for (int x = 4; x < kMarkSize.x - 4; ++x) {
        const bool shown = differ(plain, marked, x, y);
        changed += shown ? 1 : 0;
        if (shown) {
          EXPECT_TRUE(nearTheEdge(scene.primitives[0], view, x, y, 4)) << x << ' ' << y;
        } else {
          EXPECT_FALSE(nearTheEdge(scene.primitives[0], view, x, y, 1)) << x << ' ' << y;
        }
      }
    }
    EXPECT_GT(changed, 100);
  }
}

/// Whether a pixel lies within `reach` pixels of the edge of what all shapes cover together.
bool nearTheEdgeOfAll(const std::vector<PrimitiveShape>& shapes, const View& view, int x, int y, int reach) {
  const auto covered = [&](int column, int row) {
    return std::ranges::any_of(shapes, [&](const PrimitiveShape& shape) { return covers(shape, view, column, row); });
  };
  const bool here = covered(x, y);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if (covered(x + dx, y + dy) != here) return true;
    }
  }
  return false;
}

TEST_F(Drawing, ASheetIsOutlinedAsAWhole) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  for (const bool parallel : {true, false}) {
    Scene scene = sceneOf(*quad, moment);
    for (const glm::vec3& at :
         {glm::vec3(-0.3f, 0.0f, 0.0f), glm::vec3(0.0f, 0.2f, 0.1f), glm::vec3(0.3f, 0.0f, 0.0f)}) {
      PrimitiveShape& shape = scene.primitives.emplace_back();
      shape.rigIndex = static_cast<int>(scene.primitives.size()) - 1;
      shape.unitBallInWorld = glm::scale(glm::translate(glm::mat4(1), at), glm::vec3(0.4f, 0.3f, 0.2f));
      shape.sheet = 0;
      shape.selected = true;
    }
    const View view = app::framedView(Bounds{glm::vec3(-1), glm::vec3(1)}, 0.4f, 0.3f, kMarkSize, parallel);
    viewport->draw(scene, view, marksAlone());
    const Image marked = viewport->readPixels();
    int shown = 0;
    int missing = 0;
    for (int y = 4; y < kMarkSize.y - 4; ++y) {
      for (int x = 4; x < kMarkSize.x - 4; ++x) {
        if (pixelAt(marked, x, y)[3] > 0) {
          ++shown;
          EXPECT_TRUE(nearTheEdgeOfAll(scene.primitives, view, x, y, 5)) << x << ' ' << y;
        } else if (nearTheEdgeOfAll(scene.primitives, view, x, y, 1)) {
          ++missing;
        }
      }
    }
    EXPECT_GT(shown, 100);
    EXPECT_LT(missing, shown / 10) << "gaps where outlines meet";
  }
}

TEST_F(Drawing, SelectedAreOutlinedAndHoveredOnesFainter) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  Scene scene = sceneOf(*quad, moment);
  for (const float side : {-0.5f, 0.5f}) {
    PrimitiveShape shape;
    shape.unitBallInWorld = glm::scale(glm::translate(glm::mat4(1), glm::vec3(side, 0, 0)), glm::vec3(0.3f));
    scene.primitives.push_back(shape);
  }
  const View view = app::framedView(Bounds{glm::vec3(-1), glm::vec3(1)}, 0, 0, kMarkSize, true);
  const auto strength = [&](bool right) {
    viewport->draw(scene, view, marksAlone());
    const Image image = viewport->readPixels();
    int most = 0;
    for (int y = 0; y < kMarkSize.y; ++y) {
      for (int x = right ? kMarkSize.x / 2 : 0; x < (right ? kMarkSize.x : kMarkSize.x / 2); ++x) {
        most = std::max(most, pixelAt(image, x, y)[3]);
      }
    }
    return most;
  };
  scene.primitives[1].selected = true;
  EXPECT_EQ(strength(false), 0);
  const int selected = strength(true);
  EXPECT_GT(selected, 200);
  scene.primitives[1].selected = false;
  scene.primitives[1].hovered = true;
  EXPECT_EQ(strength(false), 0);
  EXPECT_GT(strength(true), 50);
  EXPECT_LT(strength(true), selected);
}

TEST_F(Drawing, InfluenceIsOutlinedOnTheSkin) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  Scene scene = sceneOf(*quad, moment);
  scene.primitives.emplace_back();
  scene.primitives[0].unitBallInWorld = glm::scale(glm::mat4(1), glm::vec3(0.4f));
  scene.primitives[0].reach = 1.5f;  // Intersects the quad in a circle of radius 0.6.
  const View view = viewOfQuad(0.0f, 128);
  DisplaySettings settings = bareColors();
  viewport->draw(scene, view, settings);
  const Image plain = viewport->readPixels();
  scene.primitives[0].selected = true;
  viewport->draw(scene, view, settings);
  const Image marked = viewport->readPixels();
  const float unit = view.unitsPerPixelAt(glm::vec3(0));
  int onRing = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) {
      const glm::vec2 at = (glm::vec2(x, y) + 0.5f - 64.0f) * unit;
      const float fromRing = std::abs(glm::length(at) - 0.6f) / unit;
      const float fromOutline = std::abs(glm::length(at) - 0.4f) / unit;
      if (fromRing < 0.4f) {
        EXPECT_TRUE(differ(plain, marked, x, y)) << x << ' ' << y;
        ++onRing;
      } else if (fromRing > 2.5f && fromOutline > 4.5f) {
        EXPECT_FALSE(differ(plain, marked, x, y)) << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(onRing, 40);
}

TEST_F(Drawing, TerritoryTintStaysOnItsSkinAndFadesOut) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 3, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  Scene scene = sceneOf(*quad, moment);
  for (const bool lighting : {true, false}) {
    DisplaySettings settings = bareColors();
    settings.lighting = lighting;
    scene.territory.clear();
    viewport->draw(scene, viewOfQuad(), settings);
    const Image plain = viewport->readPixels();
    // The lower right corner, which the upper left triangle does not touch.
    for (const glm::vec3& p : quad->mesh.positions) scene.territory.push_back(p.x > 0.0f && p.y < 0.0f ? 1.0f : 0.0f);
    viewport->draw(scene, viewOfQuad(), settings);
    const Image tinted = viewport->readPixels();
    int before = 1 << 20;
    for (int step = 1; step <= 14; ++step) {  // From the corner to the middle of the picture.
      const Pixel pixel = pixelAt(tinted, 32 + 15 - step, 32 + 15 - step);
      const Pixel was = pixelAt(plain, 32 + 15 - step, 32 + 15 - step);
      const int change = std::abs(pixel[0] - was[0]) + std::abs(pixel[1] - was[1]) + std::abs(pixel[2] - was[2]);
      EXPECT_LE(change, before + 2) << step;
      if (step == 1) {
        EXPECT_GT(change, 60);
      }
      before = change;
    }
    EXPECT_LT(before, 25);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x + y < 62; ++x) EXPECT_FALSE(differ(plain, tinted, x, y)) << x << ' ' << y;
    }
    settings.territory = false;
    viewport->draw(scene, viewOfQuad(), settings);
    EXPECT_EQ(viewport->readPixels().rgba, plain.rgba);
  }
}

TEST_F(Drawing, SegmentsConnectTheirEndsWithOptionalDots) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  Scene scene = sceneOf(*quad, moment);
  const View view = viewOfQuad(0.0f, 128);
  const SceneSegment segment{{-0.7f, 0.3f, 0.4f}, {0.6f, -0.2f, 0.4f}, SegmentClass::kLost};
  const auto colored = [&](const Image& image, const glm::vec3& point) {
    const glm::vec2 pixel(view.toPixel(point));
    return pixelAt(image, static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  };
  const auto draw = [&](const SceneSegment& shown, float scale, bool on) {
    DisplaySettings settings = bareColors();
    settings.lineScale = scale;
    settings.segments = on;
    scene.segments = {shown};
    viewport->draw(scene, view, settings);
    return viewport->readPixels();
  };
  const Image off = draw(segment, 1.0f, false);
  const Image on = draw(segment, 1.0f, true);
  const auto changedPixels = [&](const Image& image) {
    int count = 0;
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) count += differ(off, image, x, y) ? 1 : 0;
    }
    return count;
  };
  for (const float share : {0.0f, 0.25f, 0.5f, 0.8f, 1.0f}) {
    const Pixel pixel = colored(on, glm::mix(segment.from, segment.to, share));
    EXPECT_GT(pixel[0], pixel[2] + 60) << share;
  }
  const float length = glm::distance(glm::vec2(view.toPixel(segment.from)), glm::vec2(view.toPixel(segment.to)));
  EXPECT_GT(changedPixels(on), static_cast<int>(length));
  EXPECT_LT(changedPixels(on), static_cast<int>(4.0f * length));
  EXPECT_GT(changedPixels(draw(segment, 2.0f, true)), 3 * changedPixels(on) / 2);
  // Behind the skin it still shows, fainter.
  SceneSegment behind = segment;
  behind.from.z = behind.to.z = -0.4f;
  const Image hidden = draw(behind, 1.0f, true);
  const Pixel faint = colored(hidden, 0.5f * (behind.from + behind.to));
  EXPECT_LT(faint[2], 250);
  EXPECT_GT(faint[2], colored(on, 0.5f * (segment.from + segment.to))[2] + 20);
  // Every class has its own color.
  const std::array kinds{SegmentClass::kPlain, SegmentClass::kFound, SegmentClass::kFallback, SegmentClass::kLost};
  for (const SegmentClass a : kinds) {
    for (const SegmentClass b : kinds) {
      if (a == b) continue;
      EXPECT_GT(glm::distance(app::segmentColor(a), app::segmentColor(b)), 0.3f);
    }
  }
}

TEST_F(Drawing, TerritoryBonesAreHighlightedWithAHiddenSkeleton) {
  const auto quad = makeQuad();
  const Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  Scene scene = sceneOf(*quad, moment);
  const auto picture = [&](bool skeleton) {
    DisplaySettings settings = marksAlone();
    settings.skeleton = skeleton;
    viewport->draw(scene, viewOfQuad(), settings);
    return viewport->readPixels().rgba;
  };
  const auto hidden = picture(false), shown = picture(true);
  EXPECT_NE(hidden, shown);
  scene.territoryBones = {0};
  EXPECT_NE(picture(true), shown);
  EXPECT_EQ(picture(false), picture(true));  // The only bone belongs to the territory.
}

TEST_F(Drawing, UnlitBaseColorsAreExact) {
  const auto quad = makeQuad();
  for (const int gray : {0, 64, 128, 188, 255}) {
    quad->materials[0].baseColor = glm::vec4(glm::vec3(linearOf(gray)), 1.0f);
    EXPECT_EQ(pixelAt(drawBare(quad, *viewportFor(*quad), viewOfQuad()), 32, 32), (Pixel{gray, gray, gray, 255}));
  }
}

TEST_F(Drawing, SurfaceIsUploadedOnlyWhenItsRevisionChanges) {
  const auto quad = makeQuad();
  Moment moment = bindMoment(quad, 1, PatchKind::kFlat);
  const auto viewport = viewportFor(*quad);
  Scene scene = sceneOf(*quad, moment);
  scene.surfaceRevision = 1;
  const auto picture = [&] {
    viewport->draw(scene, viewOfQuad(), bareColors());
    return viewport->readPixels().rgba;
  };
  const auto first = picture();
  for (glm::vec3& p : moment.surface.positions) p.x += 0.4f;
  EXPECT_EQ(picture(), first);  // An equal version number means unchanged.
  scene.surfaceRevision = 2;
  const auto moved = picture();
  EXPECT_NE(moved, first);
  viewport->setCharacter(*quad);
  for (glm::vec3& p : moment.surface.positions) p.x -= 0.4f;
  EXPECT_EQ(picture(), first);  // The version number does not apply to another character.
}

}  // namespace
}  // namespace sinew::test
