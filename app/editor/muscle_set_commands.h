// app/editor/muscle_set_commands.h: Muscles > Add muscle set: the set and its two sliders, as one undo step.
#pragma once

#include "app/editor/editor_state.h"

namespace sinew::app {

// Play > Check muscles: the list of findings, going to one, mending.

/// Looks through all clips and shows what was found.
void checkMuscles(EditorState& state);
void closeCheck(EditorState& state);
/// Whether the rig is still the one that was checked.
[[nodiscard]] bool checkIsCurrent(const EditorState& state);
/// Selects the muscle and goes to the moment. @param finding  index into CheckState::findings
void goToFinding(EditorState& state, int finding);
/// One undo step; then checks again.
void mendFindings(EditorState& state);

// Muscles > Parts of the body: which bone is which part, corrected by hand.

void toggleBodyParts(EditorState& state);
/// The parts as found, with the rig's corrections.
[[nodiscard]] BodySlots bodyPartsOf(const EditorState& state);
/// One undo step: the rig says that this bone is the part. @param bone  -1: the character has no such part
void setBodyPart(EditorState& state, BodySlot slot, int bone);
/// One undo step: as it was found.
void forgetBodyPart(EditorState& state, BodySlot slot);

/// The sets for the body of this character. Error: why there are none. Files that are no sets are named in messages.
[[nodiscard]] Result<std::vector<Preset>> setsForBody(EditorState& state);
/// Names of those sets and of their muscles; nothing is laid for them. None where there are no sets.
[[nodiscard]] std::vector<SetEntry> setEntries(EditorState& state);
/// What the character does; made once.
const Motions& motionsOf(EditorState& state);
/// Adds the set for this kind of body and shows its sliders.
void addMuscleSet(EditorState& state);
/// @param name  of the set
void addMuscleSetNamed(EditorState& state, const std::string& name);
/// The last step is still the set's: its sliders change that step. Any other edit, undo included, ends this.
[[nodiscard]] bool setIsTunable(const EditorState& state);
/// Another set in the same step. @param chosen  index into MuscleSetState::sets
void chooseSet(EditorState& state, int chosen);

/// While a slider is dragged: shown at once, not mended yet. The first call opens the step again.
void previewSet(EditorState& state, const PresetTuning& tuning);
/// The slider is let go: mended, and the step is closed.
void keepSet(EditorState& state);
/// Esc: the set as it was before the slider was taken.
void dropPreview(EditorState& state);
[[nodiscard]] bool previewsSet(const EditorState& state);

void removeSet(EditorState& state);
void closeSet(EditorState& state);

}  // namespace sinew::app
