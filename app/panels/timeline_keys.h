// app/panels/timeline_keys.h: rows of keys above the track, for keyed numbers and channels.
#pragma once

#include "app/panels/timeline_track.h"

namespace sinew::app {

/// Design pixels that the timeline is higher by; 0 where nothing is keyed in the clip that shows.
[[nodiscard]] float keyRowsHeight(const EditorState& state);
/// Window coordinates: the names at the left; 0 without rows, or where there is no room for them.
[[nodiscard]] float keyRowsGutter(const PanelUi& ui);
/// Above clip and track, from the lowest row up: a new row leaves those below it where they are.
void drawKeyRows(PanelUi& ui, const TrackSpan& span, float gutter, float height);

}  // namespace sinew::app
