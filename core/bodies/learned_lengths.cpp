// core/bodies/learned_lengths.cpp: all lines over one pass of the clips.
#include "core/bodies/learned_lengths.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/geometry/at.h"
#include "core/rig/line_fitting.h"

namespace sinew {

Rig withLearnedLengths(Rig rig, std::size_t first, const Character& character) {
  std::vector<LineRest> rests;
  std::vector<int> lines;
  for (std::size_t i = first; i < rig.lines.size(); ++i) {
    auto rest = lineRest(rig.lines[i], character);
    if (!rest) continue;
    rests.push_back(std::move(rest).value());
    lines.push_back(static_cast<int>(i));
  }
  std::vector<LineLengths> lengths = lengthsOver(rests, character, character.clips);
  const std::vector<LineLengths> own = lengths;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int twin = findLine(rig, at(rig.lines, lines[i]).mirror);
    const auto other = std::ranges::find(lines, twin);
    if (twin < 0 || other == lines.end()) continue;
    const LineLengths& theirs = own[static_cast<std::size_t>(other - lines.begin())];
    lengths[i].least = std::min(lengths[i].least, theirs.least);
    lengths[i].secondPercentile = std::min(lengths[i].secondPercentile, theirs.secondPercentile);
    lengths[i].most = std::max(lengths[i].most, theirs.most);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // An error: it never shortens.
    if (auto learned = withLearned(rig, lines[i], lengths[i])) rig = std::move(learned).value().rig;
  }
  return rig;
}

}  // namespace sinew
