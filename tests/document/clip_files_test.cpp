// tests/document/clip_files_test.cpp: documents whose rig names clip files: opened, saved elsewhere, reopened.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "app/document/document.h"
#include "app/document/recovery.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class ClipDocument : public testing::Test {
 protected:
  void SetUp() override {
    test::Post still = test::makePost();
    still.file.json.erase("animations");
    std::ofstream(folder_ / "still.glb", std::ios::binary) << still.file.glb();
    fs::create_directories(folder_ / "clips");
    test::Post motion = test::makePost();
    for (const char* list : {"meshes", "skins"}) motion.file.json.erase(list);
    for (const char* member : {"mesh", "skin"}) motion.file.json["nodes"][0].erase(member);
    std::ofstream(folder_ / "clips" / "motion.glb", std::ios::binary) << motion.file.glb();
  }

  const test::TemporaryFolder own_;
  const fs::path folder_ = own_.path();
};

TEST_F(ClipDocument, KeepsItsClipsWhenSavedElsewhere) {
  Result<Document> opened = openDocument(folder_ / "still.glb", {folder_ / "clips" / "motion.glb"});
  ASSERT_TRUE(opened.ok()) << opened.error().text();
  ASSERT_EQ(opened->character->clips.size(), 1u);
  EXPECT_TRUE(opened->commands.modified());
  Rig relative = opened->rig();
  relative.clipFiles = {"clips/motion.glb"};
  opened.value().commands.apply("Relative", relative);
  fs::create_directories(folder_ / "a" / "b");
  for (const fs::path& file : {folder_ / "first.rig.json", folder_ / "a" / "b" / "second.rig.json"}) {
    ASSERT_TRUE(saveDocument(opened.value(), file).ok());
    const Result<Document> again = openDocument(file);
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_TRUE(missingOf(again->clipFiles.files).empty());
    ASSERT_EQ(again->character->clips.size(), 1u) << file;
    EXPECT_FALSE(again->commands.modified());
  }
  EXPECT_EQ(loadRig(folder_ / "a" / "b" / "second.rig.json")->clipFiles,
            std::vector<std::string>{"../../clips/motion.glb"});
}

TEST_F(ClipDocument, OpensWithoutAMissingClipFileAndKeepsTheEntry) {
  Rig rig;
  rig.character = "still.glb";
  rig.clipFiles = {"clips/motion.glb"};
  ASSERT_TRUE(saveRig(rig, folder_ / "a.rig.json").ok());
  fs::remove(folder_ / "clips" / "motion.glb");
  Result<Document> opened = openDocument(folder_ / "a.rig.json");
  ASSERT_TRUE(opened.ok()) << opened.error().text();
  EXPECT_TRUE(opened->character->clips.empty());
  ASSERT_EQ(missingOf(opened->clipFiles.files).size(), 1u);
  ASSERT_TRUE(saveDocument(opened.value(), folder_ / "a.rig.json").ok());
  EXPECT_EQ(loadRig(folder_ / "a.rig.json")->clipFiles, rig.clipFiles);
  EXPECT_FALSE(openDocument(folder_ / "still.glb", {folder_ / "clips" / "motion.glb"}).ok());
}

TEST_F(ClipDocument, IsRecoveredWithItsClips) {
  Result<Document> opened = openDocument(folder_ / "still.glb", {folder_ / "clips" / "motion.glb"});
  ASSERT_TRUE(opened.ok());
  const fs::path folder = folder_ / "recovery";
  {
    Result<RecoveryFile> recovery = RecoveryFile::claim(folder);
    ASSERT_TRUE(recovery.ok());
    ASSERT_TRUE(recovery.value().write(opened.value()).ok());
  }
  const std::vector<LeftBehind> left = findLeftBehind(folder);
  ASSERT_EQ(left.size(), 1u);
  const Result<Document> again = recoverDocument(left.front());
  ASSERT_TRUE(again.ok()) << again.error().text();
  EXPECT_EQ(again->character->clips.size(), 1u);
}

}  // namespace
}  // namespace sinew::app
