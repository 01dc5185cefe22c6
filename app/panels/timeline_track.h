// app/panels/timeline_track.h: the track: scrubbing, ticks, keys, the range that plays.
#pragma once

#include <vector>

#include "app/panels/panel_ui.h"

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

}  // namespace sinew::app
