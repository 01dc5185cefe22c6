// app/editor/hidden_bones.cpp: the helper bones that the editor leaves out.

#include "app/editor/hidden_bones.h"

#include <algorithm>

#include "app/editor/territory.h"
#include "core/geometry/at.h"

namespace sinew::app {

std::vector<bool> hiddenBones(const EditorState& state) {
  const std::vector<bool>& helpers = state.open.helperBones;
  if (!state.hasCharacter() || state.view.outliner.helperBones) return {};
  if (std::ranges::find(helpers, true) == helpers.end()) return {};
  std::vector<bool> hidden = helpers;
  const auto show = [&](int bone) {
    if (bone >= 0) at(hidden, bone) = false;
  };
  for (const int bone : boneOfEach(state.document.rig(), state.character().skeleton)) show(bone);
  for (const JointTurn& turn : state.open.transport.overrides.turns) show(turn.bone);
  for (const int bone : shownTerritory(state)) show(bone);
  show(state.document.selection.bone);
  return std::ranges::find(hidden, true) == hidden.end() ? std::vector<bool>{} : hidden;
}

bool isHidden(const std::vector<bool>& hidden, int bone) { return !hidden.empty() && at(hidden, bone); }

}  // namespace sinew::app
