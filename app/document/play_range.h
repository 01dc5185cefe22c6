// app/document/play_range.h: which part of each clip plays, and identities of clips.
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

using PlayRanges = std::map<int, PlayRange>;  ///< By clip index; a clip that plays as a whole has none.

/// Identity of a clip while clips of other files are added and removed.
struct ClipId {
  std::string file;  ///< AnimationClip::addedFrom
  int place = 0;     ///< Among the clips of that file.

  friend auto operator<=>(const ClipId&, const ClipId&) = default;
};

using KeptPlayRanges = std::map<ClipId, PlayRange>;  ///< Play ranges in the history.

[[nodiscard]] std::vector<ClipId> clipIds(const Character& character);      ///< [clips]
[[nodiscard]] int indexOf(const Character& character, const ClipId& clip);  ///< Index of the clip, or -1.

/// To the history's form and back, without ranges of missing clips.
[[nodiscard]] KeptPlayRanges keptRanges(const PlayRanges& ranges, const Character& character);
[[nodiscard]] PlayRanges rangesOf(const KeptPlayRanges& ranges, const Character& character);

}  // namespace sinew::app
