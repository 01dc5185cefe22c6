// tests/command/retarget_test.cpp: `sinew retarget` run as a process.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/files/json/json.h"
#include "sinew/files/rig_json.h"
#include "tests/command/program.h"

namespace sinew {
namespace {

using test::Program;

TEST_F(Program, RetargetWritesAReadableRig) {
  const std::string rig = (folder_ / "horse.rig.json").string();
  const std::string report = (folder_ / "report.json").string();
  const auto result = run({"retarget", demo("humanoid.rig.json"), demo("horse.glb"), "-o", rig, "--report", report});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.error.find("is left out: this body has no"), std::string::npos) << result.error;
  const auto loaded = loadRig(rig);
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  EXPECT_FALSE(loaded->primitives.empty());
  EXPECT_EQ(run({"inspect", rig, "--strict"}).status, 0);
  std::ifstream in(report);
  const auto json = Json::parse(std::string{std::istreambuf_iterator<char>(in), {}});
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->keys(), (std::vector<std::string>{"primitives", "left_out", "mended", "seconds"}));
}

TEST_F(Program, RetargetRefusesOnOneLine) {
  const std::string rig = (folder_ / "a.rig.json").string();
  const auto oneLine = [](const std::string& text) { return !text.empty() && text.find('\n') == text.size() - 1; };
  const auto noBody = run({"retarget", demo("humanoid.rig.json"), demo("tangle.glb"), "-o", rig});
  EXPECT_EQ(noBody.status, 1);
  EXPECT_TRUE(oneLine(noBody.error)) << noBody.error;
  const auto noFile = run({"retarget", demo("humanoid.rig.json"), demo("nobody.glb"), "-o", rig});
  EXPECT_EQ(noFile.status, 1);
  EXPECT_TRUE(oneLine(noFile.error)) << noFile.error;
  EXPECT_FALSE(std::filesystem::exists(rig));
  EXPECT_EQ(run({"retarget", demo("humanoid.rig.json"), "-o", rig}).status, 2);
  EXPECT_EQ(run({"retarget", demo("humanoid.rig.json"), demo("horse.glb"), "-o", (folder_ / "a.txt").string()}).status,
            2);
}

}  // namespace
}  // namespace sinew
