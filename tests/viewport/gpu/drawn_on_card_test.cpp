// tests/viewport/gpu/drawn_on_card_test.cpp: pictures of the GPU's surface, and the verbs that use it.

#include "app/viewport/gpu/drawn_on_card.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "app/ui/data_files.h"
#include "core/files/json/json.h"
#include "tests/command/program.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/viewport/render/pictures.h"

namespace sinew::test {
namespace {

/// Fraction of the pixels that differ by more than 2 of 255.
double differing(const app::Image& a, const app::Image& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    bool differs = false;
    for (std::size_t c = i; c < i + 4; ++c) differs = differs || std::abs(int{a.rgba[c]} - int{b.rgba[c]}) > 2;
    count += differs ? 1 : 0;
  }
  return static_cast<double>(4 * count) / static_cast<double>(a.rgba.size());
}

TEST_F(Drawing, GpuAndProcessorSurfacesLookAlike) {
  for (const char* name : {"demo", "wrapped"}) {
    const TrialScene scene = bundledTrialScene(name);
    Moment moment{spreadPoses(*scene.character, 2).back(), {}};
    Smoother smoother(scene.character);
    ASSERT_TRUE(smoother.prepare(scene.rig).ok());
    smoother.smooth(moment.pose, moment.surface);
    const auto viewport = viewportFor(*scene.character);
    const app::View view = app::framedView(boundsOf(moment.surface.positions), 0.6f, 0.2f, {320, 240}, false);
    app::Scene shown = sceneOf(*scene.character, moment);
    viewport->draw(shown, view, {});
    const app::Image expected = viewport->readPixels();

    auto card = app::DrawnOnCard::create(scene.character, scene.rig);
    ASSERT_TRUE(card.ok()) << card.error().text();
    ASSERT_FALSE(card.value()->make(moment.pose).has_value());
    const Bounds& holds = card.value()->vertices().bounds;
    for (const glm::vec3& p : moment.surface.positions) {
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(p, holds.low)) && glm::all(glm::lessThanEqual(p, holds.high)));
    }
    viewport->setCardVertices(card.value()->vertices());
    shown.surface = &card.value()->surface();
    viewport->draw(shown, view, {});
    EXPECT_LE(differing(viewport->readPixels(), expected), 0.005) << name;

    // And back.
    viewport->setCardVertices(std::nullopt);
    shown.surface = &moment.surface;
    viewport->draw(shown, view, {});
    EXPECT_EQ(viewport->readPixels().rgba, expected.rgba) << name;
  }
}

class GpuVerbs : public Program {};

std::string textOf(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(GpuVerbs, RenderUsesTheGpuOrGivesTheReason) {
  const std::string rig = app::dataFile("assets/demo.rig.json").string();
  const Outcome drawn = run({"render", rig, "--on", "gpu", "--size", "64x48", "-o", "a.png"});
  EXPECT_EQ(drawn.status, 0) << drawn.error;
  EXPECT_EQ(drawn.error.find("computed by the processor"), std::string::npos) << drawn.error;

  const Outcome left = run({"render", rig, "--on", "gpu", "--crease", "10", "--size", "64x48", "-o", "b.png"});
  EXPECT_EQ(left.status, 0) << left.error;
  EXPECT_NE(left.error.find("the surface is computed by the processor: the surface has creases"), std::string::npos)
      << left.error;
}

TEST_F(GpuVerbs, BenchReportsBothAndTheDifference) {
  const std::string rig = app::dataFile("assets/demo.rig.json").string();
  const Outcome told = run({"bench", "gpu", rig, "--frames", "2", "--crowd", "3"});
  ASSERT_EQ(told.status, 0) << told.error;
  for (const char* part : {"card: ", "3 bodies", "processor", "skin", "patch", "project", "folds", "normals", "drawn",
                           "roots", "bytes per vertex", "flipped triangles"}) {
    EXPECT_NE(told.out.find(part), std::string::npos) << part << "\n" << told.out;
  }
  const Outcome json = run({"bench", "gpu", rig, "--frames", "2", "--json"});
  ASSERT_EQ(json.status, 0) << json.error;
  const auto parsed = Json::parse(json.out);
  ASSERT_TRUE(parsed.ok()) << "JSON alone on stdout";
  const std::vector<Json> scenes = parsed->at("scenes").items();
  ASSERT_FALSE(scenes.empty());
  EXPECT_EQ(scenes[0].at("bodies").number(0), 1.0);
  EXPECT_GT(scenes[0].at("card_seconds").at("total").number(0), 0.0);
  EXPECT_LE(scenes[0].at("difference").at("surface_of_height").number(1), 1e-4);
  // A rig that the GPU does not support.
  std::string text = textOf(rig);
  const std::string patch = "\"patch\": \"pn\"";
  ASSERT_NE(text.find(patch), std::string::npos);
  text.replace(text.find(patch), patch.size(), patch + ", \"crease_angle\": 10");
  const std::string character = "\"character\": \"demo.glb\"";
  ASSERT_NE(text.find(character), std::string::npos);
  text.replace(text.find(character), character.size(),
               "\"character\": \"" + app::dataFile("assets/demo.glb").string() + '"');
  const TemporaryFolder folder;
  const Outcome refused = run({"bench", "gpu", folder.write("demo.rig.json", text).string()});
  EXPECT_EQ(refused.status, 1);
  EXPECT_TRUE(refused.oneErrorLine()) << refused.error;
  EXPECT_NE(refused.error.find("not computed on the card: the surface has creases"), std::string::npos)
      << refused.error;
  EXPECT_EQ(run({"bench", "--crowd", "3"}).status, 2);
}

}  // namespace
}  // namespace sinew::test
