// tests/viewport/render/seen_triangles_test.cpp: no triangle that covers a pixel's center is culled, and most others
// are.

#include "app/viewport/render/fewer_triangles.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <optional>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/characters/stand_ins.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

using app::SeenTriangles;
using app::View;
using Corners = SeenTriangles::Corners;

/// Small triangles in front of, around and behind a camera. Drawn vertices are numbered backwards.
struct Soup {
  Refinement refinement;
  std::vector<glm::vec3> positions;
  std::vector<int> order;
};

Soup makeSoup(std::mt19937& random, int triangles, float size) {
  std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
  const auto point = [&](float scale) {
    return scale * glm::vec3(anywhere(random), anywhere(random), anywhere(random));
  };
  Soup soup;
  const auto last = static_cast<std::uint32_t>(3 * triangles - 1);
  for (int t = 0; t < triangles; ++t) {
    const glm::vec3 center = point(1.0f);
    for (int c = 0; c < 3; ++c) soup.positions.push_back(center + point(size));
    soup.refinement.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    const auto first = last - static_cast<std::uint32_t>(3 * t);
    soup.refinement.drawTriangles.push_back({first, first - 1, first - 2});
  }
  soup.order.resize(soup.refinement.triangles.size());
  std::iota(soup.order.begin(), soup.order.end(), 0);
  std::ranges::shuffle(soup.order, random);
  return soup;
}

/// Corners in pixels in double precision, y up as for OpenGL's winding; none if one is not in front of the eye.
std::optional<std::array<glm::dvec2, 3>> pixelsOf(const Soup& soup, const View& view, int triangle) {
  const glm::dmat4 clipFromWorld = glm::dmat4(view.clipFromView) * glm::dmat4(view.viewFromWorld);
  std::array<glm::dvec2, 3> pixels;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto vertex = static_cast<std::size_t>(soup.refinement.triangles[static_cast<std::size_t>(triangle)][c]);
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(soup.positions[vertex], 1.0);
    if (clip.w <= 0.0) return std::nullopt;
    pixels[c] = (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * glm::dvec2(view.size);
  }
  return pixels;
}

/// Whether a pixel's center is inside, corners counter-clockwise.
bool coversCenter(const std::array<glm::dvec2, 3>& p, const glm::ivec2& size) {
  const auto side = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& at) {
    return (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
  };
  const glm::dvec2 least = glm::max(glm::floor(glm::min(p[0], glm::min(p[1], p[2]))), glm::dvec2(0.0));
  const glm::dvec2 most = glm::min(glm::ceil(glm::max(p[0], glm::max(p[1], p[2]))), glm::dvec2(size));
  for (double y = least.y + 0.5; y < most.y; ++y) {
    for (double x = least.x + 0.5; x < most.x; ++x) {
      const glm::dvec2 at(x, y);
      if (side(p[0], p[1], at) > 0.0 && side(p[1], p[2], at) > 0.0 && side(p[2], p[0], at) > 0.0) return true;
    }
  }
  return false;
}

/// Counts of triangles.
struct Counts {
  int all = 0;
  int kept = 0;
  int covering = 0;
};

/// The first third of the triangles is two-sided.
void compare(const Soup& soup, const View& view, SeenTriangles& seen, Counts& counts) {
  const auto count = static_cast<int>(soup.order.size());
  const int bothSides = count / 3;
  const std::array<SeenTriangles::Range, 2> ranges{{{4, 0, bothSides}, {2, bothSides, count - bothSides}}};
  const std::array<std::uint8_t, 2> keepsBacks{1, 0};
  seen.find({soup.refinement, soup.positions, soup.order, ranges, keepsBacks}, view.clipFromWorld(), view.size);
  const auto [first, second] = std::array{seen.ranges()[0], seen.ranges()[1]};
  EXPECT_EQ(first.material, 4);
  EXPECT_EQ(second.firstTriangle, first.triangles);
  EXPECT_EQ(seen.triangles().size(), static_cast<std::size_t>(first.triangles + second.triangles));
  std::size_t next = 0;
  for (int i = 0; i < count; ++i) {
    const int triangle = soup.order[static_cast<std::size_t>(i)];
    const bool kept = next < seen.triangles().size() &&
                      seen.triangles()[next] == soup.refinement.drawTriangles[static_cast<std::size_t>(triangle)];
    next += kept ? 1 : 0;
    const auto pixels = pixelsOf(soup, view, triangle);
    bool covers = !pixels;  // Triangles behind the eye, or partly, are left to OpenGL.
    if (pixels) {
      const std::array turned{(*pixels)[0], (*pixels)[2], (*pixels)[1]};
      covers = coversCenter(*pixels, view.size) || (i < bothSides && coversCenter(turned, view.size));
    }
    if (covers) {
      EXPECT_TRUE(kept) << triangle;
    }
    counts.covering += covers ? 1 : 0;
  }
  EXPECT_EQ(next, seen.triangles().size()) << "One that is not drawn, or out of order.";
  counts.all += count;
  counts.kept += static_cast<int>(seen.triangles().size());
}

TEST(SeenTriangles, ContainEveryTriangleThatCoversAPixelCenter) {
  std::mt19937 random(20010315);
  SeenTriangles seen;
  Counts counts;
  for (const float size : {0.004f, 0.03f}) {
    const Soup soup = makeSoup(random, 30'000, size);
    for (const bool orthographic : {false, true}) {
      for (const float reach : {1.0f, 0.1f}) {  // The second camera is inside the soup.
        const Bounds framed{glm::vec3(-reach), glm::vec3(reach)};
        compare(soup, app::framedView(framed, 0.7f, 0.3f, {131, 97}, orthographic), seen, counts);
      }
    }
  }
  std::printf("%d cover a pixel's center or reach behind the eye, %d are kept, of %d\n", counts.covering, counts.kept,
              counts.all);
  EXPECT_GT(counts.covering, 5'000);
  EXPECT_LT(counts.kept, 3 * counts.covering);
}

/// Whether one triangle is kept in a picture of 8 x 8 pixels.
bool isKept(const std::array<glm::vec3, 3>& corners, const glm::mat4& clipFromWorld) {
  Refinement refinement;
  refinement.triangles = {{0, 1, 2}};
  refinement.drawTriangles = {{0, 1, 2}};
  const std::array order{0};
  const std::array<SeenTriangles::Range, 1> ranges{{{0, 0, 1}}};
  const std::array<std::uint8_t, 1> keepsBacks{0};
  SeenTriangles seen;
  seen.find({refinement, corners, order, ranges, keepsBacks}, clipFromWorld, {8, 8});
  return !seen.triangles().empty();
}

/// Corners in pixels, from the lower left.
std::array<glm::vec3, 3> inPixels(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
  const auto device = [](const glm::vec2& p) { return glm::vec3(p / 4.0f - 1.0f, 0.0f); };
  return {device(a), device(b), device(c)};
}

TEST(SeenTriangles, KeepTrianglesWithinRoundingOfAPixelCenter) {
  const glm::mat4 flat(1.0f);
  for (const float sign : {-1.0f, 1.0f}) {  // Next to the center at 3.5, on either side, horizontal and vertical.
    const auto beside = [&](float off, bool upright) {
      const float near = 3.5f + sign * off;
      const float far = 3.5f + sign * (off + 0.3f);
      const auto place = [&](float x, float y) { return upright ? glm::vec2(y, x) : glm::vec2(x, y); };
      const bool turned = upright != (sign < 0.0f);
      const auto a = place(near, 3.0f), b = place(far, 3.0f), c = place(near, 4.0f);
      return isKept(turned ? inPixels(a, c, b) : inPixels(a, b, c), flat);
    };
    for (const bool upright : {false, true}) {
      EXPECT_TRUE(beside(-0.01f, upright));
      EXPECT_TRUE(beside(1.0f / 32.0f, upright)) << sign;
      EXPECT_FALSE(beside(1.0f / 8.0f, upright)) << sign;
    }
  }
  // Back-facing: nearly edge-on, and clearly.
  EXPECT_TRUE(isKept(inPixels({1.0f, 2.4f}, {6.0f, 2.6f}, {6.0f, 2.55f}), flat));
  EXPECT_FALSE(isKept(inPixels({1.0f, 2.0f}, {6.0f, 3.6f}, {6.0f, 1.0f}), flat));
}

TEST(SeenTriangles, KeepTrianglesAtTheNearPlaneAndBeyondFloatPrecision) {
  Bounds bounds;
  bounds.add(glm::vec3(-1.0f));
  bounds.add(glm::vec3(1.0f));
  const View view = app::framedView(bounds, 0.0f, 0.0f, {8, 8}, false);
  const glm::vec3 aside = 10.0f * view.forwardInWorld() + glm::vec3(0.0f, 400.0f, 0.0f);  // Above the picture.
  const std::array<glm::vec3, 3> above{aside, aside + glm::vec3(1.0f, 0.0f, 0.0f), aside + glm::vec3(0.0f, 1.0f, 0.0f)};
  EXPECT_FALSE(isKept(above, view.clipFromWorld()));
  const float near = view.clipFromView[3][2] / (view.clipFromView[2][2] - 1.0f);
  std::array<glm::vec3, 3> before = above;  // One corner between eye and near plane, above the picture too.
  before[0] = view.eyeInWorld + near * (0.5f * view.forwardInWorld() + glm::vec3(0.0f, 1.0f, 0.0f));
  EXPECT_TRUE(isKept(before, view.clipFromWorld()));
  const glm::mat4 moved = view.clipFromWorld() * glm::translate(glm::mat4(1.0f), glm::vec3(-1e6f, 0.0f, 0.0f));
  std::array<glm::vec3, 3> far = above;
  for (glm::vec3& corner : far) corner.x += 1e6f;
  EXPECT_TRUE(isKept(far, moved));
}

TEST_F(Drawing, SkippingUnseenTrianglesIsPixelIdentical) {
  const auto character = fineHumanoid();
  const Moment moment = bindMoment(character, 1);
  const Bounds bounds = boundsOf(moment.surface.positions);
  const auto moving = viewportFor(*character), plain = viewportFor(*character);
  for (const bool orthographic : {false, true}) {
    for (const float share : {1.0f, 0.05f}) {
      const glm::vec3 half = 0.5f * share * bounds.extent();
      for (const glm::ivec2 size : {glm::ivec2(40, 50), glm::ivec2(300, 200)}) {
        const View view =
            app::framedView({bounds.center() - half, bounds.center() + half}, 2.1f, 0.2f, size, orthographic);
        app::DisplaySettings settings;
        settings.wire = size.x > 100;
        moving->draw(sceneOf(*character, moment), view, settings, 1.0f);
        plain->draw(sceneOf(*character, moment), view, settings);
        EXPECT_EQ(moving->readPixels().rgba, plain->readPixels().rgba) << orthographic << share << size.x;
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
