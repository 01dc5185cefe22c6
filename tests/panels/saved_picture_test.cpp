// tests/panels/saved_picture_test.cpp: a saved picture of the view does not depend on what is selected or hovered.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/ui/offscreen.h"
#include "app/window/picture.h"
#include "core/files/disk/atomic_file.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

/// The bundled character and rig in a small picture; nothing is selected.
class SavedPicture : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    auto made = OffscreenContext::create();
    if (!made) GTEST_SKIP() << "left out: " << made.error().text();
    context_ = std::move(made).value();
    viewport_ = Viewport::create(1).value();
    picture_ = std::make_unique<Picture>(*viewport_, thumbnails_);
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
    state.open.transport.playing = false;
    settle();
    state.document.selection = {};
    const Bounds all = boundsOf(state.live->surface().positions);
    state.frame.route.view = framedView(all, 0.4f, 0.1f, {64, 48}, false);
  }
  void TearDown() override {
    picture_.reset();
    viewport_.reset();
    context_.reset();
    HeadlessEditor::TearDown();
  }

  std::vector<std::uint8_t> shownPixels() {
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    picture_->draw(state, nullptr, state.frame.route.view, list, 1.0, std::nullopt);
    return viewport_->readPixels().rgba;
  }
  std::string savedBytes() {
    const auto file = folder_.path() / "saved.png";
    EXPECT_TRUE(picture_->save(state, file).ok());
    return readWholeFile(file, 1 << 24).value();
  }

 private:
  const test::TemporaryFolder folder_;
  std::unique_ptr<OffscreenContext> context_;
  std::unique_ptr<Viewport> viewport_;
  Thumbnails thumbnails_{folder_.path()};
  std::unique_ptr<Picture> picture_;
};

TEST_F(SavedPicture, HasNoMarksOfSelectionAndHover) {
  state.view.display.skeleton = state.view.display.primitives = true;
  state.view.display.ground = state.view.display.surface = false;  // They take long and have no marks.
  std::vector<std::uint8_t> before = shownPixels();
  const std::string saved = savedBytes();
  const auto expectSeen = [&](const char* mark) {
    std::vector<std::uint8_t> now = shownPixels();
    EXPECT_TRUE(now != before) << mark;
    before = std::move(now);
  };
  Selection& selection = state.document.selection;
  ViewportHover& hover = state.view.tools.hover;
  const auto id = [&](std::size_t muscle) { return state.document.rig().primitives.at(muscle).id(); };
  selection.primitives = {id(0)};
  expectSeen("a selected muscle and its twin");
  selection.primitives = {id(0), id(4)};
  expectSeen("another one, now the active one");
  hover.primitive = 6;
  expectSeen("a hovered muscle");
  selection.bone = 1;
  expectSeen("a selected bone");
  hover.bone = 2;
  expectSeen("a hovered bone");
  EXPECT_TRUE(savedBytes() == saved);
}

}  // namespace
}  // namespace sinew::app
