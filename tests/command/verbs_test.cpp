// tests/command/verbs_test.cpp: help, version, and errors of wrong command lines.
#include <cstdlib>

#include "tests/command/program.h"
#include "tests/support/characters/gltf_builder.h"

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

TEST_F(Program, BadCommandLineIsStatus2AndOneLine) {
  const std::vector<std::vector<std::string>> wrong{
      {"inspect"},
      {"smooth", demo("demo.glb"), "surplus", "-o", "x.obj"},
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

TEST_F(Program, MisspelledNamesGetASuggestion) {
  const auto expectMeant = [&](const std::vector<std::string>& arguments, int status, const std::string& words) {
    const auto result = run(arguments);
    EXPECT_EQ(result.status, status) << result.error;
    EXPECT_TRUE(result.oneErrorLine()) << result.error;
    EXPECT_NE(result.error.find(words), std::string::npos) << result.error;
  };
  const std::string rig = demo("demo.rig.json");
  expectMeant({"inspekt"}, 2, "\"inspekt\" is neither a verb nor a file; did you mean \"inspect\"?");
  expectMeant({"inspect", rig, "--jsn"}, 2, "there is no option --jsn; did you mean \"--json\"?");
  expectMeant({"smooth", rig, "-o", "x.obj", "--dephth=3"}, 2, "no option --dephth; did you mean \"--depth\"?");
  expectMeant({"smooth", rig, "--ouput", "x.obj"}, 2, "there is no option --ouput; did you mean \"--output\"?");
  expectMeant({"smooth", rig, "-o", "x.obj", "--wobble"}, 2, "there is no option --wobble (see");
  expectMeant({"farm", "smoth", rig, "--to", "slurm"}, 2, "did you mean \"smooth\"?");
  expectMeant({"farm", "smooth", rig, "-o", "x.obj", "--to", "slurm", "--clp", "Walk"}, 2, "did you mean \"--clip\"?");
  expectMeant({"smooth", rig, "-o", "x.obj", "--clip", "wlak"}, 1, "; did you mean \"Walk\"?");
  expectMeant({"render", rig, "-o", "x.png", "--clip", "range of motion"}, 1, "; did you mean \"Range of motion\"?");
  expectMeant({"export", rig, "-o", "x.glb", "--clip", "idel"}, 1, "; did you mean \"Idle\"?");
}

TEST_F(Program, CharacterWithoutClipsIsRefusedWithTheSameMessage) {
  test::Post post = test::makePost();
  post.file.json.erase("animations");
  ASSERT_TRUE(writeFileAtomically(folder_ / "still.glb", post.file.glb()).ok());
  const std::vector<std::vector<std::string>> all{
      {"smooth", "still.glb", "--clip", "Walk", "-o", "x.obj"},
      {"render", "still.glb", "--time", "1", "-o", "x.png"},
      {"render", "still.glb", "--clip", "Walk", "-o", "x.png"},
      {"export", "still.glb", "--clip", "Walk", "-o", "x.glb"},
      {"export", "still.glb", "--as", "baked", "--clip", "Walk", "-o", "x.pc2"}};
  for (const auto& arguments : all) {
    const auto result = run(arguments);
    EXPECT_EQ(result.status, 1) << result.error;
    EXPECT_TRUE(result.oneErrorLine()) << result.error;
    EXPECT_TRUE(result.error.ends_with(": the character has no clips\n")) << result.error;
  }
}

TEST_F(Program, VerbsReportProgressOnRequest) {
  const std::string rig = demo("demo.rig.json");
  const std::vector<std::string> smooth{"smooth", rig,       "--clip", "Walk", "--frames",
                                        "0:3",    "--depth", "1",      "-o",   "f_%d.ply"};
  EXPECT_EQ(run(smooth).error, "");
  std::vector<std::string> told = smooth;
  told.emplace_back("--progress");
  const auto result = run(told);
  EXPECT_EQ(result.error,
            "sinew: smoothing f_%d.ply: 0 %\nsinew: smoothing f_%d.ply: 25 %\nsinew: smoothing f_%d.ply: 50 %\n"
            "sinew: smoothing f_%d.ply: 75 %\nsinew: smoothing f_%d.ply: 100 %\n");
  EXPECT_EQ(result.out, "f_0.ply\nf_1.ply\nf_2.ply\nf_3.ply\n");
}

TEST_F(Program, ProgressOverwritesOneTerminalLine) {
  const std::string command = "script -qec \"'" + std::string(SINEW_PROGRAM) + "' smooth '" + demo("demo.rig.json") +
                              "' --clip Walk --frames 34:36 --depth 1 -o f_%d.ply\" /dev/null > terminal </dev/null";
  if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "left out: script is not installed";
  ASSERT_EQ(std::system(("cd '" + folder_.string() + "' && " + command).c_str()), 0);
  const std::string seen = readWholeFile(folder_ / "terminal", 1 << 20).value();
  EXPECT_NE(seen.find("\rsinew: smoothing f_%d.ply: 0 %"), std::string::npos) << seen;
  EXPECT_NE(seen.find("\r\033[Kf_34.ply\r\n"), std::string::npos) << "a result takes the line's place\n" << seen;
  EXPECT_NE(seen.find("\rsinew: smoothing f_%d.ply: 100 %\r\n"), std::string::npos) << seen;
}

TEST_F(Program, ThreadCountDoesNotChangeTheOutput) {
  for (const char* threads : {"1", "3"}) {
    ASSERT_EQ(run({"smooth", demo("humanoid.rig.json"), "--depth", "6", "--threads", threads, "-o",
                   std::string(threads) + ".ply"})
                  .status,
              0);
  }
  EXPECT_EQ(readWholeFile(folder_ / "1.ply", 1 << 28).value(), readWholeFile(folder_ / "3.ply", 1 << 28).value());
  for (const char* verb : {"smooth", "render"}) {
    const std::string out = std::string("x.") + (std::string(verb) == "smooth" ? "obj" : "png");
    for (const char* wrong : {"0", "-1", "many"}) {
      EXPECT_EQ(run({verb, demo("demo.glb"), "-o", out, "--threads", wrong}).status, 2) << verb << wrong;
    }
  }
}

}  // namespace
}  // namespace sinew
