// app/editor/action_table_play.cpp: the Play menu: the clip.

#include "app/editor/action_table.h"
#include "app/editor/check_commands.h"
#include "app/editor/clip_commands.h"
#include "app/editor/edit.h"
#include "app/editor/pose_commands.h"

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
/// A range is a step of the history, so no other edit may be under way.
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
  const Possible possible = idle(s);
  if (!possible) return possible;
  return possible.also(!s.document.rig().primitives.empty(), "There is no muscle to check");
}

Possible hasClipFiles(const State& s) {
  const Possible possible = idle(s);
  return possible ? possible.also(!s.document.rig().clipFiles.empty(), "No clip file was added") : possible;
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
    {"play/clip-files", "Clip files",
     "The files whose clips were added: what did not match, to remove or to locate them", kNone, kNone, open,
     showsClipList, toggleClipList},
    {"play/read-clip-files", "Read clip files again", "Load what other programs have written into them since", kNone,
     kNone, hasClipFiles, nullptr, readClipFilesAgain},
    {"play/check", "Check muscles",
     "Look through all clips for muscles that leave the flesh, swell to a ball or reach another limb", kNone, kNone,
     checkable, nullptr, checkMuscles},
};

}  // namespace

std::span<const Action> playActions() { return kPlayActions; }

}  // namespace sinew::app::table
