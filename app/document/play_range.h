// app/document/play_range.h: which part of each clip plays.
#pragma once

#include <map>

namespace sinew::app {

/// A part of a clip, seconds.
struct PlayRange {
  double from = 0.0;
  double to = 0.0;

  friend bool operator==(const PlayRange&, const PlayRange&) = default;
};

/// By the clip's index; a clip that plays as a whole has none.
using PlayRanges = std::map<int, PlayRange>;

}  // namespace sinew::app
