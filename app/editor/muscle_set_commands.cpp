// app/editor/muscle_set_commands.cpp: muscle sets, body parts, checks. A set's slider remakes its one undo step.
#include "app/editor/muscle_set_commands.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "app/document/listed_muscles.h"
#include "app/document/muscle_sets.h"
#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/fit_sculpt_commands.h"
#include "app/editor/pose_commands.h"
#include "app/viewport/tools/select.h"
#include "core/bodies/body_map.h"
#include "core/bodies/mend.h"
#include "core/bodies/muscle_set.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {

// Adds a single muscle as a set of one muscle.

namespace {

const PresetMuscle& muscleOf(const LibraryState& library, int set, int muscle) {
  return at(at(library.sets, set).muscles, muscle);
}

/// The mark under the pointer; nullopt: no part of the body.
std::optional<MarkOnSkin> markUnder(EditorState& state, const glm::vec2& pointer) {
  const glm::vec4& viewport = state.frame.viewport;
  const glm::vec2 inside = pointer - glm::vec2(viewport.x, viewport.y);
  if (inside.x < 0.0f || inside.y < 0.0f || inside.x >= viewport.z || inside.y >= viewport.w) return std::nullopt;
  const ViewportContext context{state.document, state.live->pose(), *state.live, state.view.display,
                                state.frame.viewportPixels};
  const glm::vec2 pixel = inside * glm::vec2(state.frame.viewportPixels) / glm::vec2(viewport.z, viewport.w);
  const ViewportHover hover = hoverAt(context, state.frame.route.view, pixel);
  if (!hover.skin || !state.open.library.body) return std::nullopt;
  const Character& character = state.character();
  const glm::vec3 point = skinPointAt(character, bindPose(character.skeleton), *hover.skin).point;
  return markOnSkin(*state.open.library.body, boneAt(character, *hover.skin), point);
}

/// Sets for this character's body; messages name unreadable files. Error: there are none.
Result<std::vector<Preset>> setsForBody(EditorState& state) {
  const Document& document = state.document;
  if (!document.mirror) return errorAt("", "This character has no left and right bones");
  const BodyKind kind = bodySlots(*document.character, *document.mirror, document.rig().slots).kind;
  if (kind == BodyKind::kUnknown)
    return errorAt("", "No arms or legs were found: choose their bones in Muscles > Parts of the body");
  MuscleSets all = muscleSets();
  for (const Error& error : all.refused) addQuietly(state.session, MessageKind::kError, error.text());
  std::erase_if(all.sets, [&](const Preset& set) { return set.body != kind; });
  if (all.sets.empty()) return errorAt("", "There is no set of muscles for this kind of body");
  return std::move(all.sets);
}

/// One undo step. Selects the muscle on that side.
void lay(EditorState& state, Preset set, PresetMuscle muscle, BodySide side) {
  const std::string name = muscle.name;
  const int before = nextIndex(state.document.rig());
  set.muscles = {std::move(muscle)};
  set.sheets.clear();
  auto added =
      sinew::addMuscleSet(state.document.rig(), set, {1.0f, set.definition}, *motionsOf(state), *state.document.mirror);
  if (!added) return refuse(state, added.error());
  if (!edit(state, "Lay " + name, added->fitted.rig)) return;
  const int end = nextIndex(state.document.rig());
  if (end <= before) return;
  const bool right = side == BodySide::kRight && end > before + 1;  // The left one comes first.
  state.document.selection.set(state.document.idAt(before + (right ? 1 : 0)));
  for (const std::string& line : added->mended) say(state, "Mended " + line);
}

/// "upperLeg" -> "upper leg", "frontUpper" -> "front upper leg"
std::string readable(const char* part) {
  std::string words;
  for (const char* c = part; *c != '\0'; ++c) {
    const bool capital = *c >= 'A' && *c <= 'Z';
    if (capital) words += ' ';
    words += capital ? static_cast<char>(*c - 'A' + 'a') : *c;
  }
  const bool ofAnimals = words.starts_with("front ") || words.starts_with("hind ");
  return ofAnimals && !words.ends_with("foot") ? words + " leg" : words;
}

std::string whatDropDoes(const PresetMuscle& muscle, const sinew::Mark& mark, const MeasuredBody& body) {
  if (isOwnPlace(muscle, mark, body)) return muscle.name + ", where it belongs";
  const std::string part = mark.slot == Slot::kSpine ? "trunk" : readable(nameOf(mark.slot));
  const bool same = muscleAt(muscle, mark, body).origin.has_value() == muscle.origin.has_value();
  return muscle.name + ", on the " + part + (same ? "" : ", without its line");
}

}  // namespace

const std::shared_ptr<const Motions>& motionsOf(EditorState& state) {
  auto& motions = state.open.muscleSet.motions;
  if (!motions) motions = std::make_shared<const Motions>(state.document.character);
  return motions;
}

void readLibrary(EditorState& state) {
  LibraryState& library = state.open.library;
  if (!state.hasCharacter()) return;
  const Rig& rig = state.document.rig();
  if (library.readFor && *library.readFor == rig.slots) return;
  library.readFor = rig.slots;
  ++library.reads;
  library.drag = {};
  library.sets.clear();
  library.laid.clear();
  library.body.reset();
  auto sets = setsForBody(state);
  library.why = sets ? "" : sets.error().plainText();
  if (!sets) return;
  const MirrorPlan& plan = *state.document.mirror;
  library.body = std::make_shared<const MeasuredBody>(state.character(), plan, rig.slots);
  Rig bare;
  bare.slots = rig.slots;
  for (Preset& set : sets.value()) {
    auto laid = addMuscleSetQuickly(bare, set, {1.0f, set.definition}, *motionsOf(state), plan);
    if (!laid) continue;
    library.laid.push_back(std::move(laid).value());
    library.sets.push_back(std::move(set));
  }
}

void layFromLibrary(EditorState& state, int set, int muscle) {
  const LibraryState& library = state.open.library;
  lay(state, at(library.sets, set), muscleOf(library, set, muscle), BodySide::kLeft);
}

void takeFromLibrary(EditorState& state, int set, int muscle) { state.open.library.drag = {set, muscle, {}}; }

void carryFromLibrary(EditorState& state, const glm::vec2& pointer) {
  LibraryState& library = state.open.library;
  const PresetMuscle& muscle = muscleOf(library, library.drag.set, library.drag.muscle);
  const auto under = markUnder(state, pointer);
  library.drag.says =
      under ? whatDropDoes(muscle, under->mark, *library.body) : muscle.name + ": drop it on the character";
}

void dropFromLibrary(EditorState& state, const glm::vec2& pointer) {
  const LibraryState& library = state.open.library;
  const LibraryState::Drag drag = library.drag;
  const auto under = markUnder(state, pointer);
  leaveInLibrary(state);
  if (!under) return;
  const PresetMuscle& muscle = muscleOf(library, drag.set, drag.muscle);
  lay(state, at(library.sets, drag.set), muscleAt(muscle, under->mark, *library.body), under->side);
}

void leaveInLibrary(EditorState& state) { state.open.library.drag = {}; }

void nameNewSet(EditorState& state) {
  LibraryState& library = state.open.library;
  library.naming = library.appearing = true;
  library.name.clear();
  library.notice.clear();
  library.replacing = false;
  state.view.outliner.tab = LeftTab::kLibrary;
  state.view.layout.leftShown = true;
}

void saveNewSet(EditorState& state) {
  LibraryState& library = state.open.library;
  const std::string name = setNameFor(library.name);
  const bool replace = std::exchange(library.replacing, false);
  library.notice.clear();
  if (name.empty()) {
    library.notice = "Type a name";
  } else if (isShippedSet(name)) {
    library.notice = "A set of that name comes with the program";
  } else if (isOwnSet(name) && !replace) {
    library.notice = "A set of that name exists: Save again to replace it";
    library.replacing = true;
  }
  if (!library.notice.empty()) return;
  auto made = presetFromMuscles(state.document.rig(), selectedIndices(state.document), state.character(),
                                *state.document.mirror);
  if (!made) {
    library.notice = made.error().plainText();
    return;
  }
  Preset set = made->preset;
  set.name = name;
  set.title = library.name;
  if (const auto saved = saveOwnSet(set); !saved) {
    library.notice = saved.error().plainText();
    return;
  }
  library.naming = false;
  library.readFor.reset();
  for (const auto& [muscle, why] : made->leftOut)
    addQuietly(state.session, MessageKind::kWarning, muscle + " is not in the set: " + why);
  say(state,
      "Saved the set " + set.title + ": " + withCount(set.muscles.size(), "muscle") +
          (made->leftOut.empty() ? "" : ", " + std::to_string(made->leftOut.size()) + " left out: see the messages"));
}

void removeSetFromLibrary(EditorState& state, int set) {
  const Preset& gone = at(state.open.library.sets, set);
  const std::string title = gone.title;
  if (const auto removed = removeOwnSet(gone.name); !removed) {
    return addMessage(state.session, MessageKind::kError, removed.error().plainText());
  }
  say(state, "Removed the set " + title + "; its file is kept as " + gone.name + ".json~");
  state.open.library.readFor.reset();
}

void closePanels(EditorState& state) {
  state.open.check = {};
  state.open.muscleSet.shown = state.open.bodyParts.shown = state.open.clipList.shown = false;
  closeFit(state);
}

void checkMuscles(EditorState& state) {
  CheckState& check = state.open.check;
  const Rig& rig = state.document.rig();
  closePanels(state);
  check.shown = true;
  check.revision = state.document.commands.revision();
  check.findings = sinew::check(rig, Motions(state.document.character));
  // Of the strips of a sheet the first with a finding of a kind.
  std::set<std::pair<int, FindingKind>> seen;
  std::erase_if(check.findings,
                [&](const Finding& one) { return !seen.emplace(leadOf(rig, one.primitive), one.kind).second; });
  for (const Finding& finding : check.findings) check.muscles.push_back(state.document.idAt(finding.primitive));
}

void closeCheck(EditorState& state) { state.open.check = {}; }

bool checkIsCurrent(const EditorState& state) {
  return state.open.check.revision == state.document.commands.revision();
}

void goToFinding(EditorState& state, int finding) {
  CheckState& check = state.open.check;
  check.chosen = finding;
  state.document.selection.set(at(check.muscles, finding));
  completeSheets(state.document);
  const Finding& found = at(check.findings, finding);
  if (found.clip == kRangeOfMotionName) playRangeOfMotion(state);
  const int clip = found.clip.empty() ? -1 : findClip(state.character(), found.clip);
  Transport& transport = state.open.transport;
  chooseClip(transport, clip, state.character());
  transport.playing = false;
  transport.time = static_cast<double>(found.time);
}

void mendFindings(EditorState& state) {
  if (!checkIsCurrent(state)) return checkMuscles(state);
  const Motions motions(state.document.character);
  Result<MendedRig> mended = withMendedRig(state.document.rig(), 0, motions, state.document.mirror.get());
  if (!mended) return refuse(state, mended.error());
  if (mended->said.empty()) return sayRefusal(state, "None of these can be mended: edit the muscles by hand");
  const std::vector<std::string> said = std::move(mended.value().said);
  edit(state, "Mend muscles", std::move(mended.value().rig));
  for (const std::string& line : said) addMessage(state.session, MessageKind::kNote, "Mended " + line);
  checkMuscles(state);
}

namespace {

Rig withoutCorrection(Rig rig, BodySlot slot) {
  std::erase_if(rig.slots, [&](const SlotCorrection& each) { return each.slot == nameOf(slot); });
  return rig;
}

}  // namespace

void toggleBodyParts(EditorState& state) {
  const bool shown = !state.open.bodyParts.shown;
  if (shown) closePanels(state);
  state.open.bodyParts.shown = shown;
}

BodySlots bodyPartsOf(const EditorState& state) {
  const Document& document = state.document;
  return bodySlots(*document.character, document.mirror ? *document.mirror : MirrorPlan{}, document.rig().slots);
}

void setBodyPart(EditorState& state, BodySlot slot, int bone) {
  Rig rig = withoutCorrection(state.document.rig(), slot);
  rig.slots.push_back({nameOf(slot), bone < 0 ? "" : state.character().skeleton.fileName(bone)});
  edit(state, std::string("Part ") + nameOf(slot), std::move(rig));
}

void forgetBodyPart(EditorState& state, BodySlot slot) {
  edit(state, std::string("Part ") + nameOf(slot) + " as found", withoutCorrection(state.document.rig(), slot));
}

namespace {

constexpr const char* kLabel = "Add muscle set";

const Preset& chosenSet(const MuscleSetState& set) { return at(set.sets, set.chosen); }

Result<AddedSet> fitted(const EditorState& state, const Rig& onto) {
  const MuscleSetState& set = state.open.muscleSet;
  return sinew::addMuscleSet(onto, chosenSet(set), set.tuning, *set.motions, *state.document.mirror);
}

/// For the panel.
void remember(EditorState& state, AddedSet added) {
  MuscleSetState& set = state.open.muscleSet;
  set.muscles = std::move(added.fitted.muscles);
  set.leftOut = std::move(added.fitted.leftOut);
  set.mended = std::move(added.mended);
  set.kept = set.tuning;
  set.revision = state.document.commands.revision();
}

}  // namespace

std::vector<SetEntry> setEntries(EditorState& state) {
  if (!state.hasCharacter()) return {};
  const auto sets = setsForBody(state);
  if (!sets) return {};
  std::vector<SetEntry> entries;
  for (const Preset& set : sets.value()) {
    entries.push_back({set.name, ""});
    for (const PresetMuscle& muscle : set.muscles) entries.push_back({set.name, muscle.name});
  }
  return entries;
}

void addMuscleSet(EditorState& state) { addMuscleSetNamed(state, ""); }

void addMuscleSetNamed(EditorState& state, const std::string& name) {
  auto sets = setsForBody(state);
  if (!sets) return refuse(state, sets.error());
  closePanels(state);
  static_cast<void>(motionsOf(state));
  MuscleSetState& set = state.open.muscleSet;
  set.sets = std::move(sets).value();
  const auto named = std::ranges::find(set.sets, name, &Preset::name);
  set.chosen = named == set.sets.end() ? 0 : static_cast<int>(named - set.sets.begin());
  set.tuning = {1.0f, chosenSet(set).definition};
  Result<AddedSet> added = fitted(state, state.document.rig());
  if (!added) return refuse(state, added.error());
  edit(state, kLabel, added->fitted.rig);
  remember(state, std::move(added).value());
  set.shown = true;
}

bool previewsSet(const EditorState& state) {
  return state.open.muscleSet.shown && state.open.muscleSet.previews && state.document.commands.inGesture();
}

bool setIsTunable(const EditorState& state) {
  const MuscleSetState& set = state.open.muscleSet;
  return set.shown && (previewsSet(state) || set.revision == state.document.commands.revision());
}

void chooseSet(EditorState& state, int chosen) {
  MuscleSetState& set = state.open.muscleSet;
  const int former = std::exchange(set.chosen, chosen);
  CommandStack& commands = state.document.commands;
  commands.undo();
  set.tuning = {set.tuning.mass, chosenSet(set).definition};
  Result<AddedSet> added = fitted(state, commands.rig());
  if (!added) {
    commands.redo();
    set.chosen = former;
    set.tuning = set.kept;
    set.revision = commands.revision();
    return refuse(state, added.error());
  }
  edit(state, kLabel, added->fitted.rig);
  remember(state, std::move(added).value());
}

void previewSet(EditorState& state, const PresetTuning& tuning) {
  MuscleSetState& set = state.open.muscleSet;
  CommandStack& commands = state.document.commands;
  if (!previewsSet(state)) {
    commands.undo();
    commands.beginGesture(kLabel);
    set.previews = true;
  }
  set.tuning = tuning;
  auto rig = addMuscleSetQuickly(commands.rigOfStep(), chosenSet(set), tuning, *set.motions, *state.document.mirror);
  if (rig) commands.updateGesture(std::move(rig.value().rig));
}

void keepSet(EditorState& state) {
  CommandStack& commands = state.document.commands;
  state.open.muscleSet.previews = false;
  Result<AddedSet> added = fitted(state, commands.rigOfStep());
  if (!added) {
    dropPreview(state);
    return refuse(state, added.error());
  }
  commands.updateGesture(added->fitted.rig);
  commands.endGesture();
  remember(state, std::move(added).value());
}

void dropPreview(EditorState& state) {
  MuscleSetState& set = state.open.muscleSet;
  set.previews = false;
  state.document.commands.cancelGesture();
  state.document.commands.redo();
  set.tuning = set.kept;
  set.revision = state.document.commands.revision();
}

void removeSet(EditorState& state) {
  state.document.commands.undo();
  closeSet(state);
}

void closeSet(EditorState& state) { state.open.muscleSet.shown = false; }

}  // namespace sinew::app
