// tests/files/export/hostile_export_test.cpp: characters that an export must refuse, and the error messages.
#include <cmath>

#include <nlohmann/json.hpp>

#include "core/files/disk/atomic_file.h"
#include "sinew/files/baked_export.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

class HostileExport : public ::testing::Test {
 protected:
  std::shared_ptr<const Character> open() {
    EXPECT_TRUE(writeFileAtomically(source_, post_.file.glb()).ok());
    auto character = importGltf(source_);
    EXPECT_TRUE(character.ok()) << character.error().text();
    return character.value();
  }
  static Rig plainRig() {
    Rig rig;
    rig.smoothing.depth = 1;
    rig.smoothing.patch = PatchKind::kFlat;
    return rig;
  }
  Result<SkinnedExportReport> skinned(const SkinnedExportSettings& settings, const char* name = "out.glb") {
    const auto character = open();
    return exportSkinned(source_, character, *character, plainRig(), settings, folder_.path() / name);
  }
  Result<BakedExportReport> baked(const char* name, double bound = 0.1, double framesPerSecond = 30.0) {
    BakedExportSettings settings;
    settings.clip = "bend";
    settings.bound = bound;
    settings.framesPerSecond = framesPerSecond;
    return exportBaked(source_, open(), plainRig(), settings, folder_.path() / name);
  }
  template <class Report>
  void expectRefused(const Result<Report>& report, const std::string& place, const std::string& reason) const {
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.error().place, place);
    EXPECT_NE(report.error().reason.find(reason), std::string::npos) << report.error().reason;
    EXPECT_EQ(report.error().text().find('\n'), std::string::npos);
    for (const char* name : {"out.glb", "out.pc2", "out.obj", "out.usda"}) {
      EXPECT_FALSE(std::filesystem::exists(folder_.path() / name)) << name;
    }
  }
  void addKeys(int node, const char* path, const std::vector<float>& values, const char* type) {
    ordered_json& clip = post_.file.json["animations"][0];
    clip["channels"].push_back({{"sampler", clip["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    clip["samplers"].push_back({{"input", post_.file.accessor(std::vector<float>{0, 1}, "SCALAR")},
                                {"output", post_.file.accessor(values, type)}});
  }
  void withPositions() { post_.attributes()["POSITION"] = post_.file.accessor(post_.positions, "VEC3"); }

  TemporaryFolder folder_;
  std::filesystem::path source_ = folder_.path() / "post.glb";
  Post post_ = makePost();
};

/// Six joints for a vertex, of which four remain, with a lever of a million units.
TEST_F(HostileExport, MeshFarFromItsBonesIsRefusedByItsError) {
  for (std::size_t v = 0; v < post_.positions.size(); v += 3) post_.positions[v] += 1e6f;
  withPositions();
  ordered_json& nodes = post_.file.json["nodes"];
  std::vector<float> still;
  for (int j = 0; j < 5; ++j) {
    const auto node = static_cast<int>(nodes.size());
    nodes[1]["children"].push_back(node);
    nodes.push_back({{"name", "side " + std::to_string(j)}});
    post_.file.json["skins"][0]["joints"].push_back(node);
    const float turn = 0.15f * static_cast<float>((j % 2 == 0 ? 1 : -1) * (j + 1));
    addKeys(node, "rotation", {0, 0, 0, 1, 0, std::sin(turn), 0, std::cos(turn)}, "VEC4");
  }
  post_.file.json["skins"][0].erase("inverseBindMatrices");
  std::vector<std::uint8_t> first;
  std::vector<std::uint8_t> second;
  std::vector<float> even;
  std::vector<float> rest;
  for (std::size_t v = 0; v < 12; ++v) {
    for (const int joint : {1, 2, 3, 4}) first.push_back(static_cast<std::uint8_t>(joint));
    for (const int joint : {5, 6, 0, 0}) second.push_back(static_cast<std::uint8_t>(joint));
    for (int c = 0; c < 4; ++c) even.push_back(1.0f / 6.0f);
    for (int c = 0; c < 4; ++c) rest.push_back(c < 2 ? 1.0f / 6.0f : 0.0f);
  }
  post_.attributes()["JOINTS_0"] = post_.file.accessor(first, "VEC4");
  post_.attributes()["JOINTS_1"] = post_.file.accessor(second, "VEC4");
  post_.attributes()["WEIGHTS_0"] = post_.file.accessor(even, "VEC4");
  post_.attributes()["WEIGHTS_1"] = post_.file.accessor(rest, "VEC4");
  for (const ExportJoints joints : {ExportJoints::kOwn, ExportJoints::kHelpers}) {
    expectRefused(skinned({.joints = joints, .helpers = 4}), "clip \"bend\"", "of the height off");
    expectRefused(skinned({.joints = joints, .helpers = 4}), "clip \"bend\"", "expected at most 100 %");
  }
}

TEST_F(HostileExport, NonFinitePositionsAreRefusedWithClipAndTime) {
  post_.file.json["nodes"].push_back({{"name", "top"}, {"children", {1}}});
  post_.file.json["scenes"][0]["nodes"] = {0, 3};
  for (const int node : {1, 2, 3}) addKeys(node, "scale", {1, 1, 1, 1e15f, 1e15f, 1e15f}, "VEC3");
  const std::string reason = "places are no longer finite numbers";
  for (const ExportMesh mesh : {ExportMesh::kRefined, ExportMesh::kOriginal}) {
    expectRefused(skinned({.mesh = mesh}), "clip \"bend\" at 0.033 s", reason);
  }
  for (const char* name : {"out.glb", "out.pc2", "out.usda"})
    expectRefused(baked(name), "clip \"bend\" at 0.033 s", reason);
}

TEST_F(HostileExport, BoundBelowFloatPrecisionIsRefused) {
  addKeys(1, "translation", {2e5f, 0, 0, 2e5f, 0, 0}, "VEC3");
  expectRefused(baked("out.glb"), "clip \"bend\"", "floats hold its places to");
  const auto coarse = baked("coarse.glb", 10.0);
  ASSERT_TRUE(coarse.ok()) << coarse.error().text();
  EXPECT_LE(coarse->baked.largest, 10.0);
}

TEST_F(HostileExport, LongClipsAreRefusedIfFitted) {
  addKeys(1, "translation", {0, 0, 0, 1, 0, 0}, "VEC3");
  for (const float hours : {1.01f, 1e6f, 2e11f}) {
    post_.file.json["animations"][0]["samplers"][1]["input"] =
        post_.file.accessor(std::vector<float>{0.0f, 3600.0f * hours}, "SCALAR");
    expectRefused(skinned({}), "clips", "expected at most 3600");
    for (const char* name : {"out.glb", "out.usda"}) {
      expectRefused(baked(name, 0.1, 1e-12), "clips", "expected at most 3600");
    }
  }
  EXPECT_TRUE(baked("cache.pc2", 0.1, 1e-12).ok()) << "two frames are two frames";
}

/// One view with the keys of both clips, as many programs write them.
TEST_F(HostileExport, BytesOfOtherClipsAreRemovedFromASharedView) {
  constexpr std::size_t kKeys = 50'000;
  std::vector<float> floats;
  for (std::size_t k = 0; k < kKeys; ++k) floats.push_back(static_cast<float>(k) / 100.0f);
  for (std::size_t k = 0; k < kKeys; ++k) floats.insert(floats.end(), {0, 0, 0, 1});
  floats.insert(floats.end(), {0.0f, 1.0f});
  floats.insert(floats.end(), {0, 0, 0, 1, std::sin(0.5f), 0, 0, std::cos(0.5f)});
  const int view = post_.file.viewOf(floats);
  const auto accessor = [&](std::size_t firstFloat, std::size_t count, const char* type) {
    ordered_json& all = post_.file.json["accessors"];
    all.push_back({{"bufferView", view},
                   {"byteOffset", 4 * firstFloat},
                   {"componentType", 5126},
                   {"count", count},
                   {"type", type}});
    return static_cast<int>(all.size()) - 1;
  };
  ordered_json& clips = post_.file.json["animations"];
  ordered_json other = clips[0];
  other["name"] = "long";
  other["samplers"][0] = {{"input", accessor(0, kKeys, "SCALAR")}, {"output", accessor(kKeys, kKeys, "VEC4")}};
  clips[0]["samplers"][0] = {{"input", accessor(5 * kKeys, 2, "SCALAR")},
                             {"output", accessor(5 * kKeys + 2, 2, "VEC4")}};
  clips.push_back(other);
  const auto report = skinned({.mesh = ExportMesh::kOriginal, .clips = {"bend"}});
  ASSERT_TRUE(report.ok()) << report.error().text();
  EXPECT_LT(report->bytes, 10'000U) << "and " << sizeof(float) * 5 * kKeys << " that nothing refers to";
  const GltfOracle before(source_);
  const GltfOracle after(folder_.path() / "out.glb");
  ASSERT_EQ(after.clips(), 1U);
  for (const double time : {0.0, 0.4, 1.0}) {
    const auto old = before.triangles(0, time);
    const auto now = after.triangles(0, time);
    ASSERT_EQ(now.size(), old.size());
    for (std::size_t t = 0; t < old.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(glm::distance(now[t][i], old[t][i]), 1e-5);
    }
  }
}

}  // namespace
}  // namespace sinew::test
