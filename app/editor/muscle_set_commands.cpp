// app/editor/muscle_set_commands.cpp: muscle sets, body parts and checks of the open document. A slider of a set undoes
// its step and makes it again, so that there is only one.
#include "app/editor/muscle_set_commands.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/document/muscle_sets.h"
#include "app/editor/edit.h"
#include "app/editor/pose_commands.h"
#include "core/bodies/body_map.h"
#include "core/bodies/mend.h"
#include "core/bodies/muscle_set.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {

namespace {

/// Closes the panels that share a place.
void closePanels(EditorState& state) {
  state.open.check = {};
  state.open.muscleSet.shown = state.open.bodyParts.shown = state.open.clipList.shown = false;
}

}  // namespace

void checkMuscles(EditorState& state) {
  CheckState& check = state.open.check;
  const Rig& rig = state.document.rig();
  closePanels(state);
  check.shown = true;
  check.revision = state.document.commands.revision();
  check.findings = sinew::check(rig, Motions(state.document.character));
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

const Motions& motionsOf(EditorState& state) {
  auto& motions = state.open.muscleSet.motions;
  if (!motions) motions = std::make_shared<const Motions>(state.document.character);
  return *motions;
}

void addMuscleSet(EditorState& state) { addMuscleSetNamed(state, ""); }

void addMuscleSetNamed(EditorState& state, const std::string& name) {
  auto sets = setsForBody(state);
  if (!sets) return refuse(state, sets.error());
  closeCheck(state);
  state.open.bodyParts.shown = state.open.clipList.shown = false;
  motionsOf(state);
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
