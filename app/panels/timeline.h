// app/panels/timeline.h: the parts of the timeline: its track, and the rows of keys above it.
#pragma once

#include <string>
#include <vector>

#include "app/panels/panel_ui.h"
#include "core/rig/animated_edit.h"

namespace sinew::app {

/// Maps times of the clip to the screen.
struct TrackSpan {
  float left = 0.0f;  ///< Window coordinates.
  float right = 0.0f;
  double duration = 0.0;  ///< The clip's, seconds.
  PlayRange shown;

  [[nodiscard]] double perSecond() const { return static_cast<double>(right - left) / (shown.to - shown.from); }
  [[nodiscard]] float xOf(double time) const { return left + static_cast<float>((time - shown.from) * perSecond()); }
  [[nodiscard]] double timeAt(float x) const;  ///< Within the clip.
};

/// Fills the rest of the region. @param gutter  left free at its left, window coordinates
TrackSpan drawTimelineTrack(PanelUi& ui, float gutter = 0.0f);

/// Frames between labels, so that labels are at least `leastPixels` apart: 1, 2, 5, 10, 15, 30, 60 ...
[[nodiscard]] int tickStep(double pixelsPerFrame, double leastPixels);

/// The number of a clip's keys in each column of a time span, as a fraction of the fullest column's.
[[nodiscard]] std::vector<float> keyDensity(const AnimationClip& clip, const PlayRange& span, int columns);

/// The span after a zoom at a time, which keeps its place: shorter for steps > 0, within 0..duration, >= five frames.
[[nodiscard]] PlayRange zoomedSpan(const PlayRange& span, double at, float steps, double duration);

/// A row of keys: the track of a number or channel in the current clip.
struct KeyRow {
  std::string id;       ///< The widget's.
  std::string name;     ///< "radius X of biceps L", "channel effort"
  NumberRef ref;        ///< Of a number.
  std::string channel;  ///< Empty: a number.
  KeyTrack track;

  [[nodiscard]] bool isChannel() const { return !channel.empty(); }
};

/// Rows of the selected muscles, their lines, the surface, shapes and links, then all channels. None in the bind pose.
[[nodiscard]] std::vector<KeyRow> keyRows(const EditorState& state);

/// Replaces a key at the same time.
[[nodiscard]] Result<Rig> withKeyAt(const Rig& rig, const KeyRow& row, float time, float value);
/// The track of `start` with a key moved, in the rig `shown`, so that twins follow. Replaces a key of `start` at the
/// same time. @param key  index in the track of `start`
[[nodiscard]] Result<Rig> withKeyMoved(const Rig& start, const Rig& shown, const KeyRow& row, int key, float time);
/// Error: it is the last key of a channel, which drivers need.
[[nodiscard]] Result<Rig> withoutKey(const Rig& rig, const KeyRow& row, int key);
[[nodiscard]] Result<Rig> withKeyKind(const Rig& rig, const KeyRow& row, CurveKind kind);

/// Height of the rows, design pixels; 0 if nothing is keyed in the current clip.
[[nodiscard]] float keyRowsHeight(const EditorState& state);
/// Width of the names at the left, window coordinates; 0 without rows or without room.
[[nodiscard]] float keyRowsGutter(const PanelUi& ui);
/// Above the controls and the track, from the lowest row up: a new row does not move those below it.
void drawKeyRows(PanelUi& ui, const TrackSpan& span, float gutter, float height);

}  // namespace sinew::app
