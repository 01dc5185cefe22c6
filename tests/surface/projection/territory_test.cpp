// tests/surface/projection/territory_test.cpp: a muscle moves only the skin of its territory, whatever the pose.

#include <algorithm>

#include <gtest/gtest.h>

#include "core/character/bindings.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

/// For each control vertex: whether it has skin weight on one of the bones.
std::vector<bool> touchedBy(const Character& character, const std::vector<std::string>& bones) {
  std::vector<bool> out;
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    bool touched = false;
    for (const WeightedBinding& follows : bindingsOf(character, static_cast<int>(v))) {
      const std::string& name = character.skeleton.bones[static_cast<std::size_t>(follows.bone())].name;
      if (follows.weight > 0.0f && std::ranges::find(bones, name) != bones.end()) touched = true;
    }
    out.push_back(touched);
  }
  return out;
}

/// Refined vertices that belong only to control triangles without such a corner.
std::vector<bool> outsideOf(const Character& character, const Refinement& refinement,
                            const std::vector<bool>& touched) {
  std::vector<bool> outside(static_cast<std::size_t>(refinement.vertexCount), true);
  const std::size_t perTriangle = refinement.triangles.size() / character.mesh.triangles.size();
  for (std::size_t t = 0; t < refinement.triangles.size(); ++t) {
    const auto& corners = character.mesh.triangles[t / perTriangle].vertices;
    const bool reached = std::ranges::any_of(corners, [&](int v) { return touched[static_cast<std::size_t>(v)]; });
    if (!reached) continue;
    for (const int v : refinement.triangles[t]) outside[static_cast<std::size_t>(v)] = false;
  }
  return outside;
}

/// Effect of a rig relative to the bare character over some sample times of a clip.
struct Moved {
  int outside = 0;         ///< Vertices, times, outside the territory that changed a bit of their place, or of their
                           ///< normal with no moved neighbor (docs/design.md, Normals).
  int inside = 0;          ///< ... and within.
  int watchedOutside = 0;  ///< Vertices outside, for each sample time.
};

Moved countMoved(const CharacterPtr& character, const Rig& rig, const AnimationClip& clip, int moments,
                 const std::vector<std::string>& territory) {
  Rig bare = rig;
  bare.primitives.clear();
  Smoother with(character);
  Smoother without(character);
  EXPECT_TRUE(with.prepare(rig).ok());
  EXPECT_TRUE(without.prepare(bare).ok());
  Surface a;
  Surface b;
  Moved out;
  for (int i = 0; i < moments; ++i) {
    const float time = clip.duration * static_cast<float>(i) / static_cast<float>(moments);
    const Pose pose = samplePose(character->skeleton, clip, time);
    with.smooth(pose, a);
    without.smooth(pose, b);
    const auto outside = outsideOf(*character, *a.refinement, touchedBy(*character, territory));
    out.watchedOutside = static_cast<int>(std::ranges::count(outside, true));
    const std::vector<bool> reshaded = grown(a.refinement->triangles, movedBetween(a.positions, b.positions), 1);
    for (std::size_t v = 0; v < outside.size(); ++v) {
      const bool same =
          sameBits(a.positions[v], b.positions[v]) && (reshaded[v] || sameBits(a.normals[v], b.normals[v]));
      if (!same) ++(outside[v] ? out.outside : out.inside);
    }
  }
  return out;
}

Rig shinRig(const Character& character) {
  Rig rig;
  rig.smoothing.depth = 4;
  rig.groups.push_back({"legs", {}});
  rig.primitives.push_back(ellipsoidAt(character, "calf", "shin L", "legs", {0.3f, 0.3f, 0.05f}, {0.2f, 0.3f, 0.25f}));
  return rig;
}

TEST(Territory, MuscleOnOneLegDoesNotMoveTheOther) {
  const CharacterPtr character = makeTwoLegged();
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    Rig rig = shinRig(*character);
    rig.surface.mode = mode;
    const Moved moved = countMoved(character, rig, character->clips[0], 21, {"leg L", "shin L"});
    EXPECT_EQ(moved.outside, 0) << nameOf(mode);
    EXPECT_GT(moved.inside, 0);
    EXPECT_GT(moved.watchedOutside, 100);
  }
}

// The same muscle without territory does move the other leg when they cross: the test above can fail.
TEST(Territory, MuscleAllowedEverywhereMovesTheCrossingLeg) {
  const CharacterPtr character = makeTwoLegged();
  Rig rig = shinRig(*character);
  rig.primitives[0].territory = std::vector<std::string>{"leg L", "shin L", "leg R", "shin R", "hips", "spine"};
  const Moved moved = countMoved(character, rig, character->clips[0], 21, {"leg L", "shin L"});
  EXPECT_GT(moved.outside, 100);
}

TEST(Territory, NamedBonesReplaceTheDefault) {
  const CharacterPtr character = makeTwoLegged();
  Rig rig = shinRig(*character);
  rig.primitives[0].territory = std::vector<std::string>{"shin L"};
  const Moved moved = countMoved(character, rig, character->clips[0], 9, {"shin L"});
  EXPECT_EQ(moved.outside, 0);
  EXPECT_GT(moved.inside, 0);
}

TEST(Territory, EmptyTerritoryMovesNothing) {
  const CharacterPtr character = makeTwoLegged();
  Rig rig = shinRig(*character);
  rig.primitives[0].territory = std::vector<std::string>{};
  const Moved moved = countMoved(character, rig, character->clips[0], 9, {"leg L", "shin L"});
  EXPECT_EQ(moved.outside + moved.inside, 0);
}

TEST(Territory, FoxForearmDoesNotMoveLegsBodyOrHead) {
  const CharacterPtr character = realCharacter("Fox.glb");
  if (!character) GTEST_SKIP() << "left out: real characters are not at hand";
  const std::string bone = "b_LeftForeArm_010";
  const auto index = character->skeleton.findBone(bone);
  ASSERT_TRUE(index);
  const Bone& forearm = character->skeleton.bones[static_cast<std::size_t>(*index)];
  ASSERT_EQ(forearm.children.size(), 1u);
  std::vector<std::string> territory{bone};
  territory.push_back(character->skeleton.bones[static_cast<std::size_t>(forearm.parent)].name);
  territory.push_back(character->skeleton.bones[static_cast<std::size_t>(forearm.children[0])].name);
  EXPECT_EQ(territory[1], "b_LeftUpperArm_09");
  EXPECT_EQ(territory[2], "b_LeftHand_011");

  Rig rig;
  rig.smoothing.depth = 3;
  rig.groups.push_back({"arms", {}});
  const glm::vec3 joint = forearm.bindInWorld[3];
  const glm::vec3 tip = forearm.bindInWorld * glm::vec4(forearm.tip, 1.0f);
  const glm::vec3 radii = glm::vec3(0.16f, 0.16f, 0.16f) * character->height;
  rig.primitives.push_back(ellipsoidAt(*character, "forearm", bone, "arms", 0.5f * (joint + tip), radii));
  for (const AnimationClip& clip : character->clips) {
    const Moved moved = countMoved(character, rig, clip, 25, territory);
    EXPECT_EQ(moved.outside, 0) << clip.name;
    EXPECT_GT(moved.inside, 0) << clip.name;
    EXPECT_GT(moved.watchedOutside, 1000) << clip.name;
  }
}

}  // namespace
}  // namespace sinew::test
