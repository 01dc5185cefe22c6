// tests/command/muscle_test.cpp: `sinew muscle` run as a process.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/files/json/json.h"
#include "sinew/files/rig_json.h"
#include "tests/command/program.h"

namespace sinew {
namespace {

using test::Program;

std::string readText(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(Program, MuscleWritesAReadableRigAndAReport) {
  const std::string rig = (folder_ / "athlete.rig.json").string();
  const std::string report = (folder_ / "report.json").string();
  const auto result = run({"muscle", demo("humanoid.glb"), "-o", rig, "--report", report});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.out, "");
  const auto loaded = loadRig(rig);
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  EXPECT_GT(loaded->primitives.size(), 60u);
  EXPECT_EQ(run({"inspect", rig}).status, 0);
  const auto json = Json::parse(readText(report));
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->keys(), (std::vector<std::string>{"set", "body", "muscles", "primitives", "left_out", "mended",
                                                    "missing_parts", "seconds"}));
  EXPECT_EQ(json->at("set").text(""), "athlete");
}

TEST_F(Program, MuscleUsesTheSetForTheKindOfBody) {
  const std::string rig = (folder_ / "horse.rig.json").string();
  ASSERT_EQ(run({"muscle", demo("horse.glb"), "-o", rig}).status, 0);
  const auto loaded = loadRig(rig);
  ASSERT_TRUE(loaded.ok());
  EXPECT_GE(findPrimitive(loaded.value(), "quadriceps L"), 0);
}

TEST_F(Program, MuscleRefusesOnOneLine) {
  const std::string rig = (folder_ / "a.rig.json").string();
  const auto oneLine = [](const std::string& text) { return !text.empty() && text.find('\n') == text.size() - 1; };
  const auto otherKind = run({"muscle", demo("horse.glb"), "-o", rig, "--set", "athlete"});
  EXPECT_EQ(otherKind.status, 1);
  EXPECT_TRUE(oneLine(otherKind.error)) << otherKind.error;
  EXPECT_FALSE(std::filesystem::exists(rig));
  const auto noBody = run({"muscle", demo("tangle.glb"), "-o", rig});
  EXPECT_EQ(noBody.status, 1);
  EXPECT_TRUE(oneLine(noBody.error)) << noBody.error;
  EXPECT_EQ(run({"muscle", demo("horse.glb"), "-o", rig, "--set", "nobody"}).status, 2);
  EXPECT_EQ(run({"muscle", demo("horse.glb"), "-o", rig, "--mass", "9"}).status, 2);
  EXPECT_EQ(run({"muscle", demo("horse.glb"), "-o", (folder_ / "a.txt").string()}).status, 2);
}

}  // namespace
}  // namespace sinew
