// tests/bodies/sheets/keep_sheets_test.cpp: bellies of sheets in documents that are opened, edited and saved.
#include "core/bodies/sheets/keep_sheets.h"

#include <algorithm>

#include "core/bodies/check.h"
#include "core/bodies/motions.h"
#include "core/bodies/retarget.h"
#include "core/rig/merge.h"
#include "core/rig/rig_edit.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"
#include "tests/bodies/sheets/sheet_fixture.h"

namespace sinew {
namespace {

class KeptSheets : public testing::Test {
 protected:
  KeptSheets() {
    Rig rig;
    rig.character = "humanoid.glb";
    rig = addPrimitive(std::move(rig), single()).value();
    rig = addSheet(std::move(rig), test::chestSheet(body_)).value();
    rig = mirrorSheetToOtherSide(std::move(rig), 0, body_.plan).value();
    rig_ = withSheets(std::move(rig), body_.character);
  }

  [[nodiscard]] Primitive single() const {
    Primitive primitive;
    primitive.name = "calf";
    primitive.bone = body_.skeleton().fileName(0);
    primitive.placement.radii = {0.1f, 0.2f, 0.1f};
    return primitive;
  }

  [[nodiscard]] Rig edited(const std::function<void(MuscleSheet&)>& change) {
    return keeper_.keep(rig_, editSheet(rig_, 0, change).value(), body_.plan);
  }

  test::SheetBody body_ = test::humanoidBody();
  SheetKeeper keeper_{body_.character};
  Rig rig_;
};

TEST_F(KeptSheets, FilesHaveTheSheetsAloneAndGiveTheSameBellies) {
  ASSERT_EQ(rig_.primitives.size(), 1u + 2 * 12);
  ASSERT_TRUE(validate(rig_).ok()) << validate(rig_).error().text();
  const std::string text = rigToJson(rig_);
  EXPECT_EQ(text.find("pectoral L 1.1"), std::string::npos);
  EXPECT_NE(text.find("\"version\": 4"), std::string::npos);
  const Result<Rig> read = rigFromJson(text);
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->primitives.size(), 1u);
  EXPECT_EQ(withSheets(read.value(), body_.character), rig_);
}

TEST_F(KeptSheets, AnEditLaysTheSheetAndItsTwinAgain) {
  const Rig thick = edited([](MuscleSheet& sheet) { sheet.bellies = 5; });
  EXPECT_EQ(bellies(thick, "pectoral L").size(), 20u);
  EXPECT_EQ(bellies(thick, "pectoral R").size(), 20u);
  EXPECT_EQ(thick, withSheets(thick, body_.character));
  EXPECT_TRUE(validate(thick).ok());
}

TEST_F(KeptSheets, WhatDoesNotConcernASheetKeepsItsBellies) {
  Rig renamed = renamePrimitive(rig_, 0, "shin").value();
  const Rig kept = keeper_.keep(rig_, std::move(renamed), body_.plan);
  EXPECT_EQ(kept.primitives.size(), rig_.primitives.size());
  EXPECT_TRUE(std::equal(kept.primitives.begin() + 1, kept.primitives.end(), rig_.primitives.begin() + 1));
}

TEST_F(KeptSheets, NewMusclesComeBeforeBellies) {
  Primitive other = single();
  other.name = "another";
  const Rig kept = keeper_.keep(rig_, addPrimitive(rig_, other).value(), body_.plan);
  EXPECT_EQ(kept.primitives[1].name, "another");
  EXPECT_EQ(kept.primitives[2].sheet, "pectoral L");
}

TEST_F(KeptSheets, ABellyThatIsMovedGoesBack) {
  Rig moved = rig_;
  moved.primitives.back().placement.center.x += 0.5f;
  EXPECT_EQ(keeper_.keep(rig_, std::move(moved), body_.plan), rig_);
}

TEST_F(KeptSheets, RemovingABellyRemovesItsSheet) {
  const int belly = bellies(rig_, "pectoral R")[3];
  const Rig left = removePrimitives(rig_, std::span(&belly, 1));
  ASSERT_EQ(left.sheets.size(), 1u);
  EXPECT_EQ(left.sheets[0].name, "pectoral L");
  EXPECT_TRUE(left.sheets[0].mirror.empty());
  EXPECT_EQ(left.primitives.size(), 13u);
  EXPECT_TRUE(validate(left).ok()) << validate(left).error().text();
}

TEST_F(KeptSheets, TheGroupOfABellyIsThatOfItsSheet) {
  const int belly = bellies(rig_, "pectoral L")[0];
  const Rig moved = moveToNewGroup(rig_, std::span(&belly, 1), "trunk").value();
  EXPECT_EQ(moved.sheets[0].group, "trunk");
  EXPECT_EQ(membersOf(moved, "trunk").size(), 12u);
}

TEST_F(KeptSheets, RenamingNamesTheBelliesAndTheTwin) {
  const Rig renamed = renameSheet(rig_, 0, "breast L").value();
  EXPECT_EQ(renamed.sheets[1].name, "breast R");
  EXPECT_EQ(renamed.sheets[1].mirror, "breast L");
  EXPECT_GE(findPrimitive(renamed, "breast R 2.3"), 0);
  EXPECT_EQ(keeper_.keep(rig_, renamed, body_.plan), withSheets(renamed, body_.character));
  EXPECT_FALSE(renameSheet(rig_, 0, "pectoral R").ok());
}

TEST_F(KeptSheets, BrokenUpItsBelliesStayAsMusclesWithTwins) {
  const Rig broken = breakIntoStrips(rig_, 0);
  EXPECT_TRUE(broken.sheets.empty());
  ASSERT_EQ(broken.primitives.size(), rig_.primitives.size());
  for (const Primitive& primitive : broken.primitives) EXPECT_TRUE(primitive.sheet.empty());
  EXPECT_GE(twinOf(broken, findPrimitive(broken, "pectoral L 2.2")), 0);
  EXPECT_TRUE(validate(broken).ok()) << validate(broken).error().text();
  EXPECT_NE(rigToJson(broken).find("pectoral L 2.2"), std::string::npos);
}

TEST_F(KeptSheets, DuplicatesAndPastedCopiesAreSheets) {
  const std::vector<int> both = withTwins(rig_, bellies(rig_, "pectoral L"));
  ASSERT_EQ(both.size(), 24u);
  const Rig copied = keeper_.keep(rig_, duplicatePairs(rig_, both), body_.plan);
  ASSERT_EQ(copied.sheets.size(), 4u);
  EXPECT_EQ(copied.sheets[3].mirror, copied.sheets[2].name);
  EXPECT_EQ(bellies(copied, copied.sheets[3].name).size(), 12u);
  const Rig part = rigFromJson(rigToJson(excerpt(rig_, bellies(rig_, "pectoral L")))).value();
  ASSERT_EQ(part.sheets.size(), 1u);
  const Result<Merged> mirrored = mergeRigs(rig_, part, body_.skeleton(), &body_.plan);
  ASSERT_TRUE(mirrored.ok());
  ASSERT_EQ(mirrored->sheets.size(), 1u);
  const Rig pasted = keeper_.keep(rig_, mirrored->rig, body_.plan);
  EXPECT_EQ(bellies(pasted, mirrored->sheets[0]).size(), 12u);
  EXPECT_TRUE(validate(pasted).ok()) << validate(pasted).error().text();
}

TEST_F(KeptSheets, AStripIsCheckedAsOneMuscle) {
  Rig rig = edited([](MuscleSheet& sheet) { sheet.line = LineSettings{}; });
  const std::vector<Finding> found = check(rig, Motions(body_.character));
  std::vector<std::pair<std::string, FindingKind>> seen;
  for (const Finding& finding : found) {
    const std::string& name = at(rig.primitives, finding.primitive).name;
    const std::pair strip(name.substr(0, name.rfind('.')), finding.kind);
    EXPECT_EQ(std::ranges::find(seen, strip), seen.end()) << name;
    seen.push_back(strip);
  }
}

TEST_F(KeptSheets, RetargetMovesEdgesAndLaysAgain) {
  const Motions motions(body_.character);
  const Result<Retargeted> same = retarget(rig_, *body_.character, body_.plan, motions, body_.plan);
  ASSERT_TRUE(same.ok()) << same.error().text();
  ASSERT_EQ(same->rig.sheets.size(), 2u);
  ASSERT_EQ(same->rig.primitives.size(), rig_.primitives.size());
  for (std::size_t i = 1; i < rig_.primitives.size(); ++i) {
    const Primitive& a = rig_.primitives[i];
    const Primitive& b = same->rig.primitives[i];
    EXPECT_EQ(a.bone, b.bone);
    EXPECT_LT(glm::distance(a.placement.center, b.placement.center), 1e-3f * body_.character->height);
  }
}

TEST_F(KeptSheets, ASheetWithAMissingBoneHasNoBellies) {
  Rig rig = rig_;
  rig.sheets[0].edges[0].points[0].bone = "tail";
  std::vector<UnlaidSheet> unlaid;
  const Rig laid = withSheets(rig, body_.character, &unlaid);
  EXPECT_TRUE(bellies(laid, "pectoral L").empty());
  EXPECT_EQ(bellies(laid, "pectoral R").size(), 12u);
  ASSERT_EQ(unlaid.size(), 1u);
  EXPECT_EQ(unlaid[0].name, "pectoral L");
  EXPECT_TRUE(validate(laid).ok());
}

TEST_F(KeptSheets, BadSheetsAreRefusedByPlace) {
  const auto refusal = [&](const std::function<void(MuscleSheet&)>& change) {
    Rig rig = rig_;
    change(rig.sheets[1]);
    const Result<void> valid = validate(rig);
    return valid ? std::string("accepted") : valid.error().place;
  };
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.edges.pop_back(), sheet.edges.pop_back(); }), "sheets[1].edges");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.edges[1].points.clear(); }), "sheets[1].edges[1].points");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.edges[1].points[0].point.x = NAN; }),
            "sheets[1].edges[1].points[0].point[0]");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.strips = 17; }), "sheets[1].strips");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.strips = 1; }), "sheets[1].width");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.across = {{0.5f, 1.0f}, {0.2f, 1.0f}}; }), "sheets[1].across[1][0]");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.reach = 1.0f; }), "sheets[1].reach");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.group = "none"; }), "sheets[1].group");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.name = "pectoral L"; }), "sheets[1].name");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.mirror = "none"; }), "sheets[0].mirror");
  EXPECT_EQ(refusal([](MuscleSheet& sheet) { sheet.line.emplace().twist = 2.0f; }), "sheets[1].line.twist");
}

}  // namespace
}  // namespace sinew
