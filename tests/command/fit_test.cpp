// tests/command/fit_test.cpp: `sinew fit` run as a process.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/files/json/json.h"
#include "sinew/files/rig_json.h"
#include "tests/command/program.h"

namespace sinew {
namespace {

using test::Program;

TEST_F(Program, FitMakesTheSkinOfARigAgain) {
  const std::string sculpt = (folder_ / "sculpt.obj").string();
  const std::string rig = (folder_ / "fitted.rig.json").string();
  const std::string report = (folder_ / "fit.json").string();
  ASSERT_EQ(run({"muscle", demo("humanoid.glb"), "--mass", "1.3", "-o", (folder_ / "big.rig.json").string()}).status,
            0);
  ASSERT_EQ(run({"muscle", demo("humanoid.glb"), "-o", (folder_ / "plain.rig.json").string()}).status, 0);
  ASSERT_EQ(run({"smooth", "big.rig.json", "--detail", "uniform", "--depth", "3", "-o", sculpt}).status, 0);
  const auto result = run({"fit", "plain.rig.json", sculpt, "-o", rig, "--prior", "0.05", "--report", report});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_NE(result.out.find("explained"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("check: nothing found"), std::string::npos) << result.out;
  ASSERT_TRUE(loadRig(rig).ok());
  EXPECT_EQ(run({"inspect", rig, "--strict"}).status, 0);
  std::ifstream in(report);
  const auto json = Json::parse(std::string{std::istreambuf_iterator<char>(in), {}});
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->keys(), (std::vector<std::string>{"before", "after", "covered", "muscles", "moved", "carves",
                                                    "held_back", "findings", "seconds"}));
  const double before = json->at("before").at("explained").number(0.0);
  const double after = json->at("after").at("explained").number(0.0);
  EXPECT_LT(before, after);
  EXPECT_GT(after, 0.95);
}

TEST_F(Program, FitRefusesOnOneLine) {
  const std::string rig = demo("humanoid.rig.json");
  const std::string out = (folder_ / "a.rig.json").string();
  const auto otherBody = run({"fit", rig, demo("horse.glb"), "-o", out});
  EXPECT_EQ(otherBody.status, 1);
  EXPECT_TRUE(otherBody.oneErrorLine()) << otherBody.error;
  const auto noFile = run({"fit", rig, "nobody.obj", "-o", out});
  EXPECT_EQ(noFile.status, 1);
  EXPECT_TRUE(noFile.oneErrorLine()) << noFile.error;
  const auto noRig = run({"fit", demo("humanoid.glb"), demo("humanoid.glb"), "-o", out});
  EXPECT_EQ(noRig.status, 1);
  EXPECT_TRUE(noRig.oneErrorLine()) << noRig.error;
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_EQ(run({"fit", rig, demo("humanoid.glb"), "-o", "a.txt"}).status, 2);
  EXPECT_EQ(run({"fit", rig, demo("humanoid.glb"), "-o", out, "--prior", "2"}).status, 2);
  EXPECT_EQ(run({"fit", rig, "-o", out}).status, 2);
}

}  // namespace
}  // namespace sinew
