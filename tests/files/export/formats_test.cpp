// tests/files/export/formats_test.cpp: file extensions of formats, and the files of an export.
#include "sinew/files/formats.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

using Paths = std::vector<std::filesystem::path>;
using Words = std::vector<std::string>;

TEST(ExportFormats, ExtensionsAreListedByForm) {
  EXPECT_EQ(exportEndings({ExportForm::kSkin}), (Words{".glb", ".gltf", ".usda"}));
  EXPECT_EQ(exportEndings({ExportForm::kCache, ExportForm::kStage, ExportForm::kTargets}),
            (Words{".glb", ".gltf", ".usda", ".pc2", ".mdd"}))
      << "in the table's order, each once";
  EXPECT_TRUE(hasExportEnding("OUT.GLB", {ExportForm::kSkin}));
  EXPECT_FALSE(hasExportEnding("out.glb", {ExportForm::kCache, ExportForm::kStage}));
  EXPECT_FALSE(hasExportEnding("out", {ExportForm::kSkin}));
}

TEST(ExportFormats, SideFilesAreListedFirst) {
  EXPECT_EQ(exportedFiles("a/out.glb"), (Paths{"a/out.glb"}));
  EXPECT_EQ(exportedFiles("a/out.GLTF"), (Paths{"a/out.bin", "a/out.GLTF"}));
  EXPECT_EQ(exportedFiles("a/my clip.pc2"), (Paths{"a/my clip.obj", "a/my_clip.mtl", "a/my clip.pc2"}))
      << "the .obj names its .mtl in one word";
  EXPECT_EQ(exportedFiles("out.fbx"), (Paths{"out.fbx"}));
}

}  // namespace
}  // namespace sinew
