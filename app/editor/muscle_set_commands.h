// app/editor/muscle_set_commands.h: muscle sets, parts of the body, and the check of muscles.
#pragma once

#include <glm/vec2.hpp>

#include "app/editor/editor_state.h"

namespace sinew::app {

/// The character's motions, computed once.
[[nodiscard]] const std::shared_ptr<const Motions>& motionsOf(EditorState& state);
void closePanels(EditorState& state);  ///< Those that share a place in the picture.

// The tab Library: single muscles of sets, and the user's own sets.

void readLibrary(EditorState& state);  ///< Reads this body's sets if they are not current. Call before showing them.

/// Adds the muscle at its place on this body, with its twin, mended and selected: one undo step.
void layFromLibrary(EditorState& state, int set, int muscle);

/// A drop on the character adds the muscle and its twin (core/bodies/muscle_set.h). @param pointer  window coordinates
void takeFromLibrary(EditorState& state, int set, int muscle);
void carryFromLibrary(EditorState& state, const glm::vec2& pointer);
void dropFromLibrary(EditorState& state, const glm::vec2& pointer);
void leaveInLibrary(EditorState& state);

void nameNewSet(EditorState& state);  ///< Asks for the name of a new set of the selected muscles.
void saveNewSet(EditorState& state);  ///< Saves it as LibraryState::name, or sets LibraryState::notice.
void removeSetFromLibrary(EditorState& state, int set);  ///< @param set  one of the user's own

// Play > Check muscles.

void checkMuscles(EditorState& state);  ///< Checks all clips and shows the findings.
void closeCheck(EditorState& state);
[[nodiscard]] bool checkIsCurrent(const EditorState& state);  ///< The rig has not changed since the check.
/// Selects the muscle and goes to the time. @param finding  index into CheckState::findings
void goToFinding(EditorState& state, int finding);
void mendFindings(EditorState& state);  ///< Mends in one undo step, then checks again.

// Muscles > Parts of the body.

void toggleBodyParts(EditorState& state);
[[nodiscard]] BodySlots bodyPartsOf(const EditorState& state);  ///< The parts found, with the rig's corrections.
/// One undo step: corrects a part. @param bone  -1: the character has no such part
void setBodyPart(EditorState& state, BodySlot slot, int bone);
void forgetBodyPart(EditorState& state, BodySlot slot);  ///< One undo step: removes the correction.

// Muscles > Add muscle set: a set with two sliders, as one undo step.

/// Names of the sets for this character's body and their muscles; messages name unreadable files.
[[nodiscard]] std::vector<SetEntry> setEntries(EditorState& state);
void addMuscleSet(EditorState& state);  ///< Adds the first set and shows its sliders.
void addMuscleSetNamed(EditorState& state, const std::string& name);
/// The set is still the last step, which its sliders change. Any other edit or undo ends this.
[[nodiscard]] bool setIsTunable(const EditorState& state);
/// Replaces the set in the same step. @param chosen  index into MuscleSetState::sets
void chooseSet(EditorState& state, int chosen);

/// While a slider is dragged: shows the set at once, unmended. The first call reopens the step.
void previewSet(EditorState& state, const PresetTuning& tuning);
void keepSet(EditorState& state);      ///< The slider is released: mends the set and closes the step.
void dropPreview(EditorState& state);  ///< Esc: restores the set from before the drag.
[[nodiscard]] bool previewsSet(const EditorState& state);

void removeSet(EditorState& state);
void closeSet(EditorState& state);

}  // namespace sinew::app
