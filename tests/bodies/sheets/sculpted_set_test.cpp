// tests/bodies/sheets/sculpted_set_test.cpp: the bundled set of sheets on the bundled body.
#include <algorithm>
#include <filesystem>
#include <set>

#include <glm/geometric.hpp>

#include "core/bodies/check.h"
#include "core/bodies/motions.h"
#include "core/bodies/muscle_set.h"
#include "core/character/bone_names.h"
#include "core/files/preset_json.h"
#include "core/rig/motion_clip.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "tests/bodies/sheets/sheet_fixture.h"

namespace sinew {
namespace {

class SculptedSet : public testing::Test {
 protected:
  [[nodiscard]] AddedSet added(const PresetTuning& tuning = {}) const {
    auto made = addMuscleSet({}, set_, tuning, motions_, body_.plan);
    EXPECT_TRUE(made.ok()) << made.error().text();
    return made.ok() ? std::move(made).value() : AddedSet{};
  }

  test::SheetBody body_ = test::humanoidBody();
  Motions motions_{body_.character};
  Preset set_ = loadPreset(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "presets" / "sculpted.json").value();
};

TEST_F(SculptedSet, EverySheetFindsItsPlaceOnBothSides) {
  const AddedSet made = added();
  EXPECT_TRUE(made.fitted.leftOut.empty());
  EXPECT_TRUE(validate(made.fitted.rig).ok());
  for (const PresetSheet& sheet : set_.sheets) {
    const std::string name = sheet.single ? sheet.sheet.name : sheet.sheet.name + " L";
    const int found = findSheet(made.fitted.rig, name);
    ASSERT_GE(found, 0) << name;
    EXPECT_EQ(at(made.fitted.rig.sheets, found).mirror.empty(), sheet.single) << name;
    EXPECT_EQ(bellies(made.fitted.rig, name).size(), toIndex(sheet.sheet.strips * sheet.sheet.bellies)) << name;
  }
}

TEST_F(SculptedSet, LeftAndRightAreImages) {
  const Rig rig = added().fitted.rig;
  std::vector<float> apart;
  for (int i = 0; i < static_cast<int>(rig.primitives.size()); ++i) {
    const Primitive& belly = at(rig.primitives, i);
    const int twin = twinOf(rig, i);
    if (belly.sheet.empty() || twin < i) continue;
    const Primitive& other = at(rig.primitives, twin);
    const glm::vec3 image(reflected(body_.plan.plane, glm::dvec3(body_.inBind(belly.bone, belly.placement.center))));
    apart.push_back(glm::distance(image, body_.inBind(other.bone, other.placement.center)));
  }
  ASSERT_GT(apart.size(), 100u);
  std::ranges::sort(apart);
  EXPECT_LT(apart[apart.size() * 95 / 100], 0.0005f * body_.character->height);
}

/// The broad muscles of the shoulder stay on the ribs while the skin follows an arm that is raised high.
TEST_F(SculptedSet, OnlyBroadMusclesOfTheShoulderComeOut) {
  const std::set<std::string> broad{"pectoral", "infraspinatus", "latissimus"};
  const Rig rig = added().fitted.rig;
  for (const Finding& finding : check(rig, motions_)) {
    const Primitive& belly = at(rig.primitives, finding.primitive);
    EXPECT_TRUE(broad.contains(withoutSide(belly.sheet)) && finding.measure < 1.3f)
        << belly.name << ": " << textOf(finding) << " in " << finding.clip;
  }
}

TEST_F(SculptedSet, MassRaisesTheCrests) {
  const Rig usual = added().fitted.rig;
  const Rig heavy = added({1.6f, std::nullopt}).fitted.rig;
  for (std::size_t i = 0; i < usual.sheets.size(); ++i) {
    EXPECT_NEAR(heavy.sheets[i].crest, 1.6f * usual.sheets[i].crest, 1e-6f);
    EXPECT_EQ(heavy.sheets[i].edges, usual.sheets[i].edges);
  }
}

TEST_F(SculptedSet, SurvivesAsAFile) {
  const Result<Preset> again = presetFromJson(presetToJson(set_));
  ASSERT_TRUE(again.ok()) << again.error().text();
  ASSERT_EQ(again->sheets.size(), set_.sheets.size());
  for (std::size_t i = 0; i < set_.sheets.size(); ++i) {
    EXPECT_EQ(again->sheets[i].sheet, set_.sheets[i].sheet);
    EXPECT_EQ(again->sheets[i].single, set_.sheets[i].single);
    EXPECT_EQ(again->sheets[i].edges.size(), set_.sheets[i].edges.size());
  }
  std::string bad = presetToJson(set_);
  bad.replace(bad.find("\"strips\": "), 11, "\"strips\": 99");
  EXPECT_FALSE(presetFromJson(bad).ok());
}

}  // namespace
}  // namespace sinew
