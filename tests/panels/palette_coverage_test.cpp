// tests/panels/palette_coverage_test.cpp: the palette leads to every control whose label a panel or dialog draws.

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <map>
#include <set>
#include <span>
#include <thread>

#include "app/editor/animate.h"
#include "app/editor/edit.h"
#include "app/editor/export_commands.h"
#include "app/editor/line_commands.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/picture_commands.h"
#include "app/editor/reference_commands.h"
#include "app/editor/session.h"
#include "app/panels/palette_entries.h"
#include "app/panels/panels.h"
#include "app/viewport/render/picture_files.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/nearest_name.h"
#include "tests/panels/palette_editor.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/editor/drawn_text.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

/// Controls that the palette does not list, and why.
struct Exception {
  std::string_view begin;  ///< Of their ids.
  const char* why;
};
constexpr Exception kExceptions[] = {
    {"menu/", "title of a menu: the palette lists the menu's actions"},
    {"context/", "context menu of something under the pointer"},
    {"history/step/", "an undo step"},
    {"outliner/lock/", "switch over a name in the list"},
    {"outliner/solo/", "switch over a name in the list"},
    {"library/add/", "the palette's entry of the set does the same"},
    {"library/save-set", "the action Save as set"},
    {"blending/canvas", "the palette's entries of the groups select its nodes"},
    {"inspector/unlink", "the action Unlink twin"},
    {"inspector/territory-remove/", "removes the bone of its row"},
    {"inspector/line/via", "Add missing: the command Add via point"},
    {"inspector/animation/", "a driver or the keys of a number, listed under the row Animation"},
    {"layers/set/", "the commands Make the part skin, cloth, rigid"},
    {"shapes/group/", "shapes are found by the search of their tab"},
    {"timeline/row/", "keys of a selected number"},
    {"before/", "the action Without muscles ends it"},
    {"territory/", "the action Edit territory ends it"},
    {"driven-key/", "the actions Key number and Esc"},
    {"status/", "reports what has happened"},
    {"messages/", "reports what has happened"},
    {"check/", "panel of the action Check muscles"},
    {"muscle-set/", "panel of the action Add muscle set"},
    {"fit-sculpt/", "panel of the action Fit to a sculpt"},
    {"body-parts/", "panel of the action Parts of the body"},
    {"clip-files/", "panel of the action Clip files"},
    {"reference/", "panel of the action Reference picture"},
    {"first-steps/", "panel of the action First steps"},
    {"export-error/", "panel of the action Export error"},
    {"export/place-browse", "belongs to the name beside it"},
    {"farm/job-browse", "belongs to the name beside it"},
    {"pictures/place-browse", "belongs to the name beside it"},
    {"pictures/rows", "belongs to the columns beside it"},
    {"pictures/height", "belongs to the width beside it"},
    {"export/cancel", "Esc does the same"},
    {"pictures/cancel", "Esc does the same"},
    {"preferences/close", "Esc does the same"},
    {"preferences/keymap/blender", "the other choice beside Maya"},
    {"preferences/page/", "the palette lists the controls of both pages"},
    {"dialog/", "dialog of the actions that open and save files"},
    {"keys/", "sheet of the action Keys and mouse"},
    {"palette/", "the palette itself"},
    {"unsaved/", "question that comes by itself"},
    {"recovery/", "question that comes by itself"},
    {"conflict/", "question that comes by itself"},
    {"locate/", "question that comes by itself"},
    {"keep-muscles/", "question that comes by itself"},
    {"export-question/", "question that comes by itself"},
};

/// A control as it was drawn, with the words that name it.
struct Drawn {
  std::string id;
  std::string row;                 ///< The text at the left of its line, which names the first switch or control.
  std::string text;                ///< The text inside it.
  std::vector<std::string> parts;  ///< Ids of its switch: of the controls that touch it or each other.

  auto operator<=>(const Drawn&) const = default;
};

bool hasLetter(const std::string& text) {
  return std::ranges::any_of(text, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

/// "inspector/center" of "inspector/center.x"
std::string_view stem(std::string_view id) { return id.substr(0, id.find_last_of("./")); }

/// "Save as" for "Save as..."
std::string plain(std::string_view label) { return lowerCase(std::string(label.substr(0, label.find("...")))); }

/// Its own control, that of another part of its switch, or that of x where it is y or z.
bool leadsTo(const Control& control, const Drawn& drawn) {
  std::string x = drawn.id;
  if (x.ends_with(".y") || x.ends_with(".z")) x.back() = 'x';
  return x == control.id || std::ranges::find(drawn.parts, control.id) != drawn.parts.end();
}

/// An action or a panel's button that says the same.
bool isCommand(const Drawn& drawn) {
  const std::string text = plain(drawn.text);
  const auto runs = [&](const Action& item) {
    return item.id == drawn.id || (!text.empty() && text == plain(item.label));
  };
  const auto presses = [&](const PanelCommand& command) {  // "Inspector: Set > Rest"
    const std::string_view context = command.context;
    return context.find("> ") < context.size() &&
           text == lowerCase(std::string(context.substr(context.find("> ") + 2)));
  };
  return std::ranges::any_of(actions(), runs) || std::ranges::any_of(panelCommands(), presses);
}

/// "muscle/biceps L" for "outliner/muscle/biceps L": the palette lists what is in the document.
std::string thingOf(const std::string& id) {
  for (const auto& [begin, kind] :
       {std::pair{"outliner/muscle/", "muscle/"}, std::pair{"outliner/bone/", "bone/"},
        std::pair{"blending/group/", "group/"}, std::pair{"layers/part/", "part/"}, std::pair{"library/", "set/"},
        std::pair{"shapes/name/", "shape/"}, std::pair{"shapes/", "shape/"}}) {
    if (id.starts_with(begin)) return kind + id.substr(std::string_view(begin).size());
  }
  const bool isKey = id.starts_with("preferences/keys/");
  return isKey ? id.substr(17, id.rfind('/') - 17) : "";  // A key of an action.
}

const Exception* exceptionFor(const Drawn& drawn) {
  const auto* const found = std::ranges::find_if(
      kExceptions, [&](const Exception& each) { return std::string_view(drawn.id).starts_with(each.begin); });
  return found == std::end(kExceptions) ? nullptr : found;
}

class PaletteCoverage : public PaletteEditor {
 protected:
  void SetUp() override {
    PaletteEditor::SetUp();
    ImGui::GetIO().DisplaySize = {1700.0f, 2600.0f};
    state.view.layout.right = 460.0f;
    state.view.layout.bottom = 400.0f;
  }
  void open(const fs::path& file) {
    ASSERT_TRUE(openFile(state, file)) << file;
    state.open.transport.playing = false;
    settle();
  }
  /// Adds the labelled controls of this frame.
  void look() {
    settle();
    ImGui::Render();
    for (const auto& [id, box] : widgets().rectangles()) seen_.insert(id);
    std::map<std::string, std::vector<Glyph>> glyphs;  // By window.
    for (const Glyph& glyph : drawnGlyphs()) glyphs[glyph.list].push_back(glyph);
    std::vector<LaidOut> all = widgets().laidOut();
    std::erase_if(all, [](const LaidOut& each) { return each.visible.z <= 0.0f; });
    state.dialogs.palette.sets = setEntries(state);
    for (const PaletteEntry& entry : gatherEntries(state).entries) things_.insert(entry.id);
    for (const MorphWeight& morph : state.document.rig().morphs) things_.insert("shape/" + morph.name);
    for (const LaidOut& item : all) {
      const bool declared = std::ranges::any_of(controls(), [&](const Control* each) { return each->id == item.id; });
      if (item.item != 0 || declared) add(item, all, glyphs[item.window]);
    }
  }
  void action(const char* id) {
    run(app::action(id), state);
    look();
  }
  void closeAll() {
    for (int i = 0; i < 3; ++i) press(kEscape);
    state.dialogs = {};
    settle();
  }
  [[nodiscard]] std::vector<Drawn> uncovered(std::span<const Control* const> controls) const {
    std::vector<Drawn> found;
    for (const Drawn& each : drawn_) {
      const bool leads = std::ranges::any_of(controls, [&](const Control* control) { return leadsTo(*control, each); });
      const bool listed = things_.contains(thingOf(each.id));
      if (!leads && !listed && !isCommand(each) && exceptionFor(each) == nullptr) found.push_back(each);
    }
    return found;
  }

  void lookAtDocument();
  void lookAtAnimation();
  void lookAtLists();
  void lookAtExports();
  void lookAtDialogs();
  void lookAtOtherCharacters();

  std::set<Drawn> drawn_;
  std::set<std::string> seen_;    ///< Ids, drawn by hand or not.
  std::set<std::string> things_;  ///< Ids of the palette's entries.
  test::TemporaryFolder folder_;

 private:
  static ImVec4 boxOf(const LaidOut& item) {
    const glm::vec4& v = item.visible;
    return {v.x, v.y, v.x + v.z, v.y + v.w};
  }
  void add(const LaidOut& item, const std::vector<LaidOut>& all, const std::vector<Glyph>& glyphs) {
    const ImVec4 box = boxOf(item);
    Drawn drawn{item.id, "", textIn(glyphs, item.window, box), {}};
    std::vector<const LaidOut*> line;
    const float middle = 0.5f * (box.y + box.w);
    for (const LaidOut& each : all) {
      const ImVec4 other = boxOf(each);
      if (each.window == item.window && std::abs(0.5f * (other.y + other.w) - middle) < 3.0f) line.push_back(&each);
    }
    std::ranges::sort(line, {}, [](const LaidOut* each) { return each->visible.x; });
    const auto own = std::ranges::find(line, item.id, [](const LaidOut* each) { return each->id; });
    const auto touch = [](const LaidOut* left, const LaidOut* right) {
      return stem(left->id) == stem(right->id) && std::abs(left->visible.x + left->visible.z - right->visible.x) < 0.6f;
    };
    auto first = own;
    while (first != line.begin() && touch(*(first - 1), *first)) --first;
    auto last = own;
    while (last + 1 != line.end() && touch(*last, *(last + 1))) ++last;
    for (auto each = first; each <= last; ++each) drawn.parts.push_back((*each)->id);
    if (first == line.begin()) drawn.row = textIn(glyphsBeside(glyphs, line), item.window, {0.0f, box.y, box.x, box.w});
    if (hasLetter(drawn.row) || hasLetter(drawn.text)) drawn_.insert(std::move(drawn));
  }
  /// Those that are in no control of the line.
  static std::vector<Glyph> glyphsBeside(std::vector<Glyph> glyphs, const std::vector<const LaidOut*>& line) {
    std::erase_if(glyphs, [&](const Glyph& glyph) {
      const float x = 0.5f * (glyph.box.x + glyph.box.z);
      return std::ranges::any_of(
          line, [&](const LaidOut* each) { return x > each->visible.x && x < each->visible.x + each->visible.z; });
    });
    return glyphs;
  }
};

void PaletteCoverage::lookAtDocument() {
  look();
  openFlexing();
  for (const LeftTab tab : {LeftTab::kMuscles, LeftTab::kGroups, LeftTab::kLibrary, LeftTab::kShapes}) {
    state.view.outliner.tab = tab;
    look();
  }
  state.view.groupsAsGraph = true;
  state.view.outliner.tab = LeftTab::kGroups;
  state.open.blending.group = state.document.rig().groups.front().id();
  look();
  state.view.outliner.tab = LeftTab::kMuscles;
  state.view.inspector.shapeOpen = state.view.inspector.territoryOpen = true;
  select(state.document, {"biceps L"});
  look();
  addMuscle(state, 3);
  look();
  select(state.document, {"biceps L", state.document.activeName()});
  look();
  addViaPoints(state);
  look();
  for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
    SmoothingSettings settings = state.document.rig().smoothing;
    settings.detail = detail;
    state.document.commands.apply("detail", setSmoothing(state.document.rig(), settings).value());
    look();
  }
  state.view.layout.overlay = state.view.layout.stages = true;
  for (const char* id : {"view/heat", "view/classes", "view/anatomy", "view/isolate", "view/show-all", "view/hide",
                         "view/show-all", "tool/territory", "tool/territory", "view/before", "view/before"})
    action(id);
  state.open.viewportMenu.wanted = true;
  look();
  press(kEscape);
}

void PaletteCoverage::lookAtAnimation() {
  openFlexing();
  chooseClip(state.open.transport, 0, state.character());
  state.open.transport.playing = false;
  state.view.inspector.animationOpen = true;
  select(state.document, {"biceps L"});
  const int muscle = findPrimitive(state.document.rig(), "biceps L");
  const std::array reach{NumberRef{Parameter::kReach, muscle}};
  const std::array amount{NumberRef{Parameter::kAmount, muscle}};
  keyNumbers(state, reach, KeyValue::kDrawn);
  driveByNewChannel(state, reach);
  DriverInput bend;
  bend.kind = DriverInputKind::kBend;
  bend.bone = state.document.rig().lines.front().insertion.bone;
  driveNumbers(state, amount, bend);
  look();
  startDrivenKey(state, amount, bend);
  look();
  endDrivenKey(state);
}

void PaletteCoverage::lookAtLists() {
  openFlexing();
  for (const char* id :
       {"play/check", "muscles/add-set", "muscles/body-parts", "play/clip-files", "help/first-steps"}) {
    action(id);
    state.open.check.shown = state.open.muscleSet.shown = state.open.bodyParts.shown = state.open.clipList.shown =
        false;
    state.view.firstSteps.shown = false;
  }
  state.open.sculptFit.shown = true;
  look();
  state.open.sculptFit.shown = false;
  const Image image{2, 3, std::vector<std::uint8_t>(24, 200)};
  ASSERT_TRUE(writeFileAtomically(folder_.path() / "front.png", pngBytes(image).value()));
  action("view/reference");
  ASSERT_EQ(takeReference(state, folder_.path() / "front.png"), "");
  look();
  state.open.reference.shown = false;
  addMessage(state.session, MessageKind::kWarning, "Something is wrong");
  say(state, "Something was done");
  look();
  state.session.messages.clear();
}

void PaletteCoverage::lookAtExports() {
  for (const char* name : {"humanoid.glb", "humanoid-flex.rig.json"})
    fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / name, folder_.path() / name);
  fs::copy_file(folder_.path() / "humanoid-flex.rig.json", folder_.path() / "other.rig.json");
  open(folder_.path() / "humanoid-flex.rig.json");
  for (const char* id : {"file/export-character", "file/export-farm"}) {
    for (std::size_t kind = 0; kind < exportKinds().size(); ++kind) {
      run(app::action(id), state);
      chooseKind(state.dialogs, kind);
      ExportDialogState& dialog = state.dialogs.exporting;
      dialog.advanced = dialog.chosenClips = dialog.wholeFolder = true;
      for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
        dialog.settings.detail.kind = detail;
        look();
      }
      closeAll();
    }
  }
  for (const bool sheet : {false, true}) {
    run(app::action("file/export-pictures"), state);
    state.dialogs.pictures.sheet = sheet;
    look();
    closeAll();
  }
  open(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json");
  run(app::action("file/export-character"), state);
  chooseKind(state.dialogs, 1);
  state.dialogs.exporting.place.folder = folder_.path();
  state.dialogs.exporting.settings.weights = ExportWeights::kTransferred;
  state.dialogs.exporting.settings.detail.depth = 2;
  ASSERT_TRUE(confirmExport(state)) << state.dialogs.exporting.error;
  state.dialogs.exportQuestion = true;
  look();
  closeAll();
  while (!state.session.exports.empty()) {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  action("view/export-error");
}

void PaletteCoverage::lookAtDialogs() {
  openFlexing();
  for (const char* id : {"file/open", "file/save-as", "help/keys", "help/palette"}) {
    action(id);
    closeAll();
  }
  for (const PreferencesPage page : {PreferencesPage::kGeneral, PreferencesPage::kKeys}) {
    state.dialogs.preferences = true;
    state.dialogs.preferencesPage = page;
    look();
    closeAll();
  }
  state.dialogs.question = {IntentKind::kOpenFile, "other.glb"};
  look();
  closeAll();
  state.dialogs.keepMuscles = "other.glb";
  look();
  closeAll();
  state.dialogs.conflict.found = OnDisk::kChanged;
  look();
  closeAll();
  state.dialogs.locate = {"a.rig.json", "a.glb"};
  look();
  closeAll();
  state.session.leftBehind = {{"lost.json", "a.rig.json", "a.glb", fs::file_time_type::clock::now(), 3}};
  state.dialogs.recovery = true;
  look();
  closeAll();
}

void PaletteCoverage::lookAtOtherCharacters() {
  open(test::writeDressedHumanoid(folder_.path()));
  look();
  const test::Post post = test::makeMorphingPost(5, 2);
  open(folder_.write("post.glb", post.file.glb()));
  state.view.outliner.tab = LeftTab::kShapes;
  look();
}

TEST_F(PaletteCoverage, LeadsToEveryLabelThatIsDrawn) {
  lookAtDocument();
  lookAtAnimation();
  lookAtLists();
  lookAtExports();
  lookAtDialogs();
  lookAtOtherCharacters();
  const std::map<std::string_view, const char*> elsewhere{{"flex", "view/flex"}, {"viewport-menu", "context/"}};
  for (const Panel& panel : panels()) {
    const auto other = elsewhere.find(panel.id);
    const std::string begin = other == elsewhere.end() ? panel.id : other->second;
    EXPECT_TRUE(std::ranges::any_of(seen_, [&](const std::string& id) { return id.starts_with(begin); }))
        << "the panel " << panel.id << " was not drawn";
  }
  for (const Drawn& each : uncovered(controls())) {
    ADD_FAILURE() << "nothing leads to \"" << each.row << "\" \"" << each.text << "\": " << each.id;
  }
  for (const Exception& each : kExceptions) {
    EXPECT_TRUE(std::ranges::any_of(drawn_, [&](const Drawn& drawn) { return exceptionFor(drawn) == &each; }))
        << each.begin << " is no longer drawn";
  }
  // Each declaration is needed: without it the control's label leads nowhere, unless it is also an action's.
  int drawn = 0;
  for (const Control* left : controls()) {
    const auto found = std::ranges::find(drawn_, left->id, &Drawn::id);
    if (found == drawn_.end() || isCommand(*found)) continue;
    std::vector<const Control*> others = controls();
    std::erase(others, left);
    EXPECT_FALSE(uncovered(others).empty()) << left->id << " would not be missed";
    ++drawn;
  }
  EXPECT_GT(drawn, 60);
}

}  // namespace
}  // namespace sinew::app
