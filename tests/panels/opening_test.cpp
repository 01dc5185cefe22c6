// tests/panels/opening_test.cpp: the question about a missing character, and the button that shows helper bones.

#include <imgui.h>
#include <imgui_internal.h>  // FindWindowByName is internal in ImGui 1.86.

#include "core/files/disk/atomic_file.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class OpeningPanels : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    Rig rig;
    rig.character = "gone.glb";
    ASSERT_TRUE(saveRig(rig, folder / "lost.rig.json").ok());
    ASSERT_TRUE(writeFileAtomically(folder / "post.glb", test::makePost().file.glb()).ok());
    before = state.document.characterFile;
  }
  void ask() {
    request(state, {IntentKind::kOpenFile, folder / "lost.rig.json"});
    settle();
    ASSERT_TRUE(shown("locate/locate"));
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
  fs::path before;
};

TEST_F(OpeningPanels, CancelAndEscapeKeepTheDocument) {
  ask();
  click("locate/cancel");
  EXPECT_FALSE(shown("locate/locate"));
  ask();
  press(kEscape);
  EXPECT_FALSE(shown("locate/locate"));
  ask();
  click("locate/locate");
  ASSERT_TRUE(shown("dialog/path"));
  press(kEscape);
  EXPECT_FALSE(shown("dialog/path"));
  EXPECT_FALSE(shown("locate/locate"));
  EXPECT_EQ(state.document.characterFile, before);
  EXPECT_TRUE(state.session.messages.empty());
}

TEST_F(OpeningPanels, InvalidCharacterIsReportedInTheDialogAndCanBeReplaced) {
  ask();
  click("locate/locate");
  type((folder / "lost.rig.json").string());
  press(kEnter);
  ASSERT_TRUE(shown("dialog/path"));
  EXPECT_FALSE(state.dialogs.file.error.empty());
  EXPECT_EQ(state.document.characterFile, before);
  type((folder / "post.glb").string());  // The typed text is selected.
  press(kEnter);
  EXPECT_FALSE(shown("dialog/path"));
  EXPECT_EQ(state.document.rigFile, folder / "lost.rig.json");
  EXPECT_EQ(state.document.characterFile, folder / "post.glb");
  EXPECT_TRUE(state.document.commands.modified());
}

TEST_F(OpeningPanels, FileWithTheMissingNameIsSuggested) {
  Rig rig;
  rig.character = "models/post.glb";
  ASSERT_TRUE(saveRig(rig, folder / "lost.rig.json").ok());
  ask();
  click("locate/locate");
  EXPECT_EQ(state.dialogs.file.text, "post.glb");
  click("dialog/ok");
  EXPECT_EQ(state.document.characterFile, folder / "post.glb");
}

TEST_F(OpeningPanels, ButtonShowsHelperBonesInTheTree) {
  // The bundled character has no helper bone: make one of the last bone.
  state.open.helperBones.assign(state.character().skeleton.bones.size(), false);
  state.open.helperBones.back() = true;
  const std::string id = "outliner/bone/" + state.character().skeleton.bones.back().name;
  state.view.outlinerFilter = state.character().skeleton.bones.back().name;
  settle();
  EXPECT_FALSE(shown(id));
  click("outliner/helper-bones");
  EXPECT_TRUE(shown(id));
  EXPECT_TRUE(action("view/helper-bones").checked(state));
  click("outliner/helper-bones");
  EXPECT_FALSE(shown(id));
}

TEST_F(OpeningPanels, RowTooltipHasTheFullNameOnce) {
  test::Post post = test::makePost();
  for (auto& node : post.file.json["nodes"]) node["name"] = "mixamorig:" + node["name"].get<std::string>();
  ASSERT_TRUE(writeFileAtomically(folder / "named.glb", post.file.glb()).ok());
  ASSERT_TRUE(openFile(state, folder / "named.glb"));
  settle();
  const std::string id = "outliner/bone/mixamorig:knee";
  queue.move(glm::vec2(widgets().rectangles().at(id)) + glm::vec2(60.0f, 6.0f));
  for (int i = 0; i < 120; ++i) frame();
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  ASSERT_TRUE(tooltip != nullptr && tooltip->Active && !tooltip->Hidden);
  EXPECT_LT(tooltip->ContentSize.y, 1.5f * ImGui::GetFontSize()) << "one line";
}

}  // namespace
}  // namespace sinew::app
