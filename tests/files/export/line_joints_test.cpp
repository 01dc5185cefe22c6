// tests/files/export/line_joints_test.cpp: in every pose a line's joint applies the line's deformation relative to the
// bind pose.

#include "core/files/fit/helper_motion.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"
#include "core/rig/posed_rig.h"
#include "tests/files/export/export_scenes.h"

namespace sinew::exporting {
namespace {

std::vector<Pose> posesOf(const std::shared_ptr<const Character>& character, float every) {
  std::vector<Pose> poses;
  const auto moving = withRangeOfMotion(character);
  for (const AnimationClip& clip : moving->clips) {
    for (float time = 0.0f; time < clip.duration; time += every) {
      poses.push_back(samplePose(character->skeleton, clip, time));
    }
  }
  return poses;
}

/// Deformation of a line relative to the bind pose, by docs/muscles.md.
glm::dmat4 motionOf(const Rig& rig, const Character& character, const Pose& pose, int line) {
  const RigPoser poser(rig, character);
  const std::vector<PosedLine> now = poser.pose(pose).lines;
  const std::vector<PosedLine> inBind = poser.pose(bindPose(character.skeleton)).lines;
  return glm::dmat4(at(now, line).deformation) * glm::inverse(glm::dmat4(at(inBind, line).deformation));
}

class BundledLineJoints : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    scene_ = test::bundledScene(GetParam());
    // Bellies that are already thick in the bind pose.
    for (std::size_t i = 0; i < scene_.rig.lines.size(); i += 3) scene_.rig.lines[i].settings.base = 0.4f;
  }
  test::ExportScene scene_;
};

TEST_P(BundledLineJoints, FollowTheLine) {
  const Character& character = *scene_.character;
  const std::vector<Pose> poses = posesOf(scene_.character, 0.43f);
  const LineJoints lines(scene_.rig, character, JointScale::kFull, poses);
  ASSERT_EQ(lines.joints().size(), scene_.rig.lines.size());
  const auto height = static_cast<double>(character.height);
  std::vector<Trs> locals;
  for (const Pose& pose : poses) {
    lines.pose(pose, locals);
    for (std::size_t j = 0; j < locals.size(); ++j) {
      const HelperJoint& joint = lines.joints()[j];
      const glm::dmat4 wanted = motionOf(scene_.rig, character, pose, joint.line);
      const glm::dmat4 found = helperMatrix(joint, pose, locals[j]);
      const glm::dvec4 place = glm::inverse(joint.inverseBind)[3];
      for (const glm::dvec3& aside :
           {glm::dvec3(0.0), glm::dvec3(0.1, 0.0, 0.0), glm::dvec3(0.0, 0.1, 0.0), glm::dvec3(0.0, 0.0, 0.1)}) {
        const glm::dvec4 point = place + glm::dvec4(height * aside, 0.0);
        ASSERT_LT(glm::distance(glm::dvec3(found * point), glm::dvec3(wanted * point)), 3e-5 * height) << joint.name;
      }
    }
  }
}

TEST_P(BundledLineJoints, FollowBottomAndTopOfTheBellyWithoutScale) {
  const Character& character = *scene_.character;
  const std::vector<Pose> poses = posesOf(scene_.character, 0.71f);
  const LineJoints lines(scene_.rig, character, JointScale::kNone, poses);
  ASSERT_EQ(lines.joints().size(), 2 * scene_.rig.lines.size());
  std::vector<Trs> locals;
  for (const Pose& pose : poses) {
    lines.pose(pose, locals);
    for (std::size_t j = 0; j < locals.size(); ++j) {
      const HelperJoint& joint = lines.joints()[j];
      EXPECT_EQ(locals[j].scale, glm::dvec3(1.0));
      const glm::dvec4 place = glm::inverse(joint.inverseBind)[3];
      const glm::dvec3 wanted(motionOf(scene_.rig, character, pose, joint.line) * place);
      ASSERT_LT(glm::distance(glm::dvec3(helperMatrix(joint, pose, locals[j]) * place), wanted),
                3e-5 * static_cast<double>(character.height));
    }
  }
}

TEST_P(BundledLineJoints, KeepTheBindPose) {
  const Pose bind = bindPose(scene_.character->skeleton);
  for (const JointScale scale : {JointScale::kFull, JointScale::kUniform, JointScale::kNone}) {
    const LineJoints lines(scene_.rig, *scene_.character, scale, {});
    std::vector<Trs> locals;
    lines.pose(bind, locals);
    for (std::size_t j = 0; j < locals.size(); ++j) {
      const HelperJoint& joint = lines.joints()[j];
      for (const Trs& local : {locals[j], joint.rest}) {
        const glm::dmat4 matrix = helperMatrix(joint, bind, local);
        for (int column = 0; column < 4; ++column) {
          EXPECT_LT(glm::distance(matrix[column], glm::dmat4(1.0)[column]), 3e-5 * (1.0 + scene_.character->height));
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rigs, BundledLineJoints, ::testing::Values("humanoid-flex", "horse-flex"),
                         [](const auto& rig) { return std::string(rig.param) == "horse-flex" ? "horse" : "humanoid"; });

/// Bones with uneven scale would shear their children.
TEST(LineJoints, UseAParentWithUniformScale) {
  const test::ExportScene scene = test::bundledScene("humanoid-flex");
  const Character& character = *scene.character;
  Pose pose = bindPose(character.skeleton);
  const LineJoints plain(scene.rig, character, JointScale::kFull, std::span(&pose, 1));
  const HelperJoint& first = plain.joints().front();
  const int parent = at(character.skeleton.bones, first.bone).parent;
  ASSERT_GE(parent, 0);
  glm::mat4& matrix = at(pose.boneInWorld, first.bone);
  matrix[0] *= 1.7f;
  const LineJoints lines(scene.rig, character, JointScale::kFull, std::span(&pose, 1));
  EXPECT_EQ(lines.joints().front().bone, parent);
  std::vector<Trs> locals;
  lines.pose(pose, locals);
  const glm::dmat4 wanted = motionOf(scene.rig, character, pose, first.line);
  const glm::dmat4 found = helperMatrix(lines.joints().front(), pose, locals.front());
  for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(found[column], wanted[column]), 1e-4);
}

}  // namespace
}  // namespace sinew::exporting
