// tests/rig/merge_test.cpp: merged items refer to the items they came with, whatever their names are now.

#include "core/rig/merge.h"

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/line_edit.h"
#include "core/rig/references.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/rig_copies.h"

namespace sinew {
namespace {

MuscleLine lineNamed(const std::string& name) {
  MuscleLine line;
  line.name = name;
  line.origin = {"leg L", {0.0f, -0.1f, 0.1f}, {}};
  line.insertion = {"shin L", {0.0f, -0.1f, 0.1f}, {}};
  return line;
}

Driver readsLength(const std::string& line) {
  Driver driver;
  driver.input.kind = DriverInputKind::kLength;
  driver.input.line = line;
  driver.curve.points = {{0.0f, 0.0f}, {1.0f, 0.1f}};
  return driver;
}

/// A pair of calves on a pair of lines, each driven by the length of its own line.
struct RigMerge : testing::Test {
  std::shared_ptr<const Character> legs = test::makeTwoLegged();
  MirrorPlan plan = makeMirrorPlan(*legs);
  Rig calves;

  RigMerge() {
    calves.character = "legs.glb";
    calves.groups = {{"legs", {}}, {"torso", {}}};
    calves.links = {{{"legs", "torso"}, 0.7f}};
    calves = addLine(calves, lineNamed("calf L")).value();
    Primitive calf;
    calf.name = "calf L";
    calf.bone = "leg L";
    calf.group = "legs";
    calf.line = "calf L";
    calf.placement.radii = {0.1f, 0.2f, 0.1f};
    calf.animated = {{Parameter::kReach, {}, {readsLength("calf L")}, {}}};
    calves = addPair(calves, calf, plan).value();
  }

  [[nodiscard]] Merged merged(Rig into, const Rig& from, const MirrorPlan* mirror = nullptr) const {
    Merged result = mergeRigs(std::move(into), from, legs->skeleton, mirror).value();
    EXPECT_TRUE(validate(result.rig)) << validate(result.rig).error().text();
    return result;
  }

  static const std::string& lineRead(const Primitive& primitive) {
    return primitive.animated.front().drivers.front().input.line;
  }
};

TEST_F(RigMerge, IntoAnEmptyRigGivesTheSource) {
  Rig empty;
  empty.character = calves.character;
  EXPECT_EQ(merged(empty, calves).rig, calves);
}

TEST_F(RigMerge, IntoItselfDuplicatesEverything) {
  const Merged twice = merged(calves, calves);
  EXPECT_EQ(twice.primitives, (std::vector<int>{2, 3}));
  EXPECT_EQ(twice.lines, (std::vector<int>{2, 3}));
  EXPECT_EQ(twice.rig.groups, calves.groups);
  EXPECT_EQ(twice.rig.links, calves.links);
  for (const std::size_t i : {2u, 3u}) {
    const Primitive& copy = twice.rig.primitives[i];
    EXPECT_EQ(twinOf(twice.rig, static_cast<int>(i)), static_cast<int>(5 - i));
    EXPECT_EQ(copy.line, twice.rig.lines[i].name);
    EXPECT_EQ(twice.rig.lines[i].mirror, twice.rig.lines[5 - i].name);
    EXPECT_EQ(lineRead(copy), twice.rig.lines[i].name);
  }
}

TEST_F(RigMerge, MirroredMergeSwapsTheSide) {
  const Rig left = excerpt(calves, std::vector<int>{0});
  Rig empty;
  empty.groups = {{"torso", {}}};
  const Merged right = merged(empty, left, &plan);
  const Primitive& calf = right.rig.primitives.front();
  EXPECT_EQ(calf.name, "calf R");
  EXPECT_EQ(calf.line, "calf R");
  EXPECT_EQ(lineRead(calf), "calf R");
  EXPECT_EQ(right.rig.lines.front().insertion.bone, "shin R");
}

TEST_F(RigMerge, EqualNamesInDifferentRigsAreUnrelated) {
  // The source's "calf 2" is only read and stays there; the merged item becomes "calf 2" here.
  Rig source = addLine(addLine(Rig{}, lineNamed("calf")).value(), lineNamed("calf 2")).value();
  Primitive muscle = calves.primitives[0];
  muscle.mirror.clear();
  muscle.group.clear();
  muscle.line = "calf";
  muscle.animated = {{Parameter::kReach, {}, {readsLength("calf 2"), readsLength("calf")}, {}}};
  source = addPrimitive(source, muscle).value();
  const Merged result = merged(addLine(Rig{}, lineNamed("calf")).value(), source);
  ASSERT_EQ(result.lostDrivers.size(), 1u);
  EXPECT_EQ(result.lostDrivers[0].line, "calf 2");
  ASSERT_EQ(result.rig.primitives[0].animated[0].drivers.size(), 1u);
  EXPECT_EQ(lineRead(result.rig.primitives[0]), "calf 2");
  EXPECT_EQ(result.rig.primitives[0].line, "calf 2");
}

TEST_F(RigMerge, MergedItemsHaveNoIdentityAndTheRigIsNotCopied) {
  Rig known = calves;
  IdentitySource().identify(known, Rig{});
  Rig into = addPrimitive(known, known.primitives[0]).value();
  const test::RigCopies copies(into);
  const Merged result = merged(std::move(into), known);
  EXPECT_EQ(copies.count(), 0);
  EXPECT_TRUE(result.rig.primitives[0].id());
  EXPECT_FALSE(result.rig.primitives.back().id());
  EXPECT_FALSE(result.rig.lines.back().id());
}

TEST_F(RigMerge, MuscleWithALineOfMissingBonesIsRefusedWithAReason) {
  Rig lost = calves;
  for (MuscleLine& line : lost.lines) line.insertion.bone = "elsewhere";
  const Merged result = merged(calves, lost);
  EXPECT_EQ(result.rig, calves);
  ASSERT_EQ(result.refusals.size(), 2u);
  EXPECT_NE(result.refusals[1].why.reason.find("elsewhere"), std::string::npos);
  EXPECT_EQ(result.primitives, (std::vector<int>{-1, -1}));
}

}  // namespace
}  // namespace sinew
