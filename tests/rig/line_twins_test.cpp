// tests/rig/line_twins_test.cpp: lines of both sides: created with their muscles, kept in sync, mirrored.

#include "core/rig/twins.h"

#include <gtest/gtest.h>

#include "core/rig/line_edit.h"
#include "core/rig/posed_rig.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/rig/hamstrings.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew {
namespace {

struct LineTwins : testing::Test {
  std::shared_ptr<const Character> character = test::makeTwoLegged();
  MirrorPlan plan = makeMirrorPlan(*character);
  Rig rig = hamstrings(plan);

  ~LineTwins() override { EXPECT_TRUE(validate(rig)) << validate(rig).error().text(); }

  const MuscleLine& line(const std::string& name) { return rig.lines[static_cast<std::size_t>(findLine(rig, name))]; }

  void edit(const Result<Rig>& edited) {
    ASSERT_TRUE(edited) << edited.error().text();
    rig = keepTwins(rig, rig, edited.value(), plan);
  }

  /// Both bellies are mirror images in a symmetric pose.
  void expectMirrored() {
    Pose pose = bindPose(character->skeleton);
    pose.flex = 0.7f;
    const PosedRig posed = RigPoser(rig, *character).pose(pose);
    const auto center = [&](std::size_t i) {
      return glm::dvec3(posed.muscles[i].carrier * glm::vec4(rig.primitives[i].placement.center, 1.0f));
    };
    EXPECT_LT(glm::distance(reflected(plan.plane, center(0)), center(1)), 1e-5);
    const auto volume = [&](std::size_t i) { return glm::determinant(glm::mat3(posed.muscles[i].carrier)); };
    EXPECT_NEAR(volume(0), volume(1), 1e-5f);
  }
};

TEST_F(LineTwins, PairOfMusclesGetsAPairOfLines) {
  ASSERT_EQ(rig.lines.size(), 2u);
  EXPECT_EQ(rig.lines[1].name, "hamstring R");
  EXPECT_EQ(line("hamstring L").mirror, "hamstring R");
  EXPECT_EQ(rig.primitives[1].line, "hamstring R");
  EXPECT_EQ(rig.lines[1].insertion.bone, "shin R");
  EXPECT_EQ(rig.primitives[1].mirror, "hamstring L");
  expectMirrored();
}

TEST_F(LineTwins, EditsApplyToBothLines) {
  edit(editLine(rig, 1, [](MuscleLine& line) {
    line.origin.point.y -= 0.05f;
    line.settings.flex = {0.6f, -0.2f};
    line.via = LineAnchor{"leg R", {0.0f, -0.2f, -0.2f}, {}};
  }));
  EXPECT_EQ(rig.lines[0].settings.flex, glm::vec2(0.6f, -0.2f));
  ASSERT_TRUE(rig.lines[0].via);
  EXPECT_EQ(rig.lines[0].via->bone, "leg L");
  expectMirrored();
}

TEST_F(LineTwins, RemovingFromTheLineAppliesToBothSides) {
  edit(setLineOfSeveral(rig, std::vector<int>{0}, -1));
  EXPECT_TRUE(rig.primitives[1].line.empty());
}

TEST_F(LineTwins, FlippingTwiceRestoresTheLine) {
  const Rig before = rig;
  rig = flipPrimitives(rig, std::vector<int>{0}, plan).value();
  EXPECT_EQ(line("hamstring L").origin.bone, "leg R");
  expectMirrored();
  rig = flipPrimitives(rig, std::vector<int>{0}, plan).value();
  EXPECT_EQ(line("hamstring L").origin.bone, "leg L");
  EXPECT_LT(glm::distance(line("hamstring L").origin.point, before.lines[0].origin.point), 1e-6f);
}

TEST_F(LineTwins, DeletingOneMuscleKeepsTheOtherLine) {
  rig = removePrimitives(rig, std::vector<int>{0});
  ASSERT_EQ(rig.lines.size(), 1u);
  EXPECT_EQ(rig.lines[0].name, "hamstring R");
  EXPECT_TRUE(rig.lines[0].mirror.empty());
}

TEST_F(LineTwins, LineInTheMiddleIsItsOwnMirrorImage) {
  MuscleLine middle;
  middle.name = "abdomen";
  middle.origin = {"spine", {0.0f, 0.3f, 0.2f}, {}};
  middle.insertion = {"hips", {0.0f, 0.0f, 0.2f}, {}};
  EXPECT_TRUE(liesInPlane(plan, middle, 1e-4f));
  rig = addLine(rig, middle).value();
  Primitive side;
  side.name = "abs L";
  side.bone = "spine";
  side.line = "abdomen";
  side.placement.center = {0.1f, 0.1f, 0.2f};
  side.placement.radii = glm::vec3(0.1f);
  rig = addPair(rig, side, plan).value();
  EXPECT_EQ(rig.primitives.back().line, "abdomen");
  EXPECT_EQ(rig.lines.size(), 3u);
}

TEST_F(LineTwins, BothGetASideInTheirName) {
  MuscleLine line = rig.lines[0];
  line.name = "calf";
  line.mirror.clear();
  rig = addLine(rig, line).value();
  Primitive belly = rig.primitives[0];
  belly.name = "calf";
  belly.line = "calf";
  belly.mirror.clear();
  rig = addPair(rig, belly, plan).value();
  EXPECT_GE(findLine(rig, "calf L"), 0);
  EXPECT_GE(findLine(rig, "calf R"), 0);
  EXPECT_EQ(rig.primitives[2].line, "calf L");
  EXPECT_EQ(rig.primitives[3].line, "calf R");
}

}  // namespace
}  // namespace sinew
