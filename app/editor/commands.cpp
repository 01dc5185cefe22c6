// app/editor/commands.cpp: opening, saving, history, muscles, framing and the picture's context menu.
#include "app/editor/commands.h"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <utility>

#include "app/document/command_stack.h"
#include "app/document/listed_muscles.h"
#include "app/document/shown_names.h"
#include "app/editor/blending_edit.h"
#include "app/editor/clip_commands.h"
#include "app/editor/edit.h"
#include "app/editor/open_file.h"
#include "app/editor/session.h"
#include "app/editor/symmetry_commands.h"
#include "app/editor/visibility_commands.h"
#include "app/viewport/tools/viewport_tools.h"
#include "core/geometry/at.h"
#include "core/rig/sheet_edit.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {

namespace {

/// Takes the history's play ranges. If only another clip's range changed, chooses that clip to show the change.
void takeRanges(Transport& transport, const PlayRanges& ranges, const Character& character) {
  const PlayRanges before = std::exchange(transport.ranges, ranges);
  const auto changed = [&](int clip) {
    const auto was = before.find(clip);
    const auto is = ranges.find(clip);
    return (was == before.end()) != (is == ranges.end()) || (was != before.end() && was->second != is->second);
  };
  if (changed(transport.clip)) return;
  for (int clip = 0; clip < static_cast<int>(character.clips.size()); ++clip) {
    if (changed(clip)) return chooseClip(transport, clip, character);
  }
}

/// Moves in the history, with pose and play ranges. @return whether it moved
template <class Move>
bool travel(EditorState& state, Move move) {
  if (isBusy(state)) return false;
  const std::size_t before = state.document.commands.position();
  move(state.document.commands);
  followClipFiles(state);
  state.open.transport.overrides = state.document.commands.pose();
  takeRanges(state.open.transport, rangesOf(state.document.commands.ranges(), state.character()), state.character());
  state.open.refusal.clear();
  return state.document.commands.position() != before;
}

}  // namespace

bool isBusy(const EditorState& state) { return ownsKeyboard(state.view.tools) || state.open.gestureItem != 0; }

void request(EditorState& state, const Intent& intent) {
  if (state.hasCharacter() && state.document.commands.modified()) {
    state.dialogs.question = intent;
  } else {
    perform(state, intent);
  }
}

void perform(EditorState& state, const Intent& intent) {
  switch (intent.kind) {
    case IntentKind::kNone:
      break;
    case IntentKind::kOpenFile:
      openFile(state, intent.file);
      break;
    case IntentKind::kOpenWithMuscles:
      openWithMuscles(state, intent.file);
      break;
    case IntentKind::kAddClips:
      addClips(state, intent.file);
      break;
    case IntentKind::kReopen:
      reopen(state);
      break;
    case IntentKind::kRecover:
      recover(state, intent.file);
      break;
    case IntentKind::kQuit:
      if (state.session.exports.empty()) state.session.quit = true;
      else state.dialogs.exportQuestion = true;
      break;
  }
}

void showPathDialog(EditorState& state, DialogKind kind, const std::filesystem::path& folder, const std::string& text) {
  state.dialogs.file = {};
  state.dialogs.file.kind = kind;
  state.dialogs.file.folder = folder;
  state.dialogs.file.text = text;
  state.dialogs.file.appearing = true;
}

void showOpenDialog(EditorState& state) {
  std::filesystem::path folder = state.document.file();
  std::error_code ignored;
  if (isSample(folder)) {
    // Not the program's own folder.
    const auto& recent = state.session.preferences.recentFiles;
    folder = recent.empty() ? homeFolder() : recent.front().parent_path();
  } else {
    folder = folder.empty() ? std::filesystem::current_path(ignored)
                            : std::filesystem::absolute(folder, ignored).parent_path();
  }
  showPathDialog(state, DialogKind::kOpen, folder);
}

void showSaveDialog(EditorState& state, const Intent& then) {
  const Document& document = state.document;
  std::error_code ignored;
  std::filesystem::path file = document.rigFile;
  if (file.empty()) {
    file = document.characterFile;
    file.replace_extension(".rig.json");
  }
  if (isSample(file)) file = homeFolder() / file.filename();
  file = std::filesystem::absolute(file, ignored);
  showPathDialog(state, DialogKind::kSaveAs, file.parent_path(), file.filename().string());
  state.dialogs.file.then = then;
}

bool save(EditorState& state, const Intent& then) {
  if (!state.hasCharacter()) return false;
  if (state.document.rigFile.empty() || isSample(state.document.rigFile)) {
    showSaveDialog(state, then);
    return false;
  }
  if (asksBeforeSaving(state, then)) return false;
  if (!saveTo(state, state.document.rigFile).empty()) return false;
  perform(state, then);
  return true;
}

std::string saveTo(EditorState& state, const std::filesystem::path& file) {
  if (const Result<void> saved = saveDocument(state.document, file); !saved) {
    addMessage(state.session, MessageKind::kError, "Not saved: " + saved.error().plainText());
    state.session.saveFailed = true;
    return saved.error().plainText();
  }
  say(state, "Saved " + file.filename().string());
  return "";
}

void undo(EditorState& state) {
  const CommandStack& commands = state.document.commands;
  const std::string undone = commands.label(commands.position());
  if (travel(state, [](CommandStack& history) { history.undo(); })) say(state, "Undone: " + undone);
}

void redo(EditorState& state) {
  if (travel(state, [](CommandStack& history) { history.redo(); })) {
    say(state, "Redone: " + state.document.commands.label(state.document.commands.position()));
  }
}

void jumpTo(EditorState& state, std::size_t step) {
  travel(state, [step](CommandStack& commands) { commands.jumpTo(step); });
}

void addMuscle(EditorState& state, int bone, ShapePreset preset) {
  if (!state.hasCharacter() || isBusy(state)) return;
  if (const auto added = addMuscleOnBone(state.document, bone, preset)) state.open.refusal.clear();
  else refuse(state, added.error());
}

void deleteSelection(EditorState& state) {
  const std::vector<int> indices = editedIndices(state.document);
  if (indices.empty() || isBusy(state)) return;
  const std::string what = namedMuscles(state.document.rig(), indices);
  edit(state, "Delete " + what, removePrimitives(state.document.rig(), indices));
}

namespace {

/// Selects copies of the selection, not those of twins. @param copied  rig indices before
void selectCopies(Document& document, const Rig& before, const std::vector<int>& copied, const Selection& originals) {
  const Rig& rig = document.rig();
  std::vector<PrimitiveId>& selected = document.selection.primitives;
  int copy = nextIndex(before);
  for (const int original : withoutSheets(before, copied)) {
    if (copy == nextIndex(rig)) break;  // The rig is full.
    if (originals.contains(at(before.primitives, original).id())) selected.push_back(document.idAt(copy));
    ++copy;
  }
  std::size_t sheet = before.sheets.size();
  for (const std::string& original : sheetsOf(before, copied)) {
    const std::vector<int> own = bellies(before, original);
    const std::vector<int> copies = bellies(rig, rig.sheets[sheet++].name);
    if (own.empty() || !originals.contains(at(before.primitives, own.front()).id())) continue;
    for (const int belly : copies) selected.push_back(document.idAt(belly));
  }
  completeSheets(document);
}

}  // namespace

void duplicateSelection(EditorState& state) {
  const std::vector<int> indices = editedIndices(state.document);
  if (indices.empty() || isBusy(state)) return;
  const std::shared_ptr<const Rig> before = state.document.commands.sharedRig();
  const Selection originals = state.document.selection;
  const std::string what = namedMuscles(*before, selectedIndices(state.document));
  if (!edit(state, "Duplicate " + what, duplicatePairs(*before, indices))) return;
  state.document.selection.primitives.clear();
  selectCopies(state.document, *before, indices, originals);
  const std::string copies = namedMuscles(state.document.rig(), selectedIndices(state.document));
  if (state.session.preferences.keymap == Keymap::kBlender) {
    startDrag(state.view.tools, ToolKind::kMove);  // As in Blender, the copy follows the pointer, as another step.
    say(state, "Duplicated " + what + ": click to place " + copies + ", Esc leaves it on the original");
  } else {
    say(state, "Duplicated " + what + ": " + copies + " selected, exactly on the original; drag to move");
  }
}

void startRename(EditorState& state, PrimitiveId primitive) {
  const int index = findPrimitive(state.document.rig(), primitive);
  if (index < 0) return;
  const int lead = leadOf(state.document.rig(), index);
  state.open.rename = {state.document.idAt(lead), muscleName(state.document.rig(), lead), true};
}

bool rename(EditorState& state, PrimitiveId primitive, const std::string& name) {
  const int index = findPrimitive(state.document.rig(), primitive);
  if (index < 0) return false;
  const Rig& rig = state.document.rig();
  const std::string before = muscleName(rig, index);
  if (before == name) return true;
  const int sheet = findSheet(rig, at(rig.primitives, index).sheet);
  return edit(state, "Rename " + before, sheet < 0 ? renameWithTwin(rig, index, name) : renameSheet(rig, sheet, name));
}

void selectNothing(EditorState& state) {
  Selection& selection = state.document.selection;
  if (state.open.animate.drivenKey.isOn()) {
    state.open.animate.drivenKey = {};
  } else if (editsTerritory(state)) {
    endTerritoryMode(state.view.tools);
  } else if (state.view.tools.sheet.origin) {
    state.view.tools.sheet = {};
  } else if (selection.primitives.empty() && selection.bone < 0 && state.open.layers.chosen < 0 &&
             addsMuscles(state.view.tools.tool)) {
    setTool(state.view.tools, ToolKind::kMove);
  } else {
    selection.clear();
    state.open.layers.chosen = -1;
  }
}

void cycleAxes(EditorState& state) {
  GizmoAxes& axes = state.view.tools.gizmo.axes;
  axes = axes == GizmoAxes::kWorld ? GizmoAxes::kBone
                                   : (axes == GizmoAxes::kBone ? GizmoAxes::kPrimitive : GizmoAxes::kWorld);
}

void frameInPicture(EditorState& state, const Bounds& boundsInWorld, bool animated) {
  frameBounds(state.view.tools.camera, boundsInWorld, state.frame.viewportPixels, animated, state.frame.covered);
}

void frameSelection(EditorState& state, bool animated) {
  if (!state.hasCharacter()) return;
  Bounds bounds;
  for (const PrimitiveShape& shape : shownShapes(state, false)) {
    if (!shape.selected) continue;
    // Twice the muscle's size, to show its surroundings.
    const glm::vec3 center(shape.unitBallInWorld[3]);
    for (const glm::vec3& point : extremesOf(shape, 1.0f)) bounds.add(center + 2.0f * (point - center));
  }
  if (bounds.isEmpty()) bounds = boundsOf(state.live->surface().positions);
  frameInPicture(state, bounds, animated);
}

SurfaceView surfaceView(const EditorState& state) {
  const View& view = state.frame.route.view;
  SurfaceView wanted;
  wanted.onCard = state.session.surfaceMaker.onCard;
  wanted.hidden = hiddenPrimitives(state.document.visibility, state.document.rig(), state.character().skeleton);
  wanted.heightPixels = state.character().height / view.unitsPerPixelAt(state.view.tools.camera.stand.target);
  return wanted;
}

std::vector<int> selectedIndices(const Document& document) {
  std::vector<int> indices;
  for (const PrimitiveId id : document.selection.primitives) {
    if (const int index = findPrimitive(document.rig(), id); index >= 0) indices.push_back(index);
  }
  std::ranges::sort(indices);
  return indices;
}

std::vector<PrimitiveShape> shownShapes(const EditorState& state, bool all) {
  std::vector<PrimitiveShape> shapes = primitiveShapes(state.document, state.live->pose());
  // The left panels highlight muscles while they are shown.
  const Rig& rig = state.document.rig();
  std::unordered_set<int> lit;
  for (const int index : state.view.layout.leftShown ? state.frame.highlighted : std::vector<int>{}) {
    if (toIndex(index) < rig.primitives.size()) lit.insert(leadOf(rig, index));
  }
  lit.insert(state.view.tools.hover.primitive);
  for (PrimitiveShape& shape : shapes) shape.hovered = lit.contains(leadOf(rig, shape.rigIndex));
  if (!all) std::erase_if(shapes, [](const PrimitiveShape& shape) { return !shape.selected && !shape.hovered; });
  return shapes;
}

namespace {

bool hasMuscle(const EditorState& state) { return state.document.activePrimitive() >= 0; }
bool onBone(const EditorState& state) { return territorySubject(state.document) >= 0; }
bool mirrors(const EditorState& state) { return canMirror(state.document); }
bool hasBone(const EditorState& state) { return state.document.selection.bone >= 0; }
bool hidesSome(const EditorState& state) { return anythingHidden(state.document); }
bool hasMuscles(const EditorState& state) { return !state.document.rig().primitives.empty(); }

/// What an action needs, and the reason if it is missing. The first one that fails counts.
struct Need {
  std::string_view action;
  bool (*holds)(const EditorState&);
  const char* otherwise;
};

constexpr const char* kNoMuscle = "There is no muscle here";

constexpr std::array kNeeds{
    Need{"view/isolate", hasMuscle, kNoMuscle},
    Need{"view/hide", hasMuscle, kNoMuscle},
    Need{"view/lock", hasMuscle, kNoMuscle},
    Need{"edit/mirror", hasMuscle, kNoMuscle},
    Need{"edit/mirror", mirrors, "This character's bones do not come in left and right pairs"},
    Need{"edit/duplicate", hasMuscle, kNoMuscle},
    Need{"edit/rename", hasMuscle, kNoMuscle},
    Need{"edit/delete", hasMuscle, kNoMuscle},
    Need{"tool/territory", hasMuscle, kNoMuscle},
    Need{"tool/territory", onBone, "The muscle's bone is not in this character"},
    Need{"edit/add-on-bone", hasBone, "There is no bone here"},
    Need{"edit/select-on-bone", hasMuscles, "There are no muscles yet"},
    Need{"edit/select-all", hasMuscles, "There are no muscles yet"},
    Need{"view/show-all", hidesSome, "Nothing is hidden"},
};

}  // namespace

void selectEntry(Document& document, const PickEntry& entry) {
  if (entry.muscle) {
    document.selection.set(entry.muscle);
    completeSheets(document);
  } else {
    document.selection.clear();
    document.selection.bone = entry.bone;
  }
}

void selectForMenu(Document& document, const ViewportHover& target) {
  if (target.here.empty()) return;
  const PickEntry& entry = target.here[target.at];
  if (!entry.muscle || !document.selection.contains(entry.muscle)) selectEntry(document, entry);
}

void addMuscleAt(EditorState& state, const ViewportHover& target) {
  if (!state.hasCharacter() || isBusy(state) || !target.skin) return;
  const Pose& pose = state.live->pose();
  ViewportHover now = target;
  now.pointInWorld = skinPointAt(state.character(), pose, *target.skin).point;
  const ViewportContext context{state.document, pose, *state.live, state.view.display, state.frame.viewportPixels};
  AddMuscleState adding;
  if (const Result<void> begun = beginAddMuscle(adding, context, now, glm::vec2(0.0f)); !begun) {
    refuse(state, begun.error());
    return;
  }
  state.document.commands.endGesture();
  state.open.refusal.clear();
}

std::string whyDisabled(const EditorState& state, std::string_view actionId) {
  if (isBusy(state)) return "Finish the current drag or input first";
  for (const Need& need : kNeeds) {
    if (need.action == actionId && !need.holds(state)) return need.otherwise;
  }
  return "";
}

}  // namespace sinew::app
