// app/editor/visibility_commands.h: hide, isolate, before and after; from keys, menus and the outliner.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// What the parts of the mesh are to the muscles: shown, set, guessed. docs/characters.md.

/// A character is open whose mesh has more than one part.
[[nodiscard]] bool hasParts(const EditorState& state);
/// [parts] As the rig says, else as guessed.
[[nodiscard]] std::vector<SkinLayer> partLayers(const EditorState& state);
/// Whether the rig says what a part is. @param part  index into Character::parts, as all here
[[nodiscard]] bool isLayerSet(const EditorState& state, int part);

/// One undo step. @param layer  nullopt: as guessed
void setPartLayer(EditorState& state, int part, std::optional<SkinLayer> layer);
/// One undo step: the rig says nothing of any part, of those that the character lacks either.
void guessAllLayers(EditorState& state);
/// One undo step: what the rig says of a part that the character lacks goes.
void forgetPart(EditorState& state, const std::string& name);

/// The chosen part and the one under the pointer.
[[nodiscard]] std::vector<LitPart> litParts(const EditorState& state);

// The helper bones that the editor leaves out of picture, tree and lists.

/// [bones] Helper bones (core/character/joint_roles.h) while they are not asked for. Those that carry a muscle, are
/// selected, turned by hand or part of the territory that is being edited are never hidden. Empty: none is.
[[nodiscard]] std::vector<bool> hiddenBones(const EditorState& state);
/// @param hidden  of hiddenBones()
[[nodiscard]] bool isHidden(const std::vector<bool>& hidden, int bone);

/// Once a frame, before the surface is brought up to date: marks follow renamed muscles, new ones appear.
void followEdits(Document& document);

/// Hides the selected muscles; shows them if all of them are hidden by themselves.
void toggleHideSelection(Document& document);
/// Show every muscle: hide, solo and isolate end; locks stay.
void showAll(Document& document);
/// Shows the selected muscles alone, or ends that.
void toggleIsolation(Document& document);
void toggleLockSelection(Document& document);
void unlockAll(Document& document);

/// Something is hidden, soloed or isolated.
[[nodiscard]] bool anythingHidden(const Document& document);

/// The menu's and the key's part of "before": the key goes down, or the menu entry is chosen.
void latchBare(EditorState& state);
/// Once a frame. @param keyDown  the action's key is held  @param buttonDown  its button is
void holdBare(EditorState& state, bool keyDown, bool buttonDown);

/// "2 of 15 muscles hidden" or "".
[[nodiscard]] std::string hiddenText(const Document& document);

}  // namespace sinew::app
