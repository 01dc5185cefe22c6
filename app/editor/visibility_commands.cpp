// app/editor/visibility_commands.cpp: hide, isolate, before and after.

#include "app/editor/visibility_commands.h"

#include <algorithm>

#include "app/editor/commands.h"

namespace sinew::app {
namespace {

std::vector<PrimitiveId> selectedMuscles(const Document& document) {
  std::vector<PrimitiveId> muscles;
  for (const int index : selectedIndices(document)) muscles.push_back(document.idAt(index));
  return muscles;
}

/// Sets the mark on all selected, or takes it off if all have it.
void toggleMark(Document& document, Mark mark) {
  Visibility& visibility = document.visibility;
  const std::vector<PrimitiveId> muscles = selectedMuscles(document);
  const bool all =
      std::ranges::all_of(muscles, [&](PrimitiveId id) { return visibility.marks(mark).muscles.contains(id); });
  for (const PrimitiveId id : muscles) visibility.setMuscle(mark, id, !all);
}

}  // namespace

void followEdits(Document& document) { welcomeNew(document.visibility, document.rig(), document.character->skeleton); }

void toggleHideSelection(Document& document) { toggleMark(document, Mark::kHidden); }

void showAll(Document& document) {
  Visibility& visibility = document.visibility;
  visibility.hidden = {};
  visibility.solo = {};
  visibility.isolated.reset();
}

void toggleIsolation(Document& document) {
  Visibility& visibility = document.visibility;
  if (visibility.isolated) {
    visibility.isolated.reset();
    return;
  }
  const std::vector<PrimitiveId> muscles = selectedMuscles(document);
  if (!muscles.empty()) visibility.isolated.emplace(muscles.begin(), muscles.end());
}

void toggleLockSelection(Document& document) { toggleMark(document, Mark::kLocked); }

void unlockAll(Document& document) { document.visibility.locked = {}; }

bool anythingHidden(const Document& document) {
  const Visibility& visibility = document.visibility;
  return !visibility.hidden.empty() || !visibility.solo.empty() || visibility.isolated.has_value();
}

void latchBare(EditorState& state) { state.view.bare.latched = !state.view.bare.latched; }

void holdBare(EditorState& state, bool keyDown, bool buttonDown) {
  BareState& bare = state.view.bare;
  if (bare.byKey && !keyDown) bare.latched = false;
  bare.byKey = keyDown;
  state.document.visibility.bare = bare.latched || buttonDown;
}

std::string hiddenText(const Document& document) {
  const Visibility& visibility = document.visibility;
  if (visibility.bare) return "Before: without muscles";
  const auto hidden = hiddenPrimitives(visibility, document.rig(), document.character->skeleton).size();
  if (hidden == 0) return "";
  const std::string count = std::to_string(hidden) + " of " + std::to_string(document.rig().primitives.size());
  return visibility.isolated ? "Isolated: " + count + " muscles hidden" : count + " muscles hidden";
}

}  // namespace sinew::app
