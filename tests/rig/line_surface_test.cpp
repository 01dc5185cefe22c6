// tests/rig/line_surface_test.cpp: skin over muscles on lines.

#include <gtest/gtest.h>

#include "core/rig/attachment.h"
#include "sinew/surface/smoother.h"
#include "tests/support/allocations.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/surface/prepared_in_turn.h"

namespace sinew::test {
namespace {

struct LineSurface : testing::TestWithParam<SurfaceMode> {
  std::shared_ptr<const Character> character = makeLimb();
  Rig rig;

  LineSurface() {
    rig.groups = {{"muscles", {}}};
    rig.surface.mode = GetParam();
    rig.smoothing.depth = 4;
    MuscleLine line;
    line.name = "flexor";
    line.origin = {"root", {0.0f, 0.2f, 0.15f}, {}};
    line.insertion = {"end", {0.0f, 0.1f, 0.15f}, {}};
    rig.lines = {line};
    Primitive belly;
    belly.name = "flexor";
    belly.bone = "middle";
    belly.group = "muscles";
    belly.placement = {{0.0f, 0.0f, 0.2f}, glm::quat(1.0f, 0.0f, 0.0f, 0.0f), {0.12f, 0.3f, 0.12f}};
    belly.line = "flexor";
    rig.primitives = {belly};
  }

  [[nodiscard]] Rig withoutLine() const {
    Rig rigid = rig;
    rigid.lines.clear();
    rigid.primitives[0].line.clear();
    // Default territory of a line's muscle.
    rigid.primitives[0].territory = {"root", "middle", "end"};
    return rigid;
  }

  [[nodiscard]] Surface smoothed(const Rig& of, const Pose& pose) const {
    Smoother smoother(character);
    const auto prepared = smoother.prepare(of);
    EXPECT_TRUE(prepared.ok()) << prepared.error().text();
    Surface out;
    smoother.smooth(pose, out);
    return out;
  }

  [[nodiscard]] Pose bent(float time) const { return samplePose(character->skeleton, character->clips.front(), time); }
};

TEST_P(LineSurface, LineChangesNothingInTheBindPose) {
  const Pose bind = bindPose(character->skeleton);
  const Surface on = smoothed(rig, bind);
  EXPECT_EQ(on.positions, smoothed(withoutLine(), bind).positions);
  EXPECT_GT(on.report.projected, 0);
}

TEST_P(LineSurface, FlexingSwells) {
  Pose pose = bindPose(character->skeleton);
  const Surface loose = smoothed(rig, pose);
  pose.flex = 1.0f;
  const Surface tense = smoothed(rig, pose);
  const auto front = [](const Surface& surface) { return boundsOf(surface.positions).high.z; };
  EXPECT_GT(front(tense), front(loose) + 0.02f);
}

TEST_P(LineSurface, FlexesOnlyTheNamedLines) {
  rig.lines.push_back(rig.lines[0]);
  rig.lines[1].name = "other";
  Pose pose = bindPose(character->skeleton);
  const Surface loose = smoothed(rig, pose);
  pose.flex = 1.0f;
  const Surface tense = smoothed(rig, pose);
  pose.flexedLines = {1};
  EXPECT_EQ(smoothed(rig, pose).positions, loose.positions) << "no muscle is on the other line";
  pose.flexedLines = {0};
  EXPECT_EQ(smoothed(rig, pose).positions, tense.positions);
}

TEST_P(LineSurface, BendingDiffersFromARigidMuscle) {
  const Pose pose = bent(0.5f);
  EXPECT_NE(smoothed(rig, pose).positions, smoothed(withoutLine(), pose).positions);
}

TEST_P(LineSurface, MovesRigidlyWithTheWholeBody) {
  const glm::mat4 motion = glm::mat4_cast(glm::angleAxis(1.0f, glm::normalize(glm::vec3(1.0f, 2.0f, -1.0f))));
  Pose pose = bent(0.5f);
  const Surface here = smoothed(rig, pose);
  for (glm::mat4& bone : pose.boneInWorld) bone = motion * bone;
  const Surface there = smoothed(rig, pose);
  float most = 0.0f;
  for (std::size_t v = 0; v < here.positions.size(); ++v) {
    most = std::max(most, glm::distance(glm::vec3(motion * glm::vec4(here.positions[v], 1.0f)), there.positions[v]));
  }
  EXPECT_LT(most, 2e-5f * character->height);
}

TEST_P(LineSurface, LineEditTakesEffectWithoutReattaching) {
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  Rig edited = rig;
  edited.lines[0].settings.flex = {1.0f, 0.5f};
  ASSERT_TRUE(smoother.prepare(edited).ok());
  PreparedInTurn preparations(character);
  const auto attached = preparations.next(rig)->attached;
  EXPECT_EQ(preparations.next(edited)->attached, attached);
  Pose pose = bent(0.5f);
  pose.flex = 0.5f;
  Surface out;
  smoother.smooth(pose, out);
  EXPECT_EQ(out.positions, smoothed(edited, pose).positions);
  Rig moved = edited;
  moved.lines[0].insertion.bone = "middle";
  ASSERT_TRUE(smoother.prepare(moved).ok());
  smoother.smooth(pose, out);
  EXPECT_EQ(out.positions, smoothed(moved, pose).positions);
}

TEST_P(LineSurface, MuscleWithAMissingBoneIsOmitted) {
  Rig foreign = rig;
  foreign.lines[0].insertion.bone = "tail";
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(foreign).ok());
  EXPECT_EQ(smoother.unattached(), std::vector<int>{0});
  const std::vector<MissingBone> missing = missingBones(foreign, character->skeleton);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].place, "lines[0].insertion.bone");
}

TEST_P(LineSurface, FrameAllocatesNothing) {
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  const Pose first = bent(0.5f);
  const Pose second = bent(1.0f);
  Surface out;
  smoother.smooth(first, out);
  smoother.smooth(second, out);
  const std::int64_t before = allocations();
  smoother.smooth(first, out);
  smoother.smooth(second, out);
  EXPECT_EQ(allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(Modes, LineSurface, testing::Values(SurfaceMode::kSwell, SurfaceMode::kReplace));

}  // namespace
}  // namespace sinew::test
