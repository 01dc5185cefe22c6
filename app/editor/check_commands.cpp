// app/editor/check_commands.cpp: core/bodies on the open document.
#include "app/editor/check_commands.h"

#include <utility>

#include "app/editor/edit.h"
#include "app/editor/pose_commands.h"
#include "core/bodies/mend.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"

namespace sinew::app {

void checkMuscles(EditorState& state) {
  CheckState& check = state.open.check;
  const Rig& rig = state.document.rig();
  check = {};
  state.open.muscleSet.shown = false;  // They share a place.
  state.open.bodyParts.shown = state.open.clipList.shown = false;
  check.shown = true;
  check.revision = state.document.commands.revision();
  check.findings = sinew::check(rig, Motions(state.document.character));
  for (const Finding& finding : check.findings) check.muscles.push_back(state.document.idAt(finding.primitive));
}

void closeCheck(EditorState& state) { state.open.check = {}; }

bool checkIsCurrent(const EditorState& state) {
  return state.open.check.revision == state.document.commands.revision();
}

void goToFinding(EditorState& state, int finding) {
  CheckState& check = state.open.check;
  check.chosen = finding;
  state.document.selection.set(at(check.muscles, finding));
  const Finding& found = at(check.findings, finding);
  if (found.clip == kRangeOfMotionName) playRangeOfMotion(state);
  const int clip = found.clip.empty() ? -1 : findClip(state.character(), found.clip);
  Transport& transport = state.open.transport;
  chooseClip(transport, clip, state.character());
  transport.playing = false;
  transport.time = static_cast<double>(found.time);
}

void mendFindings(EditorState& state) {
  if (!checkIsCurrent(state)) return checkMuscles(state);
  const Motions motions(state.document.character);
  Result<MendedRig> mended = withMendedRig(state.document.rig(), 0, motions, state.document.mirror.get());
  if (!mended) return refuse(state, mended.error());
  if (mended->said.empty()) return sayRefusal(state, "Nothing of this can be mended: change these muscles by hand");
  const std::vector<std::string> said = std::move(mended.value().said);
  edit(state, "Mend muscles", std::move(mended.value().rig));
  for (const std::string& line : said) addMessage(state.session, MessageKind::kNote, "Mended " + line);
  checkMuscles(state);
}

}  // namespace sinew::app
