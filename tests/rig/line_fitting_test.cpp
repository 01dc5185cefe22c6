// tests/rig/line_fitting_test.cpp: lengths learned from poses and clips, via points, a muscle's other end.

#include "core/rig/line_edit.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/posed_rig.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew {
namespace {

struct LineFitting : testing::Test {
  std::shared_ptr<const Character> limb = test::makeLimb();
  Rig rig;

  LineFitting() {
    MuscleLine line;
    line.name = "flexor";
    line.origin = {"root", {0.0f, 0.3f, 0.15f}, {}};
    line.insertion = {"middle", {0.0f, 0.3f, 0.15f}, {}};
    rig = addLine(rig, line).value();
  }

  [[nodiscard]] LineLengths lengths() const {
    return lengthsOver(lineRest(rig.lines[0], *limb).value(), *limb, limb->clips);
  }
  /// Stretch at one time of the clip, computed independently of lengthsOver.
  [[nodiscard]] float stretchAt(const Rig& of, float time) const {
    return RigPoser(of, *limb).pose(samplePose(limb->skeleton, limb->clips.front(), time)).lines.front().stretch;
  }
};

TEST_F(LineFitting, LongClipsAreSampledSparsely) {
  const LineLengths seen = lengths();
  for (const float seconds : {3700.0f, 1e6f, 1e15f}) {
    Character slow = *limb;
    for (AnimationClip& clip : slow.clips) {
      for (Channel& channel : clip.channels) {
        for (float& time : channel.times) time *= seconds / clip.duration;
      }
      clip.duration = seconds;
    }
    const LineLengths all = lengthsOver(lineRest(rig.lines[0], slow).value(), slow, slow.clips);
    EXPECT_GT(all.poses, 50'000);
    EXPECT_LE(all.poses, 60'002);
    // With more sample times the minimum is smaller, but not by much.
    EXPECT_LE(all.least, seen.least + 1e-4f);
    EXPECT_NEAR(all.least, seen.least, 0.03f);
    EXPECT_GE(all.most, seen.most - 1e-4f);
    EXPECT_NEAR(all.most, seen.most, 0.03f);
  }
}

TEST_F(LineFitting, LengthsCoverTheClip) {
  const LineLengths seen = lengths();
  EXPECT_EQ(seen.poses, 31);
  EXPECT_LT(seen.least, 0.98f);
  EXPECT_GE(seen.secondPercentile, seen.least);
  for (float time = 0.0f; time <= 2.0f; time += 0.05f) {
    EXPECT_GT(stretchAt(rig, time), seen.least - 0.03f);
    EXPECT_LT(stretchAt(rig, time), seen.most + 0.03f);
  }
  EXPECT_EQ(seen.shortestIn, "bend");
}

TEST_F(LineFitting, LearnedContractionIsFullAtTheShortestLength) {
  const LineLengths seen = lengths();
  const Result<Learned> learned = withLearned(rig, 0, seen);
  ASSERT_TRUE(learned.ok()) << learned.error().text();
  EXPECT_FLOAT_EQ(learned->rig.lines[0].settings.full, seen.secondPercentile);
  LineLengths never = seen;
  never.least = never.secondPercentile = 1.0f;
  EXPECT_FALSE(withLearned(rig, 0, never).ok());
  LineLengths far = seen;
  far.most = 1.6f;
  EXPECT_NE(withLearned(rig, 0, far)->warning.find("160 %"), std::string::npos);
}

TEST_F(LineFitting, RestNowMakesTheCurrentLengthOneHundredPercent) {
  const float before = stretchAt(rig, 0.5f);
  const Rig rested = withRestNow(rig, 0, before).value();
  EXPECT_NEAR(stretchAt(rested, 0.5f), 1.0f, 1e-5f);
  EXPECT_FALSE(withFullNow(rig, 0, 1.05f).ok());
  EXPECT_FLOAT_EQ(withFullNow(rig, 0, 0.8f)->lines[0].settings.full, 0.8f);
}

TEST_F(LineFitting, ViaPointKeepsTheLineOutOfTheJoint) {
  const Rig bent = withViaPoint(rig, 0, *limb).value();
  ASSERT_TRUE(bent.lines[0].via);
  EXPECT_EQ(bent.lines[0].via->bone, "root");
  // In the bind pose the line passes the joint on this side, and no closer than before.
  const LineRest rest = lineRest(bent.lines[0], *limb).value();
  const glm::dvec3 joint(limb->skeleton.bones[1].bindInWorld[3]);
  EXPECT_GT(rest.via->inBind.z, joint.z);
  EXPECT_GE(glm::distance(rest.via->inBind, joint), 0.015 * 2.0 - 1e-6);
  EXPECT_EQ(withoutViaPoint(bent, 0).value(), rig);
}

TEST(OtherEnd, KeepsTheMuscleInPlaceAndTheTwinFollows) {
  const std::shared_ptr<const Character> legs = test::makeTwoLegged();
  const MirrorPlan plan = makeMirrorPlan(*legs);
  Primitive thigh;
  thigh.name = "thigh L";
  thigh.bone = "leg L";
  thigh.placement.center = {0.0f, -0.2f, 0.1f};
  thigh.placement.radii = {0.08f, 0.25f, 0.08f};
  const Rig rigid = addPair({}, thigh, plan).value();
  const int shin = legs->skeleton.findBone("shin L").value();
  const Result<Rig> own = withOtherEnd(rigid, 0, shin, *legs);
  ASSERT_TRUE(own.ok()) << own.error().text();
  const Rig rig = withTwinOnLine(own.value(), 0, plan);
  EXPECT_TRUE(validate(rig));
  ASSERT_EQ(rig.lines.size(), 2u);
  EXPECT_EQ(rig.lines[0].insertion.bone, "shin L");
  EXPECT_EQ(rig.lines[1].insertion.bone, "shin R");
  EXPECT_EQ(rig.primitives[1].line, rig.lines[1].name);
  EXPECT_EQ(rig.primitives[0].placement, rigid.primitives[0].placement);
  const PosedRig before = RigPoser(rigid, *legs).pose(bindPose(legs->skeleton));
  const PosedRig after = RigPoser(rig, *legs).pose(bindPose(legs->skeleton));
  EXPECT_EQ(before.muscles[0].carrier, after.muscles[0].carrier);
  EXPECT_EQ(before.muscles[1].carrier, after.muscles[1].carrier);
}

}  // namespace
}  // namespace sinew
