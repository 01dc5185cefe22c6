// tests/panels/layout_test.cpp: at all window sizes nothing is cut off and no text overlaps text; panel sizes depend on
// the stored sizes and the window.

#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "app/panels/panels.h"
#include "app/ui/style.h"
#include "tests/support/editor/drawn_text.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

struct Screen {
  float width, height, scale;
};

std::vector<Screen> screens() {
  std::vector<Screen> all;
  for (const float scale : {1.0f, 1.5f, 2.0f}) {
    for (const auto& [width, height] :
         {std::pair{1024.0f, 640.0f}, std::pair{1280.0f, 800.0f}, std::pair{1600.0f, 1000.0f},
          std::pair{1920.0f, 1200.0f}, std::pair{2560.0f, 1600.0f}}) {
      all.push_back({width, height, scale});
    }
  }
  return all;
}

std::string nameOf(const Screen& screen) {
  return std::to_string(static_cast<int>(screen.width)) + "x" + std::to_string(static_cast<int>(screen.height)) +
         " at " + std::to_string(screen.scale);
}

class Layout : public HeadlessEditor {
 protected:
  void use(const Screen& screen) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {screen.width, screen.height};
    io.Fonts->Clear();
    fonts = loadFonts(screen.scale);
    io.Fonts->Build();
    applyStyle(screen.scale);
    state.frame.uiScale = screen.scale;
    settleLayout();
  }
  /// Windows need a few frames to learn their content size and whether they scroll.
  void settleLayout() {
    for (int i = 0; i < 4; ++i) frame();
    ImGui::Render();
  }

  /// Long bone names as exporters write them, muscles on some bones.
  void nameAtLength() {
    auto character = std::make_shared<Character>(state.character());
    int number = 0;
    for (Bone& bone : character->skeleton.bones) {
      bone.name = "Armature_Character_" + bone.name + "_Twist_" + std::to_string(++number);
    }
    finishBones(character->skeleton);
    Document document = openDocument(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb").value();
    document.character = character;
    ASSERT_TRUE(showDocument(state, std::move(document)));
    state.open.transport.playing = false;
    for (const int bone : {0, 1, 2}) addMuscle(state, bone);
    state.document.commands.apply("A group", addGroup(state.document.rig(), "Deltoid_and_upper_arm_twist").value());
    settle();
  }

  /// @param only  windows to check; "": all
  void check(const std::string& what, const std::string& only = "") {
    nothingIsCutOff(what, only);
    nothingOverlaps(what, only);
    noTextThroughText(what, only);
  }

 private:
  static bool meant(const std::string& window, const std::string& only) {
    return only.empty() || window.find(only) != std::string::npos;
  }

  void nothingIsCutOff(const std::string& what, const std::string& only) {
    for (const LaidOut& item : widgets().laidOut()) {
      if (!meant(item.window, only)) continue;
      // A list row extends half a gap into the padding; a row across table columns is visible in the first column only.
      if (item.id.starts_with("dialog/entry/") || item.id.starts_with("dialog/sort-")) continue;
      const float gap = item.id.starts_with("history/") ? ImGui::GetStyle().ItemSpacing.x : 1.5f;
      const bool wide = item.visible.z >= item.whole.z - gap || item.scrollsX;
      const bool high =
          item.visible.w >= item.whole.w - std::min(gap, ImGui::GetStyle().ItemSpacing.y) || item.scrollsY;
      EXPECT_TRUE(wide) << what << ": " << item.id << " in " << item.window << " shows " << item.visible.z << " of "
                        << item.whole.z;
      EXPECT_TRUE(high) << what << ": " << item.id << " in " << item.window << " shows " << item.visible.w << " of "
                        << item.whole.w << " high";
    }
  }

  static bool within(const glm::vec4& a, const glm::vec4& b) {
    return a.x >= b.x - 1.0f && a.y >= b.y - 1.0f && a.x + a.z <= b.x + b.z + 1.0f && a.y + a.w <= b.y + b.w + 1.0f;
  }

  /// Controls of a window are disjoint or nested (a switch in its row).
  void nothingOverlaps(const std::string& what, const std::string& only) {
    const std::vector<LaidOut>& all = widgets().laidOut();
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        const glm::vec4 &a = all[i].visible, &b = all[k].visible;
        if (all[i].window != all[k].window || !meant(all[i].window, only)) continue;
        const float x = std::min(a.x + a.z, b.x + b.z) - std::max(a.x, b.x);
        const float y = std::min(a.y + a.w, b.y + b.w) - std::max(a.y, b.y);
        if (x <= 1.5f || y <= 1.5f || within(a, b) || within(b, a)) continue;
        ADD_FAILURE() << what << ": " << all[i].id << " and " << all[k].id << " overlap by " << x << " x " << y;
      }
    }
  }

  void noTextThroughText(const std::string& what, const std::string& only) {
    const std::vector<Glyph> glyphs = drawnGlyphs();
    ASSERT_GT(glyphs.size(), 20u);
    int worst = 0;
    std::string where;
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
      // Adjacent letters of a word may touch.
      for (std::size_t k = i + 2; k < glyphs.size(); ++k) {
        if (!meant(glyphs[i].list, only) || !meant(glyphs[k].list, only)) continue;
        if (covered(glyphs[i], glyphs[k]) < 0.4f) continue;
        ++worst;
        where = glyphs[i].list + " and " + glyphs[k].list + " at " + std::to_string(glyphs[i].box.x) + ", " +
                std::to_string(glyphs[i].box.y);
      }
    }
    EXPECT_EQ(worst, 0) << what << ": letters over letters, in " << where;
    for (const Glyph& glyph : glyphs) {
      if (!meant(glyph.list, only) || scrolls(glyph.list)) continue;
      const float width = glyph.box.z - glyph.box.x;
      const bool cut = glyph.box.x < glyph.clip.x - 0.3f * width || glyph.box.z > glyph.clip.z + 0.3f * width;
      EXPECT_FALSE(cut) << what << ": a letter is cut in " << glyph.list << " at " << glyph.box.x << ", "
                        << glyph.box.y;
    }
  }

  static bool scrolls(const std::string& window) {
    const ImGuiWindow* const found = ImGui::FindWindowByName(window.c_str());
    return found != nullptr && found->ScrollMax.x > 0.0f;
  }
};

TEST_F(Layout, NothingIsCutOffAtAnySizeAndScale) {
  nameAtLength();
  for (const bool stages : {false, true}) {
    state.view.layout.stages = stages;
    for (const Screen& screen : screens()) {
      use(screen);
      check(nameOf(screen) + (stages ? " with all numbers" : ""));
    }
  }
}

TEST_F(Layout, NothingIsCutOffInEveryState) {
  nameAtLength();
  const auto everywhere = [&](const std::string& what) {
    for (const Screen& screen :
         {Screen{1024.0f, 640.0f, 1.5f}, Screen{1280.0f, 800.0f, 1.0f}, Screen{1024.0f, 640.0f, 2.0f}}) {
      use(screen);
      check(what + ", " + nameOf(screen));
    }
  };
  state.view.outliner.tab = LeftTab::kGroups;
  everywhere("groups");
  state.view.groupsAsGraph = true;
  everywhere("graph");
  state.view.display.shading = Shading::kClasses;
  state.view.outliner.tab = LeftTab::kMuscles;
  everywhere("zones");
  state.view.display.shading = Shading::kHeat;
  run(action("tool/territory"), state);
  everywhere("territory");
  run(action("tool/territory"), state);
  selectNothing(state);
  everywhere("nothing selected");
  run(action("view/reference"), state);
  state.open.reference.chosen().file = "/home/somebody/pictures/A long name of a picture from the front.jpeg";
  everywhere("a reference picture");
  ASSERT_TRUE(shown("reference/close"));
  state.view.layout.leftShown = false;
  everywhere("without the left panels");
  state.document.character = nullptr;
  everywhere("without a character");
}

TEST_F(Layout, DialogsFitAndScroll) {
  nameAtLength();
  const auto everywhere = [&](const std::string& what, const std::string& window) {
    for (const Screen& screen : screens()) {
      use(screen);
      check(what + ", " + nameOf(screen), window);
    }
  };
  state.dialogs.preferences = true;
  everywhere("preferences", "Preferences");
  ASSERT_TRUE(shown("preferences/scale"));
  state.dialogs.preferences = false;
  state.dialogs.keySheet = true;
  everywhere("keys", "Keys and mouse");
  ASSERT_TRUE(shown("keys/maya"));
  state.dialogs.keySheet = false;
  settle();
  showOpenDialog(state);
  state.dialogs.file.folder = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
  everywhere("open", "Open a character");
  state.dialogs.file = {};
  settle();
  run(action("file/export-pictures"), state);
  everywhere("turntable", "Turntable");
  state.dialogs.pictures.sheet = true;
  everywhere("contact sheet", "Turntable");
  ASSERT_TRUE(shown("pictures/columns"));
  state.dialogs.pictures.shown = false;
  settle();
  state.dialogs.question = {IntentKind::kQuit, {}};
  everywhere("unsaved", "Unsaved changes");
  EXPECT_TRUE(shown("unsaved/save") && shown("unsaved/cancel"));
}

TEST_F(Layout, OverflowingControlsAreInTheMoreMenu) {
  nameAtLength();
  for (const auto& [more, hidden] :
       {std::pair{"display/more", "display/numbers"}, std::pair{"toolstrip/more", "toolstrip/before"},
        std::pair{"timeline/more", "timeline/speed"}}) {
    use({std::string(more) == "timeline/more" ? 640.0f : 1024.0f, 640.0f, 2.0f});
    EXPECT_FALSE(shown(hidden)) << hidden;
    click(more);
    EXPECT_TRUE(shown(hidden)) << hidden;
    ImGui::Render();
    check(more, "Popup");
    press(kEscape);
  }
}

LayoutState randomWishes(std::mt19937& random) {
  std::uniform_real_distribution<float> size(10.0f, 900.0f);
  std::bernoulli_distribution shown(0.8);
  LayoutState wished;
  wished.left = size(random);
  wished.right = size(random);
  wished.bottom = size(random);
  wished.history = size(random);
  wished.leftShown = shown(random);
  wished.rightShown = shown(random);
  wished.bottomShown = shown(random);
  return wished;
}

TEST(LayoutSizes, PanelsFitWindowsOfUsualSizes) {
  std::mt19937 random(11);
  for (int round = 0; round < 3000; ++round) {
    const LayoutState wished = randomWishes(random);
    const float width = std::uniform_real_distribution<float>(640.0f, 2600.0f)(random);
    const float height = std::uniform_real_distribution<float>(420.0f, 1600.0f)(random);
    const LayoutSizes sizes = shownSizes(wished, width, height);
    const float bars = (wished.leftShown ? kSplitter : 0.0f) + (wished.rightShown ? kSplitter : 0.0f);
    ASSERT_GE(width - sizes.left - sizes.right - bars, kViewportNarrowest - 0.01f);
    ASSERT_GE(sizes.left, wished.leftShown ? kPanelNarrowest - 0.01f : 0.0f);
    ASSERT_GE(sizes.right, wished.rightShown ? kPanelNarrowest - 0.01f : 0.0f);
    ASSERT_EQ(sizes.left == 0.0f, !wished.leftShown);
    ASSERT_EQ(sizes.bottom == 0.0f, !wished.bottomShown);
    const float bottomBar = wished.bottomShown ? kSplitter : 0.0f;
    ASSERT_GE(height - kStatusHeight - sizes.bottom - bottomBar, kViewportLowest - 0.01f);
    ASSERT_GT(sizes.history, 0.0f);
    // Never larger than preferred, except for the minimum.
    ASSERT_LE(sizes.left, std::max(wished.left, kPanelNarrowest));
    ASSERT_LE(sizes.bottom, std::max(wished.bottom, kBottomLowest));
  }
}

TEST(LayoutSizes, LargerWindowNeverShrinksAPanel) {
  std::mt19937 random(12);
  for (int round = 0; round < 500; ++round) {
    const LayoutState wished = randomWishes(random);
    LayoutSizes before = shownSizes(wished, 300.0f, 200.0f);
    for (int step = 1; step < 40; ++step) {
      const LayoutSizes now =
          shownSizes(wished, 300.0f + 50.0f * static_cast<float>(step), 200.0f + 40.0f * static_cast<float>(step));
      ASSERT_GE(now.left, before.left - 0.01f);
      ASSERT_GE(now.right, before.right - 0.01f);
      ASSERT_GE(now.bottom, before.bottom - 0.01f);
      before = now;
    }
  }
}

class LayoutSizesEditor : public HeadlessEditor {
 protected:
  void resize(float width, float height) {
    ImGui::GetIO().DisplaySize = {width, height};
    frame();
    frame();
  }
};

TEST_F(LayoutSizesEditor, ShrinkingAndEnlargingTheWindowRestoresTheLayout) {
  resize(1600.0f, 1000.0f);
  state.view.layout.left = 420.0f;
  state.view.layout.right = 380.0f;
  state.view.layout.bottom = 200.0f;
  state.view.layout.history = 300.0f;
  frame();
  frame();
  const LayoutState wished = state.view.layout;
  const auto before = widgets().rectangles();
  for (const glm::vec2 size : {glm::vec2(900.0f, 600.0f), glm::vec2(300.0f, 200.0f), glm::vec2(640.0f, 1000.0f)}) {
    resize(size.x, size.y);
    EXPECT_EQ(state.view.layout, wished);
  }
  resize(1600.0f, 1000.0f);
  EXPECT_EQ(state.view.layout, wished);
  for (const char* bar : {"layout/left", "layout/right", "layout/bottom", "layout/history"}) {
    EXPECT_EQ(widgets().rectangles().at(bar), before.at(bar)) << bar;
  }
}

TEST_F(LayoutSizesEditor, DragStopsAtTheMinimumViewportWidth) {
  drag("layout/left", {900.0f, 0.0f});
  const float wide = state.view.layout.left;
  EXPECT_GE(state.frame.viewport.z, kViewportNarrowest - 1.0f);
  resize(2000.0f, 800.0f);
  EXPECT_EQ(state.view.layout.left, wide) << "a wish for more than there was";
  EXPECT_NEAR(state.frame.viewport.x, wide + kSplitter, 1.0f);
  drag("layout/left", {-1900.0f, 0.0f});
  EXPECT_EQ(state.view.layout.left, kPanelNarrowest);
}

}  // namespace
}  // namespace sinew::app
