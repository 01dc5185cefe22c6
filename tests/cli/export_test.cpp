// tests/cli/export_test.cpp: `sinew export` as a program sees it.
#include <algorithm>
#include <fstream>

#include "core/io/json/json.h"
#include "tests/cli/program.h"

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

  /// Nothing but what a test has put there itself.
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

TEST_F(Export, ReportsWhatItWroteInBothForms) {
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
  EXPECT_EQ(json->keys(), (std::vector<std::string>{"file", "as", "mesh", "weights", "joints", "vertices", "triangles",
                                                    "bytes", "error_percent_of_height", "left_out"}));
  const Json& error = json->at("error_percent_of_height");
  EXPECT_EQ(error.keys(), (std::vector<std::string>{"fitted", "held_out", "all_clips", "clips", "further"}));
  EXPECT_EQ(error.at("clips").items().size(), 2U);
  const double ofFiles = static_cast<double>(std::filesystem::file_size(folder_ / "out.gltf") +
                                             std::filesystem::file_size(folder_ / "out.bin"));
  EXPECT_EQ(json->at("bytes").number(0), ofFiles);
  EXPECT_EQ(names(), (std::vector<std::string>{"out.bin", "out.glb", "out.gltf"}));
}

TEST_F(Export, ClipsThatAreNamedAloneAreKept) {
  const Outcome outcome = skinned(demo("demo.rig.json"), "out.glb", {"--clip", "Idle", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(Json::parse(outcome.out)->at("error_percent_of_height").at("clips").items().size(), 1U);
  const auto inspected = Json::parse(run({"inspect", "out.glb", "--json"}).out);
  ASSERT_TRUE(inspected.ok());
  ASSERT_EQ(inspected->at("clips").items().size(), 1U);
  EXPECT_EQ(inspected->at("clips").items()[0].at("name").text(""), "Idle");
}

TEST_F(Export, UnknownClipsAreToldTheKnownOnesAndNothingIsWritten) {
  expectRefused(skinned(demo("demo.rig.json"), "out.glb", {"--clip", "Walk", "--clip", "Wlk"}), 1,
                "clip \"Wlk\": expected one of \"Walk\", \"Idle\"");
  EXPECT_TRUE(names().empty());
}

TEST_F(Export, UnknownWordsAndEndingsAreABadCommandLine) {
  expectRefused(skinned(demo("demo.rig.json"), "out.fbx"), 2, ".glb or .gltf");
  expectRefused(run({"export", demo("demo.rig.json"), "--as", "helpers", "-o", "out.glb"}), 2, "skinned");
  expectRefused(run({"export", demo("demo.rig.json"), "-o", "out.glb"}), 2, "--as");
  expectRefused(skinned(demo("demo.rig.json"), "out.glb", {"--weights", "mine"}), 2, "mine");
  EXPECT_TRUE(names().empty());
}

TEST_F(Export, PlacesThatCannotBeWrittenAreStatus1AndLeaveNothing) {
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

TEST_F(Export, AFolderThatIsReadOnlyStaysEmpty) {
  std::filesystem::create_directory(folder_ / "locked");
  std::filesystem::permissions(folder_ / "locked",
                               std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  if (std::ofstream(folder_ / "locked" / "probe").good()) GTEST_SKIP() << "this user may write everywhere";
  expectRefused(skinned(demo("demo.rig.json"), "locked/out.glb"), 1, "locked/out.glb: cannot be written: ");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "locked"));
}

TEST_F(Export, WhatIsReadIsNotOverwritten) {
  ASSERT_EQ(skinned(demo("demo.glb"), "own.gltf", {"--depth", "1", "--weights", "transferred"}).status, 0);
  const std::string text = readWholeFile(folder_ / "own.gltf", 1 << 26).value();
  const std::string binary = readWholeFile(folder_ / "own.bin", 1 << 26).value();
  expectRefused(skinned("own.gltf", "./own.gltf"), 2, "is the input");
  // Another name, but the buffer beside it is the one that is read.
  std::filesystem::rename(folder_ / "own.gltf", folder_ / "other.gltf");
  expectRefused(skinned("other.gltf", "own.gltf"), 1, "own.bin: cannot be written: the character is read from it");
  EXPECT_EQ(readWholeFile(folder_ / "other.gltf", 1 << 26).value(), text);
  EXPECT_EQ(readWholeFile(folder_ / "own.bin", 1 << 26).value(), binary);
}

}  // namespace
}  // namespace sinew
