// tests/rig/rig_edit_several_test.cpp: changing several muscles at once: all of them, nothing else, or nothing.

#include "core/rig/rig_edit.h"

#include <gtest/gtest.h>

#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/rigs/rig_edits.h"

namespace sinew {
namespace {

Rig rigOf(int count) {
  Rig rig;
  for (int i = 0; i < count; ++i) {
    Primitive primitive;
    primitive.name = "m" + std::to_string(i);
    primitive.bone = "b";
    rig = addPrimitive(rig, primitive).value();
  }
  return rig;
}

TEST(RigEditSeveral, ChangesOnlyTheGivenMuscles) {
  const Rig rig = rigOf(5);
  const Rig edited = editPrimitives(rig, std::vector<int>{1, 3}, [](Primitive& p) { p.reach = 2.0f; }).value();
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(edited.primitives[i].reach, i == 1 || i == 3 ? 2.0f : kDefaultReach);
  }
  EXPECT_TRUE(validate(edited).ok());
}

TEST(RigEditSeveral, MatchesSequentialEdits) {
  Rig rig = addGroup(rigOf(4), "legs").value();
  Rig one = rig;
  for (const int i : {0, 2, 3}) one = test::setGroupOf(one, i, "legs").value();
  EXPECT_EQ(setGroupOfSeveral(rig, std::vector<int>{0, 2, 3}, "legs").value(), one);
}

TEST(RigEditSeveral, OneRefusalRefusesAllAndNamesThePlace) {
  const Rig rig = rigOf(3);
  const Result<Rig> refused =
      editPrimitives(rig, std::vector<int>{0, 2}, [&](Primitive& p) { p.reach = p.name == "m2" ? 0.5f : 3.0f; });
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().place.find("primitives[2]"), std::string::npos);
  EXPECT_FALSE(setGroupOfSeveral(rig, std::vector<int>{0}, "nowhere").ok());
}

TEST(RigEditSeveral, DissolvedGroupMovesItsMusclesToTheOther) {
  Rig rig = moveToNewGroup(rigOf(4), std::vector<int>{1, 2}, "legs").value();
  rig = setLink(rig, 0, 1, 1.0f).value();
  EXPECT_EQ(membersOf(rig, "legs"), (std::vector<int>{1, 2}));
  EXPECT_FALSE(dissolveGroup(rig, 1, 1).ok());
  const Rig left = dissolveGroup(rig, 1, 0).value();
  EXPECT_EQ(left.groups.size(), 1u);
  EXPECT_EQ(membersOf(left, left.groups[0].name).size(), 4u);
  EXPECT_TRUE(left.links.empty());
  EXPECT_TRUE(validate(left).ok());
}

TEST(RigEditSeveral, TakenGroupNameIsRefused) {
  const Rig rig = rigOf(2);
  EXPECT_FALSE(moveToNewGroup(rig, std::vector<int>{0}, rig.groups[0].name).ok());
}

}  // namespace
}  // namespace sinew
