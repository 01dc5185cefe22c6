// tests/command/export_test.cpp: `sinew export` run as a process.
#include <algorithm>
#include <fstream>

#include "core/files/json/json.h"
#include "tests/command/program.h"

namespace sinew {
namespace {

using test::Outcome;
using test::Program;

class Export : public Program {
 protected:
  [[nodiscard]] Outcome skinned(const std::string& file, const std::string& out,
                                std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"export", file, "--as", "skinned", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// Files in the folder, except for what the test put there.
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
      result.push_back(entry.path().filename().string());
    }
    std::ranges::sort(result);
    return result;
  }

  void expectRefused(const Outcome& outcome, int status, const std::string& words) const {
    EXPECT_EQ(outcome.status, status) << outcome.error;
    EXPECT_TRUE(outcome.oneErrorLine()) << outcome.error;
    EXPECT_NE(outcome.error.find(words), std::string::npos) << outcome.error;
    EXPECT_EQ(outcome.out, "");
  }
};

TEST_F(Export, ReportsProgressOnlyOnRequest) {
  const std::vector<std::string> all{"--depth", "1", "--clip", "Idle"};
  const Outcome quiet = skinned(demo("demo.rig.json"), "quiet.glb", all);
  ASSERT_EQ(quiet.status, 0) << quiet.error;
  EXPECT_EQ(quiet.error, "");
  std::vector<std::string> asked = all;
  asked.emplace_back("--progress");
  const Outcome told = skinned(demo("demo.rig.json"), "told.glb", asked);
  ASSERT_EQ(told.status, 0) << told.error;
  EXPECT_TRUE(told.error.starts_with("sinew: exporting told.glb: 0 %\n")) << told.error;
  EXPECT_TRUE(told.error.ends_with("\nsinew: exporting told.glb: 100 %\n")) << told.error;
  EXPECT_EQ(told.error.find('\r'), std::string::npos) << "lines stay where there is no terminal";
  EXPECT_GE(std::ranges::count(told.error, '\n'), 5);
  EXPECT_LE(std::ranges::count(told.error, '\n'), 21);
  EXPECT_EQ(readWholeFile(folder_ / "told.glb", 1 << 28).value(),
            readWholeFile(folder_ / "quiet.glb", 1 << 28).value());
  const Outcome points = run({"export", demo("demo.rig.json"), "--as", "baked", "--clip", "Idle", "--depth", "1", "-o",
                              "points.pc2", "--progress"});
  EXPECT_TRUE(points.error.ends_with("\nsinew: exporting points.pc2: 100 %\n")) << points.error;
}

/// `script` provides a terminal.
TEST_F(Export, ProgressOverwritesOneTerminalLine) {
  if (std::system("script --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no script (bsdutils)";
  const std::string command = quoted(SINEW_PROGRAM) + " export " + quoted(demo("demo.rig.json")) +
                              " --as skinned --depth 1 --clip Idle -o out.glb >report";
  const Outcome outcome = run({"-qefc", command, "/dev/null"}, "script");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.error;
  EXPECT_NE(outcome.out.find("\rsinew: exporting out.glb: 0 %\rsinew: "), std::string::npos) << outcome.out;
  EXPECT_TRUE(outcome.out.ends_with("\rsinew: exporting out.glb: 100 %\r\n")) << outcome.out;
}

TEST_F(Export, ReportsAsTextAndJson) {
  const Outcome plain = skinned(demo("demo.rig.json"), "out.glb");
  ASSERT_EQ(plain.status, 0) << plain.error;
  EXPECT_TRUE(plain.out.starts_with("out.glb\n  refined mesh, refitted weights: ")) << plain.out;
  for (const char* row : {"\"Walk\"", "\"Idle\"", "all clips", "(Range of motion)", "fitted poses", "held-out poses"}) {
    EXPECT_NE(plain.out.find(row), std::string::npos) << row;
  }
  const Outcome outcome = skinned(demo("demo.rig.json"), "out.gltf", {"--json", "--depth", "2"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const auto json = Json::parse(outcome.out);
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->keys(),
            (std::vector<std::string>{"file", "as", "mesh", "weights", "joints", "line_joints", "rigid_helpers",
                                      "vertices", "triangles", "bytes", "error_percent_of_height", "left_out"}));
  const Json& error = json->at("error_percent_of_height");
  EXPECT_EQ(error.keys(),
            (std::vector<std::string>{"fitted", "held_out", "all_clips", "between_keys", "clips", "further"}));
  EXPECT_EQ(error.at("clips").items().size(), 2U);
  const double ofFiles = static_cast<double>(std::filesystem::file_size(folder_ / "out.gltf") +
                                             std::filesystem::file_size(folder_ / "out.bin"));
  EXPECT_EQ(json->at("bytes").number(0), ofFiles);
  EXPECT_EQ(names(), (std::vector<std::string>{"out.bin", "out.glb", "out.gltf"}));
}

TEST_F(Export, OnlyNamedClipsAreKept) {
  const Outcome outcome = skinned(demo("demo.rig.json"), "out.glb", {"--clip", "Idle", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(Json::parse(outcome.out)->at("error_percent_of_height").at("clips").items().size(), 1U);
  const auto inspected = Json::parse(run({"inspect", "out.glb", "--json"}).out);
  ASSERT_TRUE(inspected.ok());
  ASSERT_EQ(inspected->at("clips").items().size(), 1U);
  EXPECT_EQ(inspected->at("clips").items()[0].at("name").text(""), "Idle");
}

TEST_F(Export, UnknownClipListsTheKnownOnesAndWritesNothing) {
  expectRefused(skinned(demo("demo.rig.json"), "out.glb", {"--clip", "Walk", "--clip", "Wlk"}), 1,
                "clip \"Wlk\": expected one of \"Walk\", \"Idle\"");
  EXPECT_TRUE(names().empty());
}

TEST_F(Export, UnknownOptionsAndExtensionsAreBadCommandLines) {
  expectRefused(skinned(demo("demo.rig.json"), "out.fbx"), 2, ".glb, .gltf or .usda");
  expectRefused(run({"export", demo("demo.rig.json"), "--as", "fur", "-o", "out.glb"}), 2, "skinned");
  expectRefused(skinned(demo("demo.rig.json"), "out.glb", {"--weights", "mine"}), 2, "mine");
  EXPECT_TRUE(names().empty());
}

TEST_F(Export, OptionsOfAnotherKindAreBadCommandLines) {
  const std::string rig = demo("demo.rig.json");
  const auto refused = [&](std::vector<std::string> more, const std::string& words) {
    more.insert(more.begin(), {"export", rig});
    expectRefused(run(more), 2, words);
  };
  refused({"--as", "skinned", "-o", "out.pc2"}, ".glb, .gltf or .usda");
  refused({"--as", "skinned", "-o", "out.glb", "--fps", "24"}, "--fps: is for --as baked alone");
  refused({"--as", "skinned", "-o", "out.glb", "--bound", "1"}, "--bound: is for --as baked alone");
  refused({"--as", "skinned", "-o", "out.glb", "--joints", "3"}, "--joints: is for --as helpers alone");
  refused({"--as", "baked", "-o", "out.glb", "--clip", "Walk", "--joint-scale", "none"}, "--joint-scale: is for --as");
  refused({"--as", "baked", "-o", "out.glb", "--clip", "Walk", "--mesh", "original"}, "--mesh original: is for");
  refused({"--as", "baked", "-o", "out.fbx", "--clip", "Walk"}, ".glb, .gltf, .usda, .pc2 or .mdd");
  refused({"--as", "baked", "-o", "out.mdd", "--clip", "Walk", "--bound", "1"}, "--bound: is for .glb and .gltf alone");
  refused({"--as", "baked", "-o", "out.usda", "--clip", "Walk", "--bound", "1"}, "--bound: is for .glb and .gltf");
  refused({"--as", "baked", "-o", "out.pc2", "--clip", "Walk", "--weights", "refitted"}, "--weights: is for .glb");
  refused({"-o", "out.glb", "--weights", "transferred"},
          "--weights transferred: is for --as skinned and --as baked alone");
  refused({"--as", "baked", "-o", "out.glb"}, "--clip: expected one clip");
  refused({"--as", "baked", "-o", "out.glb", "--clip", "Walk", "--clip", "Idle"}, "--clip: expected one clip");
  refused({"--as", "baked", "-o", "out.glb", "--clip", "Walk", "--bound", "0"}, "--bound");
  refused({"--as", "baked", "-o", "out.glb", "--clip", "Walk", "--bound", "nan"}, "--bound");
  refused({"--as", "baked", "-o", "out.glb", "--clip", "Walk", "--fps", "-1"}, "--fps");
  EXPECT_TRUE(names().empty());
}

TEST_F(Export, BakesAClipAndReportsAsTextAndJson) {
  const auto baked = [&](const std::string& out, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"export", demo("demo.rig.json"), "--as", "baked", "--clip", "Walk", "-o", out});
    return run(more);
  };
  const Outcome plain = baked("out.glb");
  ASSERT_EQ(plain.status, 0) << plain.error;
  for (const char* row : {"out.glb\n  \"Walk\": ", " targets, ", "joints alone", "baked", "bound"}) {
    EXPECT_NE(plain.out.find(row), std::string::npos) << row << " in " << plain.out;
  }
  const auto json = Json::parse(baked("out.gltf", {"--json", "--bound", "0.5", "--fps", "12"}).out);
  ASSERT_TRUE(json.ok());
  EXPECT_EQ(json->keys(), (std::vector<std::string>{"file", "as", "clip", "fps", "frames", "substeps", "weights",
                                                    "bound", "targets", "joints", "vertices", "triangles", "bytes",
                                                    "error_percent_of_height", "left_out"}));
  EXPECT_EQ(json->at("bound").number(0.0), 0.5);
  EXPECT_EQ(json->at("fps").number(0.0), 12.0);
  EXPECT_LE(json->at("error_percent_of_height").at("baked").at("max").number(9.0), 0.5);
  const auto cache = Json::parse(baked("cache.pc2", {"--json"}).out);
  ASSERT_TRUE(cache.ok());
  EXPECT_EQ(cache->keys(), (std::vector<std::string>{"file", "as", "clip", "fps", "frames", "vertices", "triangles",
                                                     "bytes", "left_out"}));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "cache.obj"));
  double ofFiles = 0.0;
  for (const std::string& name : names()) {
    if (name.starts_with("cache")) ofFiles += static_cast<double>(std::filesystem::file_size(folder_ / name));
  }
  EXPECT_EQ(cache->at("bytes").number(0.0), ofFiles);
  EXPECT_EQ(baked("motion.mdd").status, 0);
  const auto stage = Json::parse(baked("stage.usda", {"--json", "--fps", "7"}).out);
  ASSERT_TRUE(stage.ok());
  EXPECT_EQ(stage->keys(), cache->keys());
  EXPECT_EQ(stage->at("triangles").number(0.0), cache->at("triangles").number(1.0));
  EXPECT_GE(stage->at("bytes").number(0.0), static_cast<double>(std::filesystem::file_size(folder_ / "stage.usda")));
  expectRefused(run({"export", demo("demo.rig.json"), "--as", "baked", "--clip", "Wlk", "-o", "other.glb"}), 1,
                "clip \"Wlk\": expected one of \"Walk\", \"Idle\"");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "other.glb"));
}

TEST_F(Export, ListsAreBakedInShardsAndResumed) {
  std::ofstream(folder_ / "list.txt") << demo("demo.rig.json") << '\n' << demo("humanoid.rig.json") << '\n';
  const auto baked = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"export", "--list", "list.txt", "--as", "baked", "--clip", "Walk", "--fps", "5",
                               "--depth", "1", "-o", "{name}.mdd"});
    return run(more);
  };
  EXPECT_EQ(baked({"--dry-run"}).out, "demo.mdd\nhumanoid.mdd\n");
  EXPECT_EQ(names(), (std::vector<std::string>{"list.txt"}));
  ASSERT_EQ(baked({"--shard", "1/2"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "humanoid.obj"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "demo.mdd"));
  const Outcome rest = baked({"--resume"});
  ASSERT_EQ(rest.status, 0) << rest.error;
  EXPECT_TRUE(rest.out.starts_with("demo.mdd\n"));
  EXPECT_EQ(rest.out.find("humanoid"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "demo.obj"));
}

TEST_F(Export, UnwritableBakedOutputIsStatus1AndLeavesNothing) {
  std::filesystem::create_directory(folder_ / "one.obj");
  std::filesystem::create_directory(folder_ / "two.pc2");
  std::filesystem::create_directory(folder_ / "three.mtl");
  std::filesystem::create_symlink("/dev/full", folder_ / "full.mdd");
  const auto before = names();
  const auto refused = [&](const std::string& out, const std::string& words) {
    expectRefused(run({"export", demo("demo.rig.json"), "--as", "baked", "--clip", "Idle", "-o", out}), 1, words);
  };
  refused("one.mdd", "one.obj: cannot be written: it is a folder");
  refused("two.pc2", "two.pc2: cannot be written: it is a folder");
  refused("three.pc2", "three.mtl: cannot be written: it is a folder");
  refused("full.mdd", "full.mdd: cannot be written: ");
  refused("absent/out.pc2", "absent/out.pc2: cannot be written: there is no such folder");
  EXPECT_EQ(names(), before);
}

TEST_F(Export, UnwritableOutputIsStatus1AndLeavesNothing) {
  std::filesystem::create_directory(folder_ / "folder.glb");
  std::filesystem::create_directory(folder_ / "other.bin");
  std::filesystem::create_symlink("/dev/full", folder_ / "full.glb");
  std::filesystem::create_symlink("/dev/full", folder_ / "half.bin");
  const auto before = names();
  const std::string rig = demo("demo.rig.json");
  expectRefused(skinned(rig, "folder.glb"), 1, "folder.glb: cannot be written: it is a folder");
  expectRefused(skinned(rig, "other.gltf"), 1, "other.bin: cannot be written: it is a folder");
  expectRefused(skinned(rig, "full.glb"), 1, "full.glb: cannot be written: ");
  expectRefused(skinned(rig, "half.gltf"), 1, "half.bin: cannot be written: ");
  expectRefused(skinned(rig, "absent/out.glb"), 1, "absent/out.glb: cannot be written: there is no such folder");
  EXPECT_EQ(names(), before);
}

TEST_F(Export, UsdStageIsWrittenWholeOrNotAtAll) {
  const std::vector<std::string> quickly{"--depth", "1", "--weights", "transferred"};
  ASSERT_EQ(skinned(demo("demo.rig.json"), "Out.USDA", quickly).status, 0);
  const auto whole = names();
  ASSERT_EQ(whole, (std::vector<std::string>{"Out.USDA", "Out_0.png"}));
  const std::string text = readWholeFile(folder_ / "Out.USDA", 1 << 26).value();
  EXPECT_TRUE(text.starts_with("#usda 1.0\n"));
  EXPECT_NE(text.find("@Out_0.png@"), std::string::npos);
  for (const char* name : {"Out.USDA", "Out_0.png"}) std::filesystem::remove(folder_ / name);

  std::filesystem::create_directory(folder_ / "folder.usda");
  std::filesystem::create_directory(folder_ / "a_0.png");
  std::filesystem::create_symlink("/dev/full", folder_ / "full.usda");
  std::filesystem::create_symlink("/dev/full", folder_ / "b_0.png");
  const auto before = names();
  const std::string rig = demo("demo.rig.json");
  expectRefused(skinned(rig, "folder.usda", quickly), 1, "folder.usda: cannot be written: it is a folder");
  expectRefused(skinned(rig, "a.usda", quickly), 1, "a_0.png: cannot be written: it is a folder");
  expectRefused(skinned(rig, "full.usda", quickly), 1, "full.usda: cannot be written: ");
  expectRefused(skinned(rig, "b.usda", quickly), 1, "b_0.png: cannot be written: ");
  expectRefused(skinned(rig, "absent/out.usda", quickly), 1, "absent/out.usda: cannot be written: there is no such");
  EXPECT_EQ(names(), before);
}

TEST_F(Export, InputTextureIsNotOverwritten) {
  // The source's image lies where the export would write its own.
  ASSERT_EQ(skinned(demo("demo.rig.json"), "a.usda", {"--depth", "1", "--weights", "transferred"}).status, 0);
  ASSERT_EQ(skinned(demo("demo.glb"), "own.gltf", {"--depth", "1", "--weights", "transferred"}).status, 0);
  auto root = Json::parse(readWholeFile(folder_ / "own.gltf", 1 << 26).value());
  ASSERT_TRUE(root.ok());
  root.value().set("images", Json::array({Json::object().set("uri", "a_0.png")}));
  std::ofstream(folder_ / "own.gltf") << root->dump();
  std::filesystem::remove(folder_ / "a.usda");
  const std::string image = readWholeFile(folder_ / "a_0.png", 1 << 26).value();
  expectRefused(skinned("own.gltf", "a.usda"), 1, "a_0.png: cannot be written: the character is read from it");
  EXPECT_EQ(readWholeFile(folder_ / "a_0.png", 1 << 26).value(), image);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.usda"));
}

TEST_F(Export, ReadOnlyFolderStaysEmpty) {
  std::filesystem::create_directory(folder_ / "locked");
  std::filesystem::permissions(folder_ / "locked",
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  if (std::ofstream(folder_ / "locked" / "probe").good()) GTEST_SKIP() << "this user may write everywhere";
  expectRefused(skinned(demo("demo.rig.json"), "locked/out.glb"), 1, "locked/out.glb: cannot be written: ");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "locked"));
}

TEST_F(Export, InputIsNotOverwritten) {
  ASSERT_EQ(skinned(demo("demo.glb"), "own.gltf", {"--depth", "1", "--weights", "transferred"}).status, 0);
  const std::string text = readWholeFile(folder_ / "own.gltf", 1 << 26).value();
  const std::string binary = readWholeFile(folder_ / "own.bin", 1 << 26).value();
  expectRefused(skinned("own.gltf", "./own.gltf"), 2, "is the input");
  // The name differs, but the buffer next to it is the one that is read.
  std::filesystem::rename(folder_ / "own.gltf", folder_ / "other.gltf");
  expectRefused(skinned("other.gltf", "own.gltf"), 1, "own.bin: cannot be written: the character is read from it");
  EXPECT_EQ(readWholeFile(folder_ / "other.gltf", 1 << 26).value(), text);
  EXPECT_EQ(readWholeFile(folder_ / "own.bin", 1 << 26).value(), binary);
}

}  // namespace
}  // namespace sinew
