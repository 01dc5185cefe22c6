// tests/panels/palette_controls_test.cpp: the palette finds controls, things and help pages, and shows them.

#include <imgui.h>

#include <imgui_internal.h>  // ImGui's focused item.
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "app/editor/session.h"
#include "app/panels/palette_entries.h"
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
  /// Runs frames until the control is visible or the search is given up.
  void wait() {
    for (int i = 0; i < 40 && !state.dialogs.reveal.id.empty() && state.dialogs.reveal.until < 0.0; ++i) frame();
    frame();
  }
  void closeAll() {
    const Dialogs& dialogs = state.dialogs;
    if (dialogs.preferences || dialogs.pictures.shown || dialogs.exporting.shown != ExportDialog::kNone) press(kEscape);
    state.dialogs = {};
    settle();
  }
};

/// Folds and hides everything, and selects a muscle for which the control exists.
void hideAll(EditorState& state) {
  state.view.layout = {};
  state.view.layout.leftShown = state.view.layout.rightShown = state.view.layout.bottomShown = false;
  for (const Control* control : controls()) {
    if (*control->section != '\0') state.view.layout.folded.emplace_back(control->section);
  }
  for (const char* panel : {"inspector", "surface", "smoothing"}) state.view.layout.folded.emplace_back(panel);
  state.view.inspector.shapeOpen = false;
}

TEST_F(PaletteControls, EveryControlIsFoundByLabelRevealedAndFocused) {
  openFlexing();
  int seen = 0;
  for (const Control* control : controls()) {
    SCOPED_TRACE(control->id);
    hideAll(state);
    if (std::string_view(control->id).starts_with("view/")) state.view.layout = {};
    if (std::string_view(control->id).starts_with("farm/")) openFlexing();  // A farm job needs a saved rig.
    select(state.document, {"biceps L"});
    const std::string needsMuscle = whyNotThere(*control, state);
    if (needsMuscle.find("rides a line") != std::string::npos) addMuscle(state, 3);
    SmoothingSettings settings = state.document.rig().smoothing;
    settings.detail = needsMuscle.find("Uniform") != std::string::npos ? DetailKind::kUniform : DetailKind::kAdaptive;
    if (settings.detail != state.document.rig().smoothing.detail)
      state.document.commands.apply("detail", setSmoothing(state.document.rig(), settings).value());
    settle();
    const std::string why = whyNotThere(*control, state);
    ask(control->label);
    const std::string row = std::string("palette/control/") + control->id;
    ASSERT_TRUE(shown(row)) << control->label;
    if (!why.empty()) {  // This character has no helper bones, shapes or parts.
      press(kEscape);
      continue;
    }
    ++seen;
    click(row);
    wait();
    ASSERT_TRUE(shown(control->id)) << "it cannot be seen";
    if (itemOf(control->id) != 0) {
      EXPECT_EQ(ImGui::GetCurrentContext()->NavId, itemOf(control->id)) << ImGui::GetCurrentContext()->NavWindow->Name;
      EXPECT_FALSE(ImGui::GetCurrentContext()->NavDisableHighlight);
    }
    state.frame.now += 10.0;
    frame();
    EXPECT_EQ(state.dialogs.reveal.id, "") << "the mark stays";
    closeAll();
  }
  EXPECT_GT(seen, 60);
}

TEST_F(PaletteControls, ControlIsFoundByPartialWordsAndSynonyms) {
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

TEST_F(PaletteControls, ChosenClipPlays) {
  openFlexing();
  ask("dance");
  click("palette/clip/Dance");
  EXPECT_TRUE(state.open.transport.playing);
}

TEST_F(PaletteControls, ActionsComeFirstAndFilesLast) {
  openFlexing();
  select(state.document, {"biceps L"});  // Otherwise Learn is disabled and ranks lower.
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
  const std::string name = "\xe5\xa4\xa7\xe8\x83\xb8\xe7\xad\x8b";  // "Pectoral muscle" in Japanese.
  ASSERT_TRUE(rename(state, muscle().id(), name));
  settle();
  run(action("help/palette"), state);
  settle();
  queue.character(U'\u80f8');
  queue.character(U'\u7b4b');
  settle();
  ASSERT_TRUE(shown("palette/muscle/" + name));
  // The text contains the letter's bytes but not the letter.
  EXPECT_FALSE(fitOf("\xe8\x83\xb8", "\xe8\xa0\x83\xe8\xa0\xb8"));
  EXPECT_TRUE(fitOf("\xe8\x83\xb8", name));
}

/// A desktop: a folder in PATH with an xdg-open that records its argument and exits with a given status.
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

TEST_F(PalettePages, AreTheDocumentationFilesTitledByTheirHeadings) {
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

TEST_F(PalettePages, OpenWithTheDesktopFromTheMenuAndThePalette) {
  desktop(0);
  const auto editor = std::ranges::find(helpPages(), "editor", &HelpPage::name);
  ASSERT_NE(editor, helpPages().end());
  ask("the editor");
  click("palette/page/editor");
  untilDone();
  std::string path;
  std::getline(std::ifstream(noted()), path);
  EXPECT_EQ(path, editor->file.string());
  EXPECT_FALSE(toldOf("editor.md"));
  click("menu/help");
  queue.move(center("help/pages"));
  settle();
  for (int i = 0; i < 60 && !shown("help/pages/characters"); ++i) frame();
  click("help/pages/characters");
  untilDone();
  std::getline(std::ifstream(noted()), path);
  EXPECT_TRUE(path.ends_with("docs/characters.md")) << path;
}

TEST_F(PalettePages, FailureToOpenReportsThePath) {
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
