// tests/document/document_test.cpp: opening, saving and reopening.

#include "app/document/document.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "sinew/rig/rig_edit.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

/// An empty folder for every test.
class OpenedDocument : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::path(testing::TempDir()) / (std::string("sinew-document-") + info->name());
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  fs::path folder;
  const fs::path demo = fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb";

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return folder / name;
  }
};

Primitive muscleOn(const std::string& bone) {
  Primitive primitive;
  primitive.name = "biceps";
  primitive.bone = bone;
  primitive.placement.radii = {0.1f, 0.2f, 0.3f};
  return primitive;
}

TEST_F(OpenedDocument, CharacterOpensWithAnUnmodifiedEmptyRig) {
  const auto opened = openDocument(demo);
  ASSERT_TRUE(opened.ok()) << opened.error().text();
  EXPECT_TRUE(opened->rig().primitives.empty());
  EXPECT_FALSE(opened->commands.modified());
  EXPECT_TRUE(opened->rigFile.empty());
  EXPECT_EQ(opened->name(), "demo.glb");
  EXPECT_EQ(opened->activePrimitive(), -1);
}

TEST_F(OpenedDocument, SavedRigReopensEqualFromAnotherFolder) {
  auto opened = openDocument(demo);
  ASSERT_TRUE(opened.ok());
  Document document = std::move(opened).value();
  auto rig = addPrimitive(document.rig(), muscleOn(document.character->skeleton.fileName(0)));
  ASSERT_TRUE(rig.ok()) << rig.error().text();
  document.commands.apply("Add", rig.value());
  EXPECT_TRUE(document.commands.modified());

  fs::create_directories(folder / "deep");
  const fs::path file = folder / "deep" / "shape.rig.json";
  ASSERT_TRUE(saveDocument(document, file).ok());
  EXPECT_FALSE(document.commands.modified());
  EXPECT_EQ(document.rigFile, file);
  EXPECT_EQ(document.name(), "shape.rig.json");

  const auto again = openDocument(file);
  ASSERT_TRUE(again.ok()) << again.error().text();
  Rig expected = document.rig();
  expected.character = again->rig().character;  // Now relative to another folder.
  EXPECT_TRUE(again->rig() == expected);
  EXPECT_TRUE(fs::equivalent(again->characterFile, demo));
  EXPECT_EQ(again->character->mesh.triangles.size(), document.character->mesh.triangles.size());
}

TEST_F(OpenedDocument, FailedSaveChangesNothing) {
  auto opened = openDocument(demo);
  ASSERT_TRUE(opened.ok());
  Document document = std::move(opened).value();
  auto rig = addPrimitive(document.rig(), muscleOn("anything"));
  ASSERT_TRUE(rig.ok());
  document.commands.apply("Add", rig.value());
  EXPECT_FALSE(saveDocument(document, folder / "absent" / "shape.rig.json").ok());
  EXPECT_TRUE(document.commands.modified());
  EXPECT_TRUE(document.rigFile.empty());
}

TEST_F(OpenedDocument, ErrorsNameTheFileAndThePlace) {
  const auto unknown = openDocument(write("shape.txt", "x"));
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().text().find("shape.txt"), std::string::npos);

  const auto broken = openDocument(write("broken.rig.json", "{ \"format\": "));
  ASSERT_FALSE(broken.ok());
  EXPECT_NE(broken.error().text().find("broken.rig.json"), std::string::npos);

  const auto orphan = openDocument(
      write("orphan.rig.json", "{\"format\": \"sinew-rig\", \"version\": 1, \"character\": \"nowhere.glb\"}"));
  ASSERT_FALSE(orphan.ok());
  EXPECT_NE(orphan.error().text().find("orphan.rig.json"), std::string::npos);
  EXPECT_NE(orphan.error().text().find("nowhere.glb"), std::string::npos);
}

TEST_F(OpenedDocument, FileExtensionIsCaseInsensitive) {
  fs::copy_file(demo, folder / "DEMO.GLB");
  EXPECT_TRUE(openDocument(folder / "DEMO.GLB").ok());
}

}  // namespace
}  // namespace sinew::app
