// tests/bodies/transfer_clips_test.cpp: clips of one body played on another.

#include "core/bodies/transfer_clips.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/bodies/body_map.h"
#include "core/geometry/at.h"
#include "sinew/character/pose.h"
#include "tests/support/characters/named_bodies.h"

namespace sinew {
namespace {

using test::NamedBody;
using test::Stance;

using Expected = std::map<std::string, std::string>;

Character bodyOf(std::size_t style, Stance stance, Expected& slots) {
  return test::characterOf(test::namedBodies().at(style), stance, slots);
}

/// Every joint rotates about its own axis, and the named one also moves.
AnimationClip swaying(const Skeleton& skeleton, int moved, float size) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  AnimationClip clip;
  clip.name = "sway";
  clip.duration = 1.0f;
  for (const Bone& bone : skeleton.bones) {
    Channel channel{bone.node, ChannelPath::kRotation, Interpolation::kLinear, {0.0f, 0.5f, 1.0f}, {}};
    const glm::quat rest = at(skeleton.nodes, bone.node).rest.rotation;
    const glm::vec3 axis = glm::normalize(glm::vec3(any(random), any(random), any(random)) + glm::vec3(1e-3f));
    for (const float angle : {0.1f, 0.5f, -0.3f}) {
      const glm::quat turned = rest * glm::angleAxis(angle, axis);
      channel.values.emplace_back(turned.x, turned.y, turned.z, turned.w);
    }
    clip.channels.push_back(std::move(channel));
  }
  const glm::vec3 rest = at(skeleton.nodes, at(skeleton.bones, moved).node).rest.translation;
  Channel path{at(skeleton.bones, moved).node, ChannelPath::kTranslation, Interpolation::kLinear, {0.0f, 1.0f}, {}};
  path.values = {glm::vec4(rest, 0.0f), glm::vec4(rest + size * glm::vec3(0.1f, -0.05f, 0.3f), 0.0f)};
  clip.channels.push_back(std::move(path));
  return clip;
}

/// Twice as large, all names with a prefix.
Character scaledAndRenamed(Character character, float scale, const std::string& prefix) {
  Skeleton& skeleton = character.skeleton;
  for (Node& node : skeleton.nodes) node.rest.translation *= scale;
  for (Bone& bone : skeleton.bones) {
    bone.name = prefix + bone.name;
    at(skeleton.nodes, bone.node).name = bone.name;
    bone.bindInWorld[3] = glm::vec4(scale * glm::vec3(bone.bindInWorld[3]), 1.0f);
  }
  finishBones(skeleton);
  for (std::size_t i = 0; i < skeleton.bones.size(); ++i) {
    skeleton.bindings.at(i).inverseBind = skeleton.bones[i].inverseBindInWorld;
  }
  character.height *= scale;
  return character;
}

glm::dvec3 jointIn(const Pose& pose, int bone) { return glm::dvec3(at(pose.boneInWorld, bone)[3]); }

bool isFinitePose(const Pose& pose) {
  return std::ranges::all_of(pose.boneInWorld, [](const glm::mat4& matrix) { return isFinite(matrix); });
}

TEST(TransferClips, SameSkeletonKeepsEveryBit) {
  Expected slots;
  Character from = bodyOf(0, Stance::kArmsLevel, slots);
  // As in files, where rotations are never exactly of unit length.
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  const auto anyTurn = [&] { return glm::normalize(glm::quat(any(random), any(random), any(random), any(random))); };
  for (Node& node : from.skeleton.nodes) node.rest.rotation = 0.999999f * anyTurn();
  for (Bone& bone : from.skeleton.bones) bone.bindInWorld = bone.bindInWorld * glm::mat4_cast(anyTurn());
  finishBones(from.skeleton);
  const Character to = from;
  from.clips = {swaying(from.skeleton, 0, 1.0f)};
  from.clips.front().channels.front().interpolation = Interpolation::kStep;
  // Not transferred to other skeletons: a bone that stretches.
  const int last = from.skeleton.bones.back().node;
  from.clips.front().channels.push_back(
      {last, ChannelPath::kTranslation, Interpolation::kLinear, {0.0f, 1.0f}, {glm::vec4(0.0f), glm::vec4(0.1f)}});
  const TransferredClips made = transferClips(from, to, {}, "walk.glb");
  ASSERT_EQ(made.clips.size(), 1u);
  EXPECT_TRUE(made.notes.empty());
  const AnimationClip& clip = made.clips.front();
  EXPECT_EQ(clip.addedFrom, "walk.glb");
  EXPECT_EQ(clip.name, "sway");
  ASSERT_EQ(clip.channels.size(), from.clips.front().channels.size());
  for (const float time : {0.0f, 0.21f, 0.5f, 0.77f, 1.0f}) {
    EXPECT_EQ(samplePose(to.skeleton, clip, time), samplePose(from.skeleton, from.clips.front(), time));
  }
}

TEST(TransferClips, TakenNamesGetANumber) {
  Expected slots;
  Character from = bodyOf(0, Stance::kArmsLevel, slots);
  from.clips = {swaying(from.skeleton, 0, 1.0f), swaying(from.skeleton, 0, 1.0f)};
  const TransferredClips made = transferClips(from, from, {}, "walk.glb");
  ASSERT_EQ(made.clips.size(), 2u);
  EXPECT_EQ(made.clips[0].name, "sway 2");
  EXPECT_EQ(made.clips[1].name, "sway 3");
}

TEST(TransferClips, ScaledAndRenamedCopyPlaysTheSame) {
  for (const char* prefix : {"mixamorig:", "Armature|", "Bip01 ", "hero_"}) {
    Expected slots;
    Character from = bodyOf(0, Stance::kArmsLevel, slots);
    const std::string hips = slots.at("hips");
    const int moved = from.skeleton.findBone(hips).value();
    from.clips = {swaying(from.skeleton, moved, 1.0f)};
    const float scale = 2.5f;
    Character to = scaledAndRenamed(from, scale, prefix);
    to.clips.clear();
    const TransferredClips made = transferClips(from, to, {}, "walk.glb");
    ASSERT_EQ(made.clips.size(), 1u) << prefix;
    double most = 0.0;
    for (int i = 0; i <= 20; ++i) {
      const Pose own = samplePose(from.skeleton, from.clips.front(), static_cast<float>(i) / 20.0f);
      const Pose played = samplePose(to.skeleton, made.clips.front(), static_cast<float>(i) / 20.0f);
      for (std::size_t bone = 0; bone < own.boneInWorld.size(); ++bone) {
        const int b = static_cast<int>(bone);
        most = std::max(most, glm::distance(static_cast<double>(scale) * jointIn(own, b), jointIn(played, b)));
      }
    }
    EXPECT_LT(most, 2e-3 * static_cast<double>(scale)) << prefix;
  }
}

/// A body with level arms plays a clip of one whose arms hang: at all times the limbs have the same directions.
TEST(TransferClips, ArmsOfAnotherStanceFollowTheClip) {
  for (const auto& [ours, theirs] : {std::pair{0U, 0U}, std::pair{0U, 1U}, std::pair{1U, 0U}}) {
    Expected fromSlots;
    Expected toSlots;
    Character from = bodyOf(theirs, Stance::kArmsDown, fromSlots);
    Character to = bodyOf(ours, Stance::kArmsLevel, toSlots);
    from.clips = {swaying(from.skeleton, from.skeleton.findBone(fromSlots.at("hips")).value(), 1.0f)};
    const TransferredClips made = transferClips(from, to, {}, "walk.glb");
    ASSERT_EQ(made.clips.size(), 1u);
    for (int i = 0; i <= 10; ++i) {
      const float time = static_cast<float>(i) / 10.0f;
      const Pose own = samplePose(from.skeleton, from.clips.front(), time);
      const Pose played = samplePose(to.skeleton, made.clips.front(), time);
      for (const std::pair<const char*, const char*>& ends :
           {std::pair{"upperArm", "lowerArm"}, std::pair{"lowerArm", "hand"}, std::pair{"upperLeg", "lowerLeg"},
            std::pair{"lowerLeg", "foot"}}) {
        for (const char* side : {".L", ".R"}) {
          const auto way = [&](const Character& character, const Pose& pose, const Expected& slots) {
            const int head = character.skeleton.findBone(slots.at(std::string(ends.first) + side)).value();
            const int tail = character.skeleton.findBone(slots.at(std::string(ends.second) + side)).value();
            return glm::normalize(jointIn(pose, tail) - jointIn(pose, head));
          };
          const double apart = glm::distance(way(from, own, fromSlots), way(to, played, toSlots));
          EXPECT_LT(apart, 5e-3) << ends.first << side << " at " << time << ", styles " << theirs << " and " << ours;
        }
      }
    }
  }
}

TEST(TransferClips, MatchesEveryNamingStyleWithEveryOther) {
  const std::vector<NamedBody> bodies = test::namedBodies();
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (bodies[a].quadruped != bodies[b].quadruped) continue;
      Expected fromSlots;
      Expected toSlots;
      Character from = bodyOf(a, Stance::kArmsLevel, fromSlots);
      const Character to = bodyOf(b, Stance::kArmsDown, toSlots);
      const BodySlots theirs = bodySlots(from, makeMirrorPlan(from));
      const BodySlots ours = bodySlots(to, makeMirrorPlan(to));
      const std::vector<int> partner = matchBones(from.skeleton, theirs, to.skeleton, ours);
      for (const BodySlot slot : allBodySlots()) {
        if (slot.slot < Slot::kUpperArm || slot.slot == Slot::kToes) continue;
        const int bone = ours[slot].bone;
        if (bone < 0 || theirs[slot].bone < 0) continue;
        EXPECT_EQ(at(partner, bone), theirs[slot].bone)
            << bodies[a].style << " on " << bodies[b].style << ", " << nameOf(slot);
      }
    }
  }
}

TEST(TransferClips, SidesAreNeverSwapped) {
  Expected slots;
  Expected others;
  Character from = bodyOf(0, Stance::kArmsLevel, slots);
  const Character to = bodyOf(1, Stance::kArmsLevel, others);
  const int arm = from.skeleton.findBone(slots.at("upperArm.L")).value();
  from.clips = {swaying(from.skeleton, 0, 0.0f)};
  std::erase_if(from.clips.front().channels,
                [&](const Channel& channel) { return channel.node != at(from.skeleton.bones, arm).node; });
  const TransferredClips made = transferClips(from, to, {}, "raise.glb");
  ASSERT_EQ(made.clips.size(), 1u);
  const Pose start = samplePose(to.skeleton, made.clips.front(), 0.0f);
  const Pose later = samplePose(to.skeleton, made.clips.front(), 0.5f);
  const auto moved = [&](const char* slot) {
    const int hand = to.skeleton.findBone(others.at(slot)).value();
    return glm::distance(jointIn(start, hand), jointIn(later, hand));
  };
  EXPECT_GT(moved("hand.L"), 0.02);
  EXPECT_LT(moved("hand.R"), 1e-6);
}

TEST(TransferClips, MismatchedSkeletonIsReported) {
  Expected slots;
  Character from = bodyOf(0, Stance::kArmsLevel, slots);
  from.clips = {swaying(from.skeleton, 0, 1.0f)};
  Character to = from;
  to.clips.clear();
  for (Bone& bone : to.skeleton.bones) bone.name = "q" + std::to_string(&bone - to.skeleton.bones.data());
  for (Node& node : to.skeleton.nodes) node.name = "n";
  for (Bone& bone : to.skeleton.bones) bone.bindInWorld = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 1.0f, 0.0f));
  finishBones(to.skeleton);
  const TransferredClips made = transferClips(from, to, {}, "walk.glb");
  EXPECT_TRUE(made.clips.empty());
  ASSERT_FALSE(made.notes.empty());
  EXPECT_NE(made.notes.back().find("no bone of the clips is a bone of the character"), std::string::npos)
      << made.notes.back();
}

TEST(TransferClips, ShapesMatchByName) {
  Expected slots;
  Character from = bodyOf(0, Stance::kArmsLevel, slots);
  Character to = from;
  from.morphTargets = {{"smile", 3, 0.0f, {}, {}}, {"blink", 3, 0.0f, {}, {}}};
  to.morphTargets = {{"frown", 7, 0.25f, {}, {}}, {"smile", 7, 0.0f, {}, {}}};
  AnimationClip clip;
  clip.name = "face";
  clip.duration = 1.0f;
  clip.morphChannels = {{0, 2, Interpolation::kLinear, {0.0f, 1.0f}, {0.0f, 0.1f, 1.0f, 0.5f}}};
  from.clips = {clip};
  const TransferredClips made = transferClips(from, to, {}, "face.glb");
  ASSERT_EQ(made.clips.size(), 1u);
  ASSERT_EQ(made.clips.front().morphChannels.size(), 1u);
  EXPECT_EQ(made.clips.front().morphChannels.front().values, (std::vector<float>{0.25f, 0.0f, 0.25f, 1.0f}));
}

/// Random trees, flat and mirrored bind poses, random rotations: poses are finite, and no longer than the clip.
TEST(TransferClips, RandomSkeletonsGiveFinitePoses) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  const auto make = [&] {
    Character character;
    const int count = 1 + static_cast<int>(random() % 24);
    for (int i = 0; i < count; ++i) {
      Node node;
      node.name = "b" + std::to_string(random() % 30);
      node.parent = i == 0 ? -1 : static_cast<int>(random() % static_cast<unsigned>(i));
      node.rest.translation = {any(random), any(random), any(random)};
      node.rest.rotation = glm::normalize(glm::quat(any(random) + 1.1f, any(random), any(random), any(random)));
      if (random() % 9 == 0) node.rest.scale = {any(random), 0.0f, -1.0f};
      if (random() % 9 == 0) node.rest.matrix = glm::mat4(any(random));
      Bone bone;
      bone.name = node.name;
      bone.node = i;
      bone.parent = node.parent;
      bone.bindInWorld = node.rest.toMatrix();
      character.skeleton.nodes.push_back(node);
      character.skeleton.bones.push_back(bone);
    }
    finishBones(character.skeleton);
    return character;
  };
  for (int round = 0; round < 200; ++round) {
    Character from = make();
    const Character to = make();
    from.clips = {swaying(from.skeleton, 0, 1.0f)};
    std::erase_if(from.clips.front().channels, [&](const Channel& channel) {
      return at(from.skeleton.nodes, channel.node).rest.matrix.has_value();
    });
    const TransferredClips made = transferClips(from, to, {}, "a.glb");
    for (const AnimationClip& clip : made.clips) {
      for (const Channel& channel : clip.channels) {
        ASSERT_FALSE(channel.times.empty());
        EXPECT_TRUE(std::ranges::is_sorted(channel.times, std::less_equal{}) || channel.times.size() == 1);
        for (const glm::vec4& value : channel.values) EXPECT_TRUE(isFinite(glm::vec3(value)) && std::isfinite(value.w));
      }
      EXPECT_TRUE(isFinitePose(samplePose(to.skeleton, clip, 0.4f))) << round;
    }
  }
}

TEST(TransferClips, SkeletonOfOtherRestScalesIsAnotherSkeleton) {
  Expected slots;
  Character from = bodyOf(0, Stance::kArmsLevel, slots);
  from.clips = {swaying(from.skeleton, 0, 1.0f)};
  const int last = from.skeleton.bones.back().node;
  from.clips.front().channels.push_back(
      {last, ChannelPath::kTranslation, Interpolation::kLinear, {0.0f, 1.0f}, {glm::vec4(0.0f), glm::vec4(0.1f)}});
  Character to = from;
  EXPECT_EQ(transferClips(from, to, {}, "a.glb").clips.at(0).channels.size(), from.clips[0].channels.size());
  at(to.skeleton.nodes, last).rest.scale = glm::vec3(2.0f);
  EXPECT_LT(transferClips(from, to, {}, "a.glb").clips.at(0).channels.size(), from.clips[0].channels.size())
      << "only the same skeleton is given what stretches a bone";
}

}  // namespace
}  // namespace sinew
