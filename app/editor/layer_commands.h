// app/editor/layer_commands.h: what the parts of the mesh are to the muscles: shown, set, guessed. docs/characters.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"

namespace sinew::app {

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

}  // namespace sinew::app
