// app/editor/visibility_commands.cpp: hide, isolate, before and after.

#include "app/editor/visibility_commands.h"

#include <algorithm>

#include "app/editor/commands.h"

namespace sinew::app {
namespace {

std::vector<PrimitiveId> selectedMuscles(const EditorState& state) {
  std::vector<PrimitiveId> muscles;
  for (const int index : selectedIndices(state.document)) muscles.push_back(state.document.idAt(index));
  return muscles;
}

/// Sets the mark on all selected, or takes it off if all have it.
void toggleMark(EditorState& state, Mark mark) {
  Visibility& visibility = state.document.visibility;
  const std::vector<PrimitiveId> muscles = selectedMuscles(state);
  const bool all =
      std::ranges::all_of(muscles, [&](PrimitiveId id) { return visibility.marks(mark).muscles.contains(id); });
  for (const PrimitiveId id : muscles) visibility.setMuscle(mark, id, !all);
}

}  // namespace

void followEdits(EditorState& state) { welcomeNew(state.document.visibility, state.document.rig()); }

void toggleHideSelection(EditorState& state) { toggleMark(state, Mark::kHidden); }

void showAll(EditorState& state) {
  Visibility& visibility = state.document.visibility;
  visibility.hidden = {};
  visibility.solo = {};
  visibility.isolated.reset();
}

void toggleIsolation(EditorState& state) {
  Visibility& visibility = state.document.visibility;
  if (visibility.isolated) {
    visibility.isolated.reset();
    return;
  }
  const std::vector<PrimitiveId> muscles = selectedMuscles(state);
  if (!muscles.empty()) visibility.isolated.emplace(muscles.begin(), muscles.end());
}

void toggleLockSelection(EditorState& state) { toggleMark(state, Mark::kLocked); }

void unlockAll(EditorState& state) { state.document.visibility.locked = {}; }

bool anythingHidden(const EditorState& state) {
  const Visibility& visibility = state.document.visibility;
  return !visibility.hidden.empty() || !visibility.solo.empty() || visibility.isolated.has_value();
}

void latchBare(EditorState& state) { state.view.bare.latched = !state.view.bare.latched; }

void holdBare(EditorState& state, bool keyDown, bool buttonDown) {
  BareState& bare = state.view.bare;
  if (bare.byKey && !keyDown) bare.latched = false;
  bare.byKey = keyDown;
  state.document.visibility.bare = bare.latched || buttonDown;
}

EffectiveVisibility visibilityOf(const EditorState& state) {
  const Rig& rig = state.document.rig();
  const Skeleton& skeleton = state.character().skeleton;
  return effectiveVisibility(state.document.visibility, rig, skeleton, boneOfEach(rig, skeleton));
}

std::string hiddenText(const EditorState& state) {
  const Visibility& visibility = state.document.visibility;
  if (visibility.bare) return "Before: without muscles";
  const auto hidden = hiddenPrimitives(visibility, state.document.rig(), state.character().skeleton).size();
  if (hidden == 0) return "";
  const std::string count = std::to_string(hidden) + " of " + std::to_string(state.document.rig().primitives.size());
  return visibility.isolated ? "Isolated: " + count + " muscles hidden" : count + " muscles hidden";
}

}  // namespace sinew::app
