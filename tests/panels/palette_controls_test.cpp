// tests/panels/palette_controls_test.cpp: whatever has a name is found by it; what is found is brought into
// sight.

#include <imgui.h>
#include <imgui_internal.h>  // Which item has the keyboard.

#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "app/editor/session.h"
#include "app/panels/palette_entries.h"
#include "app/panels/palette_words.h"
#include "sinew/rig/rig_edit.h"
#include "tests/panels/palette_editor.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

class PaletteControls : public PaletteEditor {
 protected:
  [[nodiscard]] unsigned itemOf(const std::string& id) const {
    const auto& all = widgets().laidOut();
    const auto found = std::ranges::find(all, id, &LaidOut::id);
    return found == all.end() ? 0 : found->item;
  }
  /// Until it is seen, or it is given up.
  void wait() {
    for (int i = 0; i < 40 && !state.dialogs.reveal.id.empty() && state.dialogs.reveal.until < 0.0; ++i) frame();
    frame();
  }
  void closeAll() {
    if (state.dialogs.preferences || state.dialogs.exporting.shown != ExportDialog::kNone) press(kEscape);
    state.dialogs = {};
    settle();
  }
};

/// Ids, or how they begin, that are no entries of the palette, and why.
struct WithoutEntry {
  const char* begin;
  const char* why;
};
constexpr WithoutEntry kWithoutEntry[] = {
    {"toolstrip/", "buttons of actions"},
    {"display/", "buttons of actions"},
    {"menu/", "menus: their actions are entries"},
    {"context/", "menus of what lies under the pointer: their commands are actions, or need a place"},
    {"palette/", "the palette itself"},
    {"help/pages", "the pages are entries of their own"},
    {"file/recent", "recent files are entries of their own"},
    {"file/samples", "samples are entries of their own"},
    {"file/export-", "a submenu of actions"},
    {"edit/shape-", "a submenu of actions"},
    {"view/light-", "a submenu of actions"},
    {"view/background-", "a submenu of actions"},
    {"view/look-", "a submenu of actions"},
    {"view/flex-whose", "beside the slider that is an entry"},
    {"bone/", "a path of the tree"},
    {"part/", "a path of the tree"},
    {"group-delete/", "a menu's inner name"},
    {"layout/", "bars between panels: dragged"},
    {"history/step/", "steps of this document"},
    {"outliner/", "rows: muscles and bones are entries; buttons of rows are actions on what is selected"},
    {"inspector/group", "a list of groups, opened by an entry"},
    {"inspector/animation", "is there only where the muscle is driven or keyed"},
    {"surface/animation", "is there only where the surface is driven or keyed"},
    {"inspector/center.", "the row is an entry by its first field"},
    {"inspector/rotation.", "the row is an entry by its first field"},
    {"inspector/radius.", "the row is an entry by its first field"},
    {"inspector/line/", "the numbers of the table of lines and buttons of panels: entries by their whole ids"},
    {"inspector/names", "a text"},
    {"inspector/twin", "a text beside the buttons of actions"},
    {"inspector/mirror", "the button of edit/mirror"},
    {"inspector/unlink", "the button of edit/unlink-twin"},
    {"inspector/territory-", "beside the list that is an entry, or the button of tool/territory"},
    {"inspector/", "the beginning of ids of shape numbers, which are entries"},
    {"surface/replace-note", "a text"},
    {"timeline/play", "the button of play/toggle"},
    {"timeline/previous", "the button of play/previous"},
    {"timeline/next", "the button of play/next"},
    {"timeline/start", "the button of play/start"},
    {"timeline/end", "the button of play/end"},
    {"timeline/loop", "the button of play/loop"},
    {"timeline/pose", "buttons of actions of the Tool menu"},
    {"timeline/range", "dragged; by keys: the actions that begin and end the range"},
    {"timeline/scrub", "dragged; by keys: the actions of the Play menu"},
    {"timeline/clip/", "clips are entries of their own"},
    {"timeline/row/", "keys of this document"},
    {"timeline/time", "a text"},
    {"timeline/more", "what has no room; the entries lead to the action"},
    {"blending/", "groups are entries of their own; what else is there belongs to the group that is chosen"},
    {"library/", "sets and their muscles are entries of their own; muscles/save-set is an action"},
    {"shapes/", "shapes of this character, under the search that is an entry"},
    {"layers/", "parts are entries of their own, and so are the layers of the one that is chosen"},
    {"check/", "what a check has found, opened by an action"},
    {"body-parts/", "opened by an action"},
    {"clip-files/", "opened by an action"},
    {"muscle-set/", "follows the set that was added, which is an entry"},
    {"reference/", "opened by an action"},
    {"driven-key/", "while driven keys are set"},
    {"first-steps/", "opened by an action"},
    {"export-error/", "opened by an action"},
    {"legend/", "explains what is shown"},
    {"overlay/", "numbers, shown by an action"},
    {"messages/", "messages, shown by an action"},
    {"status/", "status line"},
    {"viewport/open", "the button of file/open"},
    {"dialog/", "the file dialog, opened by actions"},
    {"locate/", "a question's answer"},
    {"keep-muscles/", "a question's answer"},
    {"recovery/", "a question's answer"},
    {"conflict/", "a question's answer"},
    {"unsaved/", "a question's answer"},
    {"export-question/", "a question's answer"},
    {"keys/", "the sheet of keys, opened by an action"},
    {"pictures/", "rows of a dialog, opened by an action"},
    {"export/", "rows of the kind that is chosen: the kind is an entry"},
    {"farm/", "rows of the job: its folder is an entry"},
    {"preferences/", "lists and buttons beside what is an entry"},
};

/// Ids in the sources of the panels: a new control must be found, or it must be said why not.
std::set<std::string> idsInSources() {
  std::set<std::string> ids;
  const std::regex literal("\"([a-z][a-z-]*/[A-Za-z0-9/_.-]*)\"");
  const auto root = std::filesystem::path(SINEW_SOURCE_DIR) / "app" / "panels";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() != ".cpp" || file.filename().string().starts_with("palette_")) continue;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with("#include")) continue;
      for (std::sregex_iterator it(line.begin(), line.end(), literal), end; it != end; ++it) ids.insert((*it)[1]);
    }
  }
  return ids;
}

TEST_F(PaletteControls, NoControlIsForgotten) {
  const std::set<std::string> ids = idsInSources();
  EXPECT_GT(ids.size(), 200u);
  std::set<std::string> known;
  for (const Action& item : actions()) known.insert(item.id);
  for (const PaletteControl& control : paletteControls()) known.insert(control.id);
  std::set<std::string_view> used;
  for (const std::string& id : ids) {
    if (known.contains(id)) continue;
    const auto isBegin = [&](const WithoutEntry& each) { return id.starts_with(each.begin); };
    const auto* const found = std::ranges::find_if(kWithoutEntry, isBegin);
    ASSERT_NE(found, std::end(kWithoutEntry)) << id << " has no entry in the palette, and no reason why not";
    used.insert(found->begin);
  }
  for (const WithoutEntry& each : kWithoutEntry) EXPECT_TRUE(used.contains(each.begin)) << each.begin << " is no more";
}

TEST_F(PaletteControls, EachIsBroughtIntoSightAndGetsTheKeyboard) {
  openFlexing();
  const std::set<std::string> notHere{"outliner/helper-bones", "shapes/search", "shapes/reset", "layers/header",
                                      "layers/guess-all"};
  for (const PaletteControl& control : paletteControls()) {
    SCOPED_TRACE(control.id);
    state.view.layout = {};
    state.view.layout.leftShown = state.view.layout.rightShown = state.view.layout.bottomShown = false;
    state.view.layout.folded = {"inspector",
                                "surface",
                                "smoothing",
                                "inspector/section/placement",
                                "inspector/section/effect",
                                "inspector/section/line",
                                "inspector/section/territory"};
    if (control.shelf == Shelf::kPicture) state.view.layout = {};
    if (control.shelf == Shelf::kFarm) openFlexing();  // A job needs a rig that is saved.
    select(state.document, {"biceps L"});
    if (std::string_view(control.id) == "inspector/other-end") {
      addMuscle(state, 3);
      settle();
    }
    const bool uniform = std::string_view(control.id) == "smoothing/depth";
    SmoothingSettings settings = state.document.rig().smoothing;
    settings.detail = uniform ? DetailKind::kUniform : DetailKind::kAdaptive;
    if (settings.detail != state.document.rig().smoothing.detail)
      state.document.commands.apply("detail", setSmoothing(state.document.rig(), settings).value());
    if (notHere.contains(control.id)) {
      EXPECT_NE(whyNotThere(control, state), "");
      continue;
    }
    ASSERT_EQ(whyNotThere(control, state), "");
    revealControl(state, control);
    wait();
    ASSERT_TRUE(shown(control.id)) << "it cannot be seen";
    if (itemOf(control.id) != 0) {
      EXPECT_EQ(ImGui::GetCurrentContext()->NavId, itemOf(control.id)) << ImGui::GetCurrentContext()->NavWindow->Name;
      EXPECT_FALSE(ImGui::GetCurrentContext()->NavDisableHighlight);
    }
    state.frame.now += 10.0;
    frame();
    EXPECT_EQ(state.dialogs.reveal.id, "") << "the mark stays";
    closeAll();
  }
}

TEST_F(PaletteControls, AnEntryIsFoundByPartsOfWordsAndByOtherWords) {
  openFlexing();
  select(state.document, {"biceps L"});
  settle();
  for (const auto& [words, id] :
       {std::pair{"tight", "surface/iso"}, std::pair{"iso value", "surface/iso"},
        std::pair{"radii", "inspector/radius.x"}, std::pair{"autosav", "preferences/autosave"},
        std::pair{"hotkey", "preferences/keys/search"}, std::pair{"volume", "inspector/line/volume"},
        std::pair{"ubdivision", "smoothing/detail"}}) {
    ask(words);
    EXPECT_TRUE(shown(std::string("palette/control/") + id)) << words;
    press(kEscape);
  }
  ask("tightness");
  press(kEnter);
  wait();
  EXPECT_EQ(ImGui::GetCurrentContext()->NavId, itemOf("surface/iso"));
}

TEST_F(PaletteControls, GroupsSetsAndTheirMusclesAreFound) {
  openFlexing();
  ASSERT_FALSE(state.document.rig().groups.empty());
  const std::string group = state.document.rig().groups.front().name;
  ask(group);
  click("palette/group/" + group);
  EXPECT_EQ(state.view.outliner.tab, LeftTab::kGroups);
  EXPECT_FALSE(state.document.selection.primitives.empty());
  for (const int index : selectedIndices(state.document)) {
    EXPECT_EQ(state.document.rig().primitives.at(static_cast<std::size_t>(index)).group, group);
  }
  ask("gluteus library");
  EXPECT_EQ(state.open.library.reads, 0u) << "sets were laid to be found";
  std::string entry;
  for (const auto& [id, box] : widgets().rectangles()) {
    if (id.starts_with("palette/set/athlete/")) entry = id;
  }
  ASSERT_NE(entry, "");
  click(entry);
  wait();
  EXPECT_EQ(state.view.outliner.tab, LeftTab::kLibrary);
  EXPECT_TRUE(shown("library/" + entry.substr(std::string("palette/set/").size())));
  const std::size_t before = state.document.rig().primitives.size();
  ask("athlete set");
  ASSERT_TRUE(shown("palette/set/athlete"));
  click("palette/set/athlete");
  EXPECT_GT(state.document.rig().primitives.size(), before);
}

TEST_F(PaletteControls, AClipPlays) {
  openFlexing();
  ask("dance");
  click("palette/clip/Dance");
  EXPECT_TRUE(state.open.transport.playing);
}

TEST_F(PaletteControls, ActionsStandBeforeWhatIsInTheDocumentAndFilesLast) {
  openFlexing();
  select(state.document, {"biceps L"});  // Else Learn is grayed, and weighs less.
  ask("flex");
  float actionsLast = 0.0f;
  float filesFirst = 1e6f;
  for (const auto& [id, box] : widgets().rectangles()) {
    if (id.starts_with("palette/view/flex") || id == "palette/panel/learn") actionsLast = std::max(actionsLast, box.y);
    if (id.starts_with("palette/sample/")) filesFirst = std::min(filesFirst, box.y);
  }
  EXPECT_GT(actionsLast, 0.0f);
  EXPECT_LT(actionsLast, filesFirst);
  EXPECT_TRUE(shown("palette/panel/learn"));
}

TEST_F(PaletteControls, NamesInOtherScriptsAreFoundByTheirLetters) {
  addOne();
  const std::string name = "\xe5\xa4\xa7\xe8\x83\xb8\xe7\xad\x8b";  // The pectoral muscle in Japanese.
  ASSERT_TRUE(rename(state, muscle().id(), name));
  settle();
  run(action("help/palette"), state);
  settle();
  queue.character(U'\u80f8');
  queue.character(U'\u7b4b');
  settle();
  ASSERT_TRUE(shown("palette/muscle/" + name));
  // The bytes of the letter are in this text, but the letter is not.
  EXPECT_FALSE(fitOf("\xe8\x83\xb8", "\xe8\xa0\x83\xe8\xa0\xb8"));
  EXPECT_TRUE(fitOf("\xe8\x83\xb8", name));
}

/// A desktop: a folder in PATH with an xdg-open that notes what it is given, and ends as it is told.
class PalettePages : public PaletteControls {
 protected:
  void SetUp() override {
    PaletteControls::SetUp();
    before_ = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
  }
  void TearDown() override {
    setenv("PATH", before_.c_str(), 1);
    PaletteControls::TearDown();
  }
  void desktop(int result) {
    const std::filesystem::path program = folder_.path() / "xdg-open";
    std::ofstream(program) << "#!/bin/sh\necho \"$1\" > '" << noted().string() << "'\nexit " << result << "\n";
    chmod(program.c_str(), 0755);
    setenv("PATH", (folder_.path().string() + ":" + before_).c_str(), 1);
  }
  [[nodiscard]] std::filesystem::path noted() const { return folder_.path() / "noted"; }
  void untilDone() {
    for (int i = 0; i < 500 && state.session.opener.busy(); ++i) frame();
  }
  [[nodiscard]] bool toldOf(const std::string& text) const {
    return std::ranges::any_of(state.session.messages,
                               [&](const Message& each) { return each.text.find(text) != std::string::npos; });
  }

  test::TemporaryFolder folder_;

 private:
  std::string before_;
};

TEST_F(PalettePages, AreTheFilesOfTheDocumentationByTheirHeadings) {
  const auto docs = std::filesystem::path(SINEW_SOURCE_DIR) / "docs";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(docs))
    files += entry.path().extension() == ".md" ? 1 : 0;
  ASSERT_EQ(helpPages().size(), files);
  EXPECT_TRUE(std::ranges::is_sorted(helpPages(), {}, &HelpPage::title));
  for (const HelpPage& page : helpPages()) {
    std::ifstream in(page.file);
    std::string first;
    std::getline(in, first);
    EXPECT_EQ(first, "# " + page.title);
  }
}

TEST_F(PalettePages, OpenInWhatTheDesktopHasFromTheMenuAndFromThePalette) {
  desktop(0);
  const auto opening = std::ranges::find(helpPages(), "opening", &HelpPage::name);
  ASSERT_NE(opening, helpPages().end());
  ask("opening a character");
  click("palette/page/opening");
  untilDone();
  std::string path;
  std::getline(std::ifstream(noted()), path);
  EXPECT_EQ(path, opening->file.string());
  EXPECT_FALSE(toldOf("opening.md"));
  click("menu/help");
  queue.move(center("help/pages"));
  settle();
  for (int i = 0; i < 60 && !shown("help/pages/shapes"); ++i) frame();
  click("help/pages/shapes");
  untilDone();
  std::getline(std::ifstream(noted()), path);
  EXPECT_TRUE(path.ends_with("docs/characters.md")) << path;
}

TEST_F(PalettePages, WhereNothingOpensThemAMessageSaysWhereTheyLie) {
  desktop(3);
  openHelpPage(state, helpPages().front());
  untilDone();
  EXPECT_TRUE(toldOf(helpPages().front().file.string()));
  state.session.messages.clear();
  setenv("PATH", "/nowhere", 1);
  openHelpPage(state, helpPages().back());
  EXPECT_TRUE(toldOf(helpPages().back().file.string()));
}

}  // namespace
}  // namespace sinew::app
