// app/panels/timeline.h: the parts of the timeline: its track, and the rows of keys above it.
#pragma once

#include <string>
#include <vector>

#include "app/panels/panel_ui.h"
#include "core/rig/animated_edit.h"

namespace sinew::app {

/// Where the moments of the clip are on the screen.
struct TrackSpan {
  float left = 0.0f;  ///< Window coordinates.
  float right = 0.0f;
  double duration = 0.0;  ///< The clip's, seconds.
  PlayRange shown;

  [[nodiscard]] double perSecond() const { return static_cast<double>(right - left) / (shown.to - shown.from); }
  [[nodiscard]] float xOf(double time) const { return left + static_cast<float>((time - shown.from) * perSecond()); }
  /// Within the clip.
  [[nodiscard]] double timeAt(float x) const;
};

/// Fills the rest of the region. Nothing to drag without a clip that lasts.
/// @param gutter  window coordinates that are left free at its left
TrackSpan drawTimelineTrack(PanelUi& ui, float gutter = 0.0f);

/// Frames between labels, so that labels are at least `leastPixels` apart: 1, 2, 5, 10, 15, 30, 60 ...
[[nodiscard]] int tickStep(double pixelsPerFrame, double leastPixels);

/// How many keys of a clip fall into each column of a span of time, as a share of the fullest column.
[[nodiscard]] std::vector<float> keyDensity(const AnimationClip& clip, const PlayRange& span, int columns);

/// A span after turning the wheel at a moment, which keeps its place: shorter for steps > 0; within 0..duration and
/// never below five frames.
[[nodiscard]] PlayRange zoomedSpan(const PlayRange& span, double at, float steps, double duration);

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
