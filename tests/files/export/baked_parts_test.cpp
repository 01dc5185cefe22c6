// tests/files/export/baked_parts_test.cpp: baked files of several meshes.
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/files/disk/atomic_file.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/baked_export.h"
#include "sinew/surface/smoother.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

/// The post's patches curve as it bends: even without muscles the live surface differs from skinning.
class BakedParts : public ::testing::Test {
 protected:
  void SetUp() override { rig_.smoothing.depth = 3; }

  Result<BakedExportReport> bake(double bound = 0.02, const char* name = "out.glb") {
    EXPECT_TRUE(writeFileAtomically(source_, post_.file.glb()).ok());
    auto character = importGltf(source_);
    EXPECT_TRUE(character.ok()) << character.error().text();
    character_ = character.value();
    BakedExportSettings settings;
    settings.clip = character_->clips.front().name;
    settings.framesPerSecond = 7.0;
    settings.bound = bound;
    return exportBaked(source_, character_, rig_, settings, folder_.path() / name);
  }

  /// Largest distance from the live surface in the baked frames, percent of the height.
  [[nodiscard]] double worst() const {
    const GltfOracle oracle(folder_.path() / "out.glb");
    Smoother smoother(character_);
    EXPECT_TRUE(smoother.prepare(rig_).ok());
    double worst = 0.0;
    for (int frame = 0; frame <= 7; ++frame) {
      const float time = static_cast<float>(frame) / 7.0f;
      Surface surface;
      smoother.smooth(samplePose(*character_, character_->clips.front(), time), surface);
      const auto shown = oracle.triangles(0, static_cast<double>(time));
      const auto& triangles = surface.refinement->triangles;
      EXPECT_EQ(shown.size(), triangles.size());
      for (std::size_t t = 0; t < shown.size(); ++t) {
        // A mirrored mesh has the opposite winding: use the triangle's nearest corner.
        for (const glm::dvec3& corner : shown[t]) {
          double nearest = 1e9;
          for (const int vertex : triangles[t]) {
            nearest = std::min(nearest,
                               glm::distance(corner, glm::dvec3(surface.positions[static_cast<std::size_t>(vertex)])));
          }
          worst = std::max(worst, nearest);
        }
      }
    }
    return 100.0 * worst / static_cast<double>(character_->height);
  }

  TemporaryFolder folder_;
  std::filesystem::path source_ = folder_.path() / "post.glb";
  Post post_ = makePost();
  Rig rig_;
  std::shared_ptr<const Character> character_;
};

TEST_F(BakedParts, MeshesInTheirOwnSpacesShareTheWeights) {
  ordered_json board;
  board["attributes"]["POSITION"] =
      post_.file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5f}, "VEC3");
  board["indices"] = post_.file.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR");
  post_.file.json["meshes"].push_back({{"name", "board"}, {"primitives", ordered_json::array({board})}});
  post_.file.json["nodes"].push_back({{"name", "on knee"}, {"mesh", 1}, {"translation", {0, 0.5, 2}}});
  post_.file.json["nodes"].push_back({{"name", "alone"}, {"mesh", 1}, {"scale", {-0.1, 2, 10}}});
  post_.file.json["nodes"][2]["children"] = {3};
  post_.file.json["scenes"][0]["nodes"] = {0, 1, 4};
  const auto report = bake();
  ASSERT_TRUE(report.ok()) << report.error().text();
  ASSERT_GT(report->targets, 0);
  EXPECT_GT(report->skinned.largest, 0.02);
  EXPECT_LE(worst(), 0.02 + 1e-4);
  const tinygltf::Model model = rawModel(folder_.path() / "out.glb");
  std::set<int> shown;
  for (const auto& channel : model.animations.at(0).channels) {
    if (channel.target_path == "weights") shown.insert(channel.target_node);
  }
  EXPECT_EQ(shown, (std::set<int>{0, 3, 4}));
}

TEST_F(BakedParts, PointsAndLinesOfAMorphedMeshHaveAsManyTargets) {
  ordered_json points = post_.primitive();
  points["mode"] = 0;
  points.erase("indices");
  post_.file.json["meshes"][0]["primitives"].insert(post_.file.json["meshes"][0]["primitives"].begin(), points);
  const auto report = bake();
  ASSERT_TRUE(report.ok()) << report.error().text();
  ASSERT_GT(report->targets, 0);
  const tinygltf::Model model = rawModel(folder_.path() / "out.glb");
  ASSERT_EQ(model.meshes.at(0).primitives.size(), 2u);
  for (const auto& primitive : model.meshes[0].primitives) {
    EXPECT_EQ(primitive.targets.size(), static_cast<std::size_t>(report->targets));
  }
}

TEST_F(BakedParts, TargetsOfTheFileAreBakedAndOtherExtrasKept) {
  const int target = post_.file.accessor(std::vector<float>(post_.positions.size(), 0.25f), "VEC3");
  post_.file.json["accessors"][static_cast<std::size_t>(target)]["min"] = {0.25, 0.25, 0.25};
  post_.file.json["accessors"][static_cast<std::size_t>(target)]["max"] = {0.25, 0.25, 0.25};
  post_.primitive()["targets"] = ordered_json::array({ordered_json{{"POSITION", target}}});
  post_.file.json["meshes"][0]["weights"] = {0.5};
  post_.file.json["meshes"][0]["extras"] = {{"lod", 3}, {"targetNames", {"smile"}}};
  ordered_json& clip = post_.file.json["animations"][0];
  clip["samplers"].push_back(
      {{"input", clip["samplers"][0]["input"]}, {"output", post_.file.accessor(std::vector<float>{0, 1}, "SCALAR")}});
  clip["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}});
  const auto report = bake();
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_TRUE(report->left.empty());
  EXPECT_LE(worst(), 0.02 + 1e-4);
  const tinygltf::Model model = rawModel(folder_.path() / "out.glb");
  EXPECT_EQ(model.meshes[0].extras.Get("lod").GetNumberAsInt(), 3);
  EXPECT_EQ(model.meshes[0].extras.Get("targetNames").ArrayLen(), static_cast<std::size_t>(report->targets));
}

TEST_F(BakedParts, JointScaledToZeroIsBakedOrRefused) {
  ordered_json& clip = post_.file.json["animations"][0];
  clip["samplers"].push_back({{"input", clip["samplers"][0]["input"]},
                              {"output", post_.file.accessor(std::vector<float>{1, 1, 1, 0, 0, 0}, "VEC3")}});
  clip["channels"].push_back({{"sampler", 1}, {"target", {{"node", 2}, {"path", "scale"}}}});
  const auto report = bake(0.05);
  if (report) EXPECT_LE(worst(), 0.05 + 1e-4);
  else EXPECT_NE(report.error().reason.find("larger bound"), std::string::npos) << report.error().text();
  EXPECT_EQ(std::filesystem::exists(folder_.path() / "out.glb"), report.ok());
}

TEST_F(BakedParts, SettingsAreCheckedFirst) {
  ASSERT_TRUE(bake(1.0).ok());
  std::filesystem::remove(folder_.path() / "out.glb");
  const auto refused = [&](BakedExportSettings settings, const char* name, const std::string& words) {
    const auto report = exportBaked(source_, character_, rig_, settings, folder_.path() / name);
    ASSERT_FALSE(report.ok());
    EXPECT_NE(report.error().text().find(words), std::string::npos) << report.error().text();
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / name));
  };
  refused({.clip = "bend"}, "out.fbx", ".pc2 or .mdd");
  refused({.clip = "bond"}, "out.glb", "expected \"bend\"");
  refused({.clip = "bend", .framesPerSecond = 0.0}, "out.glb", "above 0");
  refused({.clip = "bend", .framesPerSecond = 1e12}, "out.glb", "has more than 4000 frames");
  refused({.clip = "bend", .framesPerSecond = 1e12}, "out.pc2", "has more than 1000000 frames");
  refused({.clip = "bend", .bound = 0.0}, "out.glb", "from 0.001 to 100");
  refused({.clip = "bend", .bound = std::nan("")}, "out.glb", "from 0.001 to 100");
}

}  // namespace
}  // namespace sinew::test
