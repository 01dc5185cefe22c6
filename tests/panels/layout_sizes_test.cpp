// tests/panels/layout_sizes_test.cpp: stored panel sizes are preferences; actual sizes depend on them and on the
// window.

#include "app/panels/layout_sizes.h"

#include <random>

#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

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
