// tests/document/posed_rig_memo_test.cpp: the document's rig in a pose is computed once and never stale.
#include "app/document/document.h"

#include <gtest/gtest.h>

#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_animation.h"

namespace sinew::app {
namespace {

class PosedRigs : public testing::Test {
 protected:
  Document document;
  Pose pose;

  PosedRigs() {
    document.character = test::makeLimb();
    document.commands = CommandStack(test::animatedLimbRig(*document.character, 2));
    pose = samplePose(document.character->skeleton, document.character->clips.front(), 0.4f);
  }
  PosedRig fresh() const { return RigPoser(document.rig(), *document.character).pose(pose); }
  void expectFresh() const {
    const PosedRig wanted = fresh();
    const PosedRig& is = document.posedRig(pose);
    EXPECT_EQ(is.numbers, wanted.numbers);
    ASSERT_EQ(is.muscles.size(), wanted.muscles.size());
    for (std::size_t i = 0; i < is.muscles.size(); ++i) EXPECT_EQ(is.muscles[i].carrier, wanted.muscles[i].carrier);
  }
};

TEST_F(PosedRigs, IsComputedOncePerRigAndPose) {
  const auto poser = document.poser();
  const PosedRig* posed = &document.posedRig(pose);
  EXPECT_EQ(&document.posedRig(pose), posed);
  EXPECT_EQ(document.poser(), poser);
}

TEST_F(PosedRigs, IsUpdatedWithPoseRigAndCharacter) {
  expectFresh();
  pose = samplePose(document.character->skeleton, document.character->clips.front(), 1.1f);
  expectFresh();
  Placement placement = document.rig().primitives[0].placement;
  placement.radii *= 1.5f;
  document.commands.apply("Radius", setPlacement(document.rig(), 0, placement).value());
  expectFresh();
  document.commands.undo();
  expectFresh();
  pose.flex = 1.0f;
  expectFresh();
  document.character = test::makeLimb();
  expectFresh();
}

}  // namespace
}  // namespace sinew::app
