// app/editor/visibility_commands.h: hiding, isolating and locking muscles, helper bones, and layers of the mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

// Layers of the mesh's parts (docs/characters.md). Each edit is one undo step.

[[nodiscard]] bool hasParts(const EditorState& state);  ///< The open character's mesh has more than one part.
[[nodiscard]] std::vector<SkinLayer> partLayers(const EditorState& state);  ///< [parts] Set by the rig, else guessed.
/// The rig sets the part's layer. @param part  index into Character::parts, as all here
[[nodiscard]] bool isLayerSet(const EditorState& state, int part);

void setPartLayer(EditorState& state, int part, std::optional<SkinLayer> layer);  ///< @param layer  nullopt: as guessed
void guessAllLayers(EditorState& state);                                          ///< Removes all layers from the rig.
void forgetPart(EditorState& state, const std::string& name);  ///< Removes the layer of a part that is missing.

[[nodiscard]] std::vector<LitPart> litParts(const EditorState& state);  ///< The chosen and the hovered part.

/// [bones] Helper bones (core/character/joint_roles.h) to hide in picture, tree and lists, except those with a muscle,
/// selected, rotated by hand or in the edited territory. Empty: none.
[[nodiscard]] std::vector<bool> hiddenBones(const EditorState& state);
[[nodiscard]] bool isHidden(const std::vector<bool>& hidden, int bone);  ///< @param hidden  from hiddenBones()

void followEdits(Document& document);  ///< Once a frame, before the surface is updated: shows new muscles.

void toggleHideSelection(Document& document);  ///< Hides the selected muscles, or shows them if all are hidden.
void showAll(Document& document);              ///< Ends hide, solo and isolate; locks stay.
void toggleIsolation(Document& document);      ///< Shows only the selected muscles, or all again.
void toggleLockSelection(Document& document);
void unlockAll(Document& document);

[[nodiscard]] bool anythingHidden(const Document& document);  ///< Something is hidden, soloed or isolated.

void latchBare(EditorState& state);  ///< "Before", without muscles: the key is pressed or the menu entry chosen.
/// Once a frame. @param keyDown  the action's key is held  @param buttonDown  its button is held
void holdBare(EditorState& state, bool keyDown, bool buttonDown);

[[nodiscard]] std::string hiddenText(const Document& document);  ///< "2 of 15 muscles hidden" or "".

}  // namespace sinew::app
