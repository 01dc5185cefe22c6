// tests/rig/rig_edit_test.cpp: edits leave their input unchanged and give valid rigs.
#include "sinew/rig/rig_edit.h"

#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "tests/support/rigs/random_documents.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/rig_edits.h"

namespace sinew {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Primitive named(const std::string& name) {
  Primitive primitive;
  primitive.name = name;
  primitive.bone = "bone";
  return primitive;
}

/// Three primitives, the first two twins, in two linked groups.
Rig sample() {
  Rig rig;
  rig.character = "fox.glb";
  rig.groups = {{"legs", {}}, {"torso", {}}};
  rig.links = {{"legs", "torso"}};
  rig.primitives = {named("L"), named("R"), named("belly")};
  rig.primitives[0].group = rig.primitives[1].group = "legs";
  rig.primitives[2].group = "torso";
  rig.primitives[0].mirror = "R";
  rig.primitives[1].mirror = "L";
  return rig;
}

int index(test::Random& random, std::size_t size) { return random.below(static_cast<int>(size)); }

/// One random edit whose arguments may be invalid. None: it was refused.
std::optional<Rig> randomEdit(test::Random& random, const Rig& rig) {
  const auto value = [](Result<Rig> result) { return result ? std::optional(result.value()) : std::nullopt; };
  const auto some = [&] { return random.chance(0.1f) ? kNan : random.uniform(-1.0f, 4.0f); };
  const std::string name = "n" + std::to_string(random.below(12));
  const std::size_t n = rig.primitives.size();
  const int verb = random.below(n == 0 || rig.groups.empty() ? 2 : 14);
  std::vector<int> several(n);
  std::iota(several.begin(), several.end(), 0);
  std::erase_if(several, [&](int) { return random.chance(0.7f); });
  Primitive fresh = named(random.chance(0.2f) ? "" : name);
  if (n > 0 && random.chance(0.4f)) fresh.mirror = rig.primitives[static_cast<std::size_t>(index(random, n))].name;
  fresh.placement.radii.x = some();
  switch (verb) {
    case 0:
      return value(addPrimitive(rig, fresh));
    case 1:
      return value(addGroup(rig, name));
    case 2:
      return removePrimitives(rig, several);
    case 3:
      return duplicatePairs(rig, several);
    case 4:
      return value(setPlacement(rig, index(random, n), {{some(), some(), some()}, random.rotation(), {some(), 1, 1}}));
    case 5:
      return value(test::setReach(rig, index(random, n), some()));
    case 6:
      return value(test::setSign(rig, index(random, n), random.below(3) - 1));
    case 7:
      return value(renamePrimitive(rig, index(random, n), name));
    case 8:
      return value(test::setGroupOf(rig, index(random, n), name));
    case 9:
      return value(renameGroup(rig, index(random, rig.groups.size()), name));
    case 10:
      return value(removeGroup(rig, index(random, rig.groups.size())));
    case 11:
      return value(setLink(rig, index(random, rig.groups.size()), index(random, rig.groups.size()),
                           random.chance(0.6f) ? random.uniform(0.1f, 1.0f) : 0.0f));
    case 12:
      return clearMirror(rig, index(random, n));
    default:
      break;
  }
  const int first = index(random, n);
  const int second = index(random, n);
  return first == second ? rig : setMirror(rig, first, second);
}

TEST(RigEdit, RandomEditsKeepTheRigValidAndTheInputUnchanged) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    Rig rig = test::randomDocument(seed);
    int refused = 0;
    for (int step = 0; step < 60; ++step) {
      const Rig before = rig;
      const auto edited = randomEdit(random, rig);
      ASSERT_TRUE(rig == before) << "seed " << seed << " step " << step;
      if (!edited) {
        ++refused;
        continue;
      }
      const auto valid = validate(*edited);
      ASSERT_TRUE(valid.ok()) << "seed " << seed << " step " << step << ": " << valid.error().text();
      rig = *edited;
      if (rig.primitives.size() > 40)
        rig = removePrimitives(rig, std::vector<int>{0, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21});
    }
    EXPECT_GT(refused, 0) << "the bad arguments never came";
  }
}

TEST(RigEdit, AddMakesNamesUniqueAndAssignsAGroup) {
  const auto first = addPrimitive(Rig{}, named(""));
  ASSERT_TRUE(first.ok()) << first.error().text();
  EXPECT_EQ(first->groups.at(0).name, "muscles");
  EXPECT_EQ(first->primitives.at(0).group, "muscles");
  EXPECT_EQ(first->primitives.at(0).name, "muscle");
  const auto second = addPrimitive(first.value(), named("muscle"));
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(second->primitives.at(1).name, "muscle 2");
  EXPECT_EQ(second->groups.size(), 1u);

  Primitive lost = named("x");
  lost.group = "nowhere";
  EXPECT_FALSE(addPrimitive(sample(), lost).ok());
  Primitive lone = named("x");
  lone.mirror = "nobody";
  EXPECT_FALSE(addPrimitive(sample(), lone).ok());
  Primitive flat = named("x");
  flat.placement.radii.z = 0.0f;
  const auto refused = addPrimitive(sample(), flat);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().place, "primitives[3].radii[2]");
}

TEST(RigEdit, AddingATwinPairsBothAndReleasesTheFormerTwin) {
  Primitive twin = named("new");
  twin.mirror = "L";
  const auto rig = addPrimitive(sample(), twin);
  ASSERT_TRUE(rig.ok());
  EXPECT_EQ(rig->primitives[0].mirror, "new");
  EXPECT_EQ(rig->primitives[3].mirror, "L");
  EXPECT_EQ(rig->primitives[1].mirror, "");
}

TEST(RigEdit, RenameRemoveAndDuplicateUpdateTwins) {
  const auto renamed = renamePrimitive(sample(), 0, "left");
  ASSERT_TRUE(renamed.ok());
  EXPECT_EQ(renamed->primitives[1].mirror, "left");
  EXPECT_FALSE(renamePrimitive(sample(), 0, "belly").ok());
  EXPECT_FALSE(renamePrimitive(sample(), 0, "").ok());
  EXPECT_FALSE(renamePrimitive(sample(), 0, "\xff").ok());
  EXPECT_TRUE(renamePrimitive(sample(), 0, "L").value() == sample());

  const Rig removed = removePrimitives(sample(), std::vector{0, 0});
  ASSERT_EQ(removed.primitives.size(), 2u);
  EXPECT_EQ(removed.primitives[0].mirror, "");

  const Rig doubled = duplicatePairs(sample(), std::vector{0, 1});
  ASSERT_EQ(doubled.primitives.size(), 5u);
  EXPECT_EQ(doubled.primitives[0].mirror, "R");
  EXPECT_EQ(doubled.primitives[3].name, "L 2");
  EXPECT_EQ(doubled.primitives[3].mirror, doubled.primitives[4].name) << "copies of a pair are a pair";
}

TEST(RigEdit, MirrorsAreMutual) {
  const Rig paired = setMirror(sample(), 2, 0);
  EXPECT_EQ(paired.primitives[2].mirror, "L");
  EXPECT_EQ(paired.primitives[0].mirror, "belly");
  EXPECT_EQ(paired.primitives[1].mirror, "");
  const Rig cleared = clearMirror(paired, 2);
  EXPECT_EQ(cleared.primitives[0].mirror, "");
  EXPECT_EQ(cleared.primitives[2].mirror, "");
}

TEST(RigEdit, RenamingAGroupUpdatesMembersAndLinks) {
  const auto rig = renameGroup(sample(), 0, "hind legs");
  ASSERT_TRUE(rig.ok());
  EXPECT_EQ(rig->primitives[1].group, "hind legs");
  EXPECT_EQ(rig->links[0].groups[0], "hind legs");
  EXPECT_FALSE(renameGroup(sample(), 0, "torso").ok());
  EXPECT_TRUE(renameGroup(sample(), 0, "legs").value() == sample());
}

TEST(RigEdit, OnlyEmptyGroupsAreRemovedWithTheirLinks) {
  EXPECT_FALSE(removeGroup(sample(), 1).ok());
  const Rig emptied = removePrimitives(sample(), std::vector{2});
  const auto rig = removeGroup(emptied, 1);
  ASSERT_TRUE(rig.ok());
  EXPECT_EQ(rig->groups.size(), 1u);
  EXPECT_TRUE(rig->links.empty());
}

TEST(RigEdit, LinksAreSetAndClearedOnce) {
  Rig rig = sample();
  rig.links.push_back({"torso", "legs"});  // Files may contain it twice.
  EXPECT_TRUE(setLink(rig, 1, 0, 0.0f)->links.empty());
  EXPECT_EQ(setLink(rig, 1, 0, 1.0f)->links.size(), 2u);
  const auto unlinked = setLink(sample(), 0, 1, 0.0f);
  EXPECT_EQ(setLink(unlinked.value(), 0, 1, 1.0f)->links.size(), 1u);
  EXPECT_FALSE(setLink(sample(), 0, 0, 1.0f).ok());
}

TEST(RigEdit, LinksHaveAnAmount) {
  Rig rig = sample();
  rig.links.push_back({{"torso", "legs"}, 0.25f});
  EXPECT_EQ(linkAmount(rig, "torso", "legs"), 1.0f) << "of two the larger";
  rig = setLink(rig, 1, 0, 0.5f).value();
  EXPECT_EQ(rig.links, (std::vector<Link>{{{"legs", "torso"}, 0.5f}})) << "in its place, once";
  EXPECT_EQ(linkAmount(rig, "torso", "legs"), 0.5f);
  EXPECT_EQ(linkAmount(rig, "torso", "arms"), 0.0f);
  EXPECT_TRUE(setLink(rig, 0, 1, 0.0f)->links.empty());
  for (const float amount : {-0.1f, 1.01f, kNan}) {
    EXPECT_NE(setLink(rig, 0, 1, amount).error().reason.find("from 0 to 1"), std::string::npos) << amount;
  }
}

TEST(RigEdit, SettingsAreValidated) {
  SurfaceSettings surface;
  surface.iso = 1.0f;
  EXPECT_EQ(setSurface(sample(), surface).error().place, "surface.iso");
  SmoothingSettings smoothing;
  smoothing.depth = 0;
  EXPECT_EQ(setSmoothing(sample(), smoothing).error().place, "smoothing.depth");
  smoothing.depth = 16;
  EXPECT_EQ(setSmoothing(sample(), smoothing)->smoothing.depth, 16);
  EXPECT_EQ(test::setReach(sample(), 1, kNan).error().text(), "primitives[1].reach: expected a number > 1, got NaN");
  EXPECT_EQ(setPlacement(sample(), 2, {{0, kNan, 0}, {1, 0, 0, 0}, {1, 1, 1}}).error().place,
            "primitives[2].center[1]");
  EXPECT_EQ(test::setTerritory(sample(), 0, std::vector<std::string>{"a", ""}).error().place,
            "primitives[0].territory[1]");
  EXPECT_EQ(test::setBone(sample(), 0, "", {}).error().place, "primitives[0].bone");
}

TEST(RigEdit, TooManyCliquesAreRefused) {
  // 12 triples of groups, linked except within a triple: 3^12 cliques.
  Rig rig;
  for (int i = 0; i < 36; ++i) rig.groups.push_back({"g" + std::to_string(i), {}});
  const auto linkAll = [&](bool wholeThing) {
    for (int a = 0; a < 36; ++a) {
      for (int b = a + 1; b < 36; ++b) {
        if (a / 3 == b / 3 && !(wholeThing && a / 3 >= 7)) continue;
        rig.links.push_back(
            {rig.groups[static_cast<std::size_t>(a)].name, rig.groups[static_cast<std::size_t>(b)].name});
      }
    }
  };
  linkAll(true);  // 3^7 = 2,187.
  EXPECT_TRUE(validate(rig).ok());
  rig.links.clear();
  linkAll(false);
  const auto valid = validate(rig);
  ASSERT_FALSE(valid.ok());
  EXPECT_EQ(valid.error().place, "links");
}

}  // namespace
}  // namespace sinew
