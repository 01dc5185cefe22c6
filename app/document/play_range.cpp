// app/document/play_range.cpp: identities of clips.
#include "app/document/play_range.h"

#include <algorithm>
#include <map>
#include <string>

namespace sinew::app {

std::vector<ClipId> clipIds(const Character& character) {
  std::vector<ClipId> ids;
  std::map<std::string, int> counts;
  for (const AnimationClip& clip : character.clips) ids.push_back({clip.addedFrom, counts[clip.addedFrom]++});
  return ids;
}

int indexOf(const Character& character, const ClipId& clip) {
  const std::vector<ClipId> ids = clipIds(character);
  const auto found = std::ranges::find(ids, clip);
  return found == ids.end() ? -1 : static_cast<int>(found - ids.begin());
}

KeptPlayRanges keptRanges(const PlayRanges& ranges, const Character& character) {
  const std::vector<ClipId> ids = clipIds(character);
  KeptPlayRanges kept;
  for (const auto& [clip, range] : ranges) {
    if (clip >= 0 && clip < static_cast<int>(ids.size())) kept[ids[static_cast<std::size_t>(clip)]] = range;
  }
  return kept;
}

PlayRanges rangesOf(const KeptPlayRanges& ranges, const Character& character) {
  const std::vector<ClipId> ids = clipIds(character);
  PlayRanges found;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto range = ranges.find(ids[i]);
    if (range != ranges.end()) found[static_cast<int>(i)] = range->second;
  }
  return found;
}

}  // namespace sinew::app
