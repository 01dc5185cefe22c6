// tests/files/export/skinned_export_test.cpp: skinned exports match the live surface in independent readers.
#include "sinew/files/skinned_export.h"

#include <map>

#include <glm/geometric.hpp>

#include "core/files/disk/atomic_file.h"
#include "sinew/geometry/threads.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

void expectNeverFartherOff(const SkinnedExportReport& refitted, const SkinnedExportReport& transferred) {
  EXPECT_EQ(refitted.fitted.poses, transferred.fitted.poses);
  EXPECT_LE(refitted.fitted.rms, transferred.fitted.rms * (1.0 + 1e-4));
  EXPECT_GT(refitted.heldOut.poses, 0);
}

class SkinnedExport : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    scene_ = sceneNamed(GetParam());
    if (!scene_.character) GTEST_SKIP() << "there is no " << GetParam() << " in " << SINEW_CHARACTERS_DIR;
    ASSERT_FALSE(scene_.rig.primitives.empty());
  }

  ExportScene scene_;
  TemporaryFolder folder_;
};

/// Over all clips, root mean square, percent of the height; for vertices that gather where muscles move.
const std::map<std::string, double> kMostOff{
    {"humanoid", 0.224}, {"humanoid-flex", 0.240}, {"horse", 0.250}, {"horse-flex", 0.340}};

TEST_P(SkinnedExport, MatchesTheReportedError) {
  const auto file = folder_.path() / "out.glb";
  const auto report = scene_.write(file);
  ASSERT_TRUE(report.ok()) << report.error().text();
  ASSERT_EQ(report->clips.size(), scene_.character->clips.size());
  expectPlaysAsPrinted(scene_, file, report.value());
  const auto transferred = scene_.write(file, {.weights = ExportWeights::kTransferred});
  ASSERT_TRUE(transferred.ok());
  expectNeverFartherOff(report.value(), transferred.value());
  if (const auto most = kMostOff.find(GetParam()); most != kMostOff.end()) {
    EXPECT_LT(report->allClips.rms, most->second);
    EXPECT_LT(report->heldOut.rms, 1.1 * report->fitted.rms) << "fitted to the poses, not to the motion";
  }
}

TEST_P(SkinnedExport, ReportsProgressAndCanBeCanceledAtAnyTime) {
  const auto file = folder_.path() / "out.glb";
  const auto write = [&](const ExportProgress& progress) {
    SkinnedExportSettings settings;
    settings.clips = {scene_.character->clips.front().name};
    return exportSkinned(scene_.characterFile, scene_.character, *scene_.character, scene_.rig, settings, file,
                         progress);
  };
  std::vector<double> told;
  ASSERT_TRUE(write([&](double share) {
                told.push_back(share);
                return true;
              }).ok());
  ASSERT_GT(told.size(), 10u);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
  EXPECT_GT(told.back(), 0.9);
  std::filesystem::remove(file);
  for (const std::size_t last : {std::size_t{0}, told.size() / 2, told.size() - 1}) {
    std::size_t calls = 0;
    const auto report = write([&](double) { return calls++ < last; });
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.error().reason, kCanceled);
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  }
}

TEST_P(SkinnedExport, HasTheBindPoseOfTheLiveSurface) {
  const auto file = folder_.path() / "out.gltf";
  ASSERT_TRUE(scene_.writeQuickly(file, {.weights = ExportWeights::kTransferred}).ok());
  const auto again = importGltf(file);
  ASSERT_TRUE(again.ok()) << again.error().text();
  const Surface bind = scene_.live(nullptr, 0.0f);
  const Refinement& refinement = *bind.refinement;
  const ControlMesh& mesh = again.value()->mesh;
  const float tolerance = 4e-6f * scene_.character->height;  // The import welds what lies within 1e-6.
  ASSERT_EQ(mesh.triangles.size() + static_cast<std::size_t>(mesh.trianglesDropped), refinement.triangles.size());
  if (mesh.trianglesDropped > 0) GTEST_SKIP() << "triangles without size: the order is another one";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& parent = scene_.character->mesh.triangles[static_cast<std::size_t>(refinement.controlOf[t])];
    EXPECT_EQ(mesh.triangles[t].material, parent.material);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& point = mesh.positions[static_cast<std::size_t>(mesh.triangles[t].vertices[i])];
      ASSERT_LT(glm::distance(point, bind.positions[static_cast<std::size_t>(refinement.triangles[t][i])]), tolerance);
      const auto& wedge = mesh.wedges[static_cast<std::size_t>(mesh.triangles[t].wedges[i])];
      ASSERT_LT(glm::distance(wedge.uv, refinement.drawUv[refinement.drawTriangles[t][i]]), 1e-5f);
    }
  }
}

TEST_P(SkinnedExport, KeepsSkeletonClipsMaterialsAndImages) {
  const auto file = folder_.path() / "out.glb";
  ASSERT_TRUE(scene_.write(file, {.weights = ExportWeights::kTransferred}).ok());
  const auto again = importGltf(file);
  ASSERT_TRUE(again.ok()) << again.error().text();
  const Character& before = *scene_.character;
  const Character& after = *again.value();
  ASSERT_EQ(after.skeleton.bones.size(), before.skeleton.bones.size());
  for (std::size_t b = 0; b < before.skeleton.bones.size(); ++b) {
    EXPECT_EQ(after.skeleton.bones[b].path, before.skeleton.bones[b].path);
    EXPECT_EQ(after.skeleton.bones[b].bindInWorld, before.skeleton.bones[b].bindInWorld);
  }
  ASSERT_EQ(after.clips.size(), before.clips.size());
  for (std::size_t c = 0; c < before.clips.size(); ++c) {
    EXPECT_EQ(after.clips[c].name, before.clips[c].name);
    ASSERT_EQ(after.clips[c].channels.size(), before.clips[c].channels.size());
    for (std::size_t i = 0; i < before.clips[c].channels.size(); ++i) {
      EXPECT_EQ(after.clips[c].channels[i].times, before.clips[c].channels[i].times);
      EXPECT_EQ(after.clips[c].channels[i].values, before.clips[c].channels[i].values);
    }
  }
  ASSERT_EQ(after.materials.size(), before.materials.size());
  for (std::size_t m = 0; m < before.materials.size(); ++m) {
    EXPECT_EQ(after.materials[m].name, before.materials[m].name);
    EXPECT_EQ(after.materials[m].baseColor, before.materials[m].baseColor);
    EXPECT_EQ(after.materials[m].baseColorTexture, before.materials[m].baseColorTexture);
  }
  ASSERT_EQ(after.textures.size(), before.textures.size());
  for (std::size_t t = 0; t < before.textures.size(); ++t) {
    EXPECT_EQ(after.textures[t].encoded, before.textures[t].encoded);
  }
}

TEST_P(SkinnedExport, WeightsAreAtMostFourNonNegativeAndSumToOne) {
  for (const ExportMesh mesh : {ExportMesh::kRefined, ExportMesh::kOriginal}) {
    const auto file = folder_.path() / "out.glb";
    ASSERT_TRUE(scene_.writeQuickly(file, {.mesh = mesh}).ok());
    const tinygltf::Model model = rawModel(file);
    for (const tinygltf::Node& node : model.nodes) {
      if (node.mesh < 0) continue;
      ASSERT_GE(node.skin, 0);
      const std::size_t joints = model.skins[static_cast<std::size_t>(node.skin)].joints.size();
      for (const auto& primitive : model.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
        EXPECT_FALSE(primitive.attributes.contains("JOINTS_1"));
        EXPECT_FALSE(primitive.attributes.contains("WEIGHTS_1"));
        const auto weights = rawNumbers<float>(model, primitive.attributes.at("WEIGHTS_0"));
        const auto numbers = rawNumbers<std::uint8_t>(model, primitive.attributes.at("JOINTS_0"));
        ASSERT_EQ(weights.size(), numbers.size());
        for (std::size_t v = 0; v < weights.size(); v += 4) {
          double sum = 0.0;
          for (std::size_t i = v; i < v + 4; ++i) {
            EXPECT_GE(weights[i], 0.0f);
            EXPECT_LT(numbers[i], joints);
            EXPECT_TRUE(weights[i] > 0.0f || numbers[i] == 0);
            sum += static_cast<double>(weights[i]);
          }
          ASSERT_NEAR(sum, 1.0, 1e-6);
        }
      }
    }
  }
}

TEST_P(SkinnedExport, OriginalVerticesAreNoWorseThanWithTransferredWeights) {
  const auto refitted = scene_.writeQuickly(folder_.path() / "a.glb", {.mesh = ExportMesh::kOriginal});
  const auto transferred = scene_.writeQuickly(folder_.path() / "b.glb",
                                               {.mesh = ExportMesh::kOriginal, .weights = ExportWeights::kTransferred});
  ASSERT_TRUE(refitted.ok() && transferred.ok());
  expectNeverFartherOff(refitted.value(), transferred.value());
}

TEST_P(SkinnedExport, OriginalKeepsVertexOrderTrianglesAndTextureCoordinates) {
  const auto file = folder_.path() / "out.glb";
  ASSERT_TRUE(scene_.writeQuickly(file, {.mesh = ExportMesh::kOriginal}).ok());
  const tinygltf::Model before = rawModel(scene_.characterFile);
  const tinygltf::Model after = rawModel(file);
  ASSERT_EQ(after.meshes.size(), before.meshes.size());
  bool moved = false;
  for (std::size_t m = 0; m < before.meshes.size(); ++m) {
    ASSERT_EQ(after.meshes[m].primitives.size(), before.meshes[m].primitives.size());
    for (std::size_t p = 0; p < before.meshes[m].primitives.size(); ++p) {
      const tinygltf::Primitive& old = before.meshes[m].primitives[p];
      const tinygltf::Primitive& now = after.meshes[m].primitives[p];
      ASSERT_EQ(now.indices < 0, old.indices < 0);
      if (old.indices >= 0) {
        EXPECT_EQ(rawBytes(after, now.indices), rawBytes(before, old.indices));
      }
      EXPECT_EQ(now.material, old.material);
      const auto positions = rawNumbers<float>(before, old.attributes.at("POSITION"));
      const auto exported = rawNumbers<float>(after, now.attributes.at("POSITION"));
      ASSERT_EQ(exported.size(), positions.size());
      moved = moved || exported != positions;
      for (const auto& [name, accessor] : old.attributes) {
        if (name == "POSITION" || name == "NORMAL" || name.starts_with("JOINTS") || name.starts_with("WEIGHTS"))
          continue;
        EXPECT_EQ(rawBytes(after, now.attributes.at(name)), rawBytes(before, accessor)) << name;
      }
    }
  }
  EXPECT_TRUE(moved) << "no muscle shows in the bind pose";
}

TEST_P(SkinnedExport, OriginalVerticesLieOnTheLiveSurface) {
  const auto file = folder_.path() / "out.glb";
  const auto report = scene_.writeQuickly(file, {.mesh = ExportMesh::kOriginal});
  ASSERT_TRUE(report.ok());
  const auto again = importGltf(file);
  ASSERT_TRUE(again.ok()) << again.error().text();
  const Surface bind = scene_.live(nullptr, 0.0f);
  const ControlMesh& mesh = again.value()->mesh;
  const ControlMesh& control = scene_.character->mesh;
  const std::size_t dropped = static_cast<std::size_t>(mesh.trianglesDropped + control.trianglesDropped);
  if (dropped > 0) GTEST_SKIP() << "triangles without size: muscles may give them one";
  ASSERT_EQ(mesh.triangles.size(), control.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& point = mesh.positions[static_cast<std::size_t>(mesh.triangles[t].vertices[i])];
      const auto& lives = bind.positions[static_cast<std::size_t>(control.triangles[t].vertices[i])];
      ASSERT_LT(glm::distance(point, lives), 5e-6f * scene_.character->height);
    }
  }
}

TEST_P(SkinnedExport, OutputDoesNotDependOnThreads) {
  for (const auto& [name, threads] : {std::pair("a.glb", 1), std::pair("b.glb", 3)}) {
    const ThreadLimit limit(threads);
    ASSERT_TRUE(scene_.writeQuickly(folder_.path() / name).ok());
  }
  EXPECT_EQ(readWholeFile(folder_.path() / "a.glb", 1 << 28).value(),
            readWholeFile(folder_.path() / "b.glb", 1 << 28).value());
}

/// The file on disk differs from the imported one: the export is refused, whatever differs.
TEST(SkinnedExportGuard, RefusesAFileChangedSinceImport) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out.glb";
  const ExportScene good = bundledScene("demo");
  const auto expectRefused = [&](const ExportScene& scene, const std::string& what) {
    const auto report = scene.writeQuickly(out, {.weights = ExportWeights::kTransferred});
    ASSERT_FALSE(report.ok()) << what;
    EXPECT_NE(report.error().reason.find("has changed since it was opened"), std::string::npos)
        << what << ": " << report.error().text();
    EXPECT_EQ(report.error().file, scene.characterFile.string());
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << what;
  };
  for (const char* other : {"humanoid", "horse", "wrapped"}) {
    ExportScene scene = good;
    scene.characterFile = bundledScene(other).characterFile;
    expectRefused(scene, other);
  }
  const std::vector<std::pair<std::string, std::function<void(Character&)>>> changes{
      {"a vertex", [](Character& c) { c.mesh.positions[7].x += 0.25f; }},
      {"a triangle less", [](Character& c) { c.mesh.triangles.pop_back(); }},
      {"a triangle turned",
       [](Character& c) { std::swap(c.mesh.triangles[3].vertices[0], c.mesh.triangles[3].vertices[1]); }},
      {"a joint's name", [](Character& c) { c.skeleton.bones.back().path += "x"; }},
      {"a bind pose", [](Character& c) { c.skeleton.bones.back().bindInWorld[3].y += 0.5f; }},
      {"a weight's joint", [](Character& c) { c.skeleton.bindings.back().bone = 0; }},
      {"a clip less", [](Character& c) { c.clips.pop_back(); }},
      {"a key", [](Character& c) { c.clips.front().channels.front().values.front().x += 0.1f; }}};
  for (const auto& [what, change] : changes) {
    Character changed = *good.character;
    change(changed);
    ExportScene scene = good;
    scene.character = std::make_shared<const Character>(std::move(changed));
    expectRefused(scene, what);
  }
  ASSERT_TRUE(good.writeQuickly(out, {.weights = ExportWeights::kTransferred}).ok());
}

INSTANTIATE_TEST_SUITE_P(Characters, SkinnedExport, ::testing::Values("demo", "greenman.glb"), nameOfScene);
INSTANTIATE_TEST_SUITE_P(Large, SkinnedExport,
                         ::testing::Values("horse", "humanoid-flex", "Fox.glb", "cesium_man.gltf", "robot.glb"),
                         nameOfScene);

}  // namespace
}  // namespace sinew::test
