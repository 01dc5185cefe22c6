// tests/panels/blending_test.cpp: work groups: the matrix and the graph edit the same rig and show each other's
// changes.

#include "tests/support/editor/headless_editor.h"

#include <algorithm>
#include <cmath>

#include "app/editor/blending_edit.h"
#include "app/panels/blending.h"
#include "core/rig/field.h"
#include "core/rig/rig_edit.h"
#include "core/rig/validation.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

/// Bundled rig with legs - torso - arms, in the Groups tab.
class Blending : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
    state.open.transport.playing = false;
    settle();
    click("blending/tab");
    ASSERT_TRUE(shown("blending/cell/torso/legs"));
  }
  [[nodiscard]] const Rig& rig() const { return state.document.rig(); }
  [[nodiscard]] float amount(const std::string& a, const std::string& b) const { return linkAmount(rig(), a, b); }
  [[nodiscard]] bool linked(const std::string& a, const std::string& b) const { return linkAmount(rig(), a, b) > 0.0f; }
  void hover(const std::string& id) {
    queue.move(center(id));
    settle();
  }
  /// Drags from the middle of one control to the middle of another.
  void dragTo(const std::string& from, const std::string& to) { drag(from, center(to) - center(from)); }
  [[nodiscard]] bool allValid() const { return validate(rig()).ok(); }
};

TEST_F(Blending, CellLinksAndUnlinksInOneStepEach) {
  ASSERT_TRUE(linked("legs", "torso"));
  ASSERT_FALSE(linked("legs", "arms"));
  click("blending/cell/arms/legs");
  EXPECT_TRUE(linked("legs", "arms"));
  EXPECT_EQ(steps(), 1u);
  click("blending/cell/torso/legs");
  EXPECT_FALSE(linked("legs", "torso"));
  EXPECT_EQ(steps(), 2u);
  undo(state);
  undo(state);
  EXPECT_TRUE(linked("legs", "torso"));
  EXPECT_FALSE(linked("legs", "arms"));
}

TEST_F(Blending, DraggingACellSidewaysSetsHowMuchGroupsBlend) {
  drag("blending/cell/arms/legs", {60.0f * state.frame.uiScale, 0.0f});
  EXPECT_NEAR(amount("legs", "arms"), 0.5f, 0.05f);
  EXPECT_EQ(steps(), 1u);
  const float half = amount("legs", "arms");
  EXPECT_EQ(state.document.commands.label(1), "Link arms and legs by " + percentText(half));
  EXPECT_EQ(100.0f * half, std::round(100.0f * half)) << "whole percents";
  drag("blending/cell/arms/legs", {-24.0f * state.frame.uiScale, 0.0f});
  EXPECT_NEAR(amount("legs", "arms"), half - 0.2f, 0.03f) << "from where it was";
  drag("blending/cell/arms/legs", {-400.0f, 0.0f});
  EXPECT_FALSE(linked("legs", "arms"));
  drag("blending/cell/arms/legs", {400.0f, 0.0f});
  EXPECT_EQ(amount("legs", "arms"), 1.0f);
  EXPECT_EQ(steps(), 4u);
  for (int i = 0; i < 3; ++i) undo(state);
  EXPECT_EQ(amount("legs", "arms"), half);
  click("blending/cell/arms/legs");
  EXPECT_FALSE(linked("legs", "arms")) << "a click unlinks, however little they blend";
  EXPECT_TRUE(allValid());
}

TEST_F(Blending, DragOfACellIsTakenBackByEsc) {
  queue.move(center("blending/cell/torso/legs"));
  settle();
  queue.button(0, true);
  settle();
  queue.move(center("blending/cell/torso/legs") - glm::vec2(50.0f, 0.0f));
  settle();
  EXPECT_LT(amount("legs", "torso"), 1.0f);
  press(kEscape);
  queue.button(0, false);
  settle();
  EXPECT_EQ(amount("legs", "torso"), 1.0f);
  EXPECT_EQ(steps(), 0u);
}

TEST_F(Blending, HowMuchGroupsBlendIsTypedInMatrixAndGraph) {
  click("blending/cell/torso/legs", 1);
  ASSERT_TRUE(shown("blending/amount"));
  doubleClick("blending/amount");
  press(kKeyA, true);
  type("40");
  press(kEnter);
  EXPECT_EQ(amount("legs", "torso"), 0.4f);
  EXPECT_EQ(steps(), 1u);
  press(kEscape);
  click("blending/view/graph");
  click(shown("blending/edge/legs/torso") ? "blending/edge/legs/torso" : "blending/edge/torso/legs", 1);
  ASSERT_TRUE(shown("blending/amount"));
  doubleClick("blending/amount");
  press(kKeyA, true);
  type("75");
  press(kEnter);
  EXPECT_EQ(amount("legs", "torso"), 0.75f);
  EXPECT_EQ(steps(), 2u);
  undo(state);
  EXPECT_EQ(amount("legs", "torso"), 0.4f);
}

TEST_F(Blending, HoveredCellHighlightsTheMusclesOfBothGroups) {
  hover("blending/cell/torso/legs");
  std::vector<int> both = membersOf(rig(), "legs");
  const std::vector<int> torso = membersOf(rig(), "torso");
  both.insert(both.end(), torso.begin(), torso.end());
  std::vector<int> lit = state.frame.highlighted;
  std::ranges::sort(both);
  std::ranges::sort(lit);
  EXPECT_EQ(lit, both);
  EXPECT_EQ(shownShapes(state, false).size(), both.size());
  hover("blending/cell/arms/arms");
  EXPECT_EQ(state.frame.highlighted.size() % membersOf(rig(), "arms").size(), 0u);
}

TEST_F(Blending, GraphAndMatrixShowEachOthersChanges) {
  click("blending/cell/arms/legs");
  click("blending/view/graph");
  EXPECT_TRUE(shown("blending/edge/legs/arms") || shown("blending/edge/arms/legs"));
  for (const char* group : {"legs", "torso", "arms"}) {
    EXPECT_TRUE(shown(std::string("blending/node/") + group)) << group;
  }
  click(shown("blending/edge/legs/arms") ? "blending/edge/legs/arms" : "blending/edge/arms/legs");
  EXPECT_FALSE(linked("legs", "arms"));
  dragTo("blending/rim/legs", "blending/node/arms");
  EXPECT_TRUE(linked("legs", "arms"));
  EXPECT_EQ(steps(), 3u);
  EXPECT_TRUE(allValid());
}

TEST_F(Blending, MovingANodeLeavesTheRigUnchanged) {
  click("blending/view/graph");
  const glm::vec2 before = center("blending/node/torso");
  drag("blending/node/torso", {24.0f, 30.0f});
  const glm::vec2 moved = center("blending/node/torso") - before;
  EXPECT_GT(moved.x, 12.0f);
  EXPECT_GT(moved.y, 15.0f);
  EXPECT_EQ(steps(), 0u);
  const glm::vec2 placed = center("blending/node/torso");
  click("blending/view/matrix");
  click("blending/view/graph");
  EXPECT_EQ(center("blending/node/torso"), placed);
}

TEST_F(Blending, GroupsAreAddedNamedRenamedAndDeleted) {
  click("blending/add");
  ASSERT_TRUE(shown("blending/rename"));
  press(kKeyA, true);
  type("neck");
  press(kEnter);
  ASSERT_GE(findGroup(rig(), "neck"), 0);
  doubleClick("blending/group/neck");
  ASSERT_TRUE(shown("blending/rename"));
  press(kKeyA, true);
  type("throat");
  press(kEnter);
  ASSERT_GE(findGroup(rig(), "throat"), 0);
  doubleClick("blending/group/throat");
  press(kKeyA, true);
  type("torso");
  press(kEnter);
  EXPECT_GE(findGroup(rig(), "throat"), 0) << "two groups of one name there are not";
  click("blending/cell/throat/torso");
  EXPECT_TRUE(linked("throat", "torso"));
  click("blending/group/throat", 1);
  click("context/group-delete");
  EXPECT_EQ(findGroup(rig(), "throat"), -1);
  EXPECT_TRUE(allValid());
}

TEST_F(Blending, MusclesOfADeletedGroupMoveToTheChosenGroup) {
  const std::size_t legs = membersOf(rig(), "legs").size();
  const std::size_t torso = membersOf(rig(), "torso").size();
  click("blending/group/legs", 1);
  click("context/group-delete");  // Opens the list of the other groups.
  click("context/group-delete/torso");
  EXPECT_EQ(findGroup(rig(), "legs"), -1);
  EXPECT_EQ(membersOf(rig(), "torso").size(), legs + torso);
  EXPECT_EQ(steps(), 1u);
  EXPECT_TRUE(allValid());
}

TEST_F(Blending, SelectedMusclesMoveIntoAGroup) {
  select(state.document, {"glute L"});
  state.document.selection.toggle(idOf(state.document, "glute R"));
  click("blending/group/legs");
  click("blending/move-here");
  EXPECT_EQ(rig().primitives[static_cast<std::size_t>(findPrimitive(rig(), "glute R"))].group, "legs");
  EXPECT_EQ(steps(), 1u);
  click("blending/select-members");
  EXPECT_EQ(state.document.selection.primitives.size(), membersOf(rig(), "legs").size());
}

TEST_F(Blending, MuscleIsDraggedFromTheOutlinerOntoAGroup) {
  click("outliner/tab");
  queue.move(center("outliner/muscle/glute L"));
  settle();
  queue.button(0, true);
  settle();
  queue.move(center("blending/tab"));
  for (int i = 0; i < 60; ++i) frame();
  ASSERT_TRUE(shown("blending/group/arms"));
  queue.move(center("blending/group/arms"));
  settle();
  queue.button(0, false);
  settle();
  EXPECT_EQ(rig().primitives[static_cast<std::size_t>(findPrimitive(rig(), "glute L"))].group, "arms");
}

TEST_F(Blending, SixtyGroupsFitInBothViews) {
  Rig many = rig();
  for (int i = 0; i < 57; ++i) many = addGroup(many, "group number " + std::to_string(i)).value();
  for (int i = 0; i + 1 < 60; ++i) many = setLink(many, i, i + 1, 1.0f).value();
  state.document.commands.apply("Many", many);
  settle();
  EXPECT_TRUE(shown("blending/cell/torso/legs"));
  click("blending/view/graph");
  int nodes = 0;
  for (const auto& [id, box] : widgets().rectangles()) nodes += id.starts_with("blending/node/") ? 1 : 0;
  EXPECT_EQ(nodes, 60);
}

TEST_F(Blending, TooManyCliquesAreRefusedWithAReason) {
  // The complement of n disjoint triangles has 3^n cliques: eight triangles are too many.
  Rig many = rig();
  while (many.groups.size() < 24) many = addGroup(many, "g" + std::to_string(many.groups.size())).value();
  many.links.clear();
  std::string refusal;
  for (int i = 0; i < 24 && refusal.empty(); ++i) {
    for (int j = 0; j < i; ++j) {
      if (i / 3 == j / 3) continue;
      Result<Rig> next = setLink(many, i, j, 1.0f);
      if (!next) {
        refusal = next.error().reason;
        break;
      }
      many = std::move(next).value();
    }
  }
  ASSERT_FALSE(refusal.empty());
  EXPECT_NE(refusal.find(std::to_string(kMaxCliques)), std::string::npos);
}

TEST(BlendingColors, NeighborsDifferAndColorsAreRepeatable) {
  Rig rig;
  for (int i = 0; i < 61; ++i) rig.groups.push_back({"group " + std::to_string(i), {}, {}});
  for (int i = 0; i < 60; ++i) {
    const Tint a = groupTint(rig, i);
    const Tint b = groupTint(rig, i + 1);
    EXPECT_GT(std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b), 0.15f) << i;
    EXPECT_EQ(a.r, groupTint(rig, i).r);
  }
}

TEST(BlendingLayout, NodesKeepTheirDistanceAndLinkedNodesAreCloser) {
  std::vector<std::array<int, 2>> links;
  for (int i = 0; i < 29; ++i) links.push_back({i, i + 1});
  for (const int count : {1, 2, 3, 7, 30, 60}) {
    std::vector<std::array<int, 2>> some;
    std::ranges::copy_if(links, std::back_inserter(some), [&](const auto& l) { return l[1] < count; });
    const std::vector<glm::vec2> places = layoutGraph(count, some);
    ASSERT_EQ(places.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(places, layoutGraph(count, some));
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) EXPECT_GT(glm::length(places[i] - places[j]), 50.0f) << count;
    }
  }
  const std::vector<glm::vec2> chain =
      layoutGraph(8, std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}});
  EXPECT_LT(glm::length(chain[0] - chain[1]), 0.5f * glm::length(chain[0] - chain[7]));
}

TEST(BlendingLayout, NewNodeIsPlacedInFreeSpace) {
  std::vector<glm::vec2> places;
  for (int i = 0; i < 40; ++i) places.push_back(freePlace(places));
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE(glm::length(places[i] - places[j]), 0.79f * kNodeSpacing);
  }
}

}  // namespace
}  // namespace sinew::app
