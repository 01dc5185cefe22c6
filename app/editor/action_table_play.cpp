// app/editor/action_table_play.cpp: the menus Play and Tool.
#include <iterator>
#include <utility>
#include <vector>

#include "app/editor/action_table.h"
#include "app/editor/blending_edit.h"
#include "app/editor/clip_commands.h"
#include "app/editor/edit.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/pose_commands.h"
#include "app/viewport/tools/viewport_tools.h"

namespace sinew::app::table {
namespace {

Possible playable(const State& s) {
  const bool any = s.hasCharacter() && !s.character().clips.empty();
  return open(s)
      .also(any, "The character has no clips")
      .also(any && s.open.transport.clip >= 0, "Choose a clip first")
      .also(any && clipDuration(s.open.transport, s.character()) > 0.0, "The clip is a single pose");
}
void togglePlay(State& s) { togglePlaying(s.open.transport, s.character()); }
void next(State& s) { stepFrames(s.open.transport, 1, s.character()); }
void previous(State& s) { stepFrames(s.open.transport, -1, s.character()); }
void toStart(State& s) { s.open.transport.time = playRange(s.open.transport, s.character()).from; }
void toEnd(State& s) {
  s.open.transport.time = playRange(s.open.transport, s.character()).to;
  s.open.transport.playing = false;
}
/// A range is a step of the history: no other edit may be in progress.
Possible rangeable(const State& s) {
  const Possible plays = playable(s);
  return plays ? idle(s) : plays;
}
Possible hasRange(const State& s) {
  return rangeable(s).also(hasPlayRange(s.open.transport), "The whole clip plays already");
}
void startRange(State& s) {
  setPlayRange(s.open.transport, {s.open.transport.time, playRange(s.open.transport, s.character()).to}, s.character());
  keepPlayRange(s);
}
void endRange(State& s) {
  setPlayRange(s.open.transport, {playRange(s.open.transport, s.character()).from, s.open.transport.time},
               s.character());
  keepPlayRange(s);
}
void wholeClip(State& s) {
  s.open.transport.ranges.erase(s.open.transport.clip);
  keepPlayRange(s);
}
bool isLooping(const State& s) { return s.open.transport.loop; }
void toggleLoop(State& s) { s.open.transport.loop = !s.open.transport.loop; }

Possible checkable(const State& s) {
  return idle(s).also(!s.document.rig().primitives.empty(), "There is no muscle to check");
}

Possible hasClipFiles(const State& s) {
  return idle(s).also(!s.document.rig().clipFiles.empty(), "No clip file was added");
}
bool showsClipList(const State& s) { return s.open.clipList.shown; }

const Action kPlayActions[] = {
    {"play/toggle", "Play or pause", "Start or stop the clip", key(GLFW_KEY_SPACE), kNone, playable, nullptr,
     togglePlay},
    {"play/previous", "Previous frame", "One frame back", key(GLFW_KEY_COMMA), key(GLFW_KEY_LEFT), playable, nullptr,
     previous},
    {"play/next", "Next frame", "One frame forward", key(GLFW_KEY_PERIOD), key(GLFW_KEY_RIGHT), playable, nullptr,
     next},
    {"play/start", "To the start", "Jump to the start of what plays", ctrl(GLFW_KEY_LEFT), kNone, playable, nullptr,
     toStart},
    {"play/end", "To the end", "Jump to the end of the clip", ctrl(GLFW_KEY_RIGHT), kNone, playable, nullptr, toEnd},
    {"play/loop", "Loop", "Start again at the end", key(GLFW_KEY_L), kNone, playable, isLooping, toggleLoop, true},
    {"play/range-start", "Begin the range here", "Play only what comes after the current time", key('['), kNone,
     rangeable, nullptr, startRange},
    {"play/range-end", "End the range here", "Play only what comes before the current time", key(']'), kNone, rangeable,
     nullptr, endRange},
    {"play/range-clear", "Play the whole clip", "Clear the range that plays", kNone, kNone, hasRange, nullptr,
     wholeClip},
    {"play/range-of-motion", "Range of motion",
     "Move every joint through its range, one after another: a clip made from the skeleton", kNone, kNone, idle,
     nullptr, playRangeOfMotion, true},
    {"play/clip-files", "Clip files", "Files whose clips were added: see mismatches, remove or locate files", kNone,
     kNone, open, showsClipList, toggleClipList},
    {"play/read-clip-files", "Read clip files again", "Reload clip files that other programs have changed", kNone,
     kNone, hasClipFiles, nullptr, readClipFilesAgain},
    {"play/check", "Check muscles",
     "Check all clips for muscles that leave the body, bulge into a ball or reach another limb", kNone, kNone,
     checkable, nullptr, checkMuscles},
};

template <std::size_t kIndex>
bool isTool(const State& s) {
  return s.view.tools.tool == static_cast<ToolKind>(kIndex);
}
template <std::size_t kIndex>
void chooseTool(State& s) {
  endTerritoryMode(s.view.tools);  // Which would take the tool's clicks.
  setTool(s.view.tools, static_cast<ToolKind>(kIndex));
}

Possible posing(const State& s) {
  return idle(s).also(s.view.tools.tool == ToolKind::kPose, "Choose the Pose tool first");
}
Possible anyPosed(const State& s) { return idle(s).also(isPosed(s), "No joint is turned by hand"); }
Possible jointPosed(const State& s) {
  return idle(s).also(selectedJointIsPosed(s), "Select a joint that is turned by hand first");
}
Possible canPastePose(const State& s) { return idle(s).also(!s.view.copiedPose.empty(), "Copy a pose first"); }
bool holdsPose(const State& s) { return s.open.transport.overrides.from == TurnsFrom::kBindPose; }

bool boxing(const State& s) { return s.view.tools.box.armed; }
void toggleBox(State& s) { armBox(s.view.tools); }
bool pivotsOnAll(const State& s) { return s.view.tools.pivot == GizmoPivot::kCentroid; }
void togglePivot(State& s) { s.view.tools.pivot = pivotsOnAll(s) ? GizmoPivot::kActive : GizmoPivot::kCentroid; }

template <ToolKind kTool>
void dragAtOnce(State& s) {
  startDrag(s.view.tools, kTool);
}

Possible territoryKnown(const State& s) { return editsTerritory(s) ? Possible() : selected(s); }

const Action kOthers[] = {
    {"tool/grab", "Grab", "Move the selected muscle with the pointer, without its handles; a click keeps it", kNone,
     kNone, selected, nullptr, dragAtOnce<ToolKind::kMove>, true},
    {"tool/turn", "Turn", "Turn the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kRotate>},
    {"tool/size", "Resize", "Scale the selected muscle with the pointer; a click keeps it", kNone, kNone, selected,
     nullptr, dragAtOnce<ToolKind::kScale>},
    {"tool/axes", "Turn handles", "Align the handles with the world, the bone or the muscle", key(GLFW_KEY_X), kNone,
     idle, nullptr, cycleAxes, true},
    {"tool/pivot", "Pivot in the middle", "Rotate several muscles about their center, not about the active one",
     shift(GLFW_KEY_X), kNone, idle, pivotsOnAll, togglePivot},
    {"tool/box-select", "Box select", "Draw a box around muscles: Shift adds, Alt removes. Ctrl+drag does the same",
     shift(GLFW_KEY_B), kNone, idle, boxing, toggleBox},
    {kTerritoryTool.id, kTerritoryTool.label, kTerritoryTool.hint, key(kTerritoryTool.key), kNone, territoryKnown,
     editsTerritory, toggleTerritoryMode, true},
    {"tool/pose-reset-joint", "Reset joint", "Return the selected joint to the clip or the bind pose", alt(GLFW_KEY_P),
     kNone, jointPosed, nullptr, resetJoint, true},
    {"tool/pose-reset", "Reset pose", "Undo every turn made by hand", shift(GLFW_KEY_P), kNone, anyPosed, nullptr,
     resetPose},
    {"tool/pose-mirror", "Mirror pose",
     "Copy the selected joint's side to the other side; with no joint selected, swap left and right",
     ctrlShift(GLFW_KEY_P), kNone, anyPosed, nullptr, mirrorPose},
    {"tool/pose-copy", "Copy pose", "Copy how the joints are turned", kNone, kNone, anyPosed, nullptr, copyPose},
    {"tool/pose-paste", "Paste pose", "Turn the joints as in the copied pose", kNone, kNone, canPastePose, nullptr,
     pastePose},
    {"tool/pose-hold", "Hold turned joints", "Keep turned joints still while the clip moves the others", kNone, kNone,
     idle, holdsPose, toggleHoldPose},
    {"tool/pose-parent", "Parent joint", "Select the parent of the selected joint", key(GLFW_KEY_UP), kNone, posing,
     nullptr, onDocument<selectParentJoint>},
    {"tool/pose-child", "Child joint", "Select the first child of the selected joint", key(GLFW_KEY_DOWN), kNone,
     posing, nullptr, selectChildJoint},
};

/// A row for each tool, then the others.
template <std::size_t... kIndices>
std::vector<Action> withTools(std::index_sequence<kIndices...>) {
  std::vector<Action> all{{tools()[kIndices]->id, tools()[kIndices]->label, tools()[kIndices]->hint,
                           tools()[kIndices]->shift ? shift(tools()[kIndices]->key) : key(tools()[kIndices]->key),
                           kNone, idle, isTool<kIndices>, chooseTool<kIndices>}...};
  all.insert(all.end(), std::begin(kOthers), std::end(kOthers));
  return all;
}

}  // namespace

std::span<const Action> playActions() { return kPlayActions; }

std::span<const Action> toolActions() {
  static const std::vector<Action> all = withTools(std::make_index_sequence<kToolCount>());
  return all;
}

}  // namespace sinew::app::table
