// tests/files/clip_files_test.cpp: files without a mesh, and characters with clips of other files.
#include "core/files/clip_files.h"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

#include "sinew/character/pose.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

class ClipFiles : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  /// The post's file without mesh and skin, or without clips.
  static std::string motionOnly() {
    test::Post post = test::makePost();
    post.file.json.erase("meshes");
    post.file.json.erase("skins");
    post.file.json["nodes"][0].erase("mesh");
    post.file.json["nodes"][0].erase("skin");
    return post.file.glb();
  }
  static std::string still() {
    test::Post post = test::makePost();
    post.file.json.erase("animations");
    return post.file.glb();
  }

  const test::TemporaryFolder own_;
  const std::filesystem::path folder_ = own_.path();
};

TEST_F(ClipFiles, ClipFromAFileWithoutMeshPlaysBitForBit) {
  const auto whole = importGltf(write("whole.glb", test::makePost().file.glb()));
  ASSERT_TRUE(whole.ok()) << whole.error().text();
  write("motion.glb", motionOnly());
  const auto character = importGltf(write("still.glb", still()));
  ASSERT_TRUE(character.ok()) << character.error().text();
  Rig rig;
  rig.clipFiles = {"motion.glb"};
  const WithClipFiles with = withClipFiles(character.value(), rig, folder_);
  EXPECT_TRUE(missingOf(with.files).empty()) << missingOf(with.files).front().text();
  EXPECT_TRUE(notesOf(with.files).empty()) << notesOf(with.files).front();
  ASSERT_EQ(with.character->clips.size(), 1u);
  const AnimationClip& clip = with.character->clips.front();
  EXPECT_EQ(clip.name, whole.value()->clips.front().name);
  EXPECT_EQ(clip.addedFrom, "motion.glb");
  for (const float time : {0.0f, 0.3f, 0.99f, 1.0f}) {
    EXPECT_EQ(samplePose(with.character->skeleton, clip, time),
              samplePose(whole.value()->skeleton, whole.value()->clips.front(), time));
  }
  // Loading again replaces the added clips; without the entry they are removed.
  EXPECT_EQ(withClipFiles(with.character, rig, folder_).character->clips.size(), 1u);
  EXPECT_TRUE(withClipFiles(with.character, Rig{}, folder_).character->clips.empty());
}

TEST_F(ClipFiles, MissingFileDoesNotAffectOthers) {
  write("motion.glb", motionOnly());
  const auto character = importGltf(write("still.glb", still()));
  Rig rig;
  rig.clipFiles = {"gone.glb", "motion.glb", "still.glb"};
  const WithClipFiles with = withClipFiles(character.value(), rig, folder_);
  EXPECT_EQ(with.character->clips.size(), 1u);
  const std::vector<Error> missing = missingOf(with.files);
  ASSERT_EQ(missing.size(), 2u);
  EXPECT_NE(missing[0].file.find("gone.glb"), std::string::npos);
  EXPECT_NE(missing[1].text().find("no clips"), std::string::npos) << missing[1].text();
}

TEST_F(ClipFiles, BadFilesAreRefusedOnOneLine) {
  std::string cut = motionOnly();
  cut.resize(cut.size() / 2);
  for (const std::string& bytes : {std::string("nonsense"), std::string(), cut}) {
    const auto read = importClips(write("bad.glb", bytes));
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().text().find('\n'), std::string::npos);
  }
}

TEST_F(ClipFiles, AreStoredInTheRig) {
  Rig rig;
  rig.character = "a.glb";
  EXPECT_EQ(rigToJson(rig).find("clips"), std::string::npos);
  rig.clipFiles = {"walk.glb", "../motions/run.glb"};
  const auto read = rigFromJson(rigToJson(rig));
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read.value(), rig);
  rig.clipFiles = {"walk.glb", "walk.glb"};
  EXPECT_FALSE(rigFromJson(rigToJson(rig)).ok());
  rig.clipFiles = {""};
  EXPECT_FALSE(rigFromJson(rigToJson(rig)).ok());
}

TEST_F(ClipFiles, PathsFollowTheRig) {
  std::filesystem::create_directories(folder_ / "rigs");
  const auto names = clipFilesFor(folder_ / "rigs" / "a.rig.json", {"walk.glb", "/far/run.glb"}, folder_);
  EXPECT_EQ(names, (std::vector<std::string>{"../walk.glb", "/far/run.glb"}));
}

}  // namespace
}  // namespace sinew
