// app/panels/palette_entries.cpp: the entries of the palette, kind by kind.

#include "app/panels/palette_entries.h"

#include <algorithm>
#include <array>
#include <span>
#include <system_error>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/commands.h"
#include "app/editor/line_commands.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/session.h"
#include "app/editor/visibility_commands.h"
#include "app/ui/code_points.h"
#include "core/geometry/at.h"
#include "core/rig/mesh_layers.h"

namespace sinew::app {
namespace {

Possible onLines(const EditorState& state) {
  if (!state.hasCharacter()) return {false, "Open a character first"};
  if (state.open.gestureItem != 0 || ownsKeyboard(state.view.tools)) return {false, "Finish the current edit first"};
  return {!selectedLines(state.document).indices.empty(), "Select a muscle that rides a line first"};
}

bool anyLine(const EditorState& state, bool withVia) {
  const SelectedLines lines = selectedLines(state.document);
  const auto& all = state.document.rig().lines;
  return std::ranges::any_of(lines.indices, [&](int line) { return at(all, line).via.has_value() == withVia; });
}

Possible withoutVia(const EditorState& state) {
  const Possible lines = onLines(state);
  return lines ? Possible(anyLine(state, false), "The line has a via point already") : lines;
}

Possible withVia(const EditorState& state) {
  const Possible lines = onLines(state);
  return lines ? Possible(anyLine(state, true), "The line has no via point") : lines;
}

Possible onPart(const EditorState& state) {
  const bool idle = state.open.gestureItem == 0 && !ownsKeyboard(state.view.tools);
  return Possible(state.hasCharacter(), "Open a character first")
      .also(hasParts(state), "This character is a single part")
      .also(state.open.layers.chosen >= 0, "Choose a part in the panel Layers first")
      .also(idle, "Finish the current edit first");
}

Possible onSetPart(const EditorState& state) {
  const Possible part = onPart(state);
  return part ? Possible(isLayerSet(state, state.open.layers.chosen), "The part is as guessed") : part;
}

template <SkinLayer kLayer>
void setChosenPart(EditorState& state) {
  setPartLayer(state, state.open.layers.chosen, kLayer);
}

void guessChosenPart(EditorState& state) { setPartLayer(state, state.open.layers.chosen, std::nullopt); }

constexpr PanelCommand kCommands[] = {
    {"panel/learn", "Learn contraction from clips", "Inspector: Set > Learn", "flex full analyze", onLines,
     learnContraction},
    {"panel/rest-now", "Rest length = now", "Inspector: Set > Rest", "relaxed neutral", onLines, setRestToNow},
    {"panel/full-now", "Full contraction = now", "Inspector: Set > Full", "flexed", onLines, setFullContractionToNow},
    {"panel/via-add", "Add via point", "Inspector: Via point > Add", "bend waypoint", withoutVia, addViaPoints},
    {"panel/via-remove", "Remove via point", "Inspector: Via point > Remove", "straighten", withVia, removeViaPoints},
    {"panel/rigid", "Make rigid", "Inspector: Ends > Rigid", "off the line detach", onLines, takeOffLines},
    {"panel/layer-skin", "Make the part skin", "Inspector: Layers", "layer mesh body muscles", onPart,
     setChosenPart<SkinLayer::kSkin>},
    {"panel/layer-cloth", "Make the part cloth", "Inspector: Layers", "layer mesh clothes hair garment", onPart,
     setChosenPart<SkinLayer::kCloth>},
    {"panel/layer-rigid", "Make the part rigid", "Inspector: Layers", "layer mesh eyes teeth", onPart,
     setChosenPart<SkinLayer::kRigid>},
    {"panel/layer-guess", "Guess the part's layer", "Inspector: Layers > Guess", "mesh automatic reset", onSetPart,
     guessChosenPart},
};

constexpr std::array kSynonyms{
    std::pair<std::string_view, std::string_view>{"edit/duplicate", "clone copy"},
    std::pair<std::string_view, std::string_view>{"edit/delete", "remove erase"},
    std::pair<std::string_view, std::string_view>{"edit/mirror", "reflect other side left right"},
    std::pair<std::string_view, std::string_view>{"edit/symmetry", "mirror both sides"},
    std::pair<std::string_view, std::string_view>{"edit/select-none", "deselect clear"},
    std::pair<std::string_view, std::string_view>{"edit/key", "keyframe animate"},
    std::pair<std::string_view, std::string_view>{"tool/add-muscle", "draw sketch paint create"},
    std::pair<std::string_view, std::string_view>{"tool/muscle-line", "draw stretch create flex"},
    std::pair<std::string_view, std::string_view>{"view/primitives", "ellipsoids shells"},
    std::pair<std::string_view, std::string_view>{"view/wire", "wireframe mesh topology"},
    std::pair<std::string_view, std::string_view>{"view/skeleton", "bones joints rig"},
    std::pair<std::string_view, std::string_view>{"view/clay", "matcap gray solid"},
    std::pair<std::string_view, std::string_view>{"view/before", "bare original compare"},
    std::pair<std::string_view, std::string_view>{"view/numbers", "fps statistics"},
    std::pair<std::string_view, std::string_view>{"file/add-clips", "import animation motion file retarget"},
    std::pair<std::string_view, std::string_view>{"play/clip-files", "added animation files remove locate missing"},
    std::pair<std::string_view, std::string_view>{"play/read-clip-files", "reload refresh update animation changed"},
    std::pair<std::string_view, std::string_view>{"file/export-character", "save as glb usd game"},
    std::pair<std::string_view, std::string_view>{"file/export-farm", "slurm batch render"},
};

}  // namespace

std::span<const PanelCommand> panelCommands() { return kCommands; }

std::string_view synonymsOf(std::string_view actionId) {
  const auto found = std::ranges::find(kSynonyms, actionId, &std::pair<std::string_view, std::string_view>::first);
  return found == kSynonyms.end() ? std::string_view() : found->second;
}

namespace {

// Order of entries that match equally well: actions, controls, things in the document, things outside it, files.
constexpr int kControlsRank = 1;
constexpr int kDocument = 3;
constexpr int kElsewhere = 6;
constexpr int kFiles = 30;  // Also behind actions that match by a synonym.

int recentRank(const EditorState& state, const std::string& id) {
  const auto& recent = state.session.preferences.recentActions;
  const auto found = std::ranges::find(recent, id);
  return found == recent.end() ? -1 : static_cast<int>(found - recent.begin());
}

std::string otherWords(const PaletteEntry& entry) {
  switch (entry.kind) {
    case EntryKind::kAction:
      return std::string(synonymsOf(entry.id));
    case EntryKind::kPanel:
      return panelCommands()[static_cast<std::size_t>(entry.place)].synonyms;
    case EntryKind::kControl:
      return std::string(entry.control->words) + " setting";
    case EntryKind::kPart:
      return "layer mesh material";
    case EntryKind::kClip:
      return "play animation";
    case EntryKind::kSet:
      return "preset library lay";
    case EntryKind::kPage:
      return "documentation manual " + helpPages()[static_cast<std::size_t>(entry.place)].name;
    default:
      return "";
  }
}

int laterOf(EntryKind kind) {
  switch (kind) {
    case EntryKind::kAction:
    case EntryKind::kPanel:
      return 0;
    case EntryKind::kControl:
      return kControlsRank;
    case EntryKind::kMuscle:
    case EntryKind::kGroup:
    case EntryKind::kBone:
    case EntryKind::kPart:
    case EntryKind::kClip:
      return kDocument;
    case EntryKind::kSet:
    case EntryKind::kPage:
      return kElsewhere;
    case EntryKind::kFile:
      break;
  }
  return kFiles;
}

void add(PaletteEntries& all, const EditorState& state, PaletteEntry entry, std::string label, std::string context) {
  const int recent = recentRank(state, entry.id);
  all.candidates.push_back(
      {std::move(label), std::move(context), recent, entry.why.empty(), otherWords(entry), laterOf(entry.kind)});
  all.entries.push_back(std::move(entry));
}

void addActions(PaletteEntries& all, const EditorState& state) {
  for (const Menu& menu : menus()) {
    for (const Action& item : actions()) {
      if (item.menu() != menu.id || std::string_view(item.id) == "help/palette") continue;
      PaletteEntry entry{EntryKind::kAction, item.id, &item};
      entry.why = item.enabled(state).reason();
      add(all, state, std::move(entry), item.label, menu.title);
    }
  }
}

void addPanels(PaletteEntries& all, const EditorState& state) {
  const std::span<const PanelCommand> commands = panelCommands();
  for (std::size_t i = 0; i < commands.size(); ++i) {
    PaletteEntry entry{EntryKind::kPanel, commands[i].id};
    entry.place = static_cast<int>(i);
    entry.why = commands[i].enabled(state).reason();
    add(all, state, std::move(entry), commands[i].label, commands[i].context);
  }
}

void addControls(PaletteEntries& all, const EditorState& state) {
  for (const Control* control : controls()) {
    PaletteEntry entry{EntryKind::kControl, std::string("control/") + control->id, nullptr, control};
    entry.why = whyNotThere(*control, state);
    add(all, state, std::move(entry), control->label, placeTitle(*control));
  }
}

void addClips(PaletteEntries& all, const EditorState& state) {
  const std::vector<std::string> names = shownClipNames(state.character());
  for (int clip = -1; clip < static_cast<int>(names.size()); ++clip) {
    const std::string name = clip < 0 ? "Bind pose" : at(names, clip);
    PaletteEntry entry{EntryKind::kClip, "clip/" + name};
    entry.place = clip;
    add(all, state, std::move(entry), name, "Clip");
  }
}

void addMuscles(PaletteEntries& all, const EditorState& state) {
  const Rig& rig = state.document.rig();
  for (const int i : allLeads(rig)) {
    PaletteEntry entry{EntryKind::kMuscle, "muscle/" + muscleName(rig, i)};
    entry.muscle = at(rig.primitives, i).id();
    add(all, state, std::move(entry), shownMuscleName(rig, i), "Muscle on " + listedBone(rig, i));
  }
  for (int i = 0; i < static_cast<int>(rig.groups.size()); ++i) {
    PaletteEntry entry{EntryKind::kGroup, "group/" + at(rig.groups, i).name};
    entry.place = i;
    add(all, state, std::move(entry), shownGroupName(rig, i), "Group of muscles");
  }
}

void addBones(PaletteEntries& all, const EditorState& state) {
  const Skeleton& skeleton = state.character().skeleton;
  const std::vector<std::string> names = shownBoneNames(skeleton);
  const std::vector<bool> hidden = hiddenBones(state);
  for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
    if (isHidden(hidden, bone)) continue;
    const std::string& fileName = at(skeleton.bones, bone).name;
    const std::string& name = at(names, bone);
    PaletteEntry entry{EntryKind::kBone, "bone/" + skeleton.fileName(bone)};
    entry.place = bone;
    add(all, state, std::move(entry), name, name == fileName ? "Bone" : "Bone " + fileName);
  }
}

void addParts(PaletteEntries& all, const EditorState& state) {
  if (!hasParts(state)) return;
  const std::vector<std::string> names = shownPartNames(state.character());
  const std::vector<SkinLayer> layers = partLayers(state);
  for (int part = 0; part < static_cast<int>(names.size()); ++part) {
    PaletteEntry entry{EntryKind::kPart, "part/" + at(state.character().parts, part).name};
    entry.place = part;
    add(all, state, std::move(entry), at(names, part), std::string("Part of the mesh, ") + nameOf(at(layers, part)));
  }
}

void addSets(PaletteEntries& all, const EditorState& state) {
  const std::vector<SetEntry>& sets = state.dialogs.palette.sets;
  for (const SetEntry& each : sets) {
    const auto& [set, muscle] = each;
    PaletteEntry entry{EntryKind::kSet, "set/" + set + (muscle.empty() ? "" : "/" + muscle)};
    entry.set = each;
    if (muscle.empty()) add(all, state, std::move(entry), set, "Set of muscles in the library");
    else add(all, state, std::move(entry), muscle, "In the library, set " + set);
  }
}

void addPages(PaletteEntries& all, const EditorState& state) {
  const std::vector<HelpPage>& pages = helpPages();
  for (std::size_t i = 0; i < pages.size(); ++i) {
    PaletteEntry entry{EntryKind::kPage, "page/" + pages[i].name};
    entry.place = static_cast<int>(i);
    add(all, state, std::move(entry), pages[i].title, "Help page");
  }
}

void addFiles(PaletteEntries& all, const EditorState& state) {
  const std::vector<Sample> ours = samples();
  for (std::size_t i = 0; i < ours.size(); ++i) {
    PaletteEntry entry{EntryKind::kFile, "sample/" + std::to_string(i)};
    entry.file = ours[i].file;
    add(all, state, std::move(entry), ours[i].name, "Sample");
  }
  const auto& recent = state.session.preferences.recentFiles;
  for (std::size_t i = 0; i < recent.size(); ++i) {
    std::error_code failed;
    PaletteEntry entry{EntryKind::kFile, "recent/" + std::to_string(i)};
    entry.file = recent[i];
    if (!std::filesystem::is_regular_file(recent[i], failed)) entry.why = "No longer there";
    add(all, state, std::move(entry), recent[i].filename().string(),
        "Recent file in " + recent[i].parent_path().string());
  }
}

void chooseGroup(EditorState& state, int group) {
  const Rig& rig = state.document.rig();
  if (group < 0 || group >= static_cast<int>(rig.groups.size())) return;
  state.view.layout.leftShown = true;
  state.view.outliner.tab = LeftTab::kGroups;
  state.open.blending.group = at(rig.groups, group).id();
  selectMembers(state.document, at(rig.groups, group).name);
}

void chooseSetEntry(EditorState& state, const SetEntry& entry) {
  if (entry.muscle.empty()) addMuscleSetNamed(state, entry.set);
  else revealInLibrary(state, entry);
}

}  // namespace

PaletteEntries gatherEntries(const EditorState& state) {
  PaletteEntries all;
  addActions(all, state);
  addPanels(all, state);
  addControls(all, state);
  if (state.hasCharacter()) {
    addClips(all, state);
    addMuscles(all, state);
    addBones(all, state);
    addParts(all, state);
    addSets(all, state);
  }
  addPages(all, state);
  addFiles(all, state);
  return all;
}

void chooseEntry(EditorState& state, const PaletteEntry& entry) {
  rememberAction(state.session.preferences.recentActions, entry.id);
  const auto place = static_cast<std::size_t>(std::max(entry.place, 0));
  switch (entry.kind) {
    case EntryKind::kAction:
      return run(*entry.action, state);
    case EntryKind::kPanel:
      return panelCommands()[place].run(state);
    case EntryKind::kControl:
      return revealControl(state, *entry.control);
    case EntryKind::kClip:
      chooseClip(state.open.transport, entry.place, state.character());
      state.open.transport.playing = clipDuration(state.open.transport, state.character()) > 0.0;
      return;
    case EntryKind::kMuscle:
      return jumpToMuscle(state, entry.muscle);
    case EntryKind::kGroup:
      return chooseGroup(state, entry.place);
    case EntryKind::kBone:
      return jumpToBone(state, entry.place);
    case EntryKind::kPart:
      return revealPart(state, entry.place);
    case EntryKind::kSet:
      return chooseSetEntry(state, entry.set);
    case EntryKind::kPage:
      return openHelpPage(state, helpPages()[place]);
    case EntryKind::kFile:
      return request(state, {IntentKind::kOpenFile, entry.file});
  }
}

Icon iconOf(const PaletteEntry& entry) {
  switch (entry.kind) {
    case EntryKind::kMuscle:
    case EntryKind::kSet:
      return Icon::kMuscle;
    case EntryKind::kBone:
      return Icon::kBone;
    case EntryKind::kFile:
    case EntryKind::kPage:
      return Icon::kFile;
    case EntryKind::kClip:
      return Icon::kPlay;
    default:
      return Icon::kNone;
  }
}

}  // namespace sinew::app
