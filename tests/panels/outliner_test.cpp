// tests/panels/outliner_test.cpp: outliner tree: rows, selection, switches, renaming, moving to another bone.

#include "tests/support/editor/headless_editor.h"

#include <algorithm>
#include <cmath>

#include "app/editor/outliner.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

/// Bundled rig.
class Outliner : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
    state.open.transport.playing = false;
    state.view.layout.history = 90.0f;
    settle();
  }
  [[nodiscard]] std::vector<OutlinerRow> rows(const std::string& filter = "", bool only = false) const {
    const Skeleton& skeleton = state.character().skeleton;
    return outlinerRows(state.document.rig(), skeleton, boneOfEach(state.document.rig(), skeleton),
                        {filter, only, &state.view.outliner.folded, false});
  }
  [[nodiscard]] std::size_t muscles(const std::vector<OutlinerRow>& list) const {
    return static_cast<std::size_t>(std::ranges::count(list, RowKind::kMuscle, &OutlinerRow::kind));
  }
  [[nodiscard]] int shownMuscles() const { return state.live->surface().report.primitives; }
  void held(int key, const std::string& id) {
    queue.key(key, true);
    settle();
    click(id);
    queue.key(key, false);
    settle();
  }
  [[nodiscard]] std::vector<std::string> selection() const { return selectedNames(state.document); }
  [[nodiscard]] int indexOf(const std::string& name) const { return findPrimitive(state.document.rig(), name); }
  static constexpr int kLeftShift = 340;
  static constexpr int kDown = 264;
  static constexpr int kUp = 265;
};

TEST_F(Outliner, ListsEveryMuscleAndBoneParentsFirst) {
  const auto all = rows();
  const Skeleton& skeleton = state.character().skeleton;
  EXPECT_EQ(all.size(), skeleton.bones.size() + state.document.rig().primitives.size());
  std::vector<int> open;
  for (const OutlinerRow& row : all) {
    open.resize(static_cast<std::size_t>(row.level));
    const int above = open.empty() ? -1 : open.back();
    if (row.kind == RowKind::kMuscle) {
      const Primitive& primitive = state.document.rig().primitives[static_cast<std::size_t>(row.index)];
      EXPECT_EQ(skeleton.findBone(primitive.bone), above) << primitive.name;
    } else {
      EXPECT_EQ(skeleton.bones[static_cast<std::size_t>(row.index)].parent, above);
      open.push_back(row.index);
    }
  }
}

TEST_F(Outliner, SearchKeepsTheBonesAboveItsMatches) {
  const auto found = rows("BICEPS");
  EXPECT_EQ(muscles(found), 2u);
  for (const OutlinerRow& row : found) {
    if (row.kind != RowKind::kBone) continue;
    const auto below = musclesUnder(row.index, state.character().skeleton,
                                    boneOfEach(state.document.rig(), state.character().skeleton));
    EXPECT_TRUE(std::ranges::any_of(below, [&](int i) {
      return containsText(state.document.rig().primitives[static_cast<std::size_t>(i)].name, "biceps");
    }));
  }
  // A bone's name finds its muscles.
  EXPECT_EQ(muscles(rows("upper_arm.L")), 2u);
  EXPECT_TRUE(rows("no such thing").empty());
  click("outliner/search");
  type("biceps");
  EXPECT_TRUE(shown("outliner/muscle/biceps L"));
  EXPECT_FALSE(shown("outliner/muscle/chest L"));
}

TEST_F(Outliner, BonesWithoutMusclesCanBeHidden) {
  const auto all = rows();
  click("outliner/only-with-muscles");
  EXPECT_TRUE(state.view.outliner.onlyWithMuscles);
  const auto fewer = rows("", true);
  EXPECT_LT(fewer.size(), all.size());
  EXPECT_EQ(muscles(fewer), muscles(all));
}

TEST_F(Outliner, FoldedBoneHidesItsChildrenUntilOneIsSelected) {
  const std::size_t all = rows().size();
  click("outliner/fold/hips");
  EXPECT_LT(rows().size(), all);
  select(state.document, {"tail root"});
  settle();
  settle();
  EXPECT_TRUE(shown("outliner/muscle/tail root"));
}

TEST_F(Outliner, ShiftSelectsARangeAndControlTogglesOne) {
  state.view.layout.history = 64.0f;  // All rows of the range are visible.
  settle();
  click("outliner/muscle/glute L");
  ASSERT_EQ(selection(), std::vector<std::string>{"glute L"});
  const auto all = rows();
  const auto place = [&](const std::string& name) {
    return rowOf(all, "m:" + std::to_string(idOf(state.document, name).value), state.document.rig(),
                 state.character().skeleton);
  };
  std::vector<std::string> visible;
  for (const auto& [id, box] : widgets().rectangles()) {
    constexpr std::string_view kPrefix = "outliner/muscle/";
    if (id.starts_with(kPrefix)) visible.push_back(id.substr(kPrefix.size()));
  }
  const std::string last = *std::ranges::max_element(visible, {}, place);
  held(kLeftShift, "outliner/muscle/" + last);
  const auto between =
      std::ranges::count_if(visible, [&](const std::string& name) { return place(name) >= place("glute L"); });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(selection().size()), between);
  EXPECT_EQ(selection().back(), last);
  held(kLeftControl, "outliner/muscle/" + last);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(selection().size()), between - 1);
  click("outliner/muscle/glute R");
  EXPECT_EQ(selection(), std::vector<std::string>{"glute R"});
}

TEST_F(Outliner, ArrowKeysMoveThroughTheRows) {
  click("outliner/muscle/glute L");
  press(kDown);
  EXPECT_EQ(selection(), std::vector<std::string>{"glute R"});
  press(kUp);
  EXPECT_EQ(selection(), std::vector<std::string>{"glute L"});
  press(kUp);
  EXPECT_TRUE(selection().empty());
  EXPECT_EQ(state.document.selection.bone, state.character().skeleton.findBone("hips"));
}

TEST_F(Outliner, HiddenMuscleLeavesTheSurfaceButStaysInTheRig) {
  const Rig before = state.document.rig();
  const int all = shownMuscles();
  const auto skin = state.live->surface().positions;
  click("outliner/eye/glute L");
  EXPECT_EQ(shownMuscles(), all - 1);
  EXPECT_NE(state.live->surface().positions, skin);
  EXPECT_EQ(shownShapes(state, true).size(), static_cast<std::size_t>(all) - 1);
  EXPECT_EQ(state.document.rig(), before);
  EXPECT_FALSE(state.document.commands.modified());
  click("outliner/eye/glute L");
  EXPECT_EQ(state.live->surface().positions, skin);
  click("outliner/eye/bone/hips");
  EXPECT_EQ(shownMuscles(), 0);
  EXPECT_TRUE(shown("outliner/show-all"));
  click("outliner/show-all");
  EXPECT_EQ(shownMuscles(), all);
}

TEST_F(Outliner, KeysHideIsolateAndShow) {
  const int all = shownMuscles();
  click("outliner/muscle/glute L");
  press('H');
  EXPECT_EQ(shownMuscles(), all - 1);
  press('H');
  EXPECT_EQ(shownMuscles(), all);
  press('/');
  EXPECT_EQ(shownMuscles(), 1);
  press('/');
  EXPECT_EQ(shownMuscles(), all);
  press('H');
  queue.key(342, true);  // Alt.
  press('H');
  queue.key(342, false);
  settle();
  EXPECT_EQ(shownMuscles(), all);
}

TEST_F(Outliner, BeforeViewLastsWhileItsKeyOrButtonIsHeld) {
  const int all = shownMuscles();
  const auto with = state.live->surface().positions;
  queue.key('`', true);
  settle();
  EXPECT_EQ(shownMuscles(), 0);
  queue.key('`', false);
  settle();
  EXPECT_EQ(shownMuscles(), all);
  queue.move(center("toolstrip/before"));
  settle();
  queue.button(0, true);
  settle();
  EXPECT_EQ(shownMuscles(), 0);
  queue.button(0, false);
  settle();
  EXPECT_EQ(state.live->surface().positions, with);
}

TEST_F(Outliner, HiddenStateSurvivesRenameAndUndo) {
  click("outliner/eye/glute L");
  const int shownThen = shownMuscles();
  EXPECT_TRUE(rename(state, idOf(state.document, "glute L"), "left one"));
  settle();
  EXPECT_EQ(shownMuscles(), shownThen);
  undo(state);
  settle();
  EXPECT_EQ(shownMuscles(), shownThen);
  EXPECT_TRUE(state.document.visibility.hidden.muscles.contains(idOf(state.document, "glute L")));
  select(state.document, {"glute L"});
  deleteSelection(state);
  settle();
  undo(state);
  settle();
  EXPECT_EQ(shownMuscles(), shownThen);
}

TEST_F(Outliner, MuscleDraggedOntoABoneKeepsItsPosition) {
  const auto place = [&] {
    const Primitive& primitive = state.document.rig().primitives[static_cast<std::size_t>(indexOf("glute L"))];
    const int bone = state.character().skeleton.findBone(primitive.bone).value_or(0);
    const auto& matrices = state.live->pose().boneInWorld;
    return glm::vec3(matrices[static_cast<std::size_t>(bone)] * glm::vec4(primitive.placement.center, 1.0f));
  };
  const glm::vec3 before = place();
  const std::string from = state.document.rig().primitives[static_cast<std::size_t>(indexOf("glute L"))].bone;
  const glm::vec2 way = center("outliner/bone/spine") - center("outliner/muscle/glute L");
  drag("outliner/muscle/glute L", way);
  EXPECT_EQ(state.document.rig().primitives[static_cast<std::size_t>(indexOf("glute L"))].bone, "spine");
  EXPECT_LT(glm::length(place() - before), 1e-5f * state.character().height);
  EXPECT_EQ(steps(), 1u);
  undo(state);
  EXPECT_EQ(state.document.rig().primitives[static_cast<std::size_t>(indexOf("glute L"))].bone, from);
}

TEST_F(Outliner, DoubleClickRenamesInPlace) {
  doubleClick("outliner/muscle/glute L");
  ASSERT_TRUE(shown("outliner/rename"));
  press(kKeyA, true);
  type("gluteus");
  press(kEnter);
  EXPECT_GE(indexOf("gluteus"), 0);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(Outliner, UnattachedMuscleIsListedSeparatelyAndCanBeAttached) {
  Rig rig = state.document.rig();
  Primitive lost;
  lost.name = "lost";
  lost.bone = "wing";
  rig = addPrimitive(rig, lost).value();
  state.document.commands.apply("Lost", rig);
  settle();
  ASSERT_TRUE(shown("outliner/unattached"));
  ASSERT_TRUE(shown("outliner/muscle/lost"));
  reparentMuscles(state, {indexOf("lost")}, 0);
  settle();
  EXPECT_FALSE(shown("outliner/unattached"));
}

TEST_F(Outliner, LockedMuscleIsNotPickable) {
  click("outliner/lock/glute L");
  EXPECT_FALSE(
      isPickable(state.document.visibility, state.document.rig(), state.character().skeleton, indexOf("glute L")));
  EXPECT_EQ(shownMuscles(), static_cast<int>(state.document.rig().primitives.size()));
}

TEST(OutlinerRows, ListsAThousandMusclesOnFiveHundredBones) {
  Skeleton skeleton;
  for (int b = 0; b < 500; ++b) {
    skeleton.nodes.emplace_back();
    Bone bone;
    bone.name = "bone " + std::to_string(b);
    bone.node = b;
    bone.parent = b - 1;
    skeleton.bones.push_back(bone);
  }
  finishBones(skeleton);
  Rig rig;
  rig.groups.push_back({"muscles", {}});
  std::vector<int> boneOf;
  for (int i = 0; i < 1000; ++i) {
    Primitive primitive;
    primitive.name = "muscle " + std::to_string(i);
    boneOf.push_back(i % 500);
    rig.primitives.push_back(primitive);
  }
  const std::set<std::string> none;
  EXPECT_EQ(outlinerRows(rig, skeleton, boneOf, {"", false, &none, false}).size(), 1500u);
  const auto found = outlinerRows(rig, skeleton, boneOf, {"muscle 999", false, &none, false});
  EXPECT_EQ(found.size(), 501u);
  EXPECT_EQ(found.back().index, 999);
}

/// Whether a row is highlighted: a rectangle of that color spans it.
bool isLit(const glm::vec4& row) {
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_HeaderHovered);
  bool top = false;
  bool bottom = false;
  const ImDrawData& data = *ImGui::GetDrawData();
  for (int l = 0; l < data.CmdListsCount; ++l) {
    for (const ImDrawVert& vertex : data.CmdLists[l]->VtxBuffer) {
      if (vertex.col != color || std::abs(vertex.pos.x - row.x) > 1.0f) continue;
      top = top || std::abs(vertex.pos.y - row.y) < 1.0f;
      bottom = bottom || std::abs(vertex.pos.y - row.y - row.w) < 1.0f;
    }
  }
  return top && bottom;
}

TEST_F(Outliner, HoverInTheViewportHighlightsOnlyItsRow) {
  state.document.selection.clear();
  int muscleRows = 0;
  int boneRows = 0;
  const auto scrolled = widgets().rectangles().at("outliner/bone/hips");
  for (int bone = 0; bone < static_cast<int>(state.character().skeleton.bones.size()); ++bone) {
    queue.move(pixelOfBone(bone));
    settle();
    ImGui::Render();
    const ViewportHover& hover = state.view.tools.hover;
    std::string wanted;
    if (hover.primitive >= 0) {
      wanted = "outliner/muscle/" + state.document.rig().primitives[static_cast<std::size_t>(hover.primitive)].name;
    } else if (hover.bone >= 0) {
      wanted = "outliner/bone/" + state.character().skeleton.fileName(hover.bone);
    }
    for (const auto& [id, box] : widgets().rectangles()) {
      const bool muscle = id.starts_with("outliner/muscle/");
      if (!muscle && !id.starts_with("outliner/bone/")) continue;
      if (box.w < scrolled.w) continue;  // Partly scrolled out.
      EXPECT_EQ(isLit(box), id == wanted) << id << " over " << wanted;
      if (id == wanted) ++(muscle ? muscleRows : boneRows);
    }
    EXPECT_EQ(widgets().rectangles().at("outliner/bone/hips"), scrolled) << "nothing scrolls";
  }
  EXPECT_GT(muscleRows, 0);
  EXPECT_GT(boneRows, 0);
}

TEST_F(Outliner, HoveredRowHighlightsItsMuscleInTheViewport) {
  const std::string name = state.document.rig().primitives[0].name;
  queue.move(center("outliner/muscle/" + name));
  settle();
  for (const PrimitiveShape& shape : shownShapes(state, true)) {
    EXPECT_EQ(shape.hovered, shape.rigIndex == 0) << shape.rigIndex;
  }
}

TEST_F(Outliner, PickedOrDrawnMuscleReplacesTheBoneSelection) {
  const int bone = *state.character().skeleton.findBone("spine");
  clickBone(state, bone);
  EXPECT_EQ(state.document.selection.bone, bone);
  state.document.selection.set(state.document.idAt(0));
  EXPECT_EQ(state.document.selection.bone, -1);
  clickBone(state, bone);
  setTool(state.view.tools, ToolKind::kAddMuscle);
  const std::size_t before = state.document.rig().primitives.size();
  const glm::vec2 at = pixelOfBone(bone);
  queue.move(at);
  settle();
  queue.button(0, true);
  frame();
  queue.move(at + glm::vec2(0.0f, 25.0f));
  frame();
  queue.button(0, false);
  settle();
  ASSERT_GT(state.document.rig().primitives.size(), before);
  EXPECT_EQ(state.document.selection.primitives.size(), 1u);
  EXPECT_EQ(state.document.selection.bone, -1);
  ImGui::Render();
  const ImU32 selected = ImGui::GetColorU32(ImGuiCol_Header);
  const glm::vec4 row = widgets().rectangles().at("outliner/bone/spine");
  for (int l = 0; l < ImGui::GetDrawData()->CmdListsCount; ++l) {
    for (const ImDrawVert& vertex : ImGui::GetDrawData()->CmdLists[l]->VtxBuffer) {
      const bool within = vertex.pos.x > row.x && vertex.pos.x < row.x + row.z && vertex.pos.y > row.y + 1.0f &&
                          vertex.pos.y < row.y + row.w - 1.0f;
      EXPECT_FALSE(within && vertex.col == selected) << "the bone's row looks selected";
    }
  }
}

TEST_F(Outliner, ShiftFoldsAllBelow) {
  click("outliner/fold/hips");
  const std::size_t one = state.view.outliner.folded.size();
  click("outliner/fold/hips");
  held(kLeftShift, "outliner/fold/hips");
  EXPECT_GT(state.view.outliner.folded.size(), one);
  held(kLeftShift, "outliner/fold/hips");
  EXPECT_TRUE(state.view.outliner.folded.empty());
}

TEST_F(Outliner, EyeOfOneOfSeveralSelectedIsTheEyeOfAll) {
  const int all = shownMuscles();
  click("outliner/muscle/glute L");
  held(kLeftControl, "outliner/muscle/glute R");
  ASSERT_EQ(selection().size(), 2u);
  click("outliner/eye/glute L");
  EXPECT_EQ(shownMuscles(), all - 2);
  click("outliner/eye/glute R");
  EXPECT_EQ(shownMuscles(), all);
}

}  // namespace
}  // namespace sinew::app
