// app/editor/library_commands.cpp: adds a single muscle as a set of one muscle.

#include "app/editor/library_commands.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/document/muscle_sets.h"
#include "app/document/shown_names.h"
#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/muscle_set_commands.h"
#include "app/viewport/tools/select.h"
#include "core/bodies/muscle_set.h"
#include "core/geometry/at.h"

namespace sinew::app {
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

/// One undo step. Selects the muscle on that side.
void lay(EditorState& state, Preset set, PresetMuscle muscle, BodySide side) {
  const std::string name = muscle.name;
  const std::size_t before = state.document.rig().primitives.size();
  set.muscles = {std::move(muscle)};
  auto added =
      sinew::addMuscleSet(state.document.rig(), set, {1.0f, set.definition}, motionsOf(state), *state.document.mirror);
  if (!added) return refuse(state, added.error());
  if (!edit(state, "Lay " + name, added->fitted.rig)) return;
  const auto& primitives = state.document.rig().primitives;
  if (primitives.size() <= before) return;
  // The left one comes first.
  const bool right = side == BodySide::kRight && primitives.size() > before + 1;
  state.document.selection.clear();
  state.document.selection.primitives = {primitives[before + (right ? 1 : 0)].id()};
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
    auto laid = addMuscleSetQuickly(bare, set, {1.0f, set.definition}, motionsOf(state), plan);
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

}  // namespace sinew::app
