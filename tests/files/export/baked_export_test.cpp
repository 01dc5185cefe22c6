// tests/files/export/baked_export_test.cpp: baked clips match the live surface in independent readers.
#include "sinew/files/baked_export.h"

#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/files/disk/atomic_file.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/smoother.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

/// Twenty times coarser than what a file's floats are good for.
constexpr double kFloats = 2e-4;  // Percent of the height.

class BakedExport : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    scene_ = sceneNamed(GetParam());
    if (!scene_.character) GTEST_SKIP() << "there is no " << GetParam() << " in " << SINEW_CHARACTERS_DIR;
    // The shortest clip that moves.
    for (const AnimationClip& clip : scene_.character->clips) {
      if (clip.duration > 0.3f && (!clip_ || clip.duration < clip_->duration)) clip_ = &clip;
    }
    ASSERT_TRUE(clip_);
  }

  Result<BakedExportReport> bake(const std::filesystem::path& file, double bound = 0.1, double framesPerSecond = 15.0,
                                 const ExportProgress& progress = {}) const {
    BakedExportSettings settings;
    settings.clip = clip_->name;
    settings.framesPerSecond = framesPerSecond;
    settings.bound = bound;
    return exportBaked(scene_.characterFile, scene_.character, scene_.rig, settings, file, progress);
  }

  /// Times of all frames, and the end.
  std::vector<float> times(double framesPerSecond = 15.0) const {
    std::vector<float> result;
    for (int frame = 0; frame < static_cast<double>(clip_->duration) * framesPerSecond - 1e-3; ++frame) {
      result.push_back(static_cast<float>(frame) / static_cast<float>(framesPerSecond));
    }
    result.push_back(clip_->duration);
    return result;
  }

  /// Visits the live surface at each time.
  template <class Use>
  void forEachSurface(const std::vector<float>& moments, Use use) const {
    Smoother smoother(scene_.character);
    ASSERT_TRUE(smoother.prepare(scene_.rig).ok());
    Surface surface;
    for (const float time : moments) {
      smoother.smooth(samplePose(scene_.character->skeleton, *clip_, time), surface);
      use(time, surface);
    }
  }

  /// Largest distance of the file's triangle corners to the live surface, percent of the height.
  double worst(const GltfOracle& oracle, float time, const Surface& surface) const {
    const auto& triangles = surface.refinement->triangles;
    const auto exported = oracle.triangles(0, static_cast<double>(time));
    EXPECT_EQ(exported.size(), triangles.size());
    double worst = 0.0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 point(surface.positions[static_cast<std::size_t>(triangles[t][i])]);
        worst = std::max(worst, glm::distance(point, exported[t][i]));
      }
    }
    return 100.0 * worst / static_cast<double>(scene_.character->height);
  }

  ExportScene scene_;
  const AnimationClip* clip_ = nullptr;
  TemporaryFolder folder_;
};

TEST_P(BakedExport, ErrorStaysWithinTheBoundInEveryBakedFrame) {
  for (const double bound : {0.4, 0.05}) {
    const auto file = folder_.path() / "out.glb";
    const auto report = bake(file, bound);
    ASSERT_TRUE(report.ok()) << report.error().text();
    EXPECT_LE(report->baked.largest, bound);
    EXPECT_LT(report->baked.rms, report->skinned.rms);
    EXPECT_EQ(report->frames, static_cast<int>(times().size()));
    const GltfOracle oracle(file);
    ASSERT_EQ(oracle.clips(), 1u);
    double farthest = 0.0;
    forEachSurface(times(), [&](float time, const Surface& surface) {
      const double distance = worst(oracle, time, surface);
      EXPECT_LE(distance, bound + kFloats) << time;
      farthest = std::max(farthest, distance);
    });
    EXPECT_NEAR(farthest, report->baked.largest, kFloats) << "the printed error is of something else";
  }
}

TEST_P(BakedExport, LooserBoundNeedsFewerTargets) {
  const auto loose = bake(folder_.path() / "loose.glb", 0.8);
  const auto tight = bake(folder_.path() / "tight.glb", 0.05);
  const auto none = bake(folder_.path() / "none.glb", 100.0);
  ASSERT_TRUE(loose.ok() && tight.ok() && none.ok());
  EXPECT_LT(loose->targets, tight->targets);
  EXPECT_LE(tight->targets, tight->frames);
  EXPECT_LT(loose->bytes, tight->bytes);
  EXPECT_EQ(none->targets, 0);
  EXPECT_EQ(none->baked.largest, none->skinned.largest);
}

TEST_P(BakedExport, TargetsHaveNamesBoundsNormalsAndOneWeightEachAtEveryKey) {
  const auto file = folder_.path() / "out.gltf";
  const auto report = bake(file);
  ASSERT_TRUE(report.ok()) << report.error().text();
  ASSERT_GT(report->targets, 0);
  const auto count = static_cast<std::size_t>(report->targets);
  const tinygltf::Model model = rawModel(file);
  ASSERT_EQ(model.animations.size(), 1u);
  int channels = 0;
  for (const auto& channel : model.animations[0].channels) {
    if (channel.target_path != "weights") continue;
    ++channels;
    const auto& sampler = model.animations[0].samplers.at(static_cast<std::size_t>(channel.sampler));
    EXPECT_EQ(sampler.interpolation, "LINEAR");
    EXPECT_EQ(rawNumbers<float>(model, sampler.input), times());
    EXPECT_EQ(rawNumbers<float>(model, sampler.output).size(), times().size() * count);
  }
  int meshes = 0;
  std::size_t sparse = 0;
  for (const tinygltf::Node& node : model.nodes) {
    if (node.mesh < 0) continue;
    ++meshes;
    const tinygltf::Mesh& mesh = model.meshes.at(static_cast<std::size_t>(node.mesh));
    EXPECT_EQ(mesh.weights, std::vector<double>(count, 0.0));
    EXPECT_EQ(mesh.extras.Get("targetNames").ArrayLen(), count);
    EXPECT_EQ(mesh.extras.Get("targetNames").Get(0).Get<std::string>(), clip_->name + " 1");
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      ASSERT_EQ(primitive.targets.size(), count);
      for (const auto& target : primitive.targets) {
        EXPECT_TRUE(target.contains("NORMAL"));
        const auto& accessor = model.accessors.at(static_cast<std::size_t>(target.at("POSITION")));
        EXPECT_EQ(accessor.minValues.size(), 3u);
        EXPECT_EQ(accessor.maxValues.size(), 3u);
        sparse += accessor.sparse.isSparse ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(channels, meshes);
  EXPECT_GT(sparse, 0u);
}

TEST_P(BakedExport, NormalsFollowTheLiveSurface) {
  const auto file = folder_.path() / "out.glb";
  ASSERT_TRUE(bake(file).ok());
  const tinygltf::Model model = rawModel(file);
  const GltfOracle oracle(file);
  double morphed = 0.0;
  double still = 0.0;
  forEachSurface(times(), [&](float time, const Surface& surface) {
    const auto with = oracle.normals(0, static_cast<double>(time), true);
    const auto without = oracle.normals(0, static_cast<double>(time), false);
    const auto& triangles = surface.refinement->drawTriangles;
    ASSERT_EQ(with.size(), triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 live(shadingNormal(surface, triangles[t][i]));
        morphed += 1.0 - glm::dot(live, with[t][i]);
        still += 1.0 - glm::dot(live, without[t][i]);
      }
    }
  });
  EXPECT_LT(morphed, 0.5 * still);
}

TEST_P(BakedExport, OutputDoesNotDependOnThreads) {
  for (const char* name : {"out.glb", "out.mdd", "out.usda"}) {
    const auto file = folder_.path() / name;  // USD names its root after the file.
    ASSERT_TRUE(bake(file).ok());
    const std::string first = readWholeFile(file, 1 << 28).value();
    const ThreadLimit limit(3);
    ASSERT_TRUE(bake(file).ok());
    EXPECT_EQ(readWholeFile(file, 1 << 28).value(), first);
  }
}

TEST_P(BakedExport, ReportsProgressAndCanBeCanceledAtAnyTime) {
  for (const char* name : {"out.gltf", "out.pc2", "out.usda"}) {
    const auto file = folder_.path() / name;
    std::vector<double> told;
    ASSERT_TRUE(bake(file, 0.2, 8.0, [&](double share) {
                  told.push_back(share);
                  return true;
                }).ok());
    ASSERT_GT(told.size(), 3u);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_GE(told.front(), 0.0);
    EXPECT_LE(told.back(), 1.0);
    EXPECT_GT(told.back(), 0.7);
    std::filesystem::remove_all(folder_.path());
    std::filesystem::create_directory(folder_.path());
    for (const std::size_t last : {std::size_t{0}, told.size() / 2, told.size() - 1}) {
      std::size_t calls = 0;
      const auto report = bake(file, 0.2, 8.0, [&](double) { return calls++ < last; });
      ASSERT_FALSE(report.ok());
      EXPECT_EQ(report.error().reason, kCanceled);
      EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
    }
  }
}

/// Reads numbers in sequence.
class Bytes {
 public:
  Bytes(std::string bytes, bool bigEndian) : bytes_(std::move(bytes)), bigEndian_(bigEndian) {}

  std::string text(std::size_t count) {
    next_ += count;
    return bytes_.substr(next_ - count, count);
  }
  std::uint32_t number() {
    std::uint32_t value = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const auto byte = static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_.at(next_++)));
      value |= byte << 8U * (bigEndian_ ? 3 - i : i);
    }
    return value;
  }
  float real() { return std::bit_cast<float>(number()); }
  [[nodiscard]] bool isAtEnd() const { return next_ == bytes_.size(); }

 private:
  std::string bytes_;
  bool bigEndian_;
  std::size_t next_ = 0;
};

TEST_P(BakedExport, PointCachesHoldTheLiveVertices) {
  for (const bool isMdd : {false, true}) {
    const auto file = folder_.path() / (isMdd ? "out.mdd" : "out.pc2");
    const auto report = bake(file);
    ASSERT_TRUE(report.ok()) << report.error().text();
    Bytes bytes(readWholeFile(file, 1 << 30).value(), isMdd);
    const auto frames = static_cast<std::uint32_t>(times().size());
    const auto points = static_cast<std::uint32_t>(report->vertices);
    if (isMdd) {
      EXPECT_EQ(bytes.number(), frames);
      EXPECT_EQ(bytes.number(), points);
      for (const float time : times()) EXPECT_EQ(bytes.real(), time);
    } else {
      EXPECT_EQ(bytes.text(12), std::string("POINTCACHE2\0", 12));
      EXPECT_EQ(bytes.number(), 1u);
      EXPECT_EQ(bytes.number(), points);
      EXPECT_EQ(bytes.real(), 0.0f);
      EXPECT_EQ(bytes.real(), 1.0f);
      EXPECT_EQ(bytes.number(), frames);
    }
    forEachSurface(times(), [&](float time, const Surface& surface) {
      ASSERT_EQ(surface.positions.size(), points);
      for (const glm::vec3& place : surface.positions) {
        const glm::vec3 cached{bytes.real(), bytes.real(), bytes.real()};  // Braces: evaluated in this order.
        ASSERT_EQ(cached, place) << time;
      }
    });
    EXPECT_TRUE(bytes.isAtEnd());
    const std::string object = readWholeFile(folder_.path() / "out.obj", 1 << 30).value();
    std::size_t lines = 0;
    for (std::size_t at = object.find("\nv "); at != std::string::npos; at = object.find("\nv ", at + 1)) ++lines;
    EXPECT_EQ(lines, points);
  }
}

INSTANTIATE_TEST_SUITE_P(Characters, BakedExport, ::testing::Values("demo", "greenman.glb"), nameOfScene);
INSTANTIATE_TEST_SUITE_P(Large, BakedExport,
                         ::testing::Values("humanoid-flex", "horse", "Fox.glb", "cesium_man.gltf", "robot.glb"),
                         nameOfScene);

}  // namespace
}  // namespace sinew::test
