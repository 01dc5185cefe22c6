// tests/panels/inspector_lines_test.cpp: lines of several muscles are edited together.

#include "tests/support/editor/headless_editor.h"

#include <algorithm>

#include "app/editor/commands.h"
#include "core/rig/line_edit.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

/// The character whose limbs have lines.
class InspectorLines : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid-flex.rig.json"));
    state.open.transport.playing = false;
    settle();
  }
  void select(std::initializer_list<const char*> names) {
    state.document.selection.clear();
    for (const char* name : names) state.document.selection.primitives.push_back(idOf(state.document, name));
    settle();
  }
  [[nodiscard]] const MuscleLine& line(const std::string& name) const {
    return state.document.rig().lines.at(static_cast<std::size_t>(findLine(state.document.rig(), name)));
  }
  [[nodiscard]] const Primitive& named(const std::string& name) const {
    return state.document.rig().primitives.at(static_cast<std::size_t>(findPrimitive(state.document.rig(), name)));
  }
  [[nodiscard]] bool warned(const char* of) const {
    return std::ranges::any_of(state.session.messages, [&](const Message& message) {
      return message.kind == MessageKind::kWarning && message.text.find(of) != std::string::npos;
    });
  }
};

TEST_F(InspectorLines, RowsAreShownForSeveralMuscles) {
  select({"biceps L", "triceps L", "nape"});
  for (const char* row : {"ends", "length", "rest-now", "full-now", "learn", "flex-height", "via", "rest", "volume",
                          "tendon-origin", "pivot", "gain", "full"}) {
    EXPECT_TRUE(shown(std::string("inspector/line/") + row)) << row;
  }
}

TEST_F(InspectorLines, TypedNumberAppliesToAllInOneStep) {
  select({"biceps L", "triceps L"});
  ASSERT_NE(line("biceps L").settings.rest, line("triceps L").settings.rest);
  typeInto("inspector/line/rest", "105");
  EXPECT_FLOAT_EQ(line("biceps L").settings.rest, 1.05f);
  EXPECT_FLOAT_EQ(line("triceps L").settings.rest, 1.05f);
  EXPECT_FLOAT_EQ(line("triceps R").settings.rest, 1.05f) << "twins follow";
  EXPECT_EQ(line("calf L").settings.rest, 1.0f);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(InspectorLines, DragKeepsTheDifferences) {
  select({"biceps L", "triceps L"});
  const float biceps = line("biceps L").settings.full;
  const float triceps = line("triceps L").settings.full;
  drag("inspector/line/full", {-40.0f, 0.0f});
  EXPECT_LT(line("biceps L").settings.full, biceps);
  EXPECT_NEAR(line("triceps L").settings.full - triceps, line("biceps L").settings.full - biceps, 1e-5f);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(InspectorLines, RelativeNumberIsAddedToEach) {
  select({"biceps L", "triceps L"});
  typeInto("inspector/line/rest", "+=10");
  EXPECT_NEAR(line("biceps L").settings.rest, 1.1f, 1e-5f);
  EXPECT_NEAR(line("triceps L").settings.rest, 1.22f, 1e-5f);
}

TEST_F(InspectorLines, OutOfRangeValueIsRefusedForAll) {
  select({"biceps L", "triceps L"});
  typeInto("inspector/line/rest", "9000");
  EXPECT_EQ(steps(), 0u);
  EXPECT_TRUE(state.session.toast && state.session.toast->refusal);
}

TEST_F(InspectorLines, ViaPointsAreAddedWhereMissing) {
  select({"biceps L", "triceps L"});  // Only the triceps has one.
  const LineAnchor own = *line("triceps L").via;
  click("inspector/line/via");
  EXPECT_TRUE(line("biceps L").via);
  EXPECT_EQ(line("triceps L").via, own);
  click("inspector/line/via");  // Now all have one: the button removes them.
  EXPECT_FALSE(line("biceps L").via);
  EXPECT_FALSE(line("triceps L").via);
  EXPECT_EQ(steps(), 2u);
}

TEST_F(InspectorLines, LearnIsOneStepForAll) {
  select({"biceps L", "hamstrings L"});
  const float biceps = line("biceps L").settings.full;
  const float hamstrings = line("hamstrings L").settings.full;
  click("inspector/line/learn");
  EXPECT_NE(line("biceps L").settings.full, biceps);
  EXPECT_NE(line("hamstrings L").settings.full, hamstrings);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(InspectorLines, RigidRemovesAllMusclesFromTheirLines) {
  select({"biceps L", "triceps L"});
  click("inspector/line/remove");
  EXPECT_TRUE(named("biceps L").line.empty());
  EXPECT_TRUE(named("triceps R").line.empty());
  EXPECT_EQ(steps(), 1u);
  EXPECT_FALSE(shown("inspector/line/rest"));
}

TEST_F(InspectorLines, OtherEndsOfSeveralMusclesAreAttachedInOneStep) {
  select({"nape", "trapezius L"});
  click("inspector/shape");
  click("inspector/other-end");
  click("inspector/other-end/head");
  EXPECT_FALSE(named("nape").line.empty());
  EXPECT_FALSE(named("trapezius L").line.empty());
  EXPECT_FALSE(named("trapezius R").line.empty()) << "twins follow";
  EXPECT_EQ(steps(), 1u);
}

TEST_F(InspectorLines, SectionsFoldAndStayFolded) {
  select({"biceps L"});
  click("inspector/section/placement");
  EXPECT_FALSE(shown("inspector/radius.x"));
  EXPECT_TRUE(shown("inspector/reach"));
  select({"triceps L"});
  EXPECT_FALSE(shown("inspector/radius.x")) << "for every muscle";
  EXPECT_EQ(state.view.layout.folded, std::vector<std::string>{"inspector/section/placement"})
      << "kept with the layout";
  click("inspector/section/line");
  EXPECT_FALSE(shown("inspector/line/rest"));
  click("inspector/section/line");
  click("inspector/section/placement");
  EXPECT_TRUE(shown("inspector/line/rest") && shown("inspector/radius.x"));
}

TEST_F(InspectorLines, BoneListsShowNearBonesFirstAndFilterByTyping) {
  select({"biceps L"});
  click("inspector/bone");
  EXPECT_LT(center("inspector/bone/upper_arm.L").y, center("inspector/bone/forearm.L").y);
  EXPECT_LT(center("inspector/bone/forearm.L").y, center("inspector/bone/hips").y);
  type("forearm.R");
  EXPECT_FALSE(shown("inspector/bone/hips"));
  press(kEnter);
  EXPECT_EQ(named("biceps L").bone, "forearm.R");
  EXPECT_EQ(steps(), 1u);
}

TEST_F(InspectorLines, WarningDisappearsOnceTheViaPointExists) {
  select({"hamstrings L"});
  Rig tight = state.document.rig();
  for (MuscleLine& each : tight.lines) each.settings.rest = 2.0f;  // Always far shorter than its rest length.
  state.document.commands.apply("Rest", tight);
  settle();
  click("inspector/line/learn");
  ASSERT_TRUE(warned("via point"));
  click("inspector/line/via");
  EXPECT_TRUE(line("hamstrings L").via);
  EXPECT_FALSE(warned("via point"));
  undo(state);
  click("inspector/line/learn");
  ASSERT_TRUE(warned("via point"));
  deleteSelection(state);
  settle();
  EXPECT_FALSE(warned("via point")) << "its line is gone";
}

}  // namespace
}  // namespace sinew::app
