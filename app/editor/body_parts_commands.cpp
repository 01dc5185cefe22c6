// app/editor/body_parts_commands.cpp: the rig's corrections of the parts of the body.
#include "app/editor/body_parts_commands.h"

#include <string>
#include <utility>

#include "app/editor/check_commands.h"
#include "app/editor/edit.h"
#include "app/editor/muscle_set_commands.h"
#include "core/bodies/body_map.h"

namespace sinew::app {
namespace {

Rig withoutCorrection(Rig rig, BodySlot slot) {
  std::erase_if(rig.slots, [&](const SlotCorrection& each) { return each.slot == nameOf(slot); });
  return rig;
}

}  // namespace

void toggleBodyParts(EditorState& state) {
  state.open.bodyParts.shown = !state.open.bodyParts.shown;
  if (!state.open.bodyParts.shown) return;
  closeSet(state);  // They would lie under it.
  closeCheck(state);
  state.open.clipList.shown = false;
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

}  // namespace sinew::app
