// tests/panels/clip_files_test.cpp: clips of other files in the editor: dropped, listed, selected in dialogs, located.
#include "app/editor/edit.h"
#include "sinew/files/rig_json.h"
#include "tests/panels/clip_files_editor.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

TEST_F(ClipFilesInEditor, DroppedFilesAreAddedQueriedOrOpened) {
  relative("other.glb", true);
  open("still.glb");
  drop("walk.glb");
  EXPECT_EQ(files(), Names{"walk.glb"}) << "no mesh";
  drop("whole.glb");
  EXPECT_EQ(files(), (Names{"walk.glb", "whole.glb"})) << "the same bones";
  EXPECT_EQ(state.document.characterFile.filename(), "still.glb");
  addOne();
  drop("other.glb");
  ASSERT_TRUE(shown("keep-muscles/keep"));
  ASSERT_TRUE(shown("keep-muscles/clips"));
  click("keep-muscles/clips");
  EXPECT_FALSE(shown("keep-muscles/keep"));
  EXPECT_EQ(files(), (Names{"walk.glb", "whole.glb", "other.glb"}));
  EXPECT_EQ(state.document.rig().primitives.size(), 1u);
  // Without clips there is nothing to add, nor from the character's own file.
  state.document.commands.markSaved();
  fs::copy_file(folder_ / "still.glb", folder_ / "again.glb");
  for (const char* name : {"again.glb", "still.glb"}) {
    drop(name);
    EXPECT_TRUE(shown("keep-muscles/keep")) << name;
    EXPECT_FALSE(shown("keep-muscles/clips")) << name;
    press(kEscape);
  }
  open("still.glb");
  drop("other.glb");
  EXPECT_EQ(state.document.characterFile.filename(), "other.glb") << "nothing to keep: it is opened";
}

TEST_F(ClipFilesInEditor, UnmatchedBonesAreListed) {
  relative("relative.glb", false);
  open("still.glb");
  act("play/clip-files");
  EXPECT_TRUE(shown("clip-files/heading"));
  EXPECT_FALSE(shown("clip-files/file/0"));
  act("play/clip-files");
  EXPECT_FALSE(shown("clip-files/heading"));
  add("relative.glb");
  ASSERT_TRUE(shown("clip-files/file/0")) << "it opens by itself";
  const ClipFileReport& report = state.document.clipFiles.files.at(0);
  EXPECT_EQ(report.unmatched, Names{"crank"});
  ASSERT_FALSE(report.notes.empty());
  press(kEscape);
  EXPECT_FALSE(shown("clip-files/heading"));
  act("play/clip-files");
  act("muscles/body-parts");
  EXPECT_FALSE(shown("clip-files/heading")) << "one at a time";
  act("play/clip-files");
  EXPECT_FALSE(shown("body-parts/heading"));
  click("clip-files/remove/0");
  EXPECT_TRUE(files().empty());
  EXPECT_EQ(state.document.commands.label(steps()), "Remove clips of relative.glb");
  EXPECT_FALSE(shown("clip-files/file/0"));
  click("clip-files/add");
  EXPECT_TRUE(shown("dialog/path"));
  press(kEscape);
  click("clip-files/close");
  EXPECT_FALSE(state.open.clipList.shown);
}

TEST_F(ClipFilesInEditor, DialogStaysOpenIfAFileCannotBeAdded) {
  write("bad.glb", "no file of this kind");
  open("still.glb");
  state.session.messages.clear();
  act("file/add-clips");
  ASSERT_TRUE(shown("dialog/path"));
  const Rig before = state.document.rig();
  type("bad.glb");
  press(kEnter);
  EXPECT_TRUE(shown("dialog/path"));
  EXPECT_NE(state.dialogs.file.error.find("bad.glb"), std::string::npos) << state.dialogs.file.error;
  EXPECT_EQ(messagesWith("bad.glb"), 1);
  EXPECT_EQ(state.document.rig(), before);
  EXPECT_EQ(steps(), 0u);
  press(kKeyA, true);
  type("walk.glb");
  press(kEnter);
  EXPECT_FALSE(shown("dialog/path"));
  EXPECT_EQ(files(), Names{"walk.glb"});
  // Adding it again rereads it, which is no step.
  motion("walk.glb", {"Walk", "Run", "Jump"});
  add("walk.glb");
  EXPECT_EQ(clips(), (Names{"Walk", "Run", "Jump"}));
  EXPECT_EQ(steps(), 1u);
  // Reopened below.
  act("file/open");
  EXPECT_EQ(state.dialogs.file.then.kind, IntentKind::kNone);
}

TEST_F(ClipFilesInEditor, ClipsOfADifferentBodyAreNotAdded) {
  test::Post post = test::makePost();
  post.file.json["nodes"][1]["name"] = "wheel";
  post.file.json["nodes"][2]["name"] = "crank";
  write("wheel.glb", post.file.glb());
  open("still.glb");
  state.session.messages.clear();
  EXPECT_NE(addClips(state, folder_ / "wheel.glb"), "");
  EXPECT_TRUE(files().empty());
  EXPECT_EQ(steps(), 0u);
  EXPECT_EQ(messagesWith("wheel.glb"), 1);
}

TEST_F(ClipFilesInEditor, MissingFileCanBeLocated) {
  fs::create_directories(folder_ / "moved");
  Rig rig;
  rig.character = "still.glb";
  rig.clipFiles = {"walk.glb", "more.glb"};
  ASSERT_TRUE(saveRig(rig, folder_ / "hero.rig.json").ok());
  fs::rename(folder_ / "walk.glb", folder_ / "moved" / "walk.glb");
  open("hero.rig.json");
  ASSERT_TRUE(shown("clip-files/locate/0")) << "the list comes up";
  EXPECT_FALSE(shown("clip-files/locate/1"));
  EXPECT_EQ(messagesWith("walk.glb"), 1);
  EXPECT_EQ(clips(), Names{"Walk"});
  click("clip-files/locate/0");
  ASSERT_TRUE(shown("dialog/path"));
  type("more.glb");  // Already added.
  press(kEnter);
  EXPECT_FALSE(state.dialogs.file.error.empty());
  press(kKeyA, true);
  type("moved/walk.glb");
  press(kEnter);
  EXPECT_FALSE(shown("dialog/path"));
  EXPECT_EQ(files(), (Names{"moved/walk.glb", "more.glb"}));
  EXPECT_EQ(clips(), (Names{"Walk", "Run", "Walk 2"}));
  EXPECT_EQ(state.document.commands.label(steps()), "Locate walk.glb");
  EXPECT_FALSE(shown("clip-files/locate/0"));
  act("edit/undo");
  EXPECT_EQ(files(), rig.clipFiles);
  EXPECT_EQ(clips(), Names{"Walk"});
}

TEST_F(ClipFilesInEditor, ClipFilesAreSavedAndReopened) {
  fs::create_directories(folder_ / "rigs");
  open("still.glb");
  add("walk.glb");
  ASSERT_EQ(saveTo(state, folder_ / "rigs" / "hero.rig.json"), "");
  EXPECT_EQ(loadRig(folder_ / "rigs" / "hero.rig.json")->clipFiles, Names{"../walk.glb"});
  add("more.glb");
  EXPECT_EQ(files(), (Names{"walk.glb", "more.glb"}));
  ASSERT_TRUE(save(state, {}));
  choose(2);
  state.open.transport.time = 0.25;
  act("file/reopen");
  EXPECT_EQ(clips(), (Names{"Walk", "Run", "Walk 2"}));
  EXPECT_EQ(files(), (Names{"../walk.glb", "../more.glb"}));
  EXPECT_FALSE(state.document.commands.modified());
  EXPECT_FALSE(state.open.clipList.shown);
}

TEST_F(ClipFilesInEditor, PickerShowsWhichFileClipsComeFrom) {
  open("whole.glb");
  add("walk.glb");
  click("timeline/clip");
  ASSERT_TRUE(shown("timeline/clip/2"));
  const float row = center("timeline/clip/2").y - center("timeline/clip/1").y;
  EXPECT_GT(center("timeline/clip/1").y - center("timeline/clip/0").y, 1.5f * row) << "a heading stands between";
  click("timeline/clip/add");
  EXPECT_TRUE(shown("dialog/path"));
}

TEST_F(ClipFilesInEditor, CorrectedBodyPartsRetargetClipsAgain) {
  relative("relative.glb", false);
  open("still.glb");
  add("relative.glb");
  const std::shared_ptr<const Character> before = state.document.character;
  Rig rig = state.document.rig();
  rig.slots = {{"lowerLeg.L", "knee"}};
  edit(state, "Part", rig);
  settle();
  EXPECT_NE(state.document.character, before);
  EXPECT_EQ(clips(), Names{"bend"});
  const std::shared_ptr<const Character> after = state.document.character;
  settle();
  EXPECT_EQ(state.document.character, after) << "once";
}

}  // namespace
}  // namespace sinew::app
