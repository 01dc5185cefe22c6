// tests/panels/reference_test.cpp: View > Reference picture through its panel: sides, file, numbers, and what is
// stored.

#include "app/editor/reference_commands.h"

#include <filesystem>
#include <memory>
#include <string>

#include "app/editor/actions.h"
#include "app/editor/view_memory.h"
#include "app/viewport/render/picture_files.h"
#include "core/files/disk/atomic_file.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class ReferencePanel : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    const Image image{2, 3, std::vector<std::uint8_t>(24, 200)};
    for (const char* name : {"front.png", "side.PNG"}) {
      ASSERT_TRUE(writeFileAtomically(folder / name, pngBytes(image).value()));
    }
    ASSERT_TRUE(writeFileAtomically(folder / "damaged.png", "no picture"));
    run(action("view/reference"), state);
    settle();
    ASSERT_TRUE(shown("reference/file"));
  }
  void choose(const std::string& name) {
    click("reference/file");
    ASSERT_TRUE(shown("dialog/path"));
    press(kKeyA, true);
    type((folder / name).string());
    press(kEnter);
  }
  void look(const char* side) {
    click(std::string("reference/side/") + side);
    for (int i = 0; i < 40; ++i) frame();
  }
  [[nodiscard]] const ReferencePicture& picture(ReferenceSide side) const {
    return state.open.reference.pictures[static_cast<std::size_t>(side)];
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(ReferencePanel, EachSideHasItsOwnViewAndPicture) {
  look("front");
  EXPECT_NEAR(state.view.tools.camera.stand.yaw, 0.0f, 1e-5f);
  EXPECT_FALSE(shown("reference/opacity")) << "without a picture";
  choose("front.png");
  EXPECT_FALSE(shown("dialog/path"));
  ASSERT_TRUE(picture(ReferenceSide::kFront).pixels);
  EXPECT_EQ(picture(ReferenceSide::kFront).pixels->height, 3);
  look("left");
  EXPECT_NEAR(state.view.tools.camera.stand.yaw, 1.5707963f, 1e-5f);
  choose("side.PNG");
  EXPECT_EQ(picture(ReferenceSide::kLeft).file, folder / "side.PNG");
  EXPECT_EQ(picture(ReferenceSide::kFront).file, folder / "front.png");
  EXPECT_EQ(steps(), 0u) << "it is no step of the history";
}

TEST_F(ReferencePanel, NumbersAreTypedAndDragged) {
  look("front");
  choose("front.png");
  typeInto("reference/opacity", "30");
  typeInto("reference/scale", "150");
  typeInto("reference/right", "-12.5");
  typeInto("reference/up", "4");
  click("reference/depth/through");
  click("reference/shown");
  const ReferencePicture& front = picture(ReferenceSide::kFront);
  EXPECT_NEAR(front.opacity, 0.3f, 1e-6f);
  EXPECT_NEAR(front.scale, 1.5f, 1e-6f);
  EXPECT_NEAR(front.offset.x, -0.125f, 1e-6f);
  EXPECT_NEAR(front.offset.y, 0.04f, 1e-6f);
  EXPECT_TRUE(front.inside);
  EXPECT_FALSE(front.shown);
  drag("reference/right", {40.0f, 0.0f});
  EXPECT_GT(front.offset.x, -0.125f);
  choose("side.PNG");
  EXPECT_TRUE(front.shown) << "another picture is seen";
  EXPECT_NEAR(front.scale, 1.5f, 1e-6f) << "and stands as the one before";
  click("reference/remove");
  EXPECT_TRUE(front.file.empty());
  EXPECT_EQ(front.scale, 1.0f);
  EXPECT_TRUE(fs::exists(folder / "side.PNG"));
}

TEST_F(ReferencePanel, InvalidPictureIsReportedInTheDialog) {
  choose("damaged.png");
  ASSERT_TRUE(shown("dialog/path"));
  EXPECT_NE(state.dialogs.file.error.find("damaged"), std::string::npos) << state.dialogs.file.error;
  press(kEscape);
  EXPECT_FALSE(shown("reference/opacity"));
  dropReference(state, folder / "damaged.png");
  ASSERT_EQ(state.session.messages.size(), 1u);
  EXPECT_NE(state.session.messages[0].text.find("damaged.png"), std::string::npos);
}

TEST_F(ReferencePanel, DialogListsOnlyPictures) {
  ASSERT_TRUE(writeFileAtomically(folder / "notes.txt", "text"));
  state.open.reference.chosen().file = folder / "front.png";
  settle();
  click("reference/file");
  EXPECT_TRUE(shown("dialog/entry/side.PNG"));
  EXPECT_FALSE(shown("dialog/entry/notes.txt"));
}

TEST_F(ReferencePanel, EscapeAndCloseButtonKeepThePictures) {
  choose("front.png");
  press(kEscape);
  EXPECT_FALSE(shown("reference/file"));
  run(action("view/reference"), state);
  settle();
  click("reference/close");
  EXPECT_FALSE(shown("reference/file"));
  EXPECT_EQ(referencePlanes(state.open.reference.pictures, state.character()).size(), 1u);
}

TEST_F(ReferencePanel, OpensForTheVisibleSide) {
  const auto opensFor = [&](float yaw, float pitch) {
    if (state.open.reference.shown) toggleReferencePanel(state);
    state.view.tools.camera.transition.reset();
    state.view.tools.camera.stand.yaw = yaw;
    state.view.tools.camera.stand.pitch = pitch;
    toggleReferencePanel(state);
    return state.open.reference.side;
  };
  EXPECT_EQ(opensFor(0.5f, 0.2f), ReferenceSide::kFront);
  EXPECT_EQ(opensFor(2.8f, 0.2f), ReferenceSide::kBack);
  EXPECT_EQ(opensFor(1.3f, -0.2f), ReferenceSide::kLeft);
  EXPECT_EQ(opensFor(-1.3f, 0.0f), ReferenceSide::kRight);
  EXPECT_EQ(opensFor(0.5f, 1.4f), ReferenceSide::kTop);
}

TEST_F(ReferencePanel, IsRestoredWithTheView) {
  look("front");
  choose("front.png");
  typeInto("reference/opacity", "30");
  const Json view = viewToJson(state, false);
  state.open.reference = {};
  restoreView(state, view);
  ASSERT_TRUE(picture(ReferenceSide::kFront).pixels);
  EXPECT_NEAR(picture(ReferenceSide::kFront).opacity, 0.3f, 1e-6f);
  EXPECT_TRUE(state.session.messages.empty());
  fs::remove(folder / "front.png");
  restoreView(state, view);
  ASSERT_EQ(state.session.messages.size(), 1u);
  EXPECT_NE(state.session.messages[0].text.find("front.png"), std::string::npos);
  EXPECT_FALSE(picture(ReferenceSide::kFront).pixels);
  EXPECT_EQ(picture(ReferenceSide::kFront).file, folder / "front.png");
}

}  // namespace
}  // namespace sinew::app
