// tests/viewport/tools/sheet_tool_test.cpp: two strokes on the skin add a sheet.

#include "app/viewport/tools/sheet_tool.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "app/document/listed_muscles.h"
#include "app/viewport/tools/sheet_stroke.h"
#include "core/bodies/sheets/lay_sheet.h"
#include "core/rig/validation.h"
#include "tests/viewport/tools/sheet_scene.h"

namespace sinew::app {
namespace {

using test::LimbScene;

/// The limb or two legs, with the tool chosen.
struct Drawing : LimbScene {
  explicit Drawing(std::shared_ptr<const Character> character = test::makeLimb()) : LimbScene(std::move(character)) {
    prepareMirror(document);
    setTool(tools, ToolKind::kSheet);
  }
  RouteResult stroke(const glm::vec2& from, const glm::vec2& to) {
    move(from);
    press(from);
    for (int i = 1; i <= 6; ++i) drag(glm::mix(from, to, static_cast<float>(i) / 6.0f));
    return release(to);
  }
  [[nodiscard]] glm::vec2 pixelAt(const glm::vec3& point) const {
    return glm::vec2(viewOf(tools.camera, kSize).toPixel(point));
  }
  RouteResult escape(const glm::vec2& pixel, bool down) {
    ViewportInput input;
    input.keysPressed = {Key::kEscape};
    return down ? drag(pixel, MouseButton::kLeft, input) : frame(input);
  }
};

constexpr glm::vec2 kLowLeft{-70, 160};
constexpr glm::vec2 kLowRight{70, 160};
constexpr glm::vec2 kHighLeft{-60, -160};
constexpr glm::vec2 kHighRight{60, -160};

TEST(SheetTool, TwoStrokesAddASheetInOneStep) {
  Drawing scene;
  const glm::vec2 middle = scene.skinPixel();
  EXPECT_TRUE(scene.move(middle).status.starts_with("Sheet, first stroke")) << scene.move(middle).status;
  scene.stroke(middle + kLowLeft, middle + kLowRight);
  EXPECT_EQ(scene.document.commands.position(), 0u) << "the origin alone is no change";
  ASSERT_TRUE(scene.tools.sheet.origin);
  EXPECT_GE(scene.tools.sheet.origin->points.size(), 2u);
  EXPECT_TRUE(scene.move(middle).status.starts_with("Sheet, second stroke"));
  scene.stroke(middle + kHighLeft, middle + kHighRight);
  ASSERT_EQ(scene.document.rig().sheets.size(), 1u);
  EXPECT_TRUE(validate(scene.document.rig()));
  EXPECT_EQ(scene.document.commands.position(), 1u);
  const MuscleSheet& sheet = scene.document.rig().sheets[0];
  EXPECT_EQ(scene.document.commands.label(1), "Add " + sheet.name);
  EXPECT_EQ(scene.document.rig().primitives.size(), static_cast<std::size_t>(sheet.strips * sheet.bellies));
  EXPECT_EQ(scene.document.selection.primitives.size(), scene.document.rig().primitives.size());
  EXPECT_FALSE(scene.tools.sheet.origin) << "ready for the next";
  EXPECT_EQ(sheet.edges.front().points.front().bone, "root");
  EXPECT_EQ(sheet.edges.back().points.front().bone, "end");
  EXPECT_TRUE(sheet.line) << "from bone to bone it flexes";
  scene.smooth();
  EXPECT_GT(*std::ranges::max_element(scene.surface.displacement), 0.003f * scene.document.character->height);
}

TEST(SheetTool, StripsDoNotCrossWhicheverWayTheStrokesAreDrawn) {
  std::vector<Rig> rigs;
  for (const bool reversed : {false, true}) {
    Drawing scene;
    const glm::vec2 middle = scene.skinPixel();
    scene.stroke(middle + kLowLeft, middle + kLowRight);
    if (reversed) scene.stroke(middle + kHighRight, middle + kHighLeft);
    else scene.stroke(middle + kHighLeft, middle + kHighRight);
    ASSERT_EQ(scene.document.rig().sheets.size(), 1u);
    const MuscleSheet& sheet = scene.document.rig().sheets[0];
    const auto x = [&](const LineAnchor& anchor) {
      const int bone = *scene.document.character->skeleton.findBone(anchor.bone);
      return glm::vec3(scene.pose.boneInWorld[static_cast<std::size_t>(bone)] * glm::vec4(anchor.point, 1.0f)).x;
    };
    const float origin = x(sheet.edges[0].points.back()) - x(sheet.edges[0].points.front());
    const float insertion = x(sheet.edges[1].points.back()) - x(sheet.edges[1].points.front());
    EXPECT_GT(origin * insertion, 0.0f);
  }
}

TEST(SheetTool, EscDropsTheStrokeAndTheOriginIsKept) {
  Drawing scene;
  const glm::vec2 middle = scene.skinPixel();
  scene.stroke(middle + kLowLeft, middle + kLowRight);
  const Rig before = scene.document.rig();
  scene.move(middle + kHighLeft);
  scene.press(middle + kHighLeft);
  scene.drag(middle + kHighRight);
  EXPECT_EQ(scene.document.rig().sheets.size(), 1u) << "shown while it is drawn";
  scene.escape(middle + kHighRight, true);
  EXPECT_EQ(scene.document.rig(), before);
  EXPECT_TRUE(scene.tools.sheet.origin);
  scene.release(middle + kHighRight);
  EXPECT_EQ(scene.document.commands.position(), 0u);
  setTool(scene.tools, ToolKind::kMove);
  EXPECT_FALSE(scene.tools.sheet.origin) << "another tool begins anew";
}

TEST(SheetTool, ClicksGiveAConvergingSheet) {
  Drawing scene;
  const glm::vec2 middle = scene.skinPixel();
  scene.click(middle + glm::vec2(0, 160));
  ASSERT_TRUE(scene.tools.sheet.origin);
  EXPECT_EQ(scene.tools.sheet.origin->points.size(), 1u);
  scene.click(middle + glm::vec2(0, -120));
  ASSERT_EQ(scene.document.rig().sheets.size(), 1u);
  const MuscleSheet& sheet = scene.document.rig().sheets[0];
  EXPECT_EQ(sheet.edges[0].points.size(), 3u) << "an origin across";
  EXPECT_EQ(sheet.edges[1].points.size(), 1u);
  EXPECT_FALSE(scene.document.rig().primitives.empty());
}

TEST(SheetTool, RefusesEdgesAtTheSamePlace) {
  Drawing scene;
  const glm::vec2 middle = scene.skinPixel();
  scene.stroke(middle + kLowLeft, middle + kLowRight);
  const RouteResult second = scene.stroke(middle + kLowLeft, middle + kLowRight);
  ASSERT_TRUE(second.refusal);
  EXPECT_NE(second.refusal->text().find("further apart"), std::string::npos) << second.refusal->text();
  EXPECT_TRUE(scene.document.rig().sheets.empty());
  EXPECT_EQ(scene.document.commands.position(), 0u);
}

TEST(SheetTool, SymmetryAddsTheTwin) {
  Drawing scene(test::makeTwoLegged());
  ASSERT_TRUE(scene.document.symmetry);
  const SheetSkin skin(scene.document.character, Rig{});
  const auto on = [&](const char* bone) {
    const LineAnchor front = test::edgeAcross(skin, bone, 0.5f).points[1];
    return scene.pixelAt(glm::vec3(findPoint(front, scene.document.character->skeleton)->inBind));
  };
  scene.click(on("leg L"));
  scene.click(on("shin L"));
  ASSERT_EQ(scene.document.rig().sheets.size(), 2u);
  EXPECT_EQ(scene.document.rig().sheets[0].mirror, scene.document.rig().sheets[1].name);
  EXPECT_EQ(scene.document.commands.position(), 1u);
  EXPECT_EQ(selectedSheets(scene.document), std::vector<int>{0});
}

TEST(SheetStrokes, EdgesKeepBendsAndDropTheRest) {
  const std::shared_ptr<const Character> limb = test::makeLimb();
  LimbScene scene(limb);
  const View view = viewOf(scene.tools.camera, LimbScene::kSize);
  std::vector<SkinAnchor> stroke;
  for (int i = -70; i <= 70; i += 5) {
    const auto skin = skinUnder(scene.context(), view, scene.skinPixel() + glm::vec2(i, 0));
    ASSERT_TRUE(skin);
    stroke.push_back(*skin);
  }
  const SheetEdge edge = edgeAlong(*limb, stroke).value();
  EXPECT_LT(edge.points.size(), stroke.size());
  const Pose bind = bindPose(limb->skeleton);
  for (const SkinAnchor& place : stroke) {
    const glm::vec3 point = skinPointAt(*limb, bind, {place.triangle, place.barycentric, 0.0f}).point;
    float nearest = 1e9f;
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const glm::vec3 a(findPoint(edge.points[i - 1], limb->skeleton)->inBind);
      const glm::vec3 b(findPoint(edge.points[i], limb->skeleton)->inBind);
      const float t = std::clamp(glm::dot(point - a, b - a) / glm::dot(b - a, b - a), 0.0f, 1.0f);
      nearest = std::min(nearest, glm::distance(point, glm::mix(a, b, t)));
    }
    EXPECT_LT(nearest, 0.006f * limb->height);
  }
  const SheetEdge point = edgeAlong(*limb, std::span(stroke).first(3)).value();
  EXPECT_EQ(point.points.size(), 1u) << "a short stroke";
}

}  // namespace
}  // namespace sinew::app
