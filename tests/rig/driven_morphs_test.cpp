// tests/rig/driven_morphs_test.cpp: morph target weights from file, clip, keys and drivers, and the resulting surface.
#include <limits>

#include <gtest/gtest.h>

#include "core/rig/animated_edit.h"
#include "core/rig/posed_rig.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/gltf_import.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

class DrivenMorphs : public ::testing::Test {
 protected:
  void SetUp() override {
    character_ = importGltf(folder_.write("post.glb", makeMorphingPost(3, 4).file.glb())).value();
    rig_ = withMorphsOf(randomRig(*character_, {}, 2), *character_);
  }
  [[nodiscard]] Pose at(float time) const { return samplePose(*character_, character_->clips.front(), time); }
  [[nodiscard]] std::vector<float> weights(const Rig& rig, const Pose& pose) const {
    return RigPoser(rig, *character_).pose(pose).morphWeights;
  }
  [[nodiscard]] Surface surface(const Rig& rig, const Pose& pose) const {
    Smoother smoother(character_);
    EXPECT_TRUE(smoother.prepare(rig).ok());
    Surface out;
    smoother.smooth(pose, out);
    return out;
  }

  TemporaryFolder folder_;
  std::shared_ptr<const Character> character_;
  Rig rig_;
};

TEST_F(DrivenMorphs, RigWeightsAddToTheClip) {
  const Rig more = setMorphWeight(rig_, morphName(1), 0.5f).value();
  for (const float time : {0.0f, 0.2f, 0.9f}) {
    const Pose pose = at(time);
    const std::vector<float> own = weights(rig_, pose);
    EXPECT_EQ(own, pose.morphWeights);
    const std::vector<float> now = weights(more, pose);
    EXPECT_EQ(now[0], own[0]);
    EXPECT_EQ(now[1], own[1] + 0.5f);
    EXPECT_EQ(now[2], own[2]);
  }
}

/// A corrective: the further the knee bends, the larger the weight.
TEST_F(DrivenMorphs, BendDrivesAShape) {
  DriverInput input;
  input.bone = "knee";
  const Driver driver{input, {{{0.0f, 0.0f}, {90.0f, 2.0f}}, CurveKind::kLinear}, DriverMode::kAdd, {}};
  const Rig rig = setDriver(rig_, {Parameter::kMorphWeight, 2}, driver, -1).value();
  for (const float time : {0.0f, 0.25f, 0.5f, 1.0f}) {
    const Pose pose = at(time);
    EXPECT_NEAR(weights(rig, pose)[2], pose.morphWeights[2] + 2.0f * time, 1e-4f) << time;
  }
}

TEST_F(DrivenMorphs, KeysReplaceTheRigWeightAndAreClamped) {
  Rig rig = setMorphWeight(rig_, morphName(0), 3.0f).value();
  rig = setKey(std::move(rig), {Parameter::kMorphWeight, 0}, "bend", 0.0f, 1.0f).value();
  const Pose pose = at(0.4f);
  EXPECT_NEAR(weights(rig, pose)[0], pose.morphWeights[0] + 1.0f, 1e-6f);
  EXPECT_EQ(weights(rig, bindPose(character_->skeleton))[0], 3.0f) << "no clip, no keys";
  rig = setKey(std::move(rig), {Parameter::kMorphWeight, 0}, "bend", 0.0f, 700.0f).value();
  EXPECT_NEAR(weights(rig, pose)[0], pose.morphWeights[0] + kMostMorphWeight, 1e-5f);
}

/// Equal weights give the same surface, wherever they come from; with adaptive detail the levels stay.
TEST_F(DrivenMorphs, SurfaceDependsOnlyOnTheSum) {
  for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
    rig_.smoothing.detail = detail;
    const Rig more = setMorphWeight(rig_, morphName(1), 0.75f).value();
    Pose pose = at(0.3f);
    const Surface byRig = surface(more, pose);
    pose.morphWeights[1] += 0.75f;
    const Surface byPose = surface(rig_, pose);
    EXPECT_TRUE(sameBytes(byRig.positions, byPose.positions));
    EXPECT_TRUE(sameBytes(byRig.normals, byPose.normals));
    EXPECT_FALSE(sameBytes(byRig.positions, surface(rig_, at(0.3f)).positions));
  }
}

TEST_F(DrivenMorphs, SurfaceDoesNotDependOnThePreviousOne) {
  rig_.smoothing.creaseAngle = 30.0f;
  Smoother kept(character_);
  ASSERT_TRUE(kept.prepare(rig_).ok());
  Random random(3);
  Surface out;
  for (int i = 0; i < 12; ++i) {
    Pose pose = at(random.uniform(0.0f, 1.0f));
    if (i % 3 == 0) pose.morphWeights.assign(3, 0.0f);
    if (i % 4 == 1) pose.morphWeights.clear();
    kept.smooth(pose, out);
    const Surface fresh = surface(rig_, pose);
    EXPECT_TRUE(sameBytes(out.positions, fresh.positions)) << i;
    EXPECT_TRUE(sameBytes(out.normals, fresh.normals)) << i;
    EXPECT_TRUE(sameBytes(out.shadingNormals, fresh.shadingNormals)) << i;
    if (i % 5 == 4) {
      rig_.smoothing.creaseAngle = random.uniform(10.0f, 60.0f);
      ASSERT_TRUE(kept.prepare(rig_).ok());
    }
  }
}

}  // namespace
}  // namespace sinew::test
