// tests/panels/keep_muscles_test.cpp: dropping a character on one with muscles, and Muscles > Put on another character.

#include <algorithm>
#include <set>
#include <string>

#include "app/editor/actions.h"
#include "app/editor/commands.h"
#include "app/editor/open_file.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class KeepMuscles : public HeadlessEditor {
 protected:
  static fs::path asset(const char* file) { return fs::path(SINEW_SOURCE_DIR) / "assets" / file; }
  void open(const char* file) {
    ASSERT_TRUE(openFile(state, asset(file)));
    state.open.transport.playing = false;
    settle();
  }
  void drop(const fs::path& file) {
    dropFile(state, file);
    settle();
  }
  [[nodiscard]] bool asks() { return shown("keep-muscles/keep"); }
  [[nodiscard]] std::ptrdiff_t messagesWith(const std::string& words) const {
    return std::ranges::count_if(state.session.messages,
                                 [&](const Message& message) { return message.text.find(words) != std::string::npos; });
  }
};

TEST_F(KeepMuscles, DroppedCharacterReceivesTheMuscles) {
  open("humanoid-flex.rig.json");
  const Rig before = state.document.rig();
  drop(asset("humanoid.glb"));
  ASSERT_TRUE(asks());
  click("keep-muscles/keep");
  EXPECT_FALSE(asks());
  EXPECT_EQ(state.document.characterFile, asset("humanoid.glb"));
  EXPECT_TRUE(state.document.rigFile.empty());
  EXPECT_TRUE(state.document.commands.modified());
  EXPECT_EQ(steps(), 1u);
  // Same body: same muscles.
  ASSERT_EQ(state.document.rig().primitives.size(), before.primitives.size());
  for (std::size_t i = 0; i < before.primitives.size(); ++i) {
    EXPECT_EQ(state.document.rig().primitives[i].name, before.primitives[i].name);
    EXPECT_EQ(state.document.rig().primitives[i].placement.radii, before.primitives[i].placement.radii);
  }
  run(action("edit/undo"), state);
  EXPECT_TRUE(state.document.rig().primitives.empty());
}

TEST_F(KeepMuscles, MuscleAddedAfterwardsHasAnIdentityOfItsOwn) {
  open("humanoid-flex.rig.json");
  drop(asset("humanoid.glb"));
  click("keep-muscles/keep");
  addMuscle(state, 0);
  std::set<PrimitiveId> ids;
  for (const Primitive& primitive : state.document.rig().primitives) ids.insert(primitive.id());
  EXPECT_EQ(ids.size(), state.document.rig().primitives.size());
}

TEST_F(KeepMuscles, DroppedCharacterCanBeOpenedWithoutMusclesOrCanceled) {
  open("humanoid-flex.rig.json");
  drop(asset("horse.glb"));
  press(kEscape);
  EXPECT_FALSE(asks());
  drop(asset("horse.glb"));
  click("keep-muscles/cancel");
  EXPECT_FALSE(asks());
  EXPECT_EQ(state.document.rigFile, asset("humanoid-flex.rig.json"));
  drop(asset("horse.glb"));
  click("keep-muscles/without");
  EXPECT_EQ(state.document.characterFile, asset("horse.glb"));
  EXPECT_TRUE(state.document.rig().primitives.empty());
  EXPECT_FALSE(state.document.commands.modified());
}

TEST_F(KeepMuscles, OmittedMusclesAreNamed) {
  open("humanoid-flex.rig.json");
  const Rig before = state.document.rig();
  drop(asset("horse.glb"));
  click("keep-muscles/keep");
  const Rig& kept = state.document.rig();
  ASSERT_FALSE(kept.primitives.empty());
  ASSERT_LT(kept.primitives.size(), before.primitives.size());
  for (const Primitive& each : before.primitives) {
    const bool there = std::ranges::find(kept.primitives, each.name, &Primitive::name) != kept.primitives.end();
    EXPECT_EQ(messagesWith(each.name + " is left out"), there ? 0 : 1) << each.name;
  }
}

TEST_F(KeepMuscles, PromptsAboutUnsavedChangesFirst) {
  open("humanoid-flex.rig.json");
  Rig changed = state.document.rig();
  changed.primitives.pop_back();
  state.document.commands.apply("change", changed);
  drop(asset("humanoid.glb"));
  click("keep-muscles/keep");
  ASSERT_TRUE(shown("unsaved/discard"));
  EXPECT_EQ(state.document.rigFile, asset("humanoid-flex.rig.json"));
  // Unsaved muscles are still the ones put on the other body.
  click("unsaved/discard");
  EXPECT_TRUE(state.document.rigFile.empty());
  EXPECT_EQ(state.document.rig().primitives.size(), changed.primitives.size());
}

TEST_F(KeepMuscles, DoesNotPromptWithoutMusclesToKeep) {
  open("humanoid.glb");
  drop(asset("horse.glb"));
  EXPECT_FALSE(asks());
  EXPECT_EQ(state.document.characterFile, asset("horse.glb"));
  open("humanoid-flex.rig.json");
  drop(asset("horse-flex.rig.json"));
  EXPECT_FALSE(asks());
  EXPECT_EQ(state.document.rigFile, asset("horse-flex.rig.json"));
}

TEST_F(KeepMuscles, DocumentStaysOpenIfNoMuscleFits) {
  const test::TemporaryFolder folder;
  const fs::path post = folder.write("post.glb", test::makePost().file.glb());
  open("humanoid-flex.rig.json");
  const Rig before = state.document.rig();
  drop(post);
  click("keep-muscles/keep");
  EXPECT_EQ(state.document.rig(), before);
  EXPECT_EQ(state.document.rigFile, asset("humanoid-flex.rig.json"));
  EXPECT_EQ(messagesWith("post.glb"), 1);
}

TEST_F(KeepMuscles, MenuOpensTheDialogForTheCharacter) {
  open("humanoid-flex.rig.json");
  run(action("muscles/retarget"), state);
  settle();
  ASSERT_TRUE(shown("dialog/path"));
  state.dialogs.file.folder = asset("");
  type("horse.glb");
  press(kEnter);
  EXPECT_EQ(state.document.characterFile.filename(), "horse.glb");
  EXPECT_FALSE(state.document.rig().primitives.empty());
  EXPECT_TRUE(state.document.commands.modified());
  // Opening a file after that is unaffected.
  run(action("edit/undo"), state);
  run(action("file/open"), state);
  settle();
  EXPECT_EQ(state.dialogs.file.then.kind, IntentKind::kNone);
}

TEST_F(KeepMuscles, MenuEntryIsDisabledWithoutMuscles) {
  open("humanoid.glb");
  EXPECT_FALSE(action("muscles/retarget").enabled(state));
}

}  // namespace
}  // namespace sinew::app
