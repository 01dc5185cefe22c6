// tests/command/clips_test.cpp: --clips, and rigs that name clip files.
#include <filesystem>
#include <fstream>

#include "core/files/json/json.h"
#include "sinew/character/pose.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "tests/command/program.h"
#include "tests/support/characters/gltf_builder.h"

namespace sinew {
namespace {

using test::Program;

class ClipsOption : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    test::Post still = test::makePost();
    still.file.json.erase("animations");
    std::ofstream(folder_ / "still.glb", std::ios::binary) << still.file.glb();
    test::Post motion = test::makePost();
    for (const char* list : {"meshes", "skins"}) motion.file.json.erase(list);
    for (const char* member : {"mesh", "skin"}) motion.file.json["nodes"][0].erase(member);
    std::ofstream(folder_ / "motion.glb", std::ios::binary) << motion.file.glb();
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
};

TEST_F(ClipsOption, AddsClipsForOneRun) {
  const auto told = run({"inspect", at("still.glb"), "--clips", at("motion.glb")});
  EXPECT_EQ(told.status, 0) << told.error;
  EXPECT_NE(told.out.find("bend"), std::string::npos) << told.out;
  EXPECT_EQ(run({"smooth", at("still.glb"), "--clips", at("motion.glb"), "--clip", "bend", "--time", "0.5", "-o",
                 at("bent.obj")})
                .status,
            0);
  EXPECT_EQ(run({"smooth", at("still.glb"), "--clip", "bend", "-o", at("bent.obj")}).status, 1);
  const auto gone = run({"smooth", at("still.glb"), "--clips", at("gone.glb"), "-o", at("bent.obj")});
  EXPECT_EQ(gone.status, 1);
  EXPECT_NE(gone.error.find("gone.glb"), std::string::npos);
}

TEST_F(ClipsOption, ExportsIncludeTheClips) {
  const auto written =
      run({"export", at("still.glb"), "--clips", at("motion.glb"), "--depth", "1", "-o", at("out.glb")});
  ASSERT_EQ(written.status, 0) << written.error;
  EXPECT_NE(written.out.find("bend"), std::string::npos) << written.out;
  const auto out = importGltf(at("out.glb"));
  ASSERT_TRUE(out.ok()) << out.error().text();
  ASSERT_EQ(out.value()->clips.size(), 1u);
  const auto motion = importClips(at("motion.glb"));
  const Pose own = samplePose(motion.value()->skeleton, motion.value()->clips.front(), 0.7f);
  const Pose played = samplePose(out.value()->skeleton, out.value()->clips.front(), 0.7f);
  const int theirs = motion.value()->skeleton.findBone("knee").value();
  const int ours = out.value()->skeleton.findBone("knee").value();
  EXPECT_EQ(own.boneInWorld.at(static_cast<std::size_t>(theirs)),
            played.boneInWorld.at(static_cast<std::size_t>(ours)));
  EXPECT_EQ(run({"export", at("still.glb"), "--clips", at("motion.glb"), "--depth", "1", "--as", "baked", "--clip",
                 "bend", "-o", at("baked.glb")})
                .status,
            0);
  EXPECT_EQ(run({"export", at("still.glb"), "--clips", at("motion.glb"), "--depth", "1", "-o", at("out.usda")}).status,
            0);
}

TEST_F(ClipsOption, MissingClipFileIsAWarning) {
  Rig rig;
  rig.character = "still.glb";
  rig.clipFiles = {"gone.glb", "motion.glb"};
  ASSERT_TRUE(saveRig(rig, at("a.rig.json")).ok());
  const auto made = run({"smooth", at("a.rig.json"), "--clip", "bend", "--time", "1", "-o", at("bent.obj")});
  EXPECT_EQ(made.status, 0) << made.error;
  EXPECT_NE(made.error.find("its clips are left out"), std::string::npos) << made.error;
  EXPECT_EQ(run({"inspect", at("a.rig.json")}).status, 0);
  EXPECT_EQ(run({"inspect", at("a.rig.json"), "--strict"}).status, 1);
}

TEST_F(ClipsOption, InspectJsonReportsEachClipFile) {
  Rig rig;
  rig.character = "still.glb";
  rig.clipFiles = {"gone.glb", "motion.glb"};
  ASSERT_TRUE(saveRig(rig, at("a.rig.json")).ok());
  const auto told = run({"inspect", at("a.rig.json"), "--json"});
  EXPECT_EQ(told.status, 0) << told.error;
  const auto json = Json::parse(told.out);
  ASSERT_TRUE(json.ok()) << told.out;
  const std::vector<Json>& files = json->at("clip_files").items();
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].at("file").text(""), "gone.glb");
  EXPECT_NE(files[0].at("missing").text("").find("gone.glb"), std::string::npos);
  EXPECT_TRUE(files[0].at("clips").items().empty());
  EXPECT_EQ(files[1].at("file").text(""), "motion.glb");
  EXPECT_TRUE(files[1].at("missing").isNull());
  ASSERT_EQ(files[1].at("clips").items().size(), 1u);
  EXPECT_EQ(files[1].at("clips").items()[0].text(""), "bend");
  for (const char* list : {"unmatched_bones", "unmoved_bones"}) EXPECT_TRUE(files[1].at(list).items().empty()) << list;
}

}  // namespace
}  // namespace sinew
