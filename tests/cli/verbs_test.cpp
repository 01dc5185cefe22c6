// tests/cli/verbs_test.cpp: help, version, and what a wrong command line gets.
#include "tests/cli/program.h"

namespace sinew {
namespace {

using test::Program;

TEST_F(Program, VersionAndHelpGoToStdout) {
  const auto version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(version.out.starts_with("sinew ")) << version.out;
  EXPECT_EQ(version.error, "");
  const auto help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.error, "");
  for (const char* verb : {"edit", "inspect", "smooth", "render"}) {
    EXPECT_NE(help.out.find(verb), std::string::npos) << verb;
    const auto own = run({verb, "--help"});
    EXPECT_EQ(own.status, 0) << verb;
    EXPECT_NE(own.out.find(std::string("sinew ") + verb), std::string::npos) << own.out;
  }
}

TEST_F(Program, AWrongCommandLineIsStatus2AndOneLine) {
  const std::vector<std::vector<std::string>> wrong{
      {"inspect"},
      {"inspect", demo("demo.glb"), "surplus"},
      {"inspect", demo("demo.glb"), "--jsn"},
      {"inspct", demo("demo.glb")},
      {"inspekt"},
      {"edit", "--log-state"},
      {"smooth", demo("demo.glb")},
      {"smooth", "-o", "x.obj"},
      {"smooth", demo("demo.glb"), "-o", "x.stl"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--depth", "0"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--depth", "17"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--depth", "2.5"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--mode", "melt"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--patch", "PN2"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--projection", "magic"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--time", "1"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--clip", "Walk", "--time", "nan"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--clip", "Walk", "--time", "inf"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--clip", "Walk", "--time", "-1"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--clip", "Walk", "--time", "1s"},
      {"smooth", demo("demo.glb"), "-o", "x.obj", "--clip", "Walk", "--time", "1e999"}};
  for (const auto& arguments : wrong) {
    const auto result = run(arguments);
    const std::string told = ::testing::PrintToString(arguments) + '\n' + result.error;
    EXPECT_EQ(result.status, 2) << told;
    EXPECT_TRUE(result.oneErrorLine()) << told;
    EXPECT_EQ(result.out, "") << told;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "x.obj")) << told;
  }
}

}  // namespace
}  // namespace sinew
