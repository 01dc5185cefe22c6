// tests/files/export/morph_export_test.cpp: exported morph targets, played by an independent reader.
#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/baked_export.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

ExportScene sceneOf(const std::filesystem::path& file, std::uint64_t seed) {
  ExportScene scene;
  scene.characterFile = file;
  scene.character = importGltf(file).value();
  scene.rig = withMorphsOf(randomRig(*scene.character, {.primitives = 3, .carveChance = 0.0f}, seed), *scene.character);
  scene.rig.smoothing.depth = 2;
  return scene;
}

/// A shape that grows as a bone bends, and another one at constant weight one half.
void drive(ExportScene& scene, const std::string& bone) {
  DriverInput input;
  input.bone = bone;
  const Driver driver{input, {{{0.0f, 0.0f}, {90.0f, 1.0f}}, CurveKind::kLinear}, DriverMode::kAdd, {}};
  scene.rig = setDriver(std::move(scene.rig), {Parameter::kMorphWeight, 0}, driver, -1).value();
  const std::string last = scene.rig.morphs.back().name;
  scene.rig = setMorphWeight(std::move(scene.rig), last, 0.5f).value();
}

class MorphExport : public ::testing::Test {
 protected:
  MorphExport() : scene_(sceneOf(folder_.write("post.glb", makeMorphingPost(3, 6).file.glb()), 3)) {}

  TemporaryFolder folder_;
  std::filesystem::path out_ = folder_.path() / "out.glb";
  ExportScene scene_;
};

TEST_F(MorphExport, RefinedMeshMatchesTheReportedError) {
  for (const bool driven : {false, true}) {
    if (driven) drive(scene_, "knee");
    for (const ExportJoints joints : {ExportJoints::kOwn, ExportJoints::kHelpers}) {
      const auto report = scene_.write(out_, {.joints = joints, .helpers = 2});
      ASSERT_TRUE(report.ok()) << report.error().text();
      expectPlaysAsPrinted(scene_, out_, report.value());
      EXPECT_TRUE(report->left.empty());
    }
    const auto back = importGltf(out_).value();
    ASSERT_EQ(back->morphTargets.size(), 3U);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(back->morphTargets[static_cast<std::size_t>(k)].name, morphName(k));
  }
}

/// Without muscles a target equals the file's, at any weight.
TEST_F(MorphExport, TargetsEqualTheFileWithoutMuscles) {
  scene_.rig.primitives.clear();
  scene_.rig.smoothing.depth = 1;
  scene_.rig.smoothing.patch = PatchKind::kFlat;
  ASSERT_TRUE(scene_.writeQuickly(out_).ok());
  const GltfOracle before(scene_.characterFile);
  const GltfOracle after(out_);
  for (const double time : {0.0, 0.15, 0.3, 0.77, 1.0}) {
    const auto old = before.triangles(0, time);
    const auto now = after.triangles(0, time);
    ASSERT_EQ(now.size(), old.size());
    for (std::size_t t = 0; t < old.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(glm::distance(now[t][i], old[t][i]), 1e-5);
    }
  }
}

TEST_F(MorphExport, OriginalMeshPlaysTheTargets) {
  drive(scene_, "knee");
  scene_.rig.primitives.clear();
  const auto report = scene_.writeQuickly(out_, {.mesh = ExportMesh::kOriginal});
  ASSERT_TRUE(report.ok()) << report.error().text();
  const GltfOracle after(out_);
  Smoother smoother(scene_.character);
  Rig flat = scene_.rig;
  flat.smoothing.depth = 1;
  flat.smoothing.patch = PatchKind::kFlat;
  ASSERT_TRUE(smoother.prepare(flat).ok());
  Surface surface;
  for (const float time : {0.0f, 0.1f, 0.5f, 1.0f}) {
    smoother.smooth(samplePose(*scene_.character, scene_.character->clips.front(), time), surface);
    const auto now = after.triangles(0, static_cast<double>(time));
    ASSERT_EQ(now.size(), scene_.character->mesh.triangles.size());
    for (std::size_t t = 0; t < now.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const int v = scene_.character->mesh.triangles[t].vertices[i];
        EXPECT_LT(glm::distance(now[t][i], glm::dvec3(surface.positions[static_cast<std::size_t>(v)])), 1e-4) << time;
      }
    }
  }
}

TEST_F(MorphExport, BakedTargetsIncludeTheShapes) {
  drive(scene_, "knee");
  BakedExportSettings settings;
  settings.clip = "bend";
  const auto report = exportBaked(scene_.characterFile, scene_.character, scene_.rig, settings, out_);
  ASSERT_TRUE(report.ok()) << report.error().text();
  const GltfOracle after(out_);
  for (const float time : {0.0f, 0.3f, 0.6f, 1.0f}) {
    const Surface live = scene_.live(&scene_.character->clips.front(), time);
    const auto now = after.triangles(0, static_cast<double>(time));
    ASSERT_EQ(now.size(), live.refinement->triangles.size());
    for (std::size_t t = 0; t < now.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 point(live.positions[static_cast<std::size_t>(live.refinement->triangles[t][i])]);
        EXPECT_LE(100.0 / static_cast<double>(scene_.character->height) * glm::distance(now[t][i], point),
                  settings.bound + 1e-3);
      }
    }
  }
}

TEST_F(MorphExport, UsdStageReportsUnsupportedShapes) {
  const auto report = scene_.writeQuickly(folder_.path() / "out.usda");
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_TRUE(report->left.empty()) << report->left[0];
  drive(scene_, "knee");
  const auto driven = scene_.writeQuickly(folder_.path() / "out.usda");
  ASSERT_TRUE(driven.ok()) << driven.error().text();
  ASSERT_EQ(driven->left.size(), 1U);
  EXPECT_NE(driven->left[0].find("where no clip plays"), std::string::npos);
}

TEST(MorphExportOfRealCharacters, RobotsFaceMatchesTheReportedError) {
  const auto file = characterFile("RobotExpressive.glb");
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const TemporaryFolder folder;
  ExportScene scene = sceneOf(*file, 1);
  drive(scene, "Head");
  const auto report = scene.write(folder.path() / "out.glb", {.clips = {"Wave", "Yes"}});
  ASSERT_TRUE(report.ok()) << report.error().text();
  expectPlaysAsPrinted(scene, folder.path() / "out.glb", report.value());
}

}  // namespace
}  // namespace sinew::test
