// core/bodies/learn_full.cpp: lengths over poses that are already there.
#include "core/bodies/learn_full.h"

#include <algorithm>

#include "core/rig/line_lengths.h"

namespace sinew {

void learnFull(MuscleLine& line, const Motions& motions) {
  const auto rest = lineRest(line, motions.character());
  if (!rest) return;
  const LineLengths lengths = lengthsOver(rest.value(), motions.character().skeleton, motions.poses());
  if (lengths.poses > 0 && lengths.secondPercentile < kMostFull) {
    line.settings.full = std::max(lengths.secondPercentile, kLeastFull);
  }
}

}  // namespace sinew
