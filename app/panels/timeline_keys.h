// app/panels/timeline_keys.h: rows of keys above the track, for keyed numbers and channels.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/editor/editor_state.h"
#include "app/panels/timeline_track.h"
#include "core/rig/animated_edit.h"

namespace sinew::app {

// The tracks of keys that the timeline shows below its own, and their edits.

/// A track of keys in the clip that shows: of a number, or of a channel.
struct KeyRow {
  std::string id;       ///< The widget's.
  std::string name;     ///< "radius X of biceps L", "channel effort"
  NumberRef ref;        ///< Where it is no channel.
  std::string channel;  ///< Empty: a number.
  KeyTrack track;

  [[nodiscard]] bool isChannel() const { return !channel.empty(); }
};

/// Rows of the selected muscles, their lines and the surface, then all channels. None in the bind pose.
[[nodiscard]] std::vector<KeyRow> keyRows(const EditorState& state);

// Pure edits of a row's track.
/// A key in place of one that is there.
[[nodiscard]] Result<Rig> withKeyAt(const Rig& rig, const KeyRow& row, float time, float value);
/// The track of `start` with a key moved, in the rig that is shown: twins follow what changes there. A key that is at
/// that time in `start` gives way.
/// @param key  index in the track of `start`
[[nodiscard]] Result<Rig> withKeyMoved(const Rig& start, const Rig& shown, const KeyRow& row, int key, float time);
/// A channel keeps its last key: drivers read it. Error: it is the last.
[[nodiscard]] Result<Rig> withoutKey(const Rig& rig, const KeyRow& row, int key);
[[nodiscard]] Result<Rig> withKeyKind(const Rig& rig, const KeyRow& row, CurveKind kind);

/// Design pixels that the timeline is higher by; 0 where nothing is keyed in the clip that shows.
[[nodiscard]] float keyRowsHeight(const EditorState& state);
/// Window coordinates: the names at the left; 0 without rows, or where there is no room for them.
[[nodiscard]] float keyRowsGutter(const PanelUi& ui);
/// Above clip and track, from the lowest row up: a new row leaves those below it where they are.
void drawKeyRows(PanelUi& ui, const TrackSpan& span, float gutter, float height);

}  // namespace sinew::app
