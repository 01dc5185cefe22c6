// tests/editor/opening_test.cpp: opening a character made elsewhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/editor/commands.h"
#include "app/editor/open_file.h"
#include "app/editor/outliner.h"
#include "app/editor/pose_commands.h"
#include "app/editor/visibility_commands.h"
#include "app/viewport/render/picking.h"
#include "core/files/disk/atomic_file.h"
#include "core/rig/motion_clip.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr int kHip = 0, kKnee = 1, kTarget = 2, kPole = 3, kEnd = 4;  ///< Bones of the post.

/// The post with three joints without skin: a target with a pole, and the knee's end.
test::Post postWithHelpers() {
  test::Post post = test::makePost();
  auto& json = post.file.json;
  json["nodes"][1]["children"] = {2, 3};
  json["nodes"][2]["children"] = {5};
  json["nodes"].push_back({{"name", "ik_target"}, {"translation", {3, 0, 0}}, {"children", {4}}});
  json["nodes"].push_back({{"name", "pole"}, {"translation", {1, 0, 0}}});
  json["nodes"].push_back({{"name", "knee_end"}, {"translation", {0, 1, 0}}});
  std::vector<float> inverseBinds(80, 0.0f);
  const float places[5][3] = {{0, 0, 0}, {0, 1, 0}, {3, 0, 0}, {4, 0, 0}, {0, 2, 0}};
  for (std::size_t joint = 0; joint < 5; ++joint) {
    for (std::size_t i = 0; i < 4; ++i) inverseBinds[16 * joint + 5 * i] = 1.0f;
    for (std::size_t i = 0; i < 3; ++i) inverseBinds[16 * joint + 12 + i] = -places[joint][i];
  }
  json["skins"][0]["joints"] = {1, 2, 3, 4, 5};
  json["skins"][0]["inverseBindMatrices"] = post.file.accessor(inverseBinds, "MAT4");
  return post;
}

class Opening : public testing::Test {
 protected:
  void write(const std::string& name, const test::Post& post) const {
    ASSERT_TRUE(writeFileAtomically(folder / name, post.file.glb()).ok());
  }
  void writeRig(const std::string& name, const std::string& character) const {
    Rig rig;
    rig.character = character;
    ASSERT_TRUE(saveRig(rig, folder / name).ok());
  }
  void openPost() {
    write("post.glb", postWithHelpers());
    ASSERT_TRUE(openFile(state, folder / "post.glb"));
    ASSERT_EQ(state.character().skeleton.bones.size(), 5u);
    ASSERT_EQ(bone("knee_end"), kEnd);
    ASSERT_EQ(bone("pole"), kPole);
  }
  [[nodiscard]] int bone(const char* name) const { return state.character().skeleton.findBone(name).value_or(-1); }
  [[nodiscard]] std::vector<int> hidden() const {
    std::vector<int> bones;
    const std::vector<bool> mask = hiddenBones(state);
    for (int i = 0; i < static_cast<int>(mask.size()); ++i) {
      if (isHidden(mask, i)) bones.push_back(i);
    }
    return bones;
  }
  [[nodiscard]] std::vector<int> bonesInTree() const {
    const Skeleton& skeleton = state.character().skeleton;
    OutlinerView view;
    view.filter = state.view.outlinerFilter;
    view.hiddenBones = hiddenBones(state);
    std::vector<int> bones;
    for (const OutlinerRow& row :
         outlinerRows(state.document.rig(), skeleton, boneOfEach(state.document.rig(), skeleton), view)) {
      if (row.kind == RowKind::kBone) bones.push_back(row.index);
    }
    std::ranges::sort(bones);
    return bones;
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
  EditorState state;
};

TEST_F(Opening, WalkPlaysEvenIfADeathIsFirst) {
  test::Post post = test::makePost();
  auto& clips = post.file.json["animations"];
  clips[0]["name"] = "Armature|Death";
  clips.push_back(clips[0]);
  clips[1]["name"] = "Armature|Walk_Cycle";
  write("post.glb", post);
  ASSERT_TRUE(openFile(state, folder / "post.glb"));
  EXPECT_EQ(state.open.transport.clip, 1);
  EXPECT_TRUE(state.open.transport.playing);
}

TEST_F(Opening, HelperBonesAreHiddenByDefault) {
  openPost();
  EXPECT_EQ(hidden(), (std::vector<int>{kTarget, kPole, kEnd}));
  EXPECT_EQ(bonesInTree(), (std::vector<int>{kHip, kKnee}));
  state.view.outlinerFilter = "pole";
  EXPECT_TRUE(bonesInTree().empty());
  state.view.outliner.helperBones = true;
  EXPECT_TRUE(hidden().empty());
  EXPECT_EQ(bonesInTree(), (std::vector<int>{kHip, kTarget, kPole}));
}

TEST_F(Opening, HelperBonesInUseAreShown) {
  openPost();
  addMuscle(state, kPole);
  EXPECT_EQ(hidden(), (std::vector<int>{kTarget, kEnd}));
  EXPECT_EQ(bonesInTree(), (std::vector<int>{kHip, kKnee, kTarget, kPole})) << "with what it hangs on";
  state.document.selection.clear();
  state.document.selection.bone = kEnd;
  EXPECT_EQ(hidden(), (std::vector<int>{kTarget}));
  state.document.selection.bone = -1;
  state.open.transport.overrides.set(kTarget, glm::quat(0.0f, 1.0f, 0.0f, 0.0f));
  EXPECT_EQ(hidden(), (std::vector<int>{kEnd}));
}

// A bone keeps its length if its end is hidden, and draws no line to a target.
TEST_F(Opening, HiddenBonesAreNeitherDrawnNorPicked) {
  openPost();
  state.open.transport.clip = -1;
  state.live->movePose(state.open.transport);
  const std::vector<bool> mask = hiddenBones(state);
  const Skeleton& skeleton = state.character().skeleton;
  const Pose& pose = state.live->pose();
  std::vector<std::pair<int, glm::vec3>> drawn;
  for (const BoneSegment& segment : boneSegments(skeleton, pose, mask)) drawn.emplace_back(segment.bone, segment.tail);
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_EQ(drawn[0], (std::pair{kHip, glm::vec3(0, 1, 0)}));
  EXPECT_EQ(drawn[1], (std::pair{kKnee, glm::vec3(0, 2, 0)}));
  EXPECT_EQ(boneSegments(skeleton, pose).size(), 6u);
  const Bounds bounds{{-1, -1, -1}, {5, 3, 1}};
  setScene(state.view.tools.camera, bounds, 2.0f);
  frameBounds(state.view.tools.camera, bounds, {400, 400}, false);
  const View view = viewOf(state.view.tools.camera, {400, 400});
  for (int i = 0; i < 5; ++i) {
    const glm::vec2 pixel(view.toPixel(glm::vec3(pose.boneInWorld[static_cast<std::size_t>(i)][3])));
    EXPECT_TRUE(pickBone(pixel, view, skeleton, pose, 3.0f)) << i;
    const auto hit = pickBone(pixel, view, skeleton, pose, 3.0f, mask);
    EXPECT_EQ(hit.has_value(), !isHidden(mask, i) || i == kEnd) << i;
    EXPECT_FALSE(hit && isHidden(mask, hit->bone)) << i;
  }
}

TEST_F(Opening, SelectChildJointSkipsHiddenBones) {
  openPost();
  state.document.selection.bone = kHip;
  selectChildJoint(state);
  EXPECT_EQ(state.document.selection.bone, kKnee);
  selectChildJoint(state);
  EXPECT_EQ(state.document.selection.bone, kKnee) << "its end is hidden";
  state.view.outliner.helperBones = true;
  selectChildJoint(state);
  EXPECT_EQ(state.document.selection.bone, kEnd);
}

TEST_F(Opening, MissingCharacterPromptsAndTheOpenDocumentStays) {
  write("other.glb", test::makePost());
  write("moved.glb", test::makePost());
  writeRig("lost.rig.json", "gone/post.glb");
  ASSERT_TRUE(openFile(state, folder / "other.glb"));
  EXPECT_FALSE(openFile(state, folder / "lost.rig.json"));
  EXPECT_EQ(state.dialogs.locate.rigFile, folder / "lost.rig.json");
  EXPECT_EQ(state.dialogs.locate.characterFile.filename(), "post.glb");
  EXPECT_TRUE(state.session.messages.empty());
  EXPECT_EQ(state.document.characterFile, folder / "other.glb");
  showLocateDialog(state);
  EXPECT_TRUE(state.dialogs.locate.rigFile.empty());
  EXPECT_EQ(state.dialogs.file.locateFor, folder / "lost.rig.json");
  EXPECT_EQ(state.dialogs.file.folder, folder);

  EXPECT_NE(openWithCharacter(state, folder / "lost.rig.json", folder / "lost.rig.json"), "");
  EXPECT_NE(openWithCharacter(state, folder / "lost.rig.json", folder / "absent.glb"), "");
  EXPECT_EQ(state.document.characterFile, folder / "other.glb");
  EXPECT_EQ(openWithCharacter(state, folder / "lost.rig.json", folder / "moved.glb"), "");
  EXPECT_EQ(state.document.rigFile, folder / "lost.rig.json");
  EXPECT_TRUE(state.document.commands.modified());
  ASSERT_EQ(saveTo(state, folder / "lost.rig.json"), "");
  EXPECT_EQ(loadRig(folder / "lost.rig.json")->character, "moved.glb");
  EXPECT_TRUE(openDocument(folder / "lost.rig.json").ok());
}

// An absolute path is normally kept as typed (document.cpp); here it was the broken one.
TEST_F(Opening, MissingAbsolutePathIsReplaced) {
  write("moved.glb", test::makePost());
  writeRig("lost.rig.json", (folder / "gone.glb").string());
  EXPECT_EQ(openWithCharacter(state, folder / "lost.rig.json", folder / "moved.glb"), "");
  ASSERT_EQ(saveTo(state, folder / "lost.rig.json"), "");
  EXPECT_EQ(loadRig(folder / "lost.rig.json")->character, "moved.glb");
}

TEST_F(Opening, OtherProblemsAreMessages) {
  test::Post post = test::makePost();
  ASSERT_TRUE(writeFileAtomically(folder / "post.gltf", post.file.gltfWithBufferAt("gone.bin")).ok());
  ASSERT_TRUE(writeFileAtomically(folder / "text.glb", "no character").ok());
  ASSERT_TRUE(writeFileAtomically(folder / "broken.rig.json", "{").ok());
  writeRig("bin.rig.json", "post.gltf");
  writeRig("text.rig.json", "text.glb");
  std::size_t told = 0;
  for (const char* name : {"bin.rig.json", "text.rig.json", "broken.rig.json", "absent.rig.json", "absent.glb"}) {
    EXPECT_FALSE(openFile(state, folder / name)) << name;
    EXPECT_TRUE(state.dialogs.locate.rigFile.empty()) << name;
    ASSERT_EQ(state.session.messages.size(), ++told) << name;
    EXPECT_NE(state.session.messages.back().text.find(name), std::string::npos) << state.session.messages.back().text;
  }
  EXPECT_NE(state.session.messages.front().text.find("gone.bin"), std::string::npos);
  // A folder named like the character cannot be read.
  fs::create_directory(folder / "folder.glb");
  writeRig("folder.rig.json", "folder.glb");
  EXPECT_FALSE(openFile(state, folder / "folder.rig.json"));
  EXPECT_FALSE(state.dialogs.locate.rigFile.empty());
}

TEST_F(Opening, DamagedFileIsReportedInPlainLanguage) {
  writeRig("limb.rig.json", "post.glb");
  write("post.glb", test::makePost());
  const std::string whole = readWholeFile(folder / "limb.rig.json", 1 << 20).value();
  struct Row {
    std::string text;
    std::string told;
  };
  const Row rows[] = {
      {whole.substr(0, whole.find("\"groups\"")), "the file ends too early"},
      {"{\n  \"format\": \"sinew-rig\"\n  \"version\": 1\n}",
       "line 3, column 11: a comma or a closing bracket is missing before this"},
      {"{\n  \"version\": 1,\n}",
       "line 3, column 1: a \"}\" where something else should be, perhaps after a comma too many"},
      {"{\"version\" 1}", "a colon is missing before this"},
      {"hello", "line 1, column 1: this cannot be read"},
      {"", "the file ends too early"},
  };
  for (const Row& row : rows) {
    ASSERT_TRUE(writeFileAtomically(folder / "limb.rig.json", row.text).ok());
    state.session.messages.clear();
    EXPECT_FALSE(openFile(state, folder / "limb.rig.json"));
    ASSERT_EQ(state.session.messages.size(), 1u);
    const std::string told = state.session.messages.back().text;
    EXPECT_TRUE(told.starts_with("limb.rig.json is damaged or not a rig: line ")) << told;
    EXPECT_NE(told.find(row.told), std::string::npos) << told;
    for (const char* term : {"byte", "JSON", "syntax", "parsing", "literal"}) {
      EXPECT_EQ(told.find(term), std::string::npos) << told;
    }
  }
  ASSERT_TRUE(writeFileAtomically(folder / "broken.gltf", std::string("{\"asset\": ")).ok());
  EXPECT_FALSE(openFile(state, folder / "broken.gltf"));
  EXPECT_TRUE(state.session.messages.back().text.starts_with("broken.gltf is damaged or not a character: line 1"))
      << state.session.messages.back().text;
  // Errors other than syntax errors are reported as before.
  ASSERT_TRUE(writeFileAtomically(folder / "limb.rig.json", std::string("[1, 2]")).ok());
  EXPECT_FALSE(openFile(state, folder / "limb.rig.json"));
  EXPECT_EQ(state.session.messages.back().text.find("damaged"), std::string::npos);
}

}  // namespace
}  // namespace sinew::app
