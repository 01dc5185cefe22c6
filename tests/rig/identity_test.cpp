// tests/rig/identity_test.cpp: identities are unique, outlive names and survive copies.

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/rig/references.h"
#include "core/rig/rig_edit.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {
namespace {

Rig rigOf(int muscles) {
  Rig rig;
  for (int i = 0; i < muscles; ++i) {
    Primitive primitive;
    primitive.name = "muscle " + std::to_string(i);
    primitive.bone = "bone";
    rig = addPrimitive(rig, primitive).value();
  }
  return rig;
}

std::vector<PrimitiveId> idsOf(const Rig& rig) {
  std::vector<PrimitiveId> ids;
  for (const Primitive& primitive : rig.primitives) ids.push_back(primitive.id());
  return ids;
}

bool allDifferent(const Rig& rig) {
  const std::vector<PrimitiveId> ids = idsOf(rig);
  const std::set<PrimitiveId> unique(ids.begin(), ids.end());
  return unique.size() == ids.size() && !unique.contains(PrimitiveId{});
}

TEST(RigIdentity, EveryPrimitiveAndGroupGetsAnIdentity) {
  Rig rig = rigOf(5);
  IdentitySource source;
  source.identify(rig, Rig{});
  EXPECT_TRUE(allDifferent(rig));
  ASSERT_FALSE(rig.groups.empty());
  for (const Group& group : rig.groups) EXPECT_TRUE(group.id());
}

TEST(RigIdentity, IsNotPartOfTheDocument) {
  Rig rig = rigOf(3);
  const Rig before = rig;
  IdentitySource().identify(rig, Rig{});
  EXPECT_EQ(rig, before);
}

TEST(RigIdentity, CopyGetsItsOwnIdentity) {
  Rig before = rigOf(3);
  IdentitySource source;
  source.identify(before, Rig{});
  for (const bool inFront : {true, false}) {
    Rig rig = before;
    Primitive copy = rig.primitives[1];
    copy.name = "copy";
    rig.primitives.insert(inFront ? rig.primitives.begin() : rig.primitives.end(), copy);
    source.identify(rig, before);
    EXPECT_TRUE(allDifferent(rig));
    EXPECT_EQ(rig.primitives[inFront ? 2 : 1].id(), before.primitives[1].id());
  }
}

TEST(RigIdentity, OverwrittenTwinKeepsItsIdentity) {
  Rig before = rigOf(2);
  IdentitySource source;
  source.identify(before, Rig{});
  Rig rig = before;
  rig.primitives[0] = before.primitives[1];  // As mirroring creates an image from its leader.
  rig.primitives[0].name = before.primitives[0].name;
  source.identify(rig, before);
  EXPECT_EQ(idsOf(rig), idsOf(before));
}

TEST(RigIdentity, MuscleRecreatedInEveryDragFrameKeepsItsIdentity) {
  Rig start = rigOf(2);
  IdentitySource source;
  source.identify(start, Rig{});
  Rig shown = start;
  PrimitiveId first;
  for (int frame = 0; frame < 3; ++frame) {
    Primitive drawn;
    drawn.name = "drawn";
    drawn.bone = "bone";
    Rig rig = addPrimitive(start, drawn).value();
    source.identify(rig, shown);
    if (frame == 0) first = rig.primitives.back().id();
    EXPECT_EQ(rig.primitives.back().id(), first);
    shown = rig;
  }
}

/// After any edits, remaining items keep their identity, by index and contents.
TEST(RigIdentity, SurvivesRandomEdits) {
  std::mt19937 random(7);
  Rig rig = rigOf(4);
  IdentitySource source;
  source.identify(rig, Rig{});
  std::set<PrimitiveId> everSeen;
  for (int step = 0; step < 500; ++step) {
    const Rig before = rig;
    for (const PrimitiveId id : idsOf(before)) everSeen.insert(id);
    const int count = static_cast<int>(rig.primitives.size());
    const int index = count == 0 ? 0 : static_cast<int>(random() % static_cast<unsigned>(count));
    switch (count == 0 ? 0 : random() % 3) {
      case 0: {
        Primitive primitive;
        primitive.name = "added";
        primitive.bone = "bone";
        rig = addPrimitive(rig, primitive).value();
        source.identify(rig, before);
        EXPECT_FALSE(everSeen.contains(rig.primitives.back().id())) << "nobody inherits an identity";
        break;
      }
      case 1:
        rig = removePrimitives(rig, std::vector<int>{index});
        source.identify(rig, before);
        for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
          EXPECT_EQ(rig.primitives[i].id(), before.primitives[i + (static_cast<int>(i) >= index ? 1 : 0)].id());
        }
        break;
      default:
        rig = renamePrimitive(rig, index, freePrimitiveName(rig, "renamed")).value();
        source.identify(rig, before);
        EXPECT_EQ(idsOf(rig), idsOf(before));
        break;
    }
    ASSERT_TRUE(allDifferent(rig));
  }
}

TEST(Identity, ANewSourceGivesNoIdentityThatTheRigHas) {
  Rig rig;
  rig.primitives.resize(3);
  IdentitySource().identify(rig, Rig{});
  Rig edited = rig;
  edited.primitives.emplace_back().name = "new";
  IdentitySource other;
  other.identify(edited, rig);
  for (int i = 0; i < 3; ++i) EXPECT_NE(edited.primitives[3].id(), edited.primitives[static_cast<std::size_t>(i)].id());
}

}  // namespace
}  // namespace sinew
