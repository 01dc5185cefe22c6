// tests/command/pack_test.cpp: `sinew pack` run as a process.
#include <fstream>
#include <iterator>

#include "sinew/runtime/game_file.h"
#include "tests/command/program.h"

namespace sinew {
namespace {

using test::Program;

TEST_F(Program, PackWritesAReadableGameFile) {
  const std::string file = (folder_ / "demo.sinew").string();
  const auto result = run({"pack", demo("demo.rig.json"), "--depth", "2", "-o", file});
  ASSERT_EQ(result.status, 0) << result.error;
  EXPECT_EQ(result.error, "");
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_TRUE(result.out.starts_with(file + ": " + std::to_string(bytes.size()) + " bytes, ")) << result.out;
  const auto read = readGameFile(std::as_bytes(std::span(bytes)));
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->rig.smoothing.depth, 2);
  EXPECT_FALSE(read->rig.primitives.empty());
  EXPECT_FALSE(read->character->clips.empty());
}

TEST_F(Program, PackRefusesOnOneLine) {
  EXPECT_EQ(run({"pack", demo("demo.rig.json"), "-o", "demo.glb"}).status, 2);
  EXPECT_EQ(run({"pack", demo("demo.rig.json")}).status, 2);
  const auto noFile = run({"pack", demo("nobody.rig.json"), "-o", "a.sinew"});
  EXPECT_EQ(noFile.status, 1);
  EXPECT_TRUE(noFile.oneErrorLine()) << noFile.error;
  std::ifstream from(demo("demo.rig.json"));
  std::string rig{std::istreambuf_iterator<char>(from), {}};
  const auto bone = rig.find("\"bone\": \"");
  ASSERT_NE(bone, std::string::npos);
  rig.insert(bone + 9, "no such ");
  rig.replace(rig.find("demo.glb"), 8, demo("demo.glb"));
  std::ofstream(folder_ / "other.rig.json") << rig;
  const auto missing = run({"pack", "other.rig.json", "-o", "a.sinew"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_TRUE(missing.oneErrorLine()) << missing.error;
  EXPECT_NE(missing.error.find("no such "), std::string::npos) << missing.error;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.sinew"));
}

}  // namespace
}  // namespace sinew
