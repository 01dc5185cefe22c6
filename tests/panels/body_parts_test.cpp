// tests/panels/body_parts_test.cpp: Muscles > Parts of the body through the dialog: detected parts, corrections, undo.

#include "app/editor/actions.h"
#include "app/editor/muscle_set_commands.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr BodySlot kLeftFoot{Slot::kFoot, BodySide::kLeft};

class BodyPartsPanel : public HeadlessEditor {
 protected:
  void open(const char* file) {
    ASSERT_TRUE(openFile(state, fs::path(SINEW_SOURCE_DIR) / "assets" / file));
    state.open.transport.playing = false;
    settle();
    run(action("muscles/body-parts"), state);
    settle();
  }
  [[nodiscard]] int boneOf(const BodySlot& slot) const { return bodyPartsOf(state)[slot].bone; }
  [[nodiscard]] int boneCalled(const char* name) const {
    return state.character().skeleton.findBone(name).value_or(-1);
  }
};

TEST_F(BodyPartsPanel, ListsThePartsOfTheKindOfBody) {
  open("humanoid.glb");
  EXPECT_TRUE(shown("body-parts/upperArm.L"));
  EXPECT_TRUE(shown("body-parts/upperArm.R"));
  EXPECT_FALSE(shown("body-parts/hindUpper.L"));
  click("body-parts/close");
  EXPECT_FALSE(shown("body-parts/heading"));
  open("horse.glb");
  EXPECT_TRUE(shown("body-parts/hindUpper.L"));
  EXPECT_FALSE(shown("body-parts/upperArm.L"));
  EXPECT_EQ(steps(), 0u);
}

TEST_F(BodyPartsPanel, CorrectionIsOneUndoStep) {
  open("humanoid.glb");
  const int found = boneOf(kLeftFoot);
  const int shin = boneCalled("shin.L");
  ASSERT_GE(shin, 0);
  ASSERT_NE(found, shin);
  click("body-parts/foot.L");
  type("shin.L");
  press(kEnter);
  ASSERT_EQ(state.document.rig().slots.size(), 1u);
  EXPECT_EQ(boneOf(kLeftFoot), shin);
  EXPECT_EQ(bodyPartsOf(state)[kLeftFoot].confidence, SlotConfidence::kGiven);
  EXPECT_EQ(steps(), 1u);
  run(action("edit/undo"), state);
  settle();
  EXPECT_TRUE(state.document.rig().slots.empty());
  EXPECT_EQ(boneOf(kLeftFoot), found);
  EXPECT_EQ(state.open.bodyParts.slots[kLeftFoot].bone, found);
}

TEST_F(BodyPartsPanel, PartCanBeSetToNoneAndBackToTheDetectedBone) {
  open("humanoid.glb");
  const int found = boneOf(kLeftFoot);
  click("body-parts/foot.L");
  EXPECT_FALSE(shown("body-parts/foot.L-as-found"));
  click("body-parts/foot.L-none");
  EXPECT_EQ(boneOf(kLeftFoot), -1);
  click("body-parts/foot.L");
  click("body-parts/foot.L-as-found");
  EXPECT_EQ(boneOf(kLeftFoot), found);
  EXPECT_TRUE(state.document.rig().slots.empty());
  EXPECT_EQ(steps(), 2u);
}

TEST_F(BodyPartsPanel, UnknownBodyListsThePartsOfTheChosenKind) {
  open("tangle.glb");
  EXPECT_TRUE(shown("body-parts/upperArm.L"));
  click("body-parts/kind/animal");
  EXPECT_TRUE(shown("body-parts/hindUpper.L"));
  EXPECT_FALSE(shown("body-parts/upperArm.L"));
}

TEST_F(BodyPartsPanel, OnlyOneOverlayPanelIsOpenAtATime) {
  open("humanoid.glb");
  run(action("muscles/add-set"), state);
  settle();
  EXPECT_FALSE(shown("body-parts/heading"));
  EXPECT_TRUE(shown("muscle-set/mass"));
  run(action("muscles/body-parts"), state);
  settle();
  EXPECT_TRUE(shown("body-parts/heading"));
  EXPECT_FALSE(shown("muscle-set/mass"));
  run(action("play/check"), state);
  settle();
  EXPECT_FALSE(shown("body-parts/heading"));
}

}  // namespace
}  // namespace sinew::app
