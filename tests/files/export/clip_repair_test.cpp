// tests/files/export/clip_repair_test.cpp: clips with keys that violate glTF play in an export as they were imported.
#include <algorithm>
#include <cmath>
#include <random>

#include <nlohmann/json.hpp>

#include "core/files/disk/atomic_file.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

/// The post with a clip of its own, written, opened, exported and opened again.
class ClipRepair : public ::testing::Test {
 protected:
  ClipRepair() { clip() = {{"name", "odd"}, {"channels", ordered_json::array()}, {"samplers", ordered_json::array()}}; }

  ordered_json& clip() { return post_.file.json["animations"][0]; }

  void addChannel(int node, const char* path, const std::vector<float>& times, const std::vector<float>& values,
                  const char* interpolation = "LINEAR") {
    const std::string name = path;
    const char* const type = name == "rotation" ? "VEC4" : name == "weights" ? "SCALAR" : "VEC3";
    clip()["channels"].push_back(
        {{"sampler", clip()["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    clip()["samplers"].push_back({{"input", post_.file.accessor(times, "SCALAR")},
                                  {"output", post_.file.accessor(values, type)},
                                  {"interpolation", interpolation}});
  }

  SkinnedExportReport exported(ExportMesh mesh = ExportMesh::kOriginal) {
    EXPECT_TRUE(writeFileAtomically(source_, post_.file.glb()).ok());
    const auto character = importGltf(source_);
    EXPECT_TRUE(character.ok()) << character.error().text();
    before_ = character.value();
    Rig rig;
    rig.smoothing.depth = 1;
    rig.smoothing.patch = PatchKind::kFlat;
    const auto report = exportSkinned(source_, before_, *before_, rig, {.mesh = mesh}, out_);
    EXPECT_TRUE(report.ok()) << report.error().text();
    after_ = importGltf(out_).value();
    return report.ok() ? report.value() : SkinnedExportReport{};
  }

  /// All times increase from 0, and accessors declare them so.
  void expectSoundTimes() const {
    const tinygltf::Model model = rawModel(out_);
    for (const tinygltf::Animation& animation : model.animations) {
      for (const tinygltf::AnimationSampler& sampler : animation.samplers) {
        const auto times = rawNumbers<float>(model, sampler.input);
        const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(sampler.input));
        ASSERT_FALSE(times.empty());
        EXPECT_GE(times.front(), 0.0f);
        EXPECT_EQ(std::ranges::adjacent_find(times, std::ranges::greater_equal()), times.end());
        if (accessor.minValues.empty()) continue;  // Written by the file itself.
        EXPECT_EQ(static_cast<float>(accessor.minValues.at(0)), times.front());
        EXPECT_EQ(static_cast<float>(accessor.maxValues.at(0)), times.back());
      }
    }
  }

  void expectPlaysAsRead() const {
    ASSERT_EQ(after_->clips.size(), 1U);
    const AnimationClip& was = before_->clips.front();
    const AnimationClip& is = after_->clips.front();
    EXPECT_EQ(is.duration, was.duration);
    for (int i = 0; i <= 40; ++i) {
      const float time = was.duration * static_cast<float>(i) / 40.0f;
      const Pose old = samplePose(*before_, was, time);
      const Pose now = samplePose(*after_, is, time);
      ASSERT_EQ(now.boneInWorld.size(), old.boneInWorld.size());
      for (std::size_t b = 0; b < old.boneInWorld.size(); ++b) {
        for (int c = 0; c < 4; ++c) {
          EXPECT_LT(glm::distance(now.boneInWorld[b][c], old.boneInWorld[b][c]), 2e-5f) << time;
        }
      }
    }
  }

  static bool tells(const SkinnedExportReport& report, const std::string& what) {
    return std::ranges::any_of(report.left, [&](const std::string& line) { return line.starts_with(what); });
  }

  TemporaryFolder folder_;
  std::filesystem::path source_ = folder_.path() / "post.glb";
  std::filesystem::path out_ = folder_.path() / "out.glb";
  Post post_ = makePost();
  std::shared_ptr<const Character> before_;
  std::shared_ptr<const Character> after_;
};

std::vector<float> turnsAbout(int axis, const std::vector<float>& angles) {
  std::vector<float> values;
  for (const float angle : angles) {
    for (int c = 0; c < 3; ++c) values.push_back(c == axis ? std::sin(angle / 2.0f) : 0.0f);
    values.push_back(std::cos(angle / 2.0f));
  }
  return values;
}

TEST_F(ClipRepair, DecreasingAndRepeatedTimesAreWrittenSorted) {
  for (const ExportMesh mesh : {ExportMesh::kOriginal, ExportMesh::kRefined}) {
    post_ = makePost();
    clip() = {{"name", "odd"}, {"channels", ordered_json::array()}, {"samplers", ordered_json::array()}};
    addChannel(2, "rotation", {0.0f, 1.0f, 0.5f, 0.5f, 1.5f}, turnsAbout(0, {0.0f, 1.0f, 0.2f, 0.7f, -0.4f}));
    const SkinnedExportReport report = exported(mesh);
    EXPECT_TRUE(tells(report, "key times that fall or repeat"));
    expectSoundTimes();
    expectPlaysAsRead();
  }
}

TEST_F(ClipRepair, SoundKeysKeepTheirBytes) {
  addChannel(2, "rotation", {0.0f, 1.0f}, turnsAbout(0, {0.0f, 1.0f}));
  EXPECT_TRUE(exported().left.empty());
  const tinygltf::Model was = rawModel(source_);
  const tinygltf::Model is = rawModel(out_);
  const tinygltf::AnimationSampler& before = was.animations[0].samplers[0];
  const tinygltf::AnimationSampler& after = is.animations[0].samplers[0];
  EXPECT_EQ(rawBytes(is, after.input), rawBytes(was, before.input));
  EXPECT_EQ(rawBytes(is, after.output), rawBytes(was, before.output));
}

TEST_F(ClipRepair, InactiveChannelsAreOmitted) {
  addChannel(2, "rotation", {0.0f, 1.0f}, turnsAbout(0, {0.0f, 1.0f}));
  addChannel(2, "rotation", {0.0f, 1.0f}, turnsAbout(2, {0.0f, 2.0f}));
  post_.file.json["nodes"].push_back({{"name", "still"}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  addChannel(3, "translation", {0.0f, 1.0f}, {0, 0, 0, 1, 1, 1});
  const SkinnedExportReport report = exported();
  EXPECT_TRUE(tells(report, "animation channels for a property that another channel moves"));
  EXPECT_TRUE(tells(report, "animation channels for nodes that a matrix places"));
  EXPECT_EQ(rawModel(out_).animations.at(0).channels.size(), 1U);
  expectPlaysAsRead();
}

/// Random times, also before 0, any interpolation, rotations of any length.
TEST_F(ClipRepair, RandomKeysPlayAsImported) {
  std::mt19937 random(11);
  const auto number = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  constexpr const char* kKinds[] = {"LINEAR", "STEP", "CUBICSPLINE"};
  for (int round = 0; round < 60; ++round) {
    post_ = makePost();
    clip() = {{"name", "odd"}, {"channels", ordered_json::array()}, {"samplers", ordered_json::array()}};
    for (const char* path : {"translation", "rotation", "scale"}) {
      const char* const kind = kKinds[random() % 3];
      const std::size_t keys = 1 + random() % 6;
      const std::size_t width = std::string(path) == "rotation" ? 4 : 3;
      std::vector<float> times;
      for (std::size_t k = 0; k < keys; ++k) times.push_back(0.25f * std::floor(number(-4.0f, 8.0f)));
      std::vector<float> values;
      for (std::size_t i = 0; i < keys * width * (std::string(kind) == "CUBICSPLINE" ? 3 : 1); ++i) {
        values.push_back(number(-1.0f, 1.0f));
      }
      addChannel(1 + static_cast<int>(random() % 2), path, times, values, kind);
    }
    exported();
    expectSoundTimes();
    if (before_->clips.front().duration > 0.0f) expectPlaysAsRead();
    if (HasFailure()) FAIL() << "round " << round << ": " << clip().dump();
  }
}

}  // namespace
}  // namespace sinew::test
