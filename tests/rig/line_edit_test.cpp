// tests/rig/line_edit_test.cpp: lines are added, edited and removed together with their muscles.

#include "core/rig/line_edit.h"

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {
namespace {

MuscleLine lineNamed(const std::string& name) {
  MuscleLine line;
  line.name = name;
  line.origin = {"a", {0.0f, 0.0f, 0.0f}, {}};
  line.insertion = {"b", {0.0f, 1.0f, 0.0f}, {}};
  return line;
}

Primitive on(const std::string& line) {
  Primitive primitive;
  primitive.name = "belly";
  primitive.bone = "a";
  primitive.line = line;
  return primitive;
}

struct LineEdit : testing::Test {
  Rig rig;

  LineEdit() {
    rig = addLine(rig, lineNamed("biceps")).value();
    rig = addPrimitive(rig, on("biceps")).value();
    rig = addPrimitive(rig, on("biceps")).value();
  }
  ~LineEdit() override { EXPECT_TRUE(validate(rig)) << validate(rig).error().text(); }
};

TEST_F(LineEdit, NamesAreUniqueAndRenamesAreFollowed) {
  rig = addLine(rig, lineNamed("biceps")).value();
  EXPECT_EQ(rig.lines[1].name, "biceps 2");
  EXPECT_FALSE(renameLine(rig, 1, "biceps").ok());
  EXPECT_FALSE(renameLine(rig, 1, "").ok());
  rig = renameLine(rig, 0, "triceps").value();
  EXPECT_EQ(rig.primitives[0].line, "triceps");
  EXPECT_EQ(primitivesOn(rig, "triceps"), (std::vector<int>{0, 1}));
}

TEST_F(LineEdit, LineIsRemovedWithItsLastPrimitive) {
  rig = addLine(rig, lineNamed("bare")).value();
  rig = removePrimitives(rig, std::vector<int>{0});
  EXPECT_GE(findLine(rig, "biceps"), 0);
  rig = removePrimitives(rig, std::vector<int>{0});
  EXPECT_LT(findLine(rig, "biceps"), 0);
  EXPECT_GE(findLine(rig, "bare"), 0) << "a line that carried nothing is not this edit's to take";
}

TEST_F(LineEdit, MusclesRemovedFromTheirLineFollowTheirBones) {
  const Rig off = setLineOfSeveral(rig, std::vector<int>{0, 1}, -1);
  EXPECT_TRUE(off.primitives[0].line.empty());
  EXPECT_TRUE(off.lines.empty());
  EXPECT_TRUE(validate(off));
}

TEST_F(LineEdit, TwinLinesReferToEachOther) {
  MuscleLine twin = lineNamed("other");
  twin.mirror = "biceps";
  rig = addLine(rig, twin).value();
  EXPECT_EQ(rig.lines[0].mirror, "other");
  rig = renameLine(rig, 1, "biceps R").value();
  EXPECT_EQ(rig.lines[0].mirror, "biceps R");
  rig = setLineOfSeveral(rig, std::vector<int>{0, 1}, -1);
  EXPECT_TRUE(rig.lines[0].mirror.empty()) << "it went with its last muscle";
}

TEST_F(LineEdit, OutOfRangeValuesAreRefused) {
  const Rig before = rig;
  EXPECT_FALSE(editLine(rig, 0, [](MuscleLine& line) { line.settings.full = 1.0f; }).ok());
  EXPECT_FALSE(addPrimitive(rig, on("calf")).ok());
  EXPECT_EQ(rig, before);
  rig = editLine(rig, 0, [](MuscleLine& line) { line.settings.full = 0.5f; }).value();
  EXPECT_EQ(rig.lines[0].settings.full, 0.5f);
}

TEST_F(LineEdit, DriversThatReadALineGoWithIt) {
  rig.primitives.push_back(on(""));
  rig.primitives.back().name = "rider";
  rig.primitives.back().group = rig.primitives[0].group;
  Driver driver;
  driver.input.kind = DriverInputKind::kLength;
  driver.input.line = "biceps";
  driver.curve.points = {{0.5f, 0.0f}, {1.0f, 1.0f}};
  rig = setDriver(std::move(rig), {Parameter::kAmount, 2}, driver).value();
  ASSERT_EQ(rig.primitives[2].animated.size(), 1u);
  rig = removePrimitives(rig, std::vector<int>{0, 1});
  EXPECT_TRUE(rig.lines.empty());
  EXPECT_TRUE(rig.primitives[0].animated.empty());
}

}  // namespace
}  // namespace sinew
