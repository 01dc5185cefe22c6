// tests/command/check_test.cpp: `sinew check` run as a process.
#include <filesystem>
#include <fstream>

#include "core/files/json/json.h"
#include "tests/command/program.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/dressed_humanoid.h"

namespace sinew {
namespace {

using test::Program;

TEST_F(Program, CheckReportsMuscleKindAndTime) {
  const auto result = run({"check", demo("horse.rig.json"), "--json"});
  ASSERT_EQ(result.status, 0) << result.error;
  const auto json = Json::parse(result.out);
  ASSERT_TRUE(json.ok()) << json.error().text();
  EXPECT_GT(json->at("poses").number(0), 100);
  ASSERT_FALSE(json->at("findings").items().empty());
  for (const Json& finding : json->at("findings").items()) {
    EXPECT_EQ(finding.keys(), (std::vector<std::string>{"muscle", "kind", "clip", "time", "measure", "text"}));
    EXPECT_NE(finding.at("muscle").text(""), "");
    EXPECT_GT(finding.at("measure").number(0), 0);
  }
  EXPECT_EQ(run({"check", demo("horse.rig.json"), "--strict"}).status, 1);
}

TEST_F(Program, CheckFindsNothingInASoundRig) {
  const auto result = run({"check", demo("humanoid-flex.rig.json"), "--strict"});
  EXPECT_EQ(result.status, 0) << result.error;
  EXPECT_NE(result.out.find("nothing found"), std::string::npos) << result.out;
}

TEST_F(Program, CheckRepairsAndWritesAReadableRig) {
  const auto result = run({"check", demo("horse.rig.json"), "--json", "--mend", "mended.rig.json"});
  ASSERT_EQ(result.status, 0) << result.error;
  const auto json = Json::parse(result.out);
  ASSERT_TRUE(json.ok());
  EXPECT_FALSE(json->at("mended").items().empty());
  EXPECT_LT(json->at("left").items().size(), json->at("findings").items().size());
  const auto again = run({"check", "mended.rig.json", "--json"});
  ASSERT_EQ(again.status, 0) << again.error;
  EXPECT_EQ(Json::parse(again.out)->at("findings").items().size(), json->at("left").items().size());
}

TEST_F(Program, CheckCountsClothBelowTheSkin) {
  test::writeDressedHumanoid(folder_);
  std::ofstream(folder_ / "dressed.rig.json") << R"({"format": "sinew-rig", "version": 1, "character": "dressed.glb"})";
  const auto none = run({"check", demo("horse.rig.json"), "--cloth"});
  EXPECT_NE(none.out.find("cloth: none"), std::string::npos) << none.out;
  const auto result = run({"check", "dressed.rig.json", "--cloth", "--json", "--strict"});
  ASSERT_EQ(result.status, 0) << result.error;
  const auto json = Json::parse(result.out);
  ASSERT_TRUE(json.ok());
  EXPECT_GT(json->at("cloth").at("vertices").number(0), 1000);
  EXPECT_EQ(json->at("cloth").at("more").number(-1), 0);
  EXPECT_EQ(json->at("cloth").at("in_sight").number(-1), 0);
}

TEST_F(Program, CheckRefusesInputsOtherThanRigs) {
  const auto character = run({"check", demo("demo.glb")});
  EXPECT_EQ(character.status, 1);
  EXPECT_NE(character.error.find("expected a rig"), std::string::npos) << character.error;
  EXPECT_EQ(run({"check", "none.rig.json"}).status, 1);
  EXPECT_EQ(run({"check"}).status, 2);
}

}  // namespace
}  // namespace sinew
