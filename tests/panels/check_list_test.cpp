// tests/panels/check_list_test.cpp: Play > Check muscles through the panel: the list, jumping to a finding, mending,
// undo.
#include <algorithm>

#include "app/editor/actions.h"
#include "core/rig/line_edit.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class CheckList : public HeadlessEditor {
 protected:
  void open(const char* rig) {
    ASSERT_TRUE(openFile(state, fs::path(SINEW_SOURCE_DIR) / "assets" / rig));
    state.open.transport.playing = false;
    settle();
  }
  void check() {
    run(action("play/check"), state);
    settle();
  }
};

TEST_F(CheckList, IsEmptyForASoundRig) {
  open("humanoid-flex.rig.json");
  check();
  EXPECT_TRUE(shown("check/heading"));
  EXPECT_FALSE(shown("check/0"));
  click("check/close");
  EXPECT_FALSE(shown("check/heading"));
}

TEST_F(CheckList, ClickJumpsToTheTimeOfTheFinding) {
  open("horse.rig.json");
  state.document.selection.set(state.document.idAt(4));
  check();
  ASSERT_FALSE(state.open.check.findings.empty());
  const Finding finding = state.open.check.findings[1];
  click("check/1");
  EXPECT_EQ(state.document.activePrimitive(), finding.primitive);
  ASSERT_GE(state.open.transport.clip, 0);
  EXPECT_EQ(state.character().clips[static_cast<std::size_t>(state.open.transport.clip)].name, finding.clip);
  EXPECT_FLOAT_EQ(static_cast<float>(state.open.transport.time), finding.time);
  EXPECT_FALSE(state.open.transport.playing);
}

TEST_F(CheckList, HidesLegendsWhileOpen) {
  open("horse.rig.json");
  run(action("view/anatomy"), state);
  settle();
  ASSERT_TRUE(shown("legend/anatomy"));
  check();
  EXPECT_FALSE(shown("legend/anatomy"));
  click("check/close");
  EXPECT_TRUE(shown("legend/anatomy"));
}

TEST_F(CheckList, RepairIsOneStepAndLeavesFewerFindings) {
  open("horse.rig.json");
  check();
  const std::size_t found = state.open.check.findings.size();
  const std::size_t steps = state.document.commands.stepCount();
  const Rig before = state.document.rig();
  click("check/mend");
  EXPECT_EQ(state.document.commands.stepCount(), steps + 1);
  EXPECT_LT(state.open.check.findings.size(), found);
  run(action("edit/undo"), state);
  settle();
  EXPECT_EQ(state.document.rig(), before);
  // The rig has changed since the check: the button checks again.
  click("check/mend");
  EXPECT_EQ(state.open.check.findings.size(), found);
}

}  // namespace
}  // namespace sinew::app
