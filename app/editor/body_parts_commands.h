// app/editor/body_parts_commands.h: Muscles > Parts of the body: which bone is which part, corrected by hand.
#pragma once

#include "app/editor/editor_state.h"

namespace sinew::app {

void toggleBodyParts(EditorState& state);
/// The parts as found, with the rig's corrections.
[[nodiscard]] BodySlots bodyPartsOf(const EditorState& state);
/// One undo step: the rig says that this bone is the part. @param bone  -1: the character has no such part
void setBodyPart(EditorState& state, BodySlot slot, int bone);
/// One undo step: as it was found.
void forgetBodyPart(EditorState& state, BodySlot slot);

}  // namespace sinew::app
