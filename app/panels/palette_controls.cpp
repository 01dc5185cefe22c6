// app/panels/palette_controls.cpp: the panels that controls are in, and how each is shown.

#include "app/panels/palette_controls.h"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <tuple>
#include <vector>

#include "app/document/listed_muscles.h"
#include "app/editor/actions.h"
#include "app/editor/line_commands.h"
#include "app/editor/visibility_commands.h"
#include "core/geometry/at.h"

namespace sinew::app {
namespace {

Possible withParts(const EditorState& state) {
  return withCharacter(state).also(hasParts(state), "This character is a single part");
}
Possible withPictures(const EditorState& state) { return action("file/export-pictures").enabled(state); }

template <LeftTab kTab>
void openLeft(EditorState& state) {
  state.view.layout.leftShown = true;
  state.view.outliner.tab = kTab;
}

void unfold(EditorState& state, std::string_view id) { std::erase(state.view.layout.folded, id); }

void openRight(EditorState& state) { state.view.layout.rightShown = true; }
void openBottom(EditorState& state) { state.view.layout.bottomShown = true; }
void openNothing(EditorState& /*state*/) {}

template <PreferencesPage kPage>
void openPreferences(EditorState& state) {
  state.dialogs.preferences = true;
  state.dialogs.preferencesPage = kPage;
}

void openExport(EditorState& state) { run(action("file/export-character"), state); }
void openFarm(EditorState& state) { run(action("file/export-farm"), state); }
void openPictures(EditorState& state) { run(action("file/export-pictures"), state); }

/// A panel or dialog with controls.
struct Surrounding {
  std::string_view begin;  ///< Of its controls' ids. The longer of two that begin alike comes first.
  const char* title;
  Control::Needs needs;
  void (*open)(EditorState&);
};
constexpr Surrounding kSurroundings[] = {
    {"outliner/", "Tab Muscles", withCharacter, openLeft<LeftTab::kMuscles>},
    {"blending/", "Tab Groups", withCharacter, openLeft<LeftTab::kGroups>},
    {"library/", "Tab Library", withCharacter, openLeft<LeftTab::kLibrary>},
    {"shapes/", "Tab Shapes", withCharacter, openLeft<LeftTab::kShapes>},
    {"inspector/", "Inspector: Muscle", withMuscle, openRight},
    {"surface/", "Inspector: Surface", withCharacter, openRight},
    {"smoothing/", "Inspector: Smoothing", withCharacter, openRight},
    {"layers/", "Inspector: Layers", withParts, openRight},
    {"timeline/", "Timeline", withCharacter, openBottom},
    {"view/", "Picture", withCharacter, openNothing},
    {"preferences/keys/", "Preferences: Keys", nothing, openPreferences<PreferencesPage::kKeys>},
    {"preferences/", "Preferences", nothing, openPreferences<PreferencesPage::kGeneral>},
    {"legend/", "Picture", withCharacter, openNothing},
    {"export/", "Export dialog", withExport, openExport},
    {"farm/", "Farm dialog", withFarmJob, openFarm},
    {"pictures/", "Pictures dialog", withPictures, openPictures},
};

const Surrounding& where(const Control& control) {
  const std::string_view id = control.id;
  const auto found =
      std::ranges::find_if(kSurroundings, [&](const Surrounding& place) { return id.starts_with(place.begin); });
  assert(found != std::ranges::end(kSurroundings));
  return *found;
}

std::vector<const Control*>& registered() {
  static std::vector<const Control*> all;
  return all;
}

}  // namespace

Control::Control(const char* controlId, const char* controlLabel, const char* otherWords, Needs whatItNeeds,
                 const char* heading)
    : id(controlId), label(controlLabel), words(otherWords), needs(whatItNeeds), section(heading) {
  registered().push_back(this);
}

const std::vector<const Control*>& controls() {
  static const std::vector<const Control*> sorted = [] {
    std::vector<const Control*> all = registered();
    std::ranges::sort(all, {}, [](const Control* each) {
      return std::tuple(&where(*each), std::string_view(each->section), std::string_view(each->label));
    });
    return all;
  }();
  return sorted;
}

const char* placeTitle(const Control& control) { return where(control).title; }

std::string whyNotThere(const Control& control, const EditorState& state) {
  return (control.needs != nullptr ? control.needs : where(control).needs)(state).reason();
}

Possible nothing(const EditorState& /*state*/) { return {}; }
Possible withCharacter(const EditorState& state) { return {state.hasCharacter(), "Open a character first"}; }
Possible withMuscle(const EditorState& state) {
  return withCharacter(state).also(state.document.activePrimitive() >= 0, "Select a muscle first");
}
Possible withSingleMuscle(const EditorState& state) {
  return withMuscle(state).also(activeSheet(state.document) < 0, "Select a muscle that is no sheet");
}
Possible withSheet(const EditorState& state) {
  return withMuscle(state).also(activeSheet(state.document) >= 0, "Select a sheet first");
}
Possible withLine(const EditorState& state) {
  return withMuscle(state).also(!selectedLines(state.document).indices.empty(),
                                "Select a muscle that rides a line first");
}

Possible withExport(const EditorState& state) { return action("file/export-character").enabled(state); }
Possible withFarmJob(const EditorState& state) { return action("file/export-farm").enabled(state); }

void revealControl(EditorState& state, const Control& control) {
  const Surrounding& place = where(control);
  place.open(state);
  unfold(state, place.begin.substr(0, place.begin.size() - 1));
  unfold(state, control.section);
  // Rows that unfold others.
  if (std::string_view(control.section) == "inspector/shape") state.view.inspector.shapeOpen = true;
  if (std::string_view(control.section) == "inspector/sheet/more") state.view.inspector.sheetOpen = true;
  if (std::string_view(control.section) == "export/advanced") state.dialogs.exporting.advanced = true;
  state.dialogs.reveal = {control.id};
}

void revealPart(EditorState& state, int part) {
  openRight(state);
  unfold(state, "layers");
  state.open.layers.chosen = part;
  state.dialogs.reveal = {"layers/part/" + at(state.character().parts, part).name};
}

void revealInLibrary(EditorState& state, const SetEntry& entry) {
  openLeft<LeftTab::kLibrary>(state);
  state.open.library.search.clear();
  state.open.library.folded.erase(entry.set);
  state.dialogs.reveal = {"library/" + entry.set + (entry.muscle.empty() ? "" : "/" + entry.muscle)};
}

}  // namespace sinew::app
