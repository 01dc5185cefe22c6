// app/document/play_range.h: which part of each clip plays, and which clip is which while clips come and go.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <vector>

#include "sinew/character/character.h"

namespace sinew::app {

/// A part of a clip, seconds.
struct PlayRange {
  double from = 0.0;
  double to = 0.0;

  friend bool operator==(const PlayRange&, const PlayRange&) = default;
};

/// By the clip's index; a clip that plays as a whole has none.
using PlayRanges = std::map<int, PlayRange>;

/// A clip, whichever others are there.
struct ClipId {
  std::string file;  ///< AnimationClip::addedFrom
  int place = 0;     ///< Among the clips of that file.

  friend auto operator<=>(const ClipId&, const ClipId&) = default;
};

/// The same where clips of other files may come and go: in the history.
using KeptPlayRanges = std::map<ClipId, PlayRange>;

/// [clips]
[[nodiscard]] std::vector<ClipId> clipIds(const Character& character);
/// Index of the clip, or -1: it is not there now.
[[nodiscard]] int indexOf(const Character& character, const ClipId& clip);

/// As the history keeps them, and back; those of clips that are not there are left out.
[[nodiscard]] KeptPlayRanges keptRanges(const PlayRanges& ranges, const Character& character);
[[nodiscard]] PlayRanges rangesOf(const KeptPlayRanges& ranges, const Character& character);

}  // namespace sinew::app
