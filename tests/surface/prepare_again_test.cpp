// tests/surface/prepare_again_test.cpp: a smoother edited step by step matches a fresh one.

#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/rig/attachment.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/rig_edits.h"
#include "tests/support/surface/prepared_in_turn.h"

namespace sinew::test {
namespace {

using Edit = std::function<Rig(const Rig&, Random&, const Character&)>;

int anyOf(const Rig& rig, Random& random) { return random.below(static_cast<int>(rig.primitives.size())); }

std::string boneName(const Character& character, Random& random) {
  return character.skeleton.fileName(random.below(static_cast<int>(character.skeleton.bones.size())));
}

const std::vector<Edit>& edits() {
  static const std::vector<Edit> all{
      [](const Rig& rig, Random& random, const Character& character) {
        const int i = anyOf(rig, random);
        Placement placement = rig.primitives[static_cast<std::size_t>(i)].placement;
        placement.center.y += random.uniform(-0.05f, 0.05f) * character.height;
        placement.radii *= random.uniform(0.8f, 1.25f);
        return setPlacement(rig, i, placement).value();
      },
      [](const Rig& rig, Random& random, const Character&) {
        return setReach(rig, anyOf(rig, random), random.uniform(1.1f, 2.0f)).value();
      },
      [](const Rig& rig, Random& random, const Character&) {
        const int i = anyOf(rig, random);
        return setSign(rig, i, -rig.primitives[static_cast<std::size_t>(i)].sign).value();
      },
      [](const Rig& rig, Random& random, const Character& character) {
        const int i = anyOf(rig, random);
        const Placement placement = rig.primitives[static_cast<std::size_t>(i)].placement;
        return setBone(rig, i, boneName(character, random), placement).value();
      },
      [](const Rig& rig, Random& random, const Character& character) {
        return setTerritory(rig, anyOf(rig, random), std::vector{boneName(character, random)}).value();
      },
      [](const Rig& rig, Random& random, const Character&) {
        const auto group = static_cast<std::size_t>(random.below(static_cast<int>(rig.groups.size())));
        return setGroupOf(rig, anyOf(rig, random), rig.groups[group].name).value();
      },
      [](const Rig& rig, Random& random, const Character&) {
        return setLink(rig, 0, 1 + random.below(static_cast<int>(rig.groups.size()) - 1),
                       random.chance(0.5f) ? random.uniform(0.1f, 1.0f) : 0.0f)
            .value();
      },
      [](const Rig& rig, Random& random, const Character&) {
        SurfaceSettings surface = rig.surface;
        surface.iso = random.uniform(0.1f, 0.6f);
        if (random.chance(0.3f)) {
          surface.mode = surface.mode == SurfaceMode::kSwell ? SurfaceMode::kReplace : SurfaceMode::kSwell;
        }
        return setSurface(rig, surface).value();
      },
      [](const Rig& rig, Random& random, const Character&) {
        return duplicatePairs(rig, std::vector{anyOf(rig, random)});
      },
      [](const Rig& rig, Random& random, const Character&) {
        return rig.primitives.size() > 2 ? removePrimitives(rig, std::vector{anyOf(rig, random)}) : rig;
      },
  };
  return all;
}

TEST(RepeatedPrepare, MatchesAFreshSmootherBitForBit) {
  const auto character = makeTwoLegged();
  const Pose pose = samplePose(character->skeleton, character->clips.back(), 0.4f);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    RigRecipe recipe;
    recipe.primitives = 8;
    Rig rig = randomRig(*character, recipe, seed);
    Smoother edited(character);
    Surface after;
    for (int step = 0; step < 40; ++step) {
      rig = edits()[static_cast<std::size_t>(random.below(static_cast<int>(edits().size())))](rig, random, *character);
      ASSERT_TRUE(edited.prepare(rig).ok());
      edited.smooth(pose, after);
      Smoother fresh(character);
      ASSERT_TRUE(fresh.prepare(rig).ok());
      Surface expected;
      fresh.smooth(pose, expected);
      ASSERT_EQ(after.positions, expected.positions) << "seed " << seed << ", step " << step;
      ASSERT_EQ(after.normals, expected.normals) << "seed " << seed << ", step " << step;
      ASSERT_EQ(after.classes, expected.classes) << "seed " << seed << ", step " << step;
    }
  }
}

// A drag changes shapes only; what does not depend on them is kept.
TEST(RepeatedPrepare, DragChangesOnlyShapes) {
  const auto character = makeTwoLegged();
  const Rig rig = randomRig(*character, {}, 3);
  Placement moved = rig.primitives[0].placement;
  moved.center.x += 0.1f;
  EXPECT_TRUE(sameCandidates(rig, setPlacement(rig, 0, moved).value()));
  EXPECT_TRUE(sameCandidates(rig, setSign(rig, 0, -rig.primitives[0].sign).value()));
  EXPECT_FALSE(sameCandidates(rig, setTerritory(rig, 0, std::vector<std::string>{}).value()));
  EXPECT_FALSE(sameCandidates(rig, removePrimitives(rig, std::vector{0})));
  EXPECT_FALSE(sameCandidates(rig, addGroup(rig, "another").value()));
}

TEST(RepeatedPrepare, ReattachesOnlyIfMoreThanShapesChanges) {
  const auto character = makeTwoLegged();
  Rig rig = randomRig(*character, {}, 3);
  PreparedInTurn preparations(character);
  auto attached = preparations.next(rig)->attached;
  // A drag.
  for (int frame = 0; frame < 10; ++frame) {
    rig.primitives[0].placement.center.x += 0.01f * character->height;
    EXPECT_EQ(preparations.next(rig)->attached, attached);
  }
  const auto isAttachedAnew = [&] { return std::exchange(attached, preparations.next(rig)->attached) != attached; };
  rig.primitives[0].bone =
      rig.primitives[1].bone == rig.primitives[0].bone ? rig.primitives[2].bone : rig.primitives[1].bone;
  EXPECT_TRUE(isAttachedAnew());
  rig = addGroup(rig, "another").value();
  EXPECT_TRUE(isAttachedAnew());
  rig = setLink(rig, 0, static_cast<int>(rig.groups.size()) - 1, 1.0f).value();
  EXPECT_TRUE(isAttachedAnew());
}

// A drag of how much two groups blend.
TEST(RepeatedPrepare, AnotherAmountOfALinkChangesOnlyCliques) {
  const auto character = makeTwoLegged();
  RigRecipe recipe;
  recipe.groups = 4;
  recipe.linkChance = 0.8f;
  Rig rig = randomRig(*character, recipe, 3);
  ASSERT_FALSE(rig.links.empty());
  rig.links[0].amount = 0.2f;
  PreparedInTurn preparations(character);
  const auto first = preparations.next(rig);
  for (const float amount : {0.3f, 0.7f, 0.9f}) {
    rig.links[0].amount = amount;
    const auto next = preparations.next(rig);
    EXPECT_EQ(next->tiles, first->tiles);
    EXPECT_EQ(next->refined, first->refined);
    const auto anew = PreparedInTurn(character).next(rig);
    ASSERT_EQ(next->seen->cliqueSets.size(), anew->seen->cliqueSets.size());
    EXPECT_EQ(next->seen->cliqueSet, anew->seen->cliqueSet);
    EXPECT_EQ(next->seen->items, anew->seen->items);
    for (std::size_t set = 0; set < next->seen->cliqueSets.size(); ++set) {
      const CliqueLevels& own = next->seen->cliqueSets[set].drawn;
      const CliqueLevels& wanted = anew->seen->cliqueSets[set].drawn;
      ASSERT_EQ(own.size(), wanted.size());
      for (std::size_t i = 0; i < own.size(); ++i) {
        EXPECT_EQ(own[i].weight, wanted[i].weight);
        EXPECT_EQ(own[i].cliques, wanted[i].cliques);
      }
    }
  }
}

// Groups in threes, each linked to all but its own two: 3^8 cliques.
TEST(RepeatedPrepare, RigWithTooManyCliquesIsRefusedAndThePreviousOneStays) {
  const auto character = makeTwoLegged();
  const Rig rig = randomRig(*character, {}, 3);
  Rig tangled = rig;
  for (int i = 0; i < 24; ++i) tangled.groups.push_back({"extra " + std::to_string(i), {}});
  for (int a = 0; a < 24; ++a) {
    for (int b = a + 1; b < 24; ++b) {
      if (a / 3 != b / 3) tangled.links.push_back({"extra " + std::to_string(a), "extra " + std::to_string(b)});
    }
  }
  const Pose pose = bindPose(character->skeleton);
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  Surface before;
  smoother.smooth(pose, before);
  for (int i = 0; i < 2; ++i) {
    const Result<void> refused = smoother.prepare(tangled);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().place, "links");
    Surface after;
    smoother.smooth(pose, after);
    EXPECT_EQ(after.positions, before.positions);
    EXPECT_TRUE(smoother.prepare(rig).ok());
  }
}

}  // namespace
}  // namespace sinew::test
