// tests/surface/animated_links_test.cpp: surfaces of rigs whose links have keys: those of the amounts of the moment,
// without a pop where two amounts cross.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/instruction_set.h"
#include "core/rig/animated_edit.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/smoother.h"
#include "tests/support/allocations.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/driven_rig.h"
#include "tests/support/rigs/keyed_links.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/every_kind.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

Rig linkedRig(const Character& character, SurfaceMode mode, float grooves, std::uint64_t seed) {
  RigRecipe recipe;
  recipe.primitives = 30;
  recipe.groups = 6;
  recipe.linkChance = 0.7f;
  recipe.partChance = 0.5f;
  recipe.radiusLow = mode == SurfaceMode::kReplace ? 0.06f : 0.03f;
  recipe.radiusHigh = 0.14f;
  Rig rig = randomRig(character, recipe, seed);
  rig.surface.mode = mode;
  rig.surface.grooves = grooves;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 3;
  return rig;
}

Surface surfaceOf(const CharacterPtr& character, const Rig& rig, const Pose& pose) {
  Smoother smoother(character);
  EXPECT_TRUE(smoother.prepare(rig).ok());
  Surface surface;
  smoother.smooth(pose, surface);
  return surface;
}

void expectSame(const Surface& a, const Surface& b, const std::string& what) {
  EXPECT_EQ(a.refinement->triangles, b.refinement->triangles) << what;
  EXPECT_EQ(a.positions, b.positions) << what;
  EXPECT_EQ(a.normals, b.normals) << what;
  EXPECT_EQ(a.classes, b.classes) << what;
}

TEST(AnimatedLinks, TheSurfaceIsThatOfTheAmountsOfTheMoment) {
  const CharacterPtr character = makeTwoLegged();
  const AnimationClip& clip = character->clips.back();
  std::uint64_t seed = 40;
  for (const InstructionSet set : availableInstructionSets()) {
    const InstructionSetScope scope(set);
    for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
      for (const float grooves : {0.0f, 0.02f}) {
        ++seed;
        const Rig rig = withKeyedLinks(linkedRig(*character, mode, grooves, seed), clip, seed);
        Smoother live(character);
        ASSERT_TRUE(live.prepare(rig).ok());
        Surface surface;
        // Back and forth: earlier frames leave nothing behind.
        for (const float part : {0.9f, 0.1f, 0.6f, 0.1f}) {
          const Pose pose = samplePose(character->skeleton, clip, part * clip.duration);
          live.smooth(pose, surface);
          ASSERT_GT(surface.report.projected, 100);
          expectSame(surface, surfaceOf(character, withoutKeys(drivenRig(rig, *character, pose)), pose),
                     std::string(nameOf(mode)) + ", " + nameOf(set));
        }
      }
    }
  }
}

// The bind pose has the amounts as drawn, the clip the same by keys.
TEST(AnimatedLinks, KeysThatChangeNothingChangeNoBit) {
  const CharacterPtr character = makeTwoLegged();
  const AnimationClip& clip = character->clips.back();
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
      Rig drawn = linkedRig(*character, mode, 0.02f, 7);
      drawn.smoothing.detail = detail;
      drawn.smoothing.tolerance = 0.003f;
      Rig keyed = drawn;
      for (std::size_t i = 0; i < keyed.links.size(); ++i) {
        const NumberRef ref{Parameter::kLinkAmount, static_cast<int>(i)};
        keyed = setKey(std::move(keyed), ref, "", 0.0f, keyed.links[i].amount).value();
      }
      const Pose pose = samplePose(character->skeleton, clip, 0.4f * clip.duration);
      expectSame(surfaceOf(character, keyed, pose), surfaceOf(character, drawn, pose), nameOf(mode));
    }
  }
}

TEST(AnimatedLinks, DetailFollowsTheAmountsOfThePoses) {
  const CharacterPtr character = makeTwoLegged();
  Rig drawn = linkedRig(*character, SurfaceMode::kSwell, 0.0f, 7);
  drawn.smoothing.detail = DetailKind::kAdaptive;
  for (Link& link : drawn.links) link.amount = 1.0f;
  Rig keyed = drawn;
  for (std::size_t i = 0; i < keyed.links.size(); ++i) {
    keyed = setKey(std::move(keyed), {Parameter::kLinkAmount, static_cast<int>(i)}, "", 0.0f, 0.0f).value();
  }
  const Pose pose = bindPose(character->skeleton);
  EXPECT_NE(surfaceOf(character, keyed, pose).refinement->triangles,
            surfaceOf(character, drawn, pose).refinement->triangles);
}

/// Three balls in a row, each in its own group; of the links between them one fades in while another fades out.
struct Crossing {
  CharacterPtr character = makeStrip();
  Rig rig;
  Pose pose = bindPose(character->skeleton);

  explicit Crossing(float grooves) {
    const std::array<const char*, 3> names{"A", "B", "C"};
    for (std::size_t i = 0; i < 3; ++i) {
      rig.groups.push_back({names[i], {}});
      const glm::vec3 center(0.05f * static_cast<float>(i % 2), 0.9f + 0.14f * static_cast<float>(i), 0.0f);
      rig.primitives.push_back(ellipsoidAt(*character, names[i], "end", names[i], center, glm::vec3(0.24f)));
      rig.primitives.back().territory = std::vector<std::string>{"root", "end"};
    }
    rig.links = {{{"A", "B"}}, {{"B", "C"}}, {{"A", "C"}, 0.5f}};
    rig.surface.grooves = grooves;
    rig.smoothing.detail = DetailKind::kUniform;
    rig.smoothing.depth = 8;
    // A-B and B-C cross at 0.5, and there both cross A-C.
    key(0, 0.2f, 0.8f);
    key(1, 0.8f, 0.2f);
    pose.clip = "fade";
  }
  void key(int link, float from, float to) {
    const NumberRef ref{Parameter::kLinkAmount, link};
    rig = setKey(std::move(rig), ref, "", 0.0f, from).value();
    rig = setKey(std::move(rig), ref, "", 1.0f, to).value();
    rig = setKeyKind(std::move(rig), ref, "", CurveKind::kLinear).value();
  }
  Surface at(Smoother& smoother, float time) {
    pose.time = time;
    Surface surface;
    smoother.smooth(pose, surface);
    return surface;
  }
};

float largestMove(const Surface& a, const Surface& b) {
  float most = 0.0f;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    most = std::max(most, glm::distance(a.positions[v], b.positions[v]));
  }
  return most;
}

TEST(AnimatedLinks, NothingPopsWhereAmountsCross) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    for (const float grooves : {0.0f, 0.02f}) {
      Crossing crossing(grooves);
      crossing.rig.surface.mode = mode;
      Smoother smoother(crossing.character);
      ASSERT_TRUE(smoother.prepare(crossing.rig).ok());
      constexpr float kFrame = 1.0f / 60.0f;
      constexpr float kInstant = 1e-5f;
      const float before =
          largestMove(crossing.at(smoother, 0.5f - 2.0f * kFrame), crossing.at(smoother, 0.5f - kFrame));
      const float across =
          largestMove(crossing.at(smoother, 0.5f - 0.5f * kFrame), crossing.at(smoother, 0.5f + 0.5f * kFrame));
      const float instant = largestMove(crossing.at(smoother, 0.5f - kInstant), crossing.at(smoother, 0.5f + kInstant));
      const float atOnce = largestMove(crossing.at(smoother, 0.5f), crossing.at(smoother, 0.5f + kInstant));
      EXPECT_GT(before, 1e-4f * crossing.character->height) << nameOf(mode) << ": the amounts matter";
      EXPECT_LT(across, 3.0f * before) << nameOf(mode) << ", grooves " << grooves;
      EXPECT_LT(instant, 0.02f * before) << nameOf(mode) << ", grooves " << grooves;
      EXPECT_LT(atOnce, 0.02f * before) << nameOf(mode) << ", grooves " << grooves;
    }
  }
}

// From amount to no link and back.
TEST(AnimatedLinks, NothingPopsWhereALinkEnds) {
  Crossing crossing(0.0f);
  crossing.key(0, -0.5f, 0.5f);
  Smoother smoother(crossing.character);
  ASSERT_TRUE(smoother.prepare(crossing.rig).ok());
  EXPECT_LT(largestMove(crossing.at(smoother, 0.5f - 1e-5f), crossing.at(smoother, 0.5f + 1e-5f)),
            1e-4f * crossing.character->height);
  EXPECT_GT(largestMove(crossing.at(smoother, 0.5f), crossing.at(smoother, 1.0f)), 1e-3f * crossing.character->height);
}

TEST(AnimatedLinks, AnyThreadsGiveTheSameBits) {
  TrialScene scene = bundledTrialScene("humanoid");
  scene.rig.smoothing.detail = DetailKind::kUniform;
  scene.rig.smoothing.depth = 5;
  const AnimationClip& clip = scene.character->clips.front();
  const Rig rig = withKeyedLinks(scene.rig, clip, 3);
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    Smoother one(scene.character);
    Smoother several(scene.character);
    ASSERT_TRUE(one.prepare(withMode(rig, mode)).ok());
    ASSERT_TRUE(several.prepare(withMode(rig, mode)).ok());
    Surface alone;
    Surface together;
    for (const float part : {0.2f, 0.7f}) {
      const Pose pose = samplePose(scene.character->skeleton, clip, part * clip.duration);
      {
        const ThreadLimit limit(1);
        one.smooth(pose, alone);
      }
      for (const int threads : {3, 0}) {
        const ThreadLimit limit(threads);
        several.smooth(pose, together);
        expectSame(alone, together, std::to_string(threads));
      }
    }
  }
}

/// Allocations of frames in which only the links' amounts change. They come into orders, and give cliques, that no
/// frame had before.
class KeyedFrames {
 public:
  explicit KeyedFrames(const TrialScene& scene)
      : clip_(scene.character->clips.front()),
        pose_(samplePose(scene.character->skeleton, clip_, 0.0f)),
        smoother_(scene.character) {
    EXPECT_TRUE(smoother_.prepare(withKeyedLinks(scene.rig, clip_, 5)).ok());
    play(0, 1);
  }
  std::int64_t play(int begin, int end) {
    constexpr int kFrames = 20;
    const std::int64_t before = allocations();
    for (int frame = begin; frame < end; ++frame) {
      pose_.time = clip_.duration * static_cast<float>(frame) / static_cast<float>(kFrames);
      smoother_.smooth(pose_, surface_);
    }
    return allocations() - before;
  }

 private:
  const AnimationClip& clip_;
  Pose pose_;
  Smoother smoother_;
  Surface surface_;
};

TEST(AnimatedLinks, FramesAfterTheFirstAllocateNothing) {
  for (const char* name : {"humanoid", "tangle"}) {
    TrialScene scene = bundledTrialScene(name);
    scene.rig.smoothing.detail = DetailKind::kUniform;
    for (const float grooves : {0.0f, 0.02f}) {
      scene.rig.surface.grooves = grooves;
      EXPECT_EQ(KeyedFrames(scene).play(1, 20), 0) << name << ", grooves " << grooves;
    }
  }
}

// Single vertices are halved as deep as they need.
TEST(AnimatedLinks, RepeatedFramesAllocateNothingVertexByVertexEither) {
  for (const char* name : {"humanoid", "wrapped"}) {
    TrialScene scene = bundledTrialScene(name);
    scene.rig.smoothing.detail = DetailKind::kUniform;
    for (const float grooves : {0.0f, 0.02f}) {
      scene.rig.surface.grooves = grooves;
      for (const InstructionSet set : {chosenInstructionSet(), InstructionSet::kScalar}) {
        const InstructionSetScope scope(set);
        KeyedFrames frames(scene);
        (void)frames.play(1, 20);
        EXPECT_EQ(frames.play(0, 20), 0) << name << ", grooves " << grooves << ", " << nameOf(set);
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
