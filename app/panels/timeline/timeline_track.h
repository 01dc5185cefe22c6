// app/panels/timeline/timeline_track.h: the track: scrubbing, ticks, keys, the range that plays.
#pragma once

#include <vector>

#include "app/panels/shared/panel_ui.h"

namespace sinew::app {

/// Fills the rest of the region. Nothing to drag without a clip that lasts.
void drawTimelineTrack(PanelUi& ui);

/// Frames between labels, so that labels are at least `leastPixels` apart: 1, 2, 5, 10, 15, 30, 60 ...
[[nodiscard]] int tickStep(double pixelsPerFrame, double leastPixels);

/// How many keys of a clip fall into each column of a span of time, as a share of the fullest column.
[[nodiscard]] std::vector<float> keyDensity(const AnimationClip& clip, const PlayRange& span, int columns);

/// A span after turning the wheel at a moment, which keeps its place: shorter for steps > 0; within 0..duration and
/// never below five frames.
[[nodiscard]] PlayRange zoomedSpan(const PlayRange& span, double at, float steps, double duration);

}  // namespace sinew::app
