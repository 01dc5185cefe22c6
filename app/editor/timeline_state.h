// app/editor/timeline_state.h: what the timeline remembers between frames.
#pragma once

#include <cstddef>
#include <vector>

#include "app/playback.h"

namespace sinew::app {

/// View state. Belongs to one clip of one document; another starts from the defaults.
struct TimelineState {
  std::size_t document = 0;  ///< EditorState::documentsOpened.
  int clip = -1;
  PlayRange shown;             ///< The part of the clip that the track spans, seconds.
  PlayRange grabbed;           ///< The range when its bar was grabbed.
  double grabbedAt = 0.0;      ///< Where, seconds.
  std::vector<float> density;  ///< Keys per column of the track, 0..1 of the fullest; made for `densityOf`.
  PlayRange densityOf;
};

}  // namespace sinew::app
